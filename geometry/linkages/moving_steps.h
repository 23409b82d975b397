// Of carried_out.h: how each kind of step moves its links, by the two polygons of its dyad.
#pragma once

#include "geometry/linkages/carried_out.h"

namespace epure::geometry {

template <class T>
LinkageMotion<T> CarriedOut<T>::at_rest(const LinkagePosition<T>& at) const {
  const Point<T> O{T(0), T(0)};
  LinkageMotion<T> rest{{at.links.size(), turning_about(O, T(0), T(0))}, {at.points.size(), fixed_pin(O)}, {}};
  rest_frame(at, rest);
  return rest;
}

template <class T>
void CarriedOut<T>::rest_frame(const LinkagePosition<T>& at, LinkageMotion<T>& so_far) const {
  for (const CarriedPoint& p : carried_[0].points)
    so_far.points[index(p.point)] = fixed_pin(at.points[index(p.point)]);
}

template <class T>
void CarriedOut<T>::put_motion(int link, const PlaneMotion<T>& motion, const LinkagePosition<T>& at,
                               LinkageMotion<T>& so_far) const {
  so_far.links[index(link)] = motion;
  const auto carry_with_it = [&](const auto& points) {
    for (const auto& p : points) so_far.points[index(p.point)] = pin_on(motion, at.points[index(p.point)]);
  };
  if (at.wanted == Wanted::links)
    carry_with_it(linkage_.links[index(link)].points);
  else
    carry_with_it(carried_[index(link)].points);
}

template <class T>
template <class Use>
auto CarriedOut<T>::with_side(const Rod& rod, const RodNumbers& of, const LinkagePosition<T>& at, const Rates& rates,
                              const LinkageMotion<T>& so_far, const Use& use) const {
  const Pin<T>& P = so_far.points[index(rod.pin)];
  if (rod.link != nothing) return use(Bar<T>{P});
  const DriveAt<T>* there = elsewhere(rod.cylinder, at);
  if (!there && of.exactly && *of.exactly == 0)
    throw Impossible("a cylinder without length points nowhere", "un cilindro senza lunghezza non ha direzione");
  const T over = there ? quotient(T(1), there->way) : of.over_length;
  const DriveRates<T>& rate = rates[index(rod.cylinder)];
  return use(StretchingBar<T>{P, over * rate.first, over * rate.second});
}

template <class T>
void CarriedOut<T>::move_rod(const Rod& rod, const DriveRates<T>& turning, const LinkagePosition<T>& at,
                             LinkageMotion<T>& so_far) const {
  if (rod.link == nothing) return;
  put_motion(rod.link, Bar<T>{so_far.points[index(rod.pin)]}.motion(turning.first, turning.second), at, so_far);
}

template <class T>
void CarriedOut<T>::move_block(const Track& track, const Pin<T>& joint, const LinkagePosition<T>& at,
                               LinkageMotion<T>& so_far) const {
  if (track.block == nothing) return;
  const PlaneMotion<T>& body = so_far.links[index(line(track.line).link)];
  put_motion(track.block, {joint.at, joint.v, joint.a, body.omega, body.alpha}, at, so_far);
}

template <class T>
void CarriedOut<T>::move(const TurnedCrank& step, const LinkagePosition<T>& at, const Rates& rates,
                         LinkageMotion<T>& so_far, StepPolygons<T>*) const {
  const DriveRates<T>& rate = rates[index(step.drive)];
  put_motion(step.link, Bar<T>{so_far.points[index(step.hinge)]}.motion(rate.first, rate.second), at, so_far);
}

template <class T>
void CarriedOut<T>::move(const GearedWheel& step, const LinkagePosition<T>& at, const Rates& rates,
                         LinkageMotion<T>& so_far, StepPolygons<T>*) const {
  T omega(0), alpha(0);
  for (std::size_t k = 0; k < rates.size(); ++k) {
    if (step.turn.times[k] == 0) continue;
    omega += number(step.turn.times[k]) * rates[k].first;
    alpha += number(step.turn.times[k]) * rates[k].second;
  }
  put_motion(step.link, Bar<T>{so_far.points[index(step.hinge)]}.motion(omega, alpha), at, so_far);
}

template <class T>
void CarriedOut<T>::move(const RolledWheel& step, const LinkagePosition<T>& at, const Rates&,
                         LinkageMotion<T>& so_far, StepPolygons<T>*) const {
  const RollingWheel& roll = linkage_.rolls[index(step.roll)];
  const Pin<T>& C = so_far.points[index(roll.centre)];
  const PlaneMotion<T>& body = so_far.links[index(line(roll.line).link)];
  const Vector<T> s = in_plane(roll.line, at).s;
  // The acceleration of Coriolis is square to the line.
  const T over = number(1 / roll.radius), rate = dot(s, C.v - body.velocity(C.at)),
          second = dot(s, C.a - body.acceleration(C.at));
  put_motion(step.link, Bar<T>{C}.motion(body.omega - over * rate, body.alpha - over * second), at, so_far);
}

template <class T>
void CarriedOut<T>::move(const SlidPin& step, const LinkagePosition<T>& at, const Rates& rates,
                         LinkageMotion<T>& so_far, StepPolygons<T>*) const {
  const int guide = std::get<SlidPoint>(linkage_.drives[index(step.drive)]).guide;
  const DriveRates<T>& rate = rates[index(step.drive)];
  const Point<T> X = at.points[index(step.point)];
  const PlaneMotion<T>& body = so_far.links[index(line(guide).link)];
  const Vector<T> s = in_plane(guide, at).s;
  so_far.points[index(step.point)] = {
      X, body.velocity(X) + rate.first * s,
      body.acceleration(X) + ((T(2) * body.omega * rate.first) * quarter_turn(s) + rate.second * s)};
}

template <class T>
void CarriedOut<T>::move(const SlidBlock& step, const LinkagePosition<T>& at, const Rates& rates,
                         LinkageMotion<T>& so_far, StepPolygons<T>*) const {
  move(SlidPin{step.point, step.drive}, at, rates, so_far, nullptr);
  move_block(step.track, so_far.points[index(step.point)], at, so_far);
}

template <class T>
void CarriedOut<T>::move(const TwoRods& step, const LinkagePosition<T>& at, const Rates& rates,
                         LinkageMotion<T>& so_far, StepPolygons<T>* kept) const {
  const Point<T> X = at.points[index(step.joint)];
  const DyadNumbers& of = of_joints_[index(step.joint)];
  const DyadRates both = with_side(step.first, of.first, at, rates, so_far, [&](const auto& first) {
    return with_side(step.second, of.second, at, rates, so_far,
                     [&](const auto& second) { return by_polygons(first, second, X, kept); });
  });
  so_far.points[index(step.joint)] = both.joint;
  move_rod(step.first, both.first, at, so_far);
  move_rod(step.second, both.second, at, so_far);
}

template <class T>
void CarriedOut<T>::move(const RodAndTrack& step, const LinkagePosition<T>& at, const Rates& rates,
                         LinkageMotion<T>& so_far, StepPolygons<T>* kept) const {
  const Point<T> X = at.points[index(step.joint)];
  const Slide<T> on_track = slide(step.track, at, so_far);
  const DyadRates both = with_side(step.rod, of_joints_[index(step.joint)].first, at, rates, so_far,
                                   [&](const auto& rod) { return by_polygons(rod, on_track, X, kept); });
  so_far.points[index(step.joint)] = both.joint;
  move_rod(step.rod, both.first, at, so_far);
  move_block(step.track, both.joint, at, so_far);
}

template <class T>
void CarriedOut<T>::move(const TwoTracks& step, const LinkagePosition<T>& at, const Rates&, LinkageMotion<T>& so_far,
                         StepPolygons<T>* kept) const {
  const Point<T> X = at.points[index(step.joint)];
  const DyadRates both = by_polygons(slide(step.first, at, so_far), slide(step.second, at, so_far), X, kept);
  so_far.points[index(step.joint)] = both.joint;
  move_block(step.first, both.joint, at, so_far);
  move_block(step.second, both.joint, at, so_far);
}

template <class T>
void CarriedOut<T>::move(const SlotOnPin& step, const LinkagePosition<T>& at, const Rates&, LinkageMotion<T>& so_far,
                         StepPolygons<T>* kept) const {
  const Pin<T> P = so_far.points[index(step.pin)];
  const Bar<T> lever{so_far.points[index(step.hinge)]};
  const DyadRates both = by_polygons(lever, PinInSlot<T>{P, in_plane(step.line, at).s}, P.at, kept);
  const PlaneMotion<T> motion = lever.motion(both.first.first, both.first.second);
  put_motion(step.link, motion, at, so_far);
  if (step.block != nothing) put_motion(step.block, {P.at, P.v, P.a, motion.omega, motion.alpha}, at, so_far);
}

template <class T>
void CarriedOut<T>::move(const BlockOnPin& step, const LinkagePosition<T>& at, const Rates&, LinkageMotion<T>& so_far,
                         StepPolygons<T>* kept) const {
  const Pin<T> P = so_far.points[index(step.pin)];
  const Slide<T> on_track = slide(step.track, at, so_far);
  const LineOverPin<T> over{P, in_plane(step.line, at).s, on_track.body.omega};
  const DyadRates both = by_polygons(on_track, over, P.at, kept);
  move_block(step.track, both.joint, at, so_far);
}

template <class T>
void CarriedOut<T>::move(const CrossedBlock& step, const LinkagePosition<T>& at, const Rates&,
                         LinkageMotion<T>& so_far, StepPolygons<T>* kept) const {
  const Slide<T> on_track = slide(step.track, at, so_far);
  const Pin<T>& Q = so_far.points[index(step.hinge)];
  const PlaneMotion<T> hung{Q.at, Q.v, Q.a, on_track.body.omega, on_track.body.alpha};
  put_motion(step.link, hung, at, so_far);
  const Rail crossing = in_plane(step.crossing, at);
  const DyadRates both = by_polygons(on_track, Slide<T>{hung, crossing.s}, crossing.G, kept);
  move_block(step.track, both.joint, at, so_far);
}

}  // namespace epure::geometry
