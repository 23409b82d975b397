// What an exercise starts from: exact rationals, each with symbol, unit and the values it may take.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exercises/kit/words.h"
#include "geometry/numbers/number.h"

namespace epure {

using geometry::Rational;

enum class Range { any, not_negative, positive };

// One of the words a given may be, when it is no number: a side, a branch.
struct Choice {
  std::string word;  // as typed after --set
  Words meaning;
};

struct GivenSpec {
  std::string symbol;  // as typed after --set
  Words meaning;
  std::string unit;
  std::string stated;  // the value in the source, in `unit`
  Range range = Range::positive;
  std::string letters = {};          // rich text for sheets, when it is not the symbol itself
  std::vector<Choice> choices = {};  // of a given that is no number: then `stated` is one of the words
  bool beyond_source = false;        // the source does not speak of it: a sheet names it only when it was changed
};

// Wrong or impossible givens; the message is one sentence for the user (exit code 2).
struct BadGivens : Told {
  using Told::Told;
};

class Givens {
 public:
  // As the source states them.
  explicit Givens(const std::vector<GivenSpec>& specs);

  // From "r=0.25" or "n=400rpm". Throws BadGivens: unknown symbol, unreadable value, wrong unit, out of range.
  void set(std::string_view assignment);

  // In the unit of the given. The symbol must exist. Of a word, its place among the choices.
  const Rational& operator[](std::string_view symbol) const;
  // The word. The symbol must exist, and be one with choices.
  const Choice& chosen(std::string_view symbol) const;
  // As --set takes it, without the unit: "1/5", "left".
  std::string text(std::string_view symbol) const;

  // The value is not the stated one. The symbol must exist.
  bool is_changed(std::string_view symbol) const;
  // No given was changed, so the source's printed numbers apply.
  bool as_stated() const;
  const std::vector<GivenSpec>& specs() const { return specs_; }

 private:
  std::vector<GivenSpec> specs_;
  std::vector<Rational> values_;
};

}  // namespace epure
