// What an exercise has found at given givens, each quantity once: the numbers that its sheets draw and print.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/proof/exercise.h"
#include "exercises/kit/proof/place.h"

namespace epure {

class Solution {
 public:
  // Of a quantity found by several routes, what the first one says that knows it.
  Solution(Givens givens, std::vector<RouteValue> values);
  // Of parts, each of which is a case: its quantities have names that begin with "case.", or no point where it has no
  // name. The first is found at once, so that givens are refused here; the others when one of their quantities is
  // asked for. From several threads, too.
  struct FindPart {
    std::string of_case;
    std::function<std::vector<RouteValue>()> find;
  };
  Solution(Givens givens, const std::vector<FindPart>& parts);

  const Givens& givens() const { return givens_; }

  bool has(const std::string& quantity) const { return look_up(quantity) != nullptr; }
  // The value, as the double nearest to the middle of what is known; zero when that may be zero. None when the
  // quantity does not exist or could not be decided. Asking for what no route writes is a caller's mistake.
  std::optional<double> value(const std::string& quantity) const;
  // The same as this route says it; none where it does not write the quantity.
  std::optional<double> value(const std::string& quantity, const std::string& route) const;
  // Between which bounds it is known; none as above.
  std::optional<geometry::Enclosure> enclosure(const std::string& quantity) const;
  // Of a quantity that has a value.
  double operator[](const std::string& quantity) const;
  // Whether the exercise reports it, and what it says of it then.
  bool is_reported(const std::string& quantity) const {
    return has(quantity) && find(quantity).described.has_value();
  }
  const Quantity& described(const std::string& quantity) const;

  // From the coordinates NAME_x, NAME_y; none when one of them has no value.
  std::optional<Place> point(const std::string& name) const;
  Place place(const std::string& name) const;
  // From the components, in the same way, of one that exists.
  Arrow2 vector(const std::string& name) const;

  // Everything by its name, in the order in which it was written down.
  std::vector<RouteValue> values() const;

 private:
  class Part;
  // None when no part can have it.
  Part* part_of(const std::string& quantity) const;
  // None when no route writes it.
  const RouteValue* look_up(const std::string& quantity) const;
  const RouteValue& find(const std::string& quantity) const;

  Givens givens_;
  std::vector<std::shared_ptr<Part>> parts_;
};

}  // namespace epure
