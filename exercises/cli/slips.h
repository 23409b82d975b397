// Typical slips, by the number they lead to.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/proof/measured.h"

namespace epure {

// Looks for the slip that explains a wrong number. What takes solving again, with givens as a slip would take them,
// is solved when it is first needed, on intervals (what they leave open explains nothing). Not for several threads.
class Slips {
 public:
  // Both must outlive it.
  Slips(const Exercise& exercise, const CheckedExercise& checked) : exercise_(exercise), checked_(checked) {}

  // The slip, in a few words; none: nothing explains the number. A slip scales what a quantity
  // may be off as it scales the number; one that this does not part from a right number is not looked for. In this
  // order: the number that the source
  // printed, when it is wrong; the opposite sense; a power of ten; rpm for rad/s (squared in an acceleration),
  // degrees for radians; twice or half; an angle's complement, an angle in the other unit, a length doubled or
  // halved; another quantity of the unit.
  std::optional<Words> explain(const CheckedQuantity& quantity, const Decimal& number, Allowances& allowances);

 private:
  // The exercise solved with one given mistaken.
  struct Mistaken {
    Words slip;
    std::map<std::string, double> values;
  };
  const std::vector<Mistaken>& mistaken();
  void add_mistaken(const std::string& symbol, const std::string& value, const Words& slip);

  const Exercise& exercise_;
  const CheckedExercise& checked_;
  std::optional<std::vector<Mistaken>> mistaken_;
};

}  // namespace epure
