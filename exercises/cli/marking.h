// Marks for what a class answered.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/answers.h"

namespace epure {

// How marks are given.
struct MarkingRules {
  Ruler ruler;
  std::map<std::string, Rational> points = {};  // by quantity; others: 1
  Rational slip_points = Rational(1, 2);        // of its points, for a wrong number that a slip explains
  std::optional<Rational> out_of = {};          // the mark that all points are; none: points only
};

struct Mark {
  enum Kind {
    right,
    slip,
    wrong,
    none,       // no answer
    not_marked  // there is no true value, or none is known
  } kind = none;
  Words remark = {};  // of what is neither right nor missing: "10.4 m/s, true 5.2 ± 0.13: twice too large"
};

// What a mark gives, 0 for one that is not marked.
Rational points_given(const Mark& mark, const std::string& quantity, const MarkingRules& rules);

struct MarkedStudent {
  std::vector<Mark> marks;        // one for each quantity asked
  Rational points = 0, most = 0;  // what is not marked gives none and costs none
};

// "27.5": of as many as all points are, to a tenth, a half upwards; none of a student of whom nothing is marked.
std::optional<Rational> mark_out_of(const Rational& all, const MarkedStudent& student);

// A quantity's tolerance where a student's givens and scale apply.
struct Tolerance {
  std::string quantity;
  double value, size;
  Words by;
};

struct Marking {
  std::vector<MarkedStudent> students;      // in the order of the answers
  std::vector<Tolerance> tolerances;        // of the first student with givens
  std::vector<Words> undecided = {};        // true values that could not be decided: of which student and quantity
  std::vector<Words> other_key = {};        // where the key's value is not the true one
  std::size_t keyed = 0, contradicted = 0;  // students of whom the key states values; of these, others than true
};

// Each set of givens is solved once, proved, by as many threads as there are processors. Adds remarks to students
// whose givens cannot be.
Marking mark_answers(const Exercise& exercise, Answers& answers, const MarkingRules& rules);

}  // namespace epure
