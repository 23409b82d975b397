// Of carried_out.h: where each kind of step puts its links.
#pragma once

#include "geometry/linkages/carried_out.h"

namespace epure::geometry {

template <class T>
void CarriedOut<T>::place_frame(LinkagePosition<T>& at) const {
  for (const CarriedPoint& p : carried_[0].points) at.points[index(p.point)] = {p.from_pin.x, p.from_pin.y};
}

template <class T>
void CarriedOut<T>::put_points(int link, LinkagePosition<T>& at) const {
  for (const LinkPoint& p : linkage_.links[index(link)].points)
    at.points[index(p.point)] = at.links[index(link)].at(own(link, p.point));
}

template <class T>
void CarriedOut<T>::carry(int link, const Point<T>& P, const Vector<T>& by, LinkagePosition<T>& at) const {
  const Carried& of = carried_[index(link)];
  if (at.wanted == Wanted::links || of.has_lines) {
    PlacedLink<T>& placed = at.links[index(link)];
    placed.x = of.rod ? of.over_squared * linkages::times_mirrored(by, *of.rod) : by;
    placed.O = of.pin ? P + -placed.turned(*of.pin) : P;
  }
  if (at.wanted == Wanted::links) return put_points(link, at);
  for (const CarriedPoint& p : of.points) at.points[index(p.point)] = P + linkages::times(by, p.from_pin);
}

template <class T>
void CarriedOut<T>::put_line(const OwnLine& moving, const Vector<T>& s, const Vector<T>& along, const Point<T>& P,
                             LinkagePosition<T>& at) const {
  const Vector<T> x = linkages::times_mirrored(s, along);
  at.links[index(moving.link)] = {P + -linkages::times(x, moving.through), x};
}

template <class T>
void CarriedOut<T>::put_rod(const Rod& rod, int joint, LinkagePosition<T>& at) const {
  if (rod.link == nothing) return;
  const Point<T> P = at.points[index(rod.pin)];
  carry(rod.link, P, at.points[index(joint)] - P, at);
}

template <class T>
void CarriedOut<T>::put_block(const Track& track, int joint, LinkagePosition<T>& at) const {
  if (track.block == nothing) return;
  put(track.block, in_plane(track.line, at).s, line(track.moving).along, at.points[index(joint)], at);
}

template <class T>
Point<T> CarriedOut<T>::crossing(const Rail& first, const Rail& second) {
  return joint_of_guides(geometry::line(first.G, first.s), geometry::line(second.G, second.s));
}

template <class T>
void CarriedOut<T>::place(const TurnedCrank& step, LinkagePosition<T>& at) const {
  const Angle& angle = std::get<TurnedLink>(linkage_.drives[index(step.drive)]).angle;
  const DriveAt<T>* there = elsewhere(step.drive, at);
  const Vector<T> x =
      there ? linkages::turned_times(there->direction, there->times) : linkages::Constant<T>::direction(angle);
  carry(step.link, at.points[index(step.hinge)], x, at);
}

template <class T>
void CarriedOut<T>::place(const GearedWheel& step, LinkagePosition<T>& at) const {
  Vector<T> x = linkages::Constant<T>::direction(at.elsewhere ? step.turn.rest : angle_of(step.turn, linkage_));
  if (at.elsewhere) {  // of the only drive
    const Rational times = at.elsewhere->times * step.turn.times[index(at.elsewhere->drive)];
    assert(times.denominator() == 1);
    x = linkages::times(x, linkages::turned_times(at.elsewhere->direction, static_cast<int>(CGAL::to_double(times))));
  }
  carry(step.link, at.points[index(step.hinge)], x, at);
}

template <class T>
void CarriedOut<T>::place(const RolledWheel& step, LinkagePosition<T>& at) const {
  const RollingWheel& roll = linkage_.rolls[index(step.roll)];
  const Rail on = in_plane(roll.line, at);
  const Point<T> C = at.points[index(roll.centre)];
  if constexpr (NumberWithSines<T>) {
    const T turned = quotient(number(roll.at) - dot(on.s, C - on.G), number(roll.radius));
    const Vector<T> from =
        linkages::times(at.links[index(line(roll.line).link)].x, linkages::Constant<T>::direction(roll.phase));
    carry(step.link, C, linkages::times(from, {cosine_of_angle(turned), sine_of_angle(turned)}), at);
  } else {
    const Link& wheel = linkage_.links[index(step.link)];
    PlacedLink<T>& placed = at.links[index(step.link)];
    placed = {C, {T(1), T(0)}, false};
    // Nothing of it but its centre, in its own origin, can then be told.
    const Own& centre = wheel.points.front().at;
    if (wheel.points.size() > 1 || !wheel.lines.empty() || centre.x != 0 || centre.y != 0) placed.axis();
  }
}

template <class T>
void CarriedOut<T>::place(const SlidPin& step, LinkagePosition<T>& at) const {
  const auto& drive = std::get<SlidPoint>(linkage_.drives[index(step.drive)]);
  const Rail guide = in_plane(drive.guide, at);
  at.points[index(step.point)] = guide.G + way_slid(step.drive, at) * guide.s;
}

template <class T>
void CarriedOut<T>::place(const SlidBlock& step, LinkagePosition<T>& at) const {
  const Rail on = rail(step.track, step.point, at);
  at.points[index(step.point)] = on.G + way_slid(step.drive, at) * on.s;
  put_block(step.track, step.point, at);
}

template <class T>
void CarriedOut<T>::place(const TwoRods& step, LinkagePosition<T>& at) const {
  const Point<T> P = at.points[index(step.first.pin)], Q = at.points[index(step.second.pin)];
  const DyadNumbers& of = of_joints_[index(step.joint)];
  Point<T>& X = at.points[index(step.joint)];
  if (elsewhere(step.first.cylinder, at) || elsewhere(step.second.cylinder, at)) {
    const T a2 = squared_length(step.first, of.first, at), b2 = squared_length(step.second, of.second, at);
    X = linkages::meet_by_squares<T>(P, a2, Q, a2 - b2, step.side);
  } else if (of.first.exactly && of.second.exactly) {  // by Heron's formula
    X = meet(Circle<T>{P, of.first.length}, Circle<T>{Q, of.second.length}, step.side);
  } else {
    X = linkages::meet_by_squares<T>(P, of.first.squared, Q, of.greater, step.side);
  }
  put_rod(step.first, step.joint, at);
  put_rod(step.second, step.joint, at);
}
template <class T>
void CarriedOut<T>::place(const TwoRods& step, const T& root_of_room, LinkagePosition<T>& at) const {
  const Point<T> P = at.points[index(step.first.pin)];
  const Vector<T> d = at.points[index(step.second.pin)] - P;
  const DyadNumbers& of = of_joints_[index(step.joint)];
  const T greater = squared_length(step.first, of.first, at) - squared_length(step.second, of.second, at);
  at.points[index(step.joint)] = linkages::beside<T>(P, d, length_squared(d) + greater, root_of_room, step.side);
  put_rod(step.first, step.joint, at);
  put_rod(step.second, step.joint, at);
}

template <class T>
void CarriedOut<T>::place(const RodAndTrack& step, LinkagePosition<T>& at) const {
  const Rail on = rail(step.track, step.joint, at);
  const Vector<T> GP = at.points[index(step.rod.pin)] - on.G;
  const T half_chord_squared = linkages::positive_or_zero(
      squared_length(step.rod, of_joints_[index(step.joint)].first, at) - square(cross(on.s, GP)),
      {"whether a rod reaches its guide", "se un'asta raggiunga la sua guida"},
      {"the rod does not reach its guide", "l'asta non raggiunge la sua guida"});
  put_on_track(step, on, root(half_chord_squared), at);
}
template <class T>
void CarriedOut<T>::place(const RodAndTrack& step, const T& root_of_room, LinkagePosition<T>& at) const {
  put_on_track(step, rail(step.track, step.joint, at), root_of_room, at);
}
template <class T>
void CarriedOut<T>::put_on_track(const RodAndTrack& step, const Rail& on, const T& half_chord,
                                 LinkagePosition<T>& at) const {
  const T foot = dot(on.s, at.points[index(step.rod.pin)] - on.G);
  at.points[index(step.joint)] = on.G + (foot + (step.which == Along::ahead ? half_chord : -half_chord)) * on.s;
  put_rod(step.rod, step.joint, at);
  put_block(step.track, step.joint, at);
}

template <class T>
void CarriedOut<T>::place(const TwoTracks& step, LinkagePosition<T>& at) const {
  at.points[index(step.joint)] = crossing(rail(step.first, step.joint, at), rail(step.second, step.joint, at));
  put_block(step.first, step.joint, at);
  put_block(step.second, step.joint, at);
}

template <class T>
void CarriedOut<T>::place(const SlotOnPin& step, LinkagePosition<T>& at) const {
  const Point<T> Q = at.points[index(step.hinge)], P = at.points[index(step.pin)];
  const T right = pin_right_of_hinge(step);
  put_slotted(step, step.is_towards_pin ? slot_direction(Q, P, right) : -slot_direction(Q, P, -right), at);
}
template <class T>
void CarriedOut<T>::place(const SlotOnPin& step, const T& root_of_room, LinkagePosition<T>& at) const {
  const Vector<T> QP = at.points[index(step.pin)] - at.points[index(step.hinge)];
  const T over = quotient(T(1), length_squared(QP)), along = step.is_towards_pin ? root_of_room : -root_of_room;
  put_slotted(step, (over * along) * QP - (over * pin_right_of_hinge(step)) * quarter_turn(QP), at);
}
template <class T>
void CarriedOut<T>::put_slotted(const SlotOnPin& step, const Vector<T>& s, LinkagePosition<T>& at) const {
  put(step.link, s, line(step.line).along, at.points[index(step.hinge)], at);
  if (step.block == nothing) return;
  put(step.block, s, line(step.moving).along, at.points[index(step.pin)], at);
}

template <class T>
void CarriedOut<T>::place(const BlockOnPin& step, LinkagePosition<T>& at) const {
  // The link first where the origin of its line in the guide is; then as far along it as its other line must go.
  const Rail guide = in_plane(step.track.line, at);
  const int link = step.track.block;
  const Vector<T>& along = line(step.track.moving).along;
  put_line(line(step.track.moving), guide.s, along, guide.G, at);
  const Rail own_line = in_plane(step.line, at);
  const Point<T> P = at.points[index(step.pin)];
  put_line(line(step.line), guide.s, along, crossing({own_line.G, guide.s}, {P, own_line.s}), at);
  carry(link, at.links[index(link)].O, at.links[index(link)].x, at);
}

template <class T>
void CarriedOut<T>::place(const CrossedBlock& step, LinkagePosition<T>& at) const {
  const Rail guide = in_plane(step.track.line, at);
  const int block = step.track.block;
  const Vector<T>& along = line(step.track.moving).along;
  put_line(line(step.track.moving), guide.s, along, guide.G, at);
  const Rail first = in_plane(step.crossing, at);
  put(step.link, first.s, line(step.line).along, at.points[index(step.hinge)], at);
  put_line(line(step.crossing), guide.s, along, crossing({first.G, guide.s}, in_plane(step.line, at)), at);
  carry(block, at.links[index(block)].O, at.links[index(block)].x, at);
}

// 16 times the square of the area of the triangle that the rods and their pins make (Heron).
template <class T>
T CarriedOut<T>::room(const TwoRods& step, const LinkagePosition<T>& at) const {
  const DyadNumbers& of = of_joints_[index(step.joint)];
  const T a2 = squared_length(step.first, of.first, at), b2 = squared_length(step.second, of.second, at);
  const T d2 = length_squared(at.points[index(step.second.pin)] - at.points[index(step.first.pin)]);
  return T(4) * d2 * a2 - square(d2 + a2 - b2);
}
template <class T>
T CarriedOut<T>::room(const RodAndTrack& step, const LinkagePosition<T>& at) const {
  const Rail on = rail(step.track, step.joint, at);
  return squared_length(step.rod, of_joints_[index(step.joint)].first, at) -
         square(cross(on.s, at.points[index(step.rod.pin)] - on.G));
}
template <class T>
T CarriedOut<T>::room(const TwoTracks& step, const LinkagePosition<T>& at) const {
  return square(cross(rail(step.first, step.joint, at).s, rail(step.second, step.joint, at).s));
}
template <class T>
T CarriedOut<T>::room(const SlotOnPin& step, const LinkagePosition<T>& at) const {
  return length_squared(at.points[index(step.pin)] - at.points[index(step.hinge)]) - square(pin_right_of_hinge(step));
}

}  // namespace epure::geometry
