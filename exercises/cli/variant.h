// The givens that a student of a class gets, drawn by lot.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "exercises/cli/candidate.h"
#include "exercises/cli/variation.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// What a variant is drawn from, and how it is to look.
struct Lots {
  const Exercise& exercise;
  std::vector<std::string> sheets;  // of which none must be awkward
  Givens givens;                    // of all students
  std::vector<Variation> variations;
  std::string seed;
  SheetRequest request;
  std::map<std::string, Rational> scales = {};  // of lengths, by sheet; others: the largest at which a variant fits

  SheetRequest request_of(const std::string& sheet) const;
};

// Why variants were not taken, in English and Italian, and how often.
using Rejections = std::map<std::pair<std::string, std::string>, std::size_t>;

struct Variant {
  std::vector<std::string> assignments;  // what varies, as --set takes it
  Solution solution;
  std::vector<DrawnSheet> solved;  // the sheets with the student's name, one after the other
  Rejections rejected;
};

// What is awkward about the exercise's own givens, at the scale that fits these, is no reason: it is in the nature of
// the exercise.
std::vector<std::string> awkward_as_stated(const Lots& lots);

// The same for the same lots, seed and number, whoever else is in the class. Impossible and awkward ones are drawn
// again, 200 times at most and none twice; a variant without lots is taken as it is, awkward or not. Throws
// BadGivens: there was none.
Variant draw_variant(const Lots& lots, const Candidate& student, const std::vector<std::string>& awkward_anyway);

// Its sheets with the student's name, to be solved or solved, one after the other.
std::vector<DrawnSheet> sheets_of(const Lots& lots, const Solution& solution, const Candidate& student, bool blank);
// What he was given, by what was drawn for him.
Solution solution_of(const Lots& lots, const std::vector<std::string>& assignments);

}  // namespace epure
