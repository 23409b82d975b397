// What the exercises on the slider-crank share: their givens, when these are impossible, and the instant.
#pragma once

#include "exercises/kit/linkages/driving_crank.h"
#include "exercises/kit/statement/givens.h"
#include "geometry/mechanisms/slider_crank.h"
#include "geometry/numbers/numbers.h"

namespace epure {

// r, l, AC, BC in metres, n in rpm, t in seconds or phi in degrees; alpha_2 in rad/s² where the exercise has it; then
// what the source leaves at zero, the guide's offset e in metres and its direction delta in degrees.
std::vector<GivenSpec> slider_crank_givens(bool with_alpha_2);

struct SliderCrankInstant {
  geometry::SliderCrankLengths lengths;
  Angle n;           // of a second
  Angle crank;       // from +x
  Angle guide = {};  // from +x
  Angle alpha_2 = {};

  // Special positions, decided exactly.
  bool pole_at_infinity = false;  // the crank is square to the guide
  bool dead_centre = false;       // crank and coupler in line: the pole is B

  bool is_offset() const { return lengths.e != 0; }
  bool is_inclined() const { return !is_zero(guide); }
  Angle crank_from_guide() const { return crank - guide; }
  // Less than a right angle off the guide's direction.
  bool crank_points_ahead() const;

  template <class T>
  T omega_2() const {
    return crank_speed<T>(n, alpha_2);
  }
  template <class T>
  geometry::SliderCrank<T> position() const {
    return geometry::slider_crank<T>(lengths, direction<T>(crank), direction<T>(guide));
  }
  // On a sheet that is turned until the guide is level. Crank along the guide or square to it is then exactly that in
  // every number, which directions such as 20° and 110° are only to an exact one.
  template <class T>
  geometry::SliderCrank<T> level_position() const {
    return geometry::slider_crank<T>(lengths, direction<T>(crank_from_guide()));
  }
  // A, at its place on the sheet as it lies.
  template <class T>
  geometry::Point<T> crank_pin() const {
    return geometry::Point<T>{T(0), T(0)} + geometry::from_rational<T>(lengths.r) * direction<T>(crank);
  }
  template <class T>
  static geometry::Vector<T> direction(const Angle& angle) {
    return {geometry::cosine<T>(angle), geometry::sine<T>(angle)};
  }
};

// Throws BadGivens, in one sentence with the values, when the plate ABC does not close, and as require_drivable.
SliderCrankInstant slider_crank_instant(const Givens& givens);

// The crank angles from +x, in degrees, between which the linkage closes, from and to in turn: none when it closes
// nowhere or the crank turns fully, else one or two ranges.
std::vector<geometry::Deep> crank_limits(const SliderCrankInstant& at);
std::vector<AngleRange> crank_swings(const SliderCrankInstant& at);

// Decides the special positions. Throws BadGivens, in one sentence with the values, when n = 0, the linkage does not
// close, or the coupler is square to the guide, where the crank cannot drive the slider; Undecided when no number can
// tell.
void require_drivable(SliderCrankInstant& at);

}  // namespace epure
