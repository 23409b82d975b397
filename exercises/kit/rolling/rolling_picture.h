// Rolling bodies and the path of the point they carry, on a picture of the fixed plane about the contact.
#pragma once

#include "exercises/kit/panels/fit.h"
#include "exercises/kit/rolling/rolled.h"

namespace epure {

// What is fixed: the line or circle p.
void draw_ground(Plot& plot, const Rolled& f, const drawings::Box& room);
// What rolls: the line or circle π with M.
void draw_body(Plot& plot, const Rolled& f, const drawings::Box& room);
// As far as a rolling line is drawn at this scale: behind the contact, ahead.
std::pair<Place, Place> ends_of_line(const Rolled& f, const Scale& scale);
// The arc arrow of ω: about C, or beside a line. None when the body does not turn.
void draw_sense(Plot& plot, const Rolled& f);
// Ahead of a line from the contact P0 to `end`, turning counter-clockwise (sense > 0) or clockwise; or behind it,
// where accelerations lie ahead.
struct SenseOfLine {
  double sense, share = 0.6;
  bool is_behind = false;
  std::string omega = "ω";
};
void draw_sense_of_line(Plot& plot, const Place& P0, const Place& end, const SenseOfLine& turning);
// Returns how far, in mm of paper, the drawn path may be from the true one, proved.
double draw_path(Plot& plot, const RollingGivens& given, const Way& way, Meaning ink = Meaning::locus);
// Points of the path, as many as show how far it reaches.
std::vector<Place> samples_of_path(const RollingGivens& given, const Way& way);

// What the column tells of a path constructed point by point: its equation, and how near to it the drawn line is.
std::vector<drawings::Block> told_of_curve(const Words& name, const Words& equation, double deviation,
                                           Language language);

// A circle about a point of the plane, with room for letters.
void include_circle(Extent& extent, const Scale& scale, const Place& centre, double radius);

inline constexpr double letters_room = 9;  // mm around a point

}  // namespace epure
