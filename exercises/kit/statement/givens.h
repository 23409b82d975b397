// What an exercise starts from: exact rationals, each with symbol, unit and the values it may take.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exercises/kit/statement/format_words.h"
#include "geometry/numbers/angle.h"
#include "geometry/numbers/given.h"

namespace epure {

using geometry::Angle;
using geometry::Rational;

enum class Range { any, not_negative, positive };

// One of the words a given may be, when it is no number: a side, a branch.
struct Choice {
  std::string word;  // as typed after --set
  Words meaning;
};

// An angle that an instant states as well: what turns with the given `speed` has turned through it at the `instant`.
struct TurnedThrough {
  std::string instant, speed;
};

struct GivenSpec {
  std::string symbol;  // as typed after --set
  Words meaning;
  std::string unit;
  std::string stated;  // the value in the source, in `unit`; of an angle that an instant states, empty
  Range range = Range::positive;
  std::string letters = {};            // rich text for sheets, when it is not the symbol itself
  std::vector<Choice> choices = {};    // of a given that is no number: then `stated` is one of the words
  bool beyond_source = false;          // the source does not speak of it: a sheet names it only when it was changed
  std::vector<std::string> also = {};  // other names that --set takes for it
  std::optional<TurnedThrough> turned = {};
};

// Wrong or impossible givens; the message is one sentence for the user (exit code 2).
struct BadGivens : Told {
  using Told::Told;
};
// What givens must fulfil beside their ranges; `otherwise` says which value violates which condition.
inline void require(bool holds, const Words& otherwise) {
  if (!holds) throw BadGivens(otherwise);
}

// The place among `specs` of the one with this symbol, or with this other name; specs.size() when there is none.
std::size_t index_of(const std::vector<GivenSpec>& specs, std::string_view name);

class Givens {
 public:
  // As the source states them.
  explicit Givens(const std::vector<GivenSpec>& specs);

  // From "r=0.25" or "n=400rpm". Throws BadGivens: unknown symbol, unreadable value, wrong unit, out of range; an
  // angle and the instant that states it too, both set.
  void set(std::string_view assignment);

  // In the unit of the given, of what does not turn. The symbol must exist. Of a word, its place among the choices.
  const Rational& operator[](std::string_view symbol) const;
  // Of an angle, an angular velocity (the angle of one second) or an angular acceleration. The symbol must exist.
  Angle angle(std::string_view symbol) const;
  // The word. The symbol must exist, and be one with choices.
  const Choice& chosen(std::string_view symbol) const;

  // The number and its unit: that of the given, or one across π from it. None for an instant that no fraction says.
  // The symbol must exist.
  std::optional<geometry::InUnit> reading(std::string_view symbol) const;
  // The number as --set takes it, without the unit: "1/5"; or the word, "left". Empty where there is no reading.
  std::string text(std::string_view symbol) const;

  // Of an angle and an instant that state one thing, the one that was not set. The symbol must exist.
  bool follows(std::string_view symbol) const;
  // The value is not the stated one. The symbol must exist.
  bool is_changed(std::string_view symbol) const;
  // No given was changed, so the source's printed numbers apply.
  bool as_stated() const;
  const std::vector<GivenSpec>& specs() const { return specs_; }

 private:
  struct Value {
    geometry::InUnit reading;
    bool was_set = false;
  };

  std::size_t place(std::string_view symbol) const;
  // Of an angle its instant, of an instant its angle.
  std::optional<std::size_t> partner(std::size_t i) const;
  Angle turned(const TurnedThrough& by) const;
  std::optional<geometry::InUnit> reading_at(std::size_t i) const;
  bool follows_at(std::size_t i) const;

  std::vector<GivenSpec> specs_;
  std::vector<Value> values_;
};

}  // namespace epure
