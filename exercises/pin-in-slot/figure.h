// The slotted lever and the disc as they are drawn.
#pragma once

#include "exercises/kit/panels/fit.h"
#include "exercises/pin-in-slot/exercise.h"

namespace epure::pin_in_slot {

// Of the disc, metres.
double radius(const Drawn& figure);

// The lever with its slot and the mass at A; the disc, which stands behind it.
void draw_lever(Plot& plot, const Drawn& figure);
void draw_disc(Plot& plot, const Drawn& figure);
// The guide, hatched below the disc.
void draw_ground(Plot& plot, const Drawn& figure);

// An arc arrow about P, its middle in the direction `middle` (radians): counter-clockwise for sense > 0, clockwise
// for sense < 0, none for 0.
struct Named {
  std::string letters;
  Meaning meaning = Meaning::link;
};
void draw_sense(Plot& plot, const Place& P, double radius_mm, double middle, double sense, const Named& as);

// All of it with the letters, the pivot at O, the angle α, the level y = R and the senses of rotation.
void draw_mechanism(Plot& plot, const Drawn& figure);

// What these cover at a scale.
void include_lever(Extent& extent, const Scale& scale, const Drawn& figure);
void include_disc(Extent& extent, const Scale& scale, const Drawn& figure);

// The mechanism as large as the room allows.
Fit fit_mechanism(const Drawn& figure, const drawings::Box& room, const SheetRequest& request);

// From end to end, in metres.
double reach(const Drawn& figure);

}  // namespace epure::pin_in_slot
