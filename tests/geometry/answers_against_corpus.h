// The answers of an analytic route against a corpus, number by number: what holds for every linkage.
#pragma once

#include "tests/geometry/answers.h"
#include "tests/geometry/reference.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace epure::tests {

// With unit crank speed only what does not depend on the speed is as in the corpus.
inline bool depends_on_speed(const std::string& name) {
  const bool place = name.size() == 3 && (name[2] == 'x' || name[2] == 'y');
  return !place && (name.rfind("omega", 0) == 0 || name.rfind("alpha", 0) == 0 || name[1] == '_');
}

struct Tally {
  int answered = 0, undecided = 0;
};

// Every answer contains its reference, or is undecided where `may_be_undecided(case)`; a case of which nothing can be
// told counts with all its references. `answers_of(case)` gives the answers.
template <class AnswersOf, class MayBeUndecided>
Tally intervals_contain_references(const std::vector<CorpusCase>& corpus, const AnswersOf& answers_of,
                                   const MayBeUndecided& may_be_undecided) {
  const Arithmetic<Bounded> scope;
  Tally tally;
  for (const CorpusCase& c : corpus) {
    if (!closes(c)) continue;
    Answers<Bounded> answers;
    try {
      answers = answers_of(c);
    } catch (const Undecided&) {
      tally.undecided += static_cast<int>(c.references.size());
      continue;
    }
    for (const Reference& r : c.references) {
      CAPTURE(c.name, r.name, r.value);
      const Outcome<Bounded> found = ask(answers, r.name);
      if (found.kind == Kind::undecided) {
        ++tally.undecided;
        CHECK(may_be_undecided(c));
        continue;
      }
      ++tally.answered;
      REQUIRE(found.kind == expected_kind(r.value));
      if (found.kind == Kind::value) CHECK(overlaps(enclosure(*found.value), exact_decimal(r.value)));
    }
  }
  return tally;
}

// Every interval is at most so wide, relative to its value where that is more than 1.
inline void intervals_are_narrow(const CorpusCase& c, const Answers<Bounded>& answers, double width) {
  for (const Reference& r : c.references) {
    const Enclosure e = enclosure(*ask(answers, r.name).value);
    CAPTURE(c.name, r.name, e.lower, e.upper);
    CHECK(e.upper - e.lower <= width * std::max(std::abs(e.value), 1.0));
  }
}

// The largest relative error of doubles, and where it is made.
inline std::pair<double, std::string> worst_of_doubles(const CorpusCase& c, const Answers<Fast>& answers) {
  std::pair<double, std::string> worst{0, "nothing"};
  for (const Reference& r : c.references) {
    const Outcome<Fast> found = ask(answers, r.name);
    if (found.kind != Kind::value || expected_kind(r.value) != Kind::value || r.value == "0") continue;
    worst = std::max(worst, std::pair{std::abs(*found.value / std::stod(r.value) - 1), r.name},
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  return worst;
}

// Exact numbers decide every answer they have; `answers_of(case)` gives them, for unit crank speed. Returns how many.
// One tower for each answer: all the lengths of a scene together are too many roots. Needs an Arithmetic<Deep> scope.
template <class AnswersOf>
int exact_numbers_decide(const CorpusCase& c, const AnswersOf& answers_of) {
  int decided = 0;
  for (const Reference& r : c.references) {
    CAPTURE(c.name, r.name, r.value);
    const Arithmetic<Exact> tower;
    const Answers<Exact> answers = answers_of(c);
    if (answers.count(r.name) == 0) continue;
    const Outcome<Exact> found = ask(answers, r.name);
    REQUIRE(found.kind == expected_kind(r.value));
    if (found.kind == Kind::value && r.value == "0") CHECK(sign(*found.value) == Sign::zero);
    if (found.kind == Kind::value && !depends_on_speed(r.name))
      CHECK(overlaps(to_deep(*found.value), exact_decimal(r.value)));
    ++decided;
  }
  return decided;
}

}  // namespace epure::tests
