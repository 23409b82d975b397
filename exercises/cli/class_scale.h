// One scale of lengths for all sheets of a class.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/variant.h"

namespace epure {

struct ClassScales {
  std::map<std::string, Rational> of_sheets;    // 1/5 for 1 : 5
  std::vector<std::string> too_different = {};  // sheets whose variants no one scale fits well
};

// The largest standard scale at which a sheet fits for all rows of a table of variants, and for two dozen students
// drawn by lot; none where some would have to be more than five times as small as they could be, or where nothing is
// drawn to scale. Of the lots, not of who is in the class: so a student's sheet stays the same when others join.
// (Where there is no variant at all, which is told with the first student, none either.)
ClassScales class_scales(const Lots& lots, const std::vector<Candidate>& students,
                         const std::vector<std::string>& awkward_anyway);

// The one that a sheet has, and that a request could ask for; none: it shows no lengths.
std::optional<Rational> scale_shown(const DrawnSheet& sheet);

// "1:5", "2:1".
std::string scale_in_words(const Rational& scale);

}  // namespace epure
