// The moving plane itself: pole, circles, and the curvature of a path, with the pole near, far and at infinity.
#pragma once

#include "bench/family.h"
#include "geometry/motion/plane_motion.h"

namespace epure::bench {

struct PlaneMotionGivens {
  Rational x_A, y_A, vx_A, vy_A, ax_A, ay_A, omega, alpha;
  Rational x_X, y_X;  // the point whose path is curved

  template <class T>
  PlaneMotion<T> motion() const {
    const auto number = [](const Rational& q) { return from_rational<T>(q); };
    return {{number(x_A), number(y_A)},
            {number(vx_A), number(vy_A)},
            {number(ax_A), number(ay_A)},
            number(omega),
            number(alpha)};
  }
};

// The givens as numbers.
template <class T>
struct PlaneMotionOn {
  PlaneMotion<T> plane;
  Point<T> X;
  explicit PlaneMotionOn(const PlaneMotionGivens& of)
      : plane(of.motion<T>()), X{from_rational<T>(of.x_X), from_rational<T>(of.y_X)} {}
};

inline PlaneMotionGivens plane_motion_givens(const CorpusCase& c) {
  const auto given = [&](const char* name) { return c.givens.at(name); };
  return {given("x_A"),  given("y_A"),   given("vx_A"),  given("vy_A"), given("ax_A"),
          given("ay_A"), given("omega"), given("alpha"), given("x_X"),  given("y_X")};
}

template <class T>
T radius_unless_line(const Cycle<T>& cycle) {
  if (sign(cycle.k) == Sign::zero)
    throw Impossible("the circle has become a line", "la circonferenza è diventata una retta");
  return cycle.radius();
}

// What both families have in common.
struct PlaneMotionCases {
  static constexpr const char* corpus = "plane_motion.txt";
  using Givens = PlaneMotionGivens;
  static Givens givens(const CorpusCase& c) { return plane_motion_givens(c); }

  template <class T>
  using On = PlaneMotionOn<T>;
};

struct PoleAndCircles : PlaneMotionCases {
  static constexpr const char* name = "pole-and-circles";

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const PlaneMotion<T>& plane = of.plane;
    const auto point = [&](const char* x, const char* y, const ProjectivePoint<T>& P) {
      report(x, [&] { return unless_infinite(P).x; });
      report(y, [&] { return unless_infinite(P).y; });
    };
    point("x_P0", "y_P0", plane.pole());
    point("x_K", "y_K", plane.acceleration_pole());
    point("x_J", "y_J", plane.inflection_pole());
    const Cycle<T> inflections = plane.inflection_circle(), stationary = plane.stationarity_circle();
    point("x_inflection", "y_inflection", inflections.centre());
    report("r_inflection", [&] { return radius_unless_line(inflections); });
    point("x_stationarity", "y_stationarity", stationary.centre());
    report("r_stationarity", [&] { return radius_unless_line(stationary); });
  }

  // K has no acceleration and so is on the inflection circle; impossible where it has left the plane.
  static std::vector<Question> questions(const Givens& of) {
    const auto K_on_inflection_circle = [of]<class T>() -> T {
      const PlaneMotion<T> plane = of.motion<T>();
      return plane.inflection_circle().power(unless_infinite(plane.acceleration_pole()));
    };
    return {{"K_on_inflection_circle", [=] { return decided_or_impossible(K_on_inflection_circle); }}};
  }
};

struct Curvature : PlaneMotionCases {
  static constexpr const char* name = "curvature";

  template <class T, class Report>
  static void results(const On<T>& of, Report& report) {
    const Point<T>& X = of.X;
    const ProjectivePoint<T> centre = of.plane.centre_of_curvature(X), X_prime = of.plane.on_inflection_circle(X);
    report("x_centre", [&] { return unless_infinite(centre).x; });
    report("y_centre", [&] { return unless_infinite(centre).y; });
    report("radius", [&] { return distance(X, unless_infinite(centre)); });
    report("x_prime", [&] { return unless_infinite(X_prime).x; });
    report("y_prime", [&] { return unless_infinite(X_prime).y; });
  }

  // Whether X is on the inflection circle (or the pole), and on which side.
  static std::vector<Question> questions(const Givens& of) {
    const auto bend = [of]<class T>() -> T {
      const auto [plane, X] = PlaneMotionOn<T>(of);
      return cross(plane.velocity(X), plane.acceleration(X));
    };
    return {{"bends_to", [=] { return in_words(decide(bend)); }}};
  }
};

}  // namespace epure::bench
