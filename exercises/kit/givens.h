// What an exercise starts from: exact rationals, each with symbol, unit and the values it may take.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "exercises/kit/words.h"
#include "geometry/numbers/number.h"

namespace epure {

using geometry::Rational;

enum class Range { any, not_negative, positive };

struct GivenSpec {
  std::string symbol;  // as typed after --set
  Words meaning;
  std::string unit;
  std::string stated;  // the value in the source, in `unit`
  Range range = Range::positive;
  std::string letters = {};  // rich text for sheets, when it is not the symbol itself
};

// Wrong or impossible givens; the message is one sentence for the user (exit code 2).
struct BadGivens : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Givens {
 public:
  // As the source states them.
  explicit Givens(const std::vector<GivenSpec>& specs);

  // From "r=0.25" or "n=400rpm". Throws BadGivens: unknown symbol, unreadable value, wrong unit, out of range.
  void set(std::string_view assignment);

  // In the unit of the given. The symbol must exist.
  const Rational& operator[](std::string_view symbol) const;

  // No given was changed, so the source's printed numbers apply.
  bool as_stated() const;
  const std::vector<GivenSpec>& specs() const { return specs_; }

 private:
  std::vector<GivenSpec> specs_;
  std::vector<Rational> values_;
};

}  // namespace epure
