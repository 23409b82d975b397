// A family of constructions that is held against a corpus of hard cases: by the tests, and by the bench for its time
// and errors.
//
//   struct SomeFamily {
//     static constexpr const char* name = "some-family";
//     static constexpr const char* corpus = "some_corpus.txt";   // below the folder of the corpora
//     using Givens = ...;                                             // exact
//     static Givens givens(const CorpusCase&);
//     template <class T> struct On { explicit On(const Givens&); };   // the givens as numbers; throws as results
//     does
//     // The construction: reports every result as report("name", [&] { return T; }), the same ones in the same order
//     // for every number and every case. Throws, or lets a computation throw, Undecided or Impossible.
//     template <class T, class Report> static void results(const On<T>&, Report& report);
//     // What is to be decided: none in most families.
//     static std::vector<Question> questions(const Givens&);
//   };
//
// A case of the corpus has a reference for each result: a decimal number of 110 digits or more, or `absent` where it
// does not exist (a pole at infinity). Where nothing exists (a linkage that does not close) it has instead the one
// line `some-family impossible`. The reference of a question is the word of its answer.
#pragma once

#include "bench/corpus.h"
#include "geometry/constructions/plane.h"
#include "geometry/numbers/climb.h"

#include <functional>
#include <string>
#include <vector>

namespace epure::bench {

using namespace geometry;

// One question and the way to its answer: yes, no, negative, zero, positive, impossible or undecided, with the number
// that gave it (climb.h) or the reason why none did.
struct Decided {
  std::string word, rung;
  Words reason;
};
struct Question {
  std::string name;
  std::function<Decided()> ask;
};

inline Decided in_words(const Answer& answer) {
  const char* word = answer.truth == Truth::yes ? "yes" : answer.truth == Truth::no ? "no" : "undecided";
  return {word, answer.rung, answer.reason};
}
inline Decided in_words(const Decision& decision) {
  const Sign sign = decision.sign;
  const char* word = sign == Sign::negative   ? "negative"
                     : sign == Sign::zero     ? "zero"
                     : sign == Sign::positive ? "positive"
                                              : "undecided";
  return {word, decision.rung, decision.reason};
}

// A decision on something that may be proved not to exist: then `impossible`.
template <class Scene>
Decided decided_or_impossible(const Scene& scene) {
  try {
    return in_words(decide(scene));
  } catch (const Impossible& proved) {
    return {"impossible", "", proved.words()};
  }
}

// For a family whose construction takes exact givens.
template <class Givens, class T>
struct Unread {
  Givens givens;
  explicit Unread(const Givens& of) : givens(of) {}
};

// Collects what a family reports, each result with what stood in its way.
template <class T>
struct Readings {
  std::vector<std::string> names = {};
  std::vector<Reading<T>> values = {};

  template <class Computation>
  void operator()(const char* name, const Computation& computation) {
    names.emplace_back(name);
    values.push_back(Reading<T>::from(computation));
  }
};

// All results of one case. Throws Undecided, Impossible or LeavesTheTower when there are none.
template <class Family, class T>
Readings<T> readings(const typename Family::Givens& of) {
  Readings<T> collected;
  Family::template results<T>(typename Family::template On<T>(of), collected);
  return collected;
}

// The scene of climb.h.
template <class Family>
auto scene_of(const typename Family::Givens& of) {
  return [&of]<class T>() { return readings<Family, T>(of).values; };
}

// The point where it is finite. Throws Impossible where it is proved to be at infinity, Undecided as ever.
template <class T>
Point<T> unless_infinite(const ProjectivePoint<T>& P) {
  if (sign(P.w) == Sign::zero) throw Impossible("the point lies at infinity", "il punto è all'infinito");
  return finite(P);
}

}  // namespace epure::bench
