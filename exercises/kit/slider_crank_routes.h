// The position of the slider-crank and its pole as its two routes find them: by construction and by analysis.
#pragma once

#include "exercises/kit/ledger.h"
#include "exercises/kit/slider_crank.h"
#include "geometry/analytic/slider_crank.h"

namespace epure {

inline constexpr const char* pole_at_infinity = "the pole P₀ is at infinity: the crank is square to the guide";

template <class T>
struct AnalyticSliderCrank {
  geometry::analytic::SliderCrankPosition<T> position;
  geometry::analytic::SliderCrankMotion<T> motion;
};

template <class T>
AnalyticSliderCrank<T> analytic_slider_crank(const SliderCrankInstant& instant) {
  namespace analytic = geometry::analytic;
  const geometry::SliderCrankLengths& of = instant.lengths;
  const analytic::SliderCrank g{of.r, of.l, of.AC, of.BC};
  const auto crank =
      analytic::crank_at<T>(instant.crank, instant.omega_2<T>(), geometry::from_rational<T>(instant.alpha_2));
  const auto position = analytic::position(g, crank);
  return {position, analytic::motion(g, crank, position)};
}

// From complex numbers to what a ledger takes.
template <class T>
geometry::Vector<T> plane(const geometry::analytic::Complex<T>& z) {
  return {z.re, z.im};
}

// The nearest whole number of half turns.
inline Rational half_turns(const geometry::Turn& turn) {
  const Rational shifted = 2 * turn.fraction + Rational(1, 2);
  CGAL::Gmpz floor;
  mpz_fdiv_q(floor.mpz(), shifted.numerator().mpz(), shifted.denominator().mpz());
  return Rational(floor);
}

// The crank angle as a protractor at A0 shows it, whole turns counted: from the half turn nearest to A, so that the
// angle is never taken at its cut.
template <class T>
T crank_angle_seen(const SliderCrankInstant& instant, const geometry::Point<T>& A) {
  if constexpr (signs_only<T>) {
    return geometry::from_rational<T>(instant.crank.fraction);
  } else {
    const Rational halves = half_turns(instant.crank);
    const bool even = mpz_even_p(halves.numerator().mpz()) != 0;
    const T angle = even ? geometry::arc_tangent(A.y, A.x) : geometry::arc_tangent(T(-A.y), T(-A.x));
    return angle + geometry::from_rational<T>(halves) * geometry::pi<T>();
  }
}

// 180 / π degrees in a radian; for signs, any positive number.
template <class T>
T in_degrees(const T& radians) {
  if constexpr (signs_only<T>) {
    return radians;
  } else {
    return geometry::quotient(geometry::from_rational<T>(180) * radians, geometry::pi<T>());
  }
}

// What both exercises on the slider-crank say of the crank and the pole, by construction.
template <class T>
void write_crank(Ledger<T>& ledger, const SliderCrankInstant& instant, const geometry::SliderCrank<T>& at) {
  const T phi = crank_angle_seen(instant, at.A);
  ledger.put("omega_2", [&]() -> T {
    if (instant.t1 == 0) return instant.omega_2<T>();
    return geometry::quotient(phi, geometry::from_rational<T>(instant.t1));
  });
  ledger.put("crank_angle_phi", phi);
  ledger.put("crank_angle_phi_deg", in_degrees(phi));
}

// The same from n and t1.
template <class T>
void write_crank(Ledger<T>& ledger, const SliderCrankInstant& instant) {
  ledger.put("omega_2", instant.omega_2<T>());
  if constexpr (signs_only<T>) {
    ledger.put("crank_angle_phi", geometry::from_rational<T>(instant.crank.fraction));
  } else {
    ledger.put("crank_angle_phi", instant.omega_2<T>() * geometry::from_rational<T>(instant.t1));
  }
  ledger.put("crank_angle_phi_deg", geometry::from_rational<T>(360 * instant.crank.fraction));
}

// The pole and its distances, found by lines.
template <class T>
void write_pole(Ledger<T>& ledger, const geometry::SliderCrank<T>& at) {
  const geometry::ProjectivePoint<T> P0 = at.pole();
  ledger.point("P0", P0, pole_at_infinity);
  ledger.distance("P0A", P0, at.A, pole_at_infinity);
  ledger.distance("P0B", P0, at.B, pole_at_infinity);
  ledger.distance("P0C", P0, at.C, pole_at_infinity);
  ledger.distance("P0M", P0, at.M, pole_at_infinity);
}

// The pole and its distances, z_A + i v_A/ω₃.
template <class T>
void write_pole(Ledger<T>& ledger, const AnalyticSliderCrank<T>& found) {
  const auto& p = found.position;
  // Looked for anew in each entry, so that an undecided one leaves the others alone.
  const auto pole = [&] {
    const auto P0 = geometry::analytic::coupler(p, found.motion).pole();
    if (!P0) throw geometry::Impossible(pole_at_infinity);
    return *P0;
  };
  ledger.put("P0_x", [&] { return pole().re; });
  ledger.put("P0_y", [&] { return pole().im; });
  ledger.put("P0A", [&] { return size(plane(p.A - pole())); });
  ledger.put("P0B", [&] { return size(plane(p.B - pole())); });
  ledger.put("P0C", [&] { return size(plane(p.C - pole())); });
  ledger.put("P0M", [&] { return size(plane(p.M - pole())); });
}

}  // namespace epure
