// Slider-cranks at and beside their special positions, and the points of their polodes.
#pragma once

#include "bench/families/four_bar_family.h"
#include "geometry/curves/polodes.h"
#include "geometry/mechanisms/slider_crank.h"

namespace epure::bench {

struct SliderCrankGivens {
  SliderCrankLengths lengths;
  CrankDirection crank;
  Heading guide;
  Rational omega_2, alpha_2;
};

inline SliderCrankGivens slider_crank_givens(const CorpusCase& c) {
  const auto given = [&](const char* name) { return c.givens.at(name); };
  return {.lengths = {given("r"), given("l"), given("AC"), given("BC"), given("e")},
          .crank = crank_of(c),
          .guide = {given("x_guide"), given("y_guide")},
          .omega_2 = given("omega_2"),
          .alpha_2 = given("alpha_2")};
}

struct SliderCrankSecondOrder {
  static constexpr const char* name = "slider-crank-second-order";
  static constexpr const char* corpus = "slider_crank.txt";
  using Givens = SliderCrankGivens;
  static Givens givens(const CorpusCase& c) { return slider_crank_givens(c); }

  // A slider-crank reads its lengths itself, for each position.
  template <class T>
  struct On {
    SliderCrankLengths lengths;
    Vector<T> crank, along;
    T omega_2, alpha_2;
    explicit On(const Givens& of)
        : lengths(of.lengths),
          crank(unit_vector<T>(of.crank)),
          along(unit_vector<T>(of.guide)),
          omega_2(from_rational<T>(of.omega_2)),
          alpha_2(from_rational<T>(of.alpha_2)) {}
  };

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const SliderCrank<T> at = slider_crank<T>(of.lengths, of.crank, of.along);
    const SliderCrankMotion<T> motion = slider_crank_motion(at, of.omega_2, of.alpha_2);
    const PlaneMotion<T>& coupler = motion.coupler;
    report("x_B", [&] { return at.B.x; });
    report("y_B", [&] { return at.B.y; });
    report("x_C", [&] { return at.C.x; });
    report("y_C", [&] { return at.C.y; });
    report("omega_3", [&] { return coupler.omega; });
    report("alpha_3", [&] { return coupler.alpha; });
    report("v_B", [&] { return dot(motion.v_B(), of.along); });
    report("a_B", [&] { return dot(motion.a_B(), of.along); });
    const ProjectivePoint<T> P0 = at.pole(), K = coupler.acceleration_pole();
    report("x_P0", [&] { return unless_infinite(P0).x; });
    report("y_P0", [&] { return unless_infinite(P0).y; });
    report("x_K", [&] { return unless_infinite(K).x; });
    report("y_K", [&] { return unless_infinite(K).y; });
    const ProjectivePoint<T> centre = coupler.centre_of_curvature(at.C);
    report("x_centre", [&] { return unless_infinite(centre).x; });
    report("y_centre", [&] { return unless_infinite(centre).y; });
  }

  // Of the crank and of A against the guide, with B needed nowhere: r cos ψ, and l² less A's distance from it
  // squared.
  static std::vector<Question> questions(const Givens& of) {
    const auto crank_ahead = [of]<class T>() -> T { return dot(unit_vector<T>(of.crank), unit_vector<T>(of.guide)); };
    const auto crank_beside = [of]<class T>() -> T {
      return cross(unit_vector<T>(of.guide), unit_vector<T>(of.crank));
    };
    const auto room_to_guide = [of, crank_beside]<class T>() -> T {
      const T height = from_rational<T>(of.lengths.r) * crank_beside.template operator()<T>();
      return from_rational<T>(of.lengths.l * of.lengths.l) - square(height - from_rational<T>(of.lengths.e));
    };
    const auto alpha_3 = [of]<class T>() -> T {
      const SliderCrank<T> at = slider_crank<T>(of.lengths, unit_vector<T>(of.crank), unit_vector<T>(of.guide));
      return slider_crank_motion(at, from_rational<T>(of.omega_2), from_rational<T>(of.alpha_2)).coupler.alpha;
    };
    return {{"coupler_accelerates", [=] { return decided_or_impossible(alpha_3); }},
            {"crank_ahead", [=] { return in_words(decide(crank_ahead)); }},
            {"crank_beside", [=] { return in_words(decide(crank_beside)); }},
            {"room_to_guide", [=] { return in_words(decide(room_to_guide)); }}};
  }
};

// P₀ in the fixed plane, and in the coupler drawn with the crank along the guide: the same text as the drawn polodes.
struct PolodePoint {
  static constexpr const char* name = "polode-point";
  static constexpr const char* corpus = "polodes.txt";
  using Givens = SliderCrankGivens;
  static Givens givens(const CorpusCase& c) { return slider_crank_givens(c); }

  template <class T>
  struct On {
    SliderCrankLoop<T> loop;
    Vector<T> crank;
    explicit On(const Givens& of)
        : loop{.r = from_rational<T>(of.lengths.r),
               .l = from_rational<T>(of.lengths.l),
               .e = from_rational<T>(of.lengths.e)},
          crank(unit_vector<T>(of.crank)) {}
  };

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const CouplerPosition<T> reference = coupler_position(of.loop, Vector<T>{T(1), T(0)});
    const FixedPolode<T> fixed{of.loop};
    const MovingPolode<T> moving{of.loop, reference};
    const ProjectivePoint<T> on_frame = fixed(of.crank), on_coupler = moving(of.crank);
    report("x_fixed", [&] { return unless_infinite(on_frame).x; });
    report("y_fixed", [&] { return unless_infinite(on_frame).y; });
    report("x_moving", [&] { return unless_infinite(on_coupler).x; });
    report("y_moving", [&] { return unless_infinite(on_coupler).y; });
  }

  static std::vector<Question> questions(const Givens&) { return {}; }
};

}  // namespace epure::bench
