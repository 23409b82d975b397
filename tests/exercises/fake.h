// A right triangle as an exercise: small enough to know every number, and made to be spoilt.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/proof/exercise.h"

namespace epure {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Catheti a (along x) and b (along y); the hypotenuse c runs from the end of b down to the end of a.
class Triangle : public Exercise {
 public:
  Triangle();
  const Description& about() const override { return description; }
  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override;
  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override;

  Description description;
  void change_quantities(const std::function<void(std::vector<Quantity>&)>& change);
  // Applied to what solve and draw return.
  std::function<void(std::vector<RouteValue>&)> spoil_values = [](auto&) {};
  std::function<void(DrawnSheet&)> spoil_sheet = [](auto&) {};

  // Of its sheet "sides".
  std::optional<LongTable> long_table(const std::string& sheet, const Solution& solution) const override;
  std::optional<LongTable> table_of_it = {};

  std::vector<Flaw> flaws(const Givens&) const override { return flaws_of_it; }
  std::vector<Flaw> flaws_of_it = {};
};

// Of a known number: exactly a double, as the climb hands it on.
geometry::Settled certain(double value);
geometry::Settled absent(const std::string& reason);
geometry::Settled undecided(const std::string& reason);
geometry::Settled enclosed(double lower, double value, double upper);

// The value of a quantity by a route, to be spoilt.
geometry::Settled& value_of(std::vector<RouteValue>& values, const std::string& quantity, const std::string& route);

}  // namespace epure
