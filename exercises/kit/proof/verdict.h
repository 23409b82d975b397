// What to make of a number the source printed. The verdict follows from a rule, not from taste.
#pragma once

#include <optional>
#include <string>

#include "exercises/kit/proof/exercise.h"

namespace epure {

enum class Verdict {
  rounding,  // the value rounds to the printed digits
  reading,   // a number read off a drawing, and no further from the value than one can read
  disagrees
};

// "rounding", "reading", "disagrees".
std::string name(Verdict verdict);

struct PrintedVerdict {
  std::string text, route;
  std::optional<double> difference_percent = {};  // none when the value is zero or there is none
  Verdict verdict = Verdict::disagrees;
  std::optional<Words> explanation = {};  // of a number that disagrees, when the mistaken formula gives it
  bool explanation_holds = true;          // false: the formula given for the mistake does not give the printed number
};

// A text without a sign is a magnitude: sources print the size of a velocity and show its sense in the figure. What
// disagrees with a quantity that does not exist, or is not known, has no difference.
PrintedVerdict judge(const Printed& printed, const geometry::Settled& quantity);

// Whether there is a number at all (certain, enclosed or without bounds).
bool has_value(const geometry::Settled& quantity);

}  // namespace epure
