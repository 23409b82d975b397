// The full second-order analysis of one position of a four-bar or slider-crank: where its joints are, velocities and
// accelerations of coupler and driven link, pole, acceleration pole, and centre of curvature of the path of a point C
// of the coupler. Put together from the constructions, for sweeps over many positions.
//
// Metres, radians, seconds; counter-clockwise positive; A₀ is the origin.
#pragma once

#include "geometry/mechanisms/four_bar.h"
#include "geometry/mechanisms/slider_crank.h"

#include <span>

// A function with everything it calls inlined: as functions of their own the constructions pass their numbers through
// memory, at half the speed. Not with a sanitiser, whose checks make such a function take more than ten minutes to
// compile.
#ifdef __SANITIZE_ADDRESS__
#define EPURE_ALL_INLINED gnu::noinline
#else
#define EPURE_ALL_INLINED gnu::flatten, gnu::noinline
#endif

namespace epure::geometry {

template <class T>
struct SecondOrder {
  Point<T> A, B, C;
  T omega_3, alpha_3;                      // of the coupler
  T driven_velocity, driven_acceleration;  // ω₄, α₄ of the rocker; v_B, a_B of the slider along its guide
  Point<T> P0, K, centre;                  // centre of curvature of the path of C
};

template <class T>
struct CouplerRates {
  PlaneMotion<T> coupler;
  T driven_velocity, driven_acceleration;
};

// A point of the coupler, along AB from A and across to its left, in parts of AB.
template <class T>
struct CouplerShares {
  T along, across;

  Point<T> operator()(const Point<T>& A, const Point<T>& B) const {
    const Vector<T> AB = B - A;
    return A + (along * AB + across * quarter_turn(AB));
  }
};

// A four-bar with its crank driven. B stays on the named side of A -> B₀.
struct DrivenFourBar {
  FourBarLengths lengths;
  Side side;
  Rational omega_2, alpha_2;
  Rational along, across;  // C, in parts of AB

  // The givens as numbers, read once.
  template <class T>
  class On {
   public:
    explicit On(const DrivenFourBar& of)
        : bars_(of.lengths),
          side_(of.side),
          omega_2_(from_rational<T>(of.omega_2)),
          alpha_2_(from_rational<T>(of.alpha_2)),
          C_{from_rational<T>(of.along), from_rational<T>(of.across)} {}

    // The crank along a unit vector. Errors as four_bar.
    FourBar<T> position(const Vector<T>& crank) const { return four_bar(bars_, crank, side_); }
    Point<T> C(const FourBar<T>& at) const { return C_(at.A, at.B); }
    // Errors as four_bar_motion.
    CouplerRates<T> rates(const FourBar<T>& at) const {
      const FourBarMotion<T> motion = four_bar_motion(at, omega_2_, alpha_2_);
      return {motion.coupler, motion.rocker.omega, motion.rocker.alpha};
    }

   private:
    FourBarBars<T> bars_;
    Side side_;
    T omega_2_, alpha_2_;
    CouplerShares<T> C_;
  };
};

// A slider-crank with its crank driven and its guide along +x; C as its lengths say.
struct DrivenSliderCrank {
  SliderCrankLengths lengths;
  Rational omega_2, alpha_2;

  template <class T>
  class On {
   public:
    explicit On(const DrivenSliderCrank& of)
        : bars_(of.lengths),
          guide_(guide_of_slider_crank(bars_.e, Vector<T>{T(1), T(0)})),
          omega_2_(from_rational<T>(of.omega_2)),
          alpha_2_(from_rational<T>(of.alpha_2)),
          C_(shares(of.lengths)),
          M_{from_rational<T>(Rational(1, 2)), T(0)} {}

    // Errors as slider_crank.
    SliderCrank<T> position(const Vector<T>& crank) const {
      const Point<T> A0{T(0), T(0)}, A = A0 + bars_.r * crank, B = slider_pin(bars_, A0, A, guide_);
      return {A0, A, B, C_(A, B), M_(A, B), guide_};
    }
    Point<T> C(const SliderCrank<T>& at) const { return at.C; }
    // Errors as slider_crank_motion.
    CouplerRates<T> rates(const SliderCrank<T>& at) const {
      const SliderCrankMotion<T> motion = slider_crank_motion(at, omega_2_, alpha_2_);
      return {motion.coupler, motion.velocity.second_rate, motion.acceleration.second_rate};
    }

   private:
    // The plate drawn once, with AB along +x.
    static CouplerShares<T> shares(const SliderCrankLengths& of) {
      const T l = from_rational<T>(of.l);
      const Point<T> C = plate_corner(Point<T>{T(0), T(0)}, Point<T>{l, T(0)}, of);
      return {quotient(C.x, l), quotient(C.y, l)};
    }

    SliderCrankBars<T> bars_;
    Line<T> guide_;
    T omega_2_, alpha_2_;
    CouplerShares<T> C_, M_;
  };
};

// With the crank along a unit vector; `of` is a DrivenFourBar::On<T> or DrivenSliderCrank::On<T>. Throws Impossible
// when the linkage does not close or stands at a limit position of the crank, Undecided when that cannot be told, and
// when P₀, K or the centre may be at infinity.
template <class T, class Linkage>
SecondOrder<T> second_order(const Linkage& of, const Vector<T>& crank) {
  const auto at = of.position(crank);
  const CouplerRates<T> rates = of.rates(at);
  const PlaneMotion<T>& coupler = rates.coupler;
  const Point<T> C = of.C(at);
  return {at.A,
          at.B,
          C,
          coupler.omega,
          coupler.alpha,
          rates.driven_velocity,
          rates.driven_acceleration,
          finite(at.pole()),
          finite(coupler.acceleration_pole()),
          finite(coupler.centre_of_curvature(C))};
}

// The plain loop, one position after the other: what the speed of a sweep is compared with. Errors as second_order,
// at the first position that has one.
template <class T, class Driven>
[[EPURE_ALL_INLINED]] void second_order_one_by_one(const Driven& driven, std::span<const Vector<T>> cranks,
                                                   std::span<SecondOrder<T>> results) {
  const typename Driven::template On<T> of(driven);
  for (std::size_t i = 0; i < cranks.size(); ++i) results[i] = second_order(of, cranks[i]);
}

}  // namespace epure::geometry
