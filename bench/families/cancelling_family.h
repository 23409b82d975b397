// Functions whose terms cancel: what a user of plain doubles would have been told, and what is true.
#pragma once

#include "bench/family.h"
#include "geometry/analytic/cancelling_functions.h"

namespace epure::bench {

struct CancellingGivens {
  Rational alpha, n, beta, t;
};

struct Cancelling {
  static constexpr const char* name = "cancelling";
  static constexpr const char* corpus = "cancelling.txt";
  using Givens = CancellingGivens;
  static Givens givens(const CorpusCase& c) {
    const auto given = [&](const char* name) { return c.givens.at(name); };
    return {given("alpha"), given("n"), given("beta"), given("t")};
  }

  template <class T>
  struct On {
    T alpha, n, beta, t;
    explicit On(const Givens& of)
        : alpha(from_rational<T>(of.alpha)),
          n(from_rational<T>(of.n)),
          beta(from_rational<T>(of.beta)),
          t(from_rational<T>(of.t)) {}
  };

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    if constexpr (NumberWithAngles<T>) {
      report("involute", [&] { return analytic::tangent_less_angle(of.alpha); });
      report("logarithms", [&] { return analytic::logarithms_near_one(of.n); });
      report("exponentials", [&] { return analytic::exponentials_over_twice(of.beta, of.t); });
    } else if constexpr (std::is_same_v<T, Exact>) {
      throw LeavesTheTower("an involute function, logarithm or exponential",
                           "una funzione involuta, un logaritmo o un esponenziale");
    } else {
      throw Undecided("an involute function, logarithm or exponential is transcendental",
                      "una funzione involuta, un logaritmo o un esponenziale è trascendente");
    }
  }

  static std::vector<Question> questions(const Givens&) { return {}; }
};

}  // namespace epure::bench
