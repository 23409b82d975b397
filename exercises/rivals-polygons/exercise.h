// Rivals' theorem on the centred slider-crank: velocity and acceleration of B, then of a point G of the coupler, by
// vector polygons that are built one step a picture.
#pragma once

#include "exercises/kit/linkages/slider_crank_instant.h"
#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/proof/exercise.h"
#include "exercises/rivals-polygons/mechanism.h"

namespace epure::rivals_polygons {

// G is the corner of a coupler plate that is flat: AC = |AG|, BC = |l - AG|.
struct Instant {
  SliderCrankInstant crank;
  Rational AG;  // from A towards B; negative: beyond A
};

// Throws BadGivens, in one sentence with the values, as require_drivable.
Instant instant_of(const Givens& givens);

// What the sheets show, in the doubles a drawing takes.
struct Drawn {
  Mechanism mechanism;
  VectorPolygon velocity_of_B, velocity_of_G, acceleration_of_B, acceleration_of_G;
  double omega_2 = 0, omega_3 = 0, alpha_3 = 0;
  Arrow2 a_B_as_printed{0, 0};
};
Drawn drawn(const Instant& instant);

// One sheet each; they add to an empty sheet.
void draw_velocity_of_B(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_velocity_of_G(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_acceleration_of_B(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);
void draw_acceleration_of_G(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request);

}  // namespace epure::rivals_polygons
