// Four-bar linkages at and beside their special positions.
#pragma once

#include "bench/family.h"
#include "geometry/mechanisms/four_bar_questions.h"

namespace epure::bench {

struct FourBarGivens {
  FourBarLengths lengths;
  CrankDirection crank;
  Side branch;
  Rational omega_2, alpha_2;  // rad/s, rad/s²
  Rational along, across;     // C: along AB from A, and to its left, in parts of AB
};

inline Side side_in_words(const std::string& word) {
  if (word != "left" && word != "right") throw std::runtime_error("no side: " + word);
  return word == "left" ? Side::left : Side::right;
}

// The given `turn`, or else the heading (x_crank, y_crank).
inline CrankDirection crank_of(const CorpusCase& c) {
  if (const auto turn = c.givens.find("turn"); turn != c.givens.end()) return Turn{turn->second};
  return Heading{c.givens.at("x_crank"), c.givens.at("y_crank")};
}

inline FourBarGivens four_bar_givens(const CorpusCase& c) {
  const auto given = [&](const char* name) { return c.givens.at(name); };
  return {.lengths = {given("A0A"), given("AB"), given("B0B"), given("x_B0"), given("y_B0")},
          .crank = crank_of(c),
          .branch = side_in_words(c.choices.at("branch")),
          .omega_2 = given("omega_2"),
          .alpha_2 = given("alpha_2"),
          .along = given("along"),
          .across = given("across")};
}

// The givens as numbers.
template <class T>
struct FourBarOn {
  FourBarBars<T> bars;
  Vector<T> crank;
  Side branch;
  T omega_2, alpha_2, along, across;

  explicit FourBarOn(const FourBarGivens& of)
      : bars(of.lengths),
        crank(unit_vector<T>(of.crank)),
        branch(of.branch),
        omega_2(from_rational<T>(of.omega_2)),
        alpha_2(from_rational<T>(of.alpha_2)),
        along(from_rational<T>(of.along)),
        across(from_rational<T>(of.across)) {}

  FourBar<T> position() const { return four_bar(bars, crank, branch); }
  FourBarMotion<T> motion(const FourBar<T>& at) const { return four_bar_motion(at, omega_2, alpha_2); }
  // C, carried by the coupler.
  Point<T> C(const FourBar<T>& at) const {
    const Vector<T> AB = at.B - at.A;
    return at.A + (along * AB + across * quarter_turn(AB));
  }
};

// What both families have in common.
struct FourBarCases {
  static constexpr const char* corpus = "four_bar.txt";
  using Givens = FourBarGivens;
  static Givens givens(const CorpusCase& c) { return four_bar_givens(c); }
  template <class T>
  using On = FourBarOn<T>;
};

struct FourBarPosition : FourBarCases {
  static constexpr const char* name = "four-bar-position";

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const FourBar<T> at = of.position();
    const Vector<T> AB = at.B - at.A, B0B = at.B - at.B0;
    report("x_B", [&] { return at.B.x; });
    report("y_B", [&] { return at.B.y; });
    // sin μ of the transmission angle
    report("transmission", [&] { return quotient(cross(AB, B0B), of.bars.AB * of.bars.B0B); });
  }

  static std::vector<Question> questions(const Givens& of) {
    const auto truth = [](const char* question, auto ask) {
      return Question{question, [ask] { return in_words(ask()); }};
    };
    return {
        truth("is_dead_centre_extended",
              [of] { return is_dead_centre(of.lengths, of.crank, of.branch, Reach::extended); }),
        truth("is_dead_centre_folded",
              [of] { return is_dead_centre(of.lengths, of.crank, of.branch, Reach::folded); }),
        truth("is_parallel_same", [of] { return is_parallel(of.lengths, of.crank, of.branch, Sense::same); }),
        truth("is_parallel_opposite", [of] { return is_parallel(of.lengths, of.crank, of.branch, Sense::opposite); }),
        truth("is_limit_extended", [of] { return is_crank_limit(of.lengths, of.crank, Reach::extended); }),
        truth("is_limit_folded", [of] { return is_crank_limit(of.lengths, of.crank, Reach::folded); }),
        truth("is_change_point", [of] { return is_change_point(of.lengths, of.crank); })};
  }
};

struct FourBarSecondOrder : FourBarCases {
  static constexpr const char* name = "four-bar-second-order";

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const FourBar<T> at = of.position();
    const FourBarMotion<T> motion = of.motion(at);
    const PlaneMotion<T>& coupler = motion.coupler;
    report("omega_3", [&] { return coupler.omega; });
    report("omega_4", [&] { return motion.rocker.omega; });
    report("alpha_3", [&] { return coupler.alpha; });
    report("alpha_4", [&] { return motion.rocker.alpha; });
    const ProjectivePoint<T> P0 = at.pole(), K = coupler.acceleration_pole();
    report("x_P0", [&] { return unless_infinite(P0).x; });
    report("y_P0", [&] { return unless_infinite(P0).y; });
    report("x_K", [&] { return unless_infinite(K).x; });
    report("y_K", [&] { return unless_infinite(K).y; });
    const ProjectivePoint<T> centre = coupler.centre_of_curvature(of.C(at));
    report("x_centre", [&] { return unless_infinite(centre).x; });
    report("y_centre", [&] { return unless_infinite(centre).y; });
  }

  // Whether coupler and rocker turn, and which way: with B, and so with the roots that find it.
  static std::vector<Question> questions(const Givens& of) {
    const auto omega_3 = [of]<class T>() -> T { return coupler_and_rocker<T>(of).coupler.omega; };
    const auto omega_4 = [of]<class T>() -> T { return coupler_and_rocker<T>(of).rocker.omega; };
    return {{"coupler_turns", [=] { return decided_or_impossible(omega_3); }},
            {"rocker_turns", [=] { return decided_or_impossible(omega_4); }}};
  }

 private:
  template <class T>
  static FourBarMotion<T> coupler_and_rocker(const Givens& of) {
    const On<T> linkage(of);
    return linkage.motion(linkage.position());
  }
};

}  // namespace epure::bench
