// Points of a four-bar's coupler curve, with cusps and inflections.
#pragma once

#include "bench/families/four_bar_family.h"
#include "geometry/curves/four_bar_loci.h"

namespace epure::bench {

struct CouplerCurvePoint {
  static constexpr const char* name = "coupler-curve-point";
  static constexpr const char* corpus = "coupler_curve.txt";
  using Givens = FourBarGivens;
  static Givens givens(const CorpusCase& c) { return four_bar_givens(c); }

  // The curve reads its givens itself, for each point.
  template <class T>
  struct On : FourBarOn<T> {
    FourBarCouplerCurve curve;
    explicit On(const Givens& of)
        : FourBarOn<T>(of), curve{of.lengths, of.branch, of.along * of.lengths.AB, of.across * of.lengths.AB} {}
  };

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const ProjectivePoint<T> on_curve = of.curve(of.crank);
    report("x_C", [&] { return finite(on_curve).x; });
    report("y_C", [&] { return finite(on_curve).y; });
    const FourBar<T> at = of.position();
    const PlaneMotion<T> coupler = of.motion(at).coupler;
    const Point<T> C = of.C(at);
    const Vector<T> v = coupler.velocity(C);
    const T bend = cross(v, coupler.acceleration(C));
    report("v_x", [&] { return v.x; });
    report("v_y", [&] { return v.y; });
    report("bend", [&] { return bend; });  // v x a: zero at inflections and cusps
    report("radius", [&] { return radius_of_curvature(v, bend); });
  }

  // Whether C is at an inflection or a cusp of its path, and on which side of it.
  static std::vector<Question> questions(const Givens& of) {
    const auto bend = [of]<class T>() -> T {
      const FourBarOn<T> linkage(of);
      const FourBar<T> at = linkage.position();
      const PlaneMotion<T> coupler = linkage.motion(at).coupler;
      const Point<T> C = linkage.C(at);
      return cross(coupler.velocity(C), coupler.acceleration(C));
    };
    return {{"bends_to", [=] { return in_words(decide(bend)); }}};
  }

 private:
  template <class T>
  static T radius_of_curvature(const Vector<T>& v, const T& bend) {
    if (sign(bend) == Sign::zero)
      throw Impossible("the path has an inflection or a cusp there", "lì la traiettoria ha un flesso o una cuspide");
    const T speed2 = length_squared(v);
    return quotient(speed2 * root(speed2), absolute(bend));
  }
};

}  // namespace epure::bench
