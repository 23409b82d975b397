#include "exercises/pin-in-slot/figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epure::pin_in_slot {
namespace {

constexpr double quarter = std::numbers::pi / 2;
constexpr double slot_width = 3.5;     // mm: takes the hinge that is its pin
constexpr double mass_radius = 2;      // mm
constexpr double ground_beyond = 9;    // mm of guide on either side of the disc
constexpr double clear_of_pivot = 5;   // mm of guide left out on either side of O
constexpr double shortest_ground = 4;  // mm

double lever_angle(const Drawn& f) { return std::atan2(f.slot.y, f.slot.x); }
Place along_slot(const Drawn& f, double distance) {
  return {f.O.x + distance * f.slot.x, f.O.y + distance * f.slot.y};
}

// The centres of the slot's ends, as distances from O. It is longer than it must be for this one position, but keeps
// clear of O.
struct SlotEnds {
  double near, far;
};
SlotEnds slot_ends(const Drawn& f, const Scale& scale) {
  const double OB = std::hypot(f.B.x, f.B.y), shortest = 9 / scale.mm_per_unit;
  const double half = std::max(0.3 * OB, shortest);
  return {OB - std::min(half, 0.6 * OB), OB + half};
}

void draw_piece_of_ground(Plot& plot, double from_mm, double to_mm, double y_mm) {
  if (to_mm - from_mm > shortest_ground) plot.mark(drawings::Ground{{from_mm, y_mm}, {to_mm, y_mm}});
}

}  // namespace

double radius(const Drawn& f) { return f.B.y; }

void draw_lever(Plot& plot, const Drawn& f) {
  const auto [near, far] = slot_ends(f, plot.scale());
  const double AO = std::hypot(f.A.x, f.A.y);
  plot.segment(along_slot(f, mass_radius / plot.scale().mm_per_unit - AO), along_slot(f, near), Meaning::link);
  plot.mark(drawings::Slot{plot.at(along_slot(f, near)), plot.at(along_slot(f, far)), slot_width});
  const drawings::Path mass = drawings::circle(plot.at(f.A), mass_radius);
  plot.mark(drawings::Area{mass, Meaning::link});
  plot.mark(drawings::Line{mass, Meaning::link});
}

void draw_disc(Plot& plot, const Drawn& f) {
  plot.mark(drawings::Area{drawings::circle(plot.at(f.B), radius(f) * plot.scale().mm_per_unit), Meaning::plate});
  plot.circle(f.B, radius(f), Meaning::link);
}

void draw_ground(Plot& plot, const Drawn& f) {
  const drawings::Point d = plot.at(f.D), o = plot.at(f.O);
  const double half = radius(f) * plot.scale().mm_per_unit + ground_beyond;
  const double left = d.x - half, right = d.x + half;
  draw_piece_of_ground(plot, left, std::min(right, o.x - clear_of_pivot), d.y);
  draw_piece_of_ground(plot, std::max(left, o.x + clear_of_pivot), right, d.y);
}

void draw_sense(Plot& plot, const Place& P, double radius_mm, double middle, double sense, const Named& as) {
  if (sense == 0) return;
  constexpr double half_sweep = 0.65;  // radians
  const double turn = sense > 0 ? half_sweep : -half_sweep;
  plot.mark(drawings::Rotation{plot.at(P), radius_mm, middle - turn, middle + turn, as.meaning});
  const double out = (radius_mm + 1) / plot.scale().mm_per_unit;
  plot.label(as.letters, {P.x + out * std::cos(middle), P.y + out * std::sin(middle)}, P, as.meaning);
}

void draw_mechanism(Plot& plot, const Drawn& f) {
  const double mm = plot.scale().mm_per_unit, R = radius(f), angle = lever_angle(f);
  draw_disc(plot, f);
  draw_ground(plot, f);
  plot.long_segment(f.O, {f.O.x + std::max(f.D.x, 16 / mm), 0}, 2, Meaning::axis);
  plot.long_segment({std::min(f.O.x, f.B.x - R), R}, {f.B.x + R, R}, 6, Meaning::axis);
  draw_lever(plot, f);
  plot.mark(drawings::FixedHinge{plot.at(f.O)});
  plot.hinge(f.B);
  plot.dot(f.D, Meaning::link);

  constexpr double angle_radius = 13, sense_radius = 9;  // mm
  plot.mark(drawings::AngleMark{plot.at(f.O), angle_radius, 0, angle});
  const double out = angle_radius / mm;
  plot.label("$α$", {f.O.x + out * std::cos(angle / 2), f.O.y + out * std::sin(angle / 2)}, f.O);
  draw_sense(plot, f.O, sense_radius, angle + quarter, -f.omega, {"$ω$"});
  if (R * mm > 11) draw_sense(plot, f.B, 0.6 * R * mm, -0.6 * quarter, f.omega_disc, {"$ω_{d}$"});
  plot.small_label("$y = R$", {f.B.x + R + 6 / mm, R}, f.B);
  plot.label("$O$", f.O, f.B);
  plot.label("$A$, $M_{1}$", f.A, f.O);
  plot.label("$B$", f.B, f.O);
  plot.label("$D$", f.D, f.B);
}

void include_lever(Extent& extent, const Scale& scale, const Drawn& f) {
  extent.include(scale, f.A, 8);
  extent.include(scale, f.O, 12);
  extent.include(scale, along_slot(f, slot_ends(f, scale).far), 3);
}

void include_disc(Extent& extent, const Scale& scale, const Drawn& f) {
  const double R = radius(f);
  extent.include(scale, {f.B.x - R, 0}, ground_beyond);
  extent.include(scale, {f.B.x + R, 2 * R}, ground_beyond);
}

Fit fit_mechanism(const Drawn& f, const drawings::Box& room, const SheetRequest& request) {
  return fit_lengths(room, request, 1000 / reach(f), [&](const Scale& scale) {
    Extent extent;
    include_lever(extent, scale, f);
    include_disc(extent, scale, f);
    const double room_for_level = 14;  // mm, for "y = R" at the end of the level
    extent.include(scale.mm_per_unit * (f.B.x + radius(f)) + room_for_level, 0);
    return extent.box();
  });
}

double reach(const Drawn& f) { return std::hypot(f.B.x - f.A.x, f.B.y - f.A.y) + 2 * radius(f); }

}  // namespace epure::pin_in_slot
