// Exercise 4 of Pisa's machine design: a bar turns about a hinge O on a body that translates; velocity and
// acceleration of its end A, and its velocity centre.
#pragma once

#include "exercises/kit/panels/coupler_figure.h"
#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/statement/exercise.h"
#include "exercises/velocity-centre/carried_bar.h"

namespace epure::velocity_centre {

std::vector<Printed> printed_by_the_source();

// O is the origin and x the line the body translates along: V and a are positive towards +x, θ, ω and dω/dt
// counter-clockwise. Metres, seconds, radians.
struct Instant {
  Rational L;
  Angle angle;  // θ, of OA from +x
  Angle omega, omega_dot;
  Rational V, a;

  // Special positions, decided exactly.
  bool turns() const { return !is_zero(omega); }
  bool is_upright() const;  // OA square to x: then v_O and v_A are parallel, and one line is normal to both
};
Instant instant_of(const Givens& givens);

// How the velocity centre is found, or why there is none.
enum class Centre {
  by_two_normals,
  by_the_tips,  // both normals are the line OA: it is met by the line through the tips of v_O and v_A
  is_O,         // O rests
  at_infinity,  // the bar translates
  everywhere    // the bar rests
};
Centre centre_of(const Instant& instant);

// What the sheets show, in the doubles a drawing takes.
struct Drawn {
  Instant instant;
  Centre centre;
  CarriedBar bar;
  CouplerFigure motion;  // of O and A; refers to `bar`
  VectorPolygon velocities, accelerations;
  std::optional<double> normal_slope = {};
  const CouplerPoint& O() const { return motion.points[0]; }
  const CouplerPoint& A() const { return motion.points[1]; }
};
// Kept where it is made: the motion refers to the bar.
std::unique_ptr<Drawn> drawn(const Instant& instant);

// One sheet each; they add to an empty sheet.
void draw_velocities(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_accelerations(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_acceleration_pole(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);

}  // namespace epure::velocity_centre
