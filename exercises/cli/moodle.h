// Question banks in Moodle's XML: a cloze question a student, with its figures inside.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/variant.h"

namespace epure {

// The question, the givens and the figures to start from, then what is asked with a field for each number. A number
// that the sheet shows may be off by what `reading` (mm) is worth there; one that is calculated, by as large a part
// of it as the coarsest number that the sheet shows.
std::string moodle_question(const Exercise& exercise, const Candidate& student, const Variant& variant,
                            const Lots& lots, double reading);

// The whole file.
std::string moodle_quiz(const std::vector<std::string>& questions);

}  // namespace epure
