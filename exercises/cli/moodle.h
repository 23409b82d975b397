// Question banks in Moodle's XML: a cloze question a student, with its figures inside.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/variant.h"
#include "exercises/kit/proof/measured.h"

namespace epure {

// The question, the givens and the figures to start from, which sense is positive, then what is asked with a field
// for each number, and what is not asked at these givens. An answer may be as far off as where mark takes it for
// right.
std::string moodle_question(const Exercise& exercise, const Variant& variant, const Lots& lots, const Ruler& ruler);

// As moodle_question made it, under a name.
struct MoodleQuestion {
  std::string name, text;
};
// The whole file. The questions are numbered, so that Moodle's list, which is sorted by name, has them in this order;
// they go to a category of their own below "epure". Plain text.
std::string moodle_quiz(const std::string& category, const std::vector<MoodleQuestion>& questions);

}  // namespace epure
