// Reading names, and what to say when one is not known.
#pragma once

#include <string>
#include <vector>

#include "words/words.h"

namespace epure {

// "did you mean omega_3?" for the known names that `wrong` begins, or that are nearest to it (at most three); when
// none is near, "known are: " and the names, or the first of them when there are many. No full stop and no capital:
// the end of a sentence.
Words did_you_mean(const std::string& wrong, const std::vector<std::string>& known);

// Those names, the nearest first; none when none is near.
std::vector<std::string> near_names(const std::string& wrong, const std::vector<std::string>& known);

// Without capitals: A to Z only, as names have no others.
std::string lower_case(std::string text);

// "a, b or c".
Words alternatives(const std::vector<std::string>& names);

}  // namespace epure
