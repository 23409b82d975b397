// A linkage placed and moved by ruler and compass, step after step (assur_groups.h), on any number. Metres, radians,
// seconds; counter-clockwise positive.
#pragma once

#include <cassert>
#include <optional>
#include <vector>

#include "geometry/linkages/assur_groups.h"
#include "geometry/linkages/linkage_at_place.h"
#include "geometry/linkages/ruler_and_compass.h"

namespace epure::geometry {

// The rod of changing length as a side of a dyad: v_P + l'/l PX + ω k x PX; l' and l'' over l are given.
template <class T>
struct StretchingBar {
  Pin<T> P;
  T first_rate, second_rate;  // l'/l, l''/l

  Vector<T> direction(const Point<T>& X) const { return quarter_turn(X - P.at); }
  Vector<T> known_velocity(const Point<T>& X) const { return P.v + first_rate * (X - P.at); }
  AccelerationTerms<T> known_acceleration(const Point<T>& X, const T& omega, const T&) const {
    const Vector<T> PX = X - P.at, none{T(0), T(0)};
    return {P.a + second_rate * PX, -(square(omega) * PX), (T(2) * omega * first_rate) * quarter_turn(PX), none};
  }
};

// A link of known angular velocity whose line runs over a pin: the link's point there leaves the pin along the line.
template <class T>
struct LineOverPin {
  Pin<T> P;
  Vector<T> along;
  T omega;  // of the line

  Vector<T> direction(const Point<T>&) const { return -along; }
  Vector<T> known_velocity(const Point<T>&) const { return P.v; }
  AccelerationTerms<T> known_acceleration(const Point<T>&, const T& u, const T&) const {
    const Vector<T> none{T(0), T(0)};
    return {P.a, none, -((T(2) * omega * u) * quarter_turn(along)), none};
  }
};

// The numbers of a linkage, read once for many positions. One after the other they cost least as points alone,
// written into what the caller keeps, by a function of the caller's with all of it inlined (as in
// mechanisms/second_order.h).
template <class T>
class CarriedOut {
 public:
  CarriedOut(const Linkage& linkage, const std::vector<Step>& steps);

  // With the drives as they stand, but for one that is elsewhere. Throws NotClosed, Undecided when that cannot be
  // told.
  LinkagePosition<T> position(const std::optional<DriveAt<T>>& elsewhere = {}) const {
    return position_before(steps_.size(), elsewhere);
  }
  // The same, written over a position of this linkage that the caller keeps (at first that before the first step): it
  // says what is wanted and where the drive is. When it throws, what is kept is no place; the next call writes all of
  // it.
  void place_all(LinkagePosition<T>& at) const;
  // What the steps before this one place.
  LinkagePosition<T> position_before(std::size_t step, const std::optional<DriveAt<T>>& elsewhere = {},
                                     const std::optional<RoomTold<T>>& told = {}) const;
  // How far left of a line a point is.
  T left_in_plane(int line, int point, const LinkagePosition<T>& at) const {
    const Rail on = in_plane(line, at);
    return cross(on.s, at.points[index(point)] - on.G);
  }
  // How far a step is from its limit, where the steps before it are placed: positive where there is room to move,
  // zero at a dead centre or change point, where the joints do not tell how its links move, negative where it does
  // not close.
  T from_limit(std::size_t step, const LinkagePosition<T>& at) const {
    return std::visit([&](const auto& s) { return room(s, at); }, steps_[step]);
  }
  // Throws NotClosed where a group is at a limit (its polygon does not close), Undecided when that cannot be told.
  // `rates`: as the drives of the linkage.
  LinkageMotion<T> motion(const LinkagePosition<T>& at, const std::vector<DriveRates<T>>& rates) const;
  LinkageMotion<T> at_rest(const LinkagePosition<T>& at) const;
  // The same as `motion` without the polygons, written over a motion of this linkage (at first that at rest).
  void move_all(LinkageMotion<T>& motion, const LinkagePosition<T>& at,
                const std::vector<DriveRates<T>>& rates) const;
  std::vector<DriveRates<T>> rates() const;

 private:
  struct OwnLine {
    int link;
    Vector<T> through, along;
  };
  // What a rod and its joint are read as: the distance of the joint from the pin, and its square.
  struct RodNumbers {
    std::optional<Rational> exactly = {};  // the distance, where it is rational
    Rational exactly_squared = 0;
    T length{0}, squared{0}, over_length{0};  // the last one of a cylinder
  };
  // Of the rods of a step that places a joint: by how much the first one's square is the greater.
  struct DyadNumbers {
    RodNumbers first = {}, second = {};
    T greater{0};
  };
  // A link is placed where its pin is (of the frame and of a block on a pin: its origin), by the vector that its x
  // axis is, or, of a rod, that to its joint.
  struct CarriedPoint {
    int point;
    Vector<T> from_pin;  // in parts of that vector, as complex numbers
  };
  struct Carried {
    std::vector<CarriedPoint> points = {};  // that no step places before
    std::optional<Vector<T>> pin = {};      // none: it lies in the origin
    std::optional<Vector<T>> rod = {};      // in the link's own axes
    T over_squared{0};                      // of the rod
    bool has_lines = false;
  };
  // A line in the plane, and where it is cut.
  struct Rail {
    Point<T> G;
    Vector<T> s;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const Vector<T>& own(int link, int point) const { return own_[index(link)][index(point)]; }
  const OwnLine& line(int l) const { return lines_[index(l)]; }
  T number(const Rational& q) const { return from_rational<T>(q); }

  template <class Do>
  static void at_step(std::size_t step, const Do& carry_out) {
    try {
      carry_out();
    } catch (const Impossible& why) {
      throw NotClosed(step, why.words());
    }
  }

  void read_carried(const Hung& hung, std::vector<bool>& is_placed);

  // Placing.
  void place_frame(LinkagePosition<T>& at) const;
  void place(const TurnedCrank& step, LinkagePosition<T>& at) const;
  void place(const GearedWheel& step, LinkagePosition<T>& at) const;
  void place(const RolledWheel& step, LinkagePosition<T>& at) const;
  void place(const SlidBlock& step, LinkagePosition<T>& at) const;
  void place(const SlidPin& step, LinkagePosition<T>& at) const;
  void place(const TwoRods& step, LinkagePosition<T>& at) const;
  void place(const RodAndTrack& step, LinkagePosition<T>& at) const;
  void place(const TwoTracks& step, LinkagePosition<T>& at) const;
  void place(const SlotOnPin& step, LinkagePosition<T>& at) const;
  void place(const BlockOnPin& step, LinkagePosition<T>& at) const;
  void place(const CrossedBlock& step, LinkagePosition<T>& at) const;
  // By the root of its room.
  void place(const TwoRods& step, const T& root_of_room, LinkagePosition<T>& at) const;
  void place(const RodAndTrack& step, const T& root_of_room, LinkagePosition<T>& at) const;
  void place(const SlotOnPin& step, const T& root_of_room, LinkagePosition<T>& at) const;
  template <class Other>
  void place(const Other& step, const T&, LinkagePosition<T>& at) const {
    place(step, at);
  }

  T room(const TwoRods& step, const LinkagePosition<T>& at) const;
  T room(const RodAndTrack& step, const LinkagePosition<T>& at) const;
  T room(const TwoTracks& step, const LinkagePosition<T>& at) const;
  T room(const SlotOnPin& step, const LinkagePosition<T>& at) const;
  // The others have no limit, whatever their place.
  template <class Other>
  T room(const Other&, const LinkagePosition<T>&) const {
    return T(1);
  }

  Rail in_plane(int l, const LinkagePosition<T>& at) const;
  // Of the joint on the track.
  Rail rail(const Track& track, int joint, const LinkagePosition<T>& at) const;
  // How far left of the line the point lies, in the link's own axes.
  T left_of(int l, int point) const;
  // Where the drive is, if it is not where the linkage says.
  static const DriveAt<T>* elsewhere(int drive, const LinkagePosition<T>& at) {
    return at.elsewhere && drive != nothing && at.elsewhere->drive == drive ? &*at.elsewhere : nullptr;
  }
  T way_slid(int drive, const LinkagePosition<T>& at) const {
    if (const DriveAt<T>* there = elsewhere(drive, at)) return there->way;
    return number(std::get<SlidPoint>(linkage_.drives[index(drive)]).at);
  }
  T squared_length(const Rod& rod, const RodNumbers& of, const LinkagePosition<T>& at) const {
    if (const DriveAt<T>* there = elsewhere(rod.cylinder, at)) return square(there->way);
    return of.squared;
  }
  RodNumbers numbers_of(const Rod& rod, int joint) const;
  void put_points(int link, LinkagePosition<T>& at) const;
  // A link with its pin in P, by the vector that places it (see Carried).
  void carry(int link, const Point<T>& P, const Vector<T>& by, LinkagePosition<T>& at) const;
  // One whose own unit vector `along` points in the direction s.
  void put(int link, const Vector<T>& s, const Vector<T>& along, const Point<T>& P, LinkagePosition<T>& at) const {
    carry(link, P, linkages::times_mirrored(s, along), at);
  }
  // One that nothing is carried with yet, with this point of a line of its own in P.
  void put_line(const OwnLine& moving, const Vector<T>& s, const Vector<T>& along, const Point<T>& P,
                LinkagePosition<T>& at) const;
  void put_rod(const Rod& rod, int joint, LinkagePosition<T>& at) const;
  void put_block(const Track& track, int joint, LinkagePosition<T>& at) const;
  // How much farther left of the line the pin lies than the hinge: so far right of it, seen from there.
  T pin_right_of_hinge(const SlotOnPin& step) const {
    return (step.block == nothing ? T(0) : left_of(step.moving, step.pin)) - left_of(step.line, step.hinge);
  }
  void put_slotted(const SlotOnPin& step, const Vector<T>& s, LinkagePosition<T>& at) const;
  void put_on_track(const RodAndTrack& step, const Rail& on, const T& half_chord, LinkagePosition<T>& at) const;
  static Point<T> crossing(const Rail& first, const Rail& second);

  // Moving.
  using Rates = std::vector<DriveRates<T>>;
  // The polygons are written into the last, of steps that have any, unless it is null.
  void move(const TurnedCrank&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const GearedWheel&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const RolledWheel&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const SlidBlock&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const SlidPin&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const TwoRods&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const RodAndTrack&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const TwoTracks&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const SlotOnPin&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const BlockOnPin&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;
  void move(const CrossedBlock&, const LinkagePosition<T>&, const Rates&, LinkageMotion<T>&, StepPolygons<T>*) const;

  void rest_frame(const LinkagePosition<T>& at, LinkageMotion<T>& so_far) const;
  void put_motion(int link, const PlaneMotion<T>& motion, const LinkagePosition<T>& at,
                  LinkageMotion<T>& so_far) const;
  // Calls `use` with the rod as a side of a dyad, a Bar or a StretchingBar.
  template <class Use>
  auto with_side(const Rod& rod, const RodNumbers& of, const LinkagePosition<T>& at, const Rates& rates,
                 const LinkageMotion<T>& so_far, const Use& use) const;
  void move_rod(const Rod& rod, const DriveRates<T>& turning, const LinkagePosition<T>& at,
                LinkageMotion<T>& so_far) const;
  Slide<T> slide(const Track& track, const LinkagePosition<T>& at, const LinkageMotion<T>& so_far) const {
    return {so_far.links[index(line(track.line).link)], in_plane(track.line, at).s};
  }
  // The block goes with its joint and turns with its guide.
  void move_block(const Track& track, const Pin<T>& joint, const LinkagePosition<T>& at,
                  LinkageMotion<T>& so_far) const;
  // What the two polygons of a dyad tell.
  struct DyadRates {
    DriveRates<T> first, second;
    Pin<T> joint;
  };
  template <class First, class Second>
  static DyadRates by_polygons(const First& first, const Second& second, const Point<T>& X, StepPolygons<T>* kept) {
    const DyadVelocity<T> v = dyad_velocity(first, second, X);
    const DyadAcceleration<T> a = dyad_acceleration(first, second, X, v);
    if (kept) *kept = {v, a};
    DyadRates both{{v.first_rate, a.first_rate}, {v.second_rate, a.second_rate}, {X, v.v_X, a.a_X}};
    // By its guide a joint moves along one that rests, and not only nearly: of an upright one its v_x is zero.
    if constexpr (std::is_same_v<Second, Slide<T>>) {
      both.joint.v = v.second.known + v.second.closing;
      both.joint.a = a.second.known + a.second.coriolis + a.second.closing;
    }
    return both;
  }

  const Linkage& linkage_;
  const std::vector<Step>& steps_;
  std::vector<std::vector<Vector<T>>> own_;  // link, point
  std::vector<OwnLine> lines_;
  std::vector<DyadNumbers> of_joints_;  // of the points
  std::vector<Carried> carried_;        // of the links
};

template <class T>
CarriedOut<T>::CarriedOut(const Linkage& linkage, const std::vector<Step>& steps) : linkage_(linkage), steps_(steps) {
  own_.assign(linkage.links.size(), std::vector<Vector<T>>(index(linkage.count_of_points()), {T(0), T(0)}));
  lines_.resize(index(linkage.count_of_lines()));
  for (std::size_t i = 0; i < linkage.links.size(); ++i) {
    for (const LinkPoint& p : linkage.links[i].points) own_[i][index(p.point)] = {number(p.at.x), number(p.at.y)};
    for (const LinkLine& l : linkage.links[i].lines)
      lines_[index(l.line)] = {
          static_cast<int>(i), {number(l.through.x), number(l.through.y)}, linkages::unit_vector<T>(l.along)};
  }
  of_joints_.resize(index(linkage.count_of_points()));
  carried_.resize(linkage.links.size());
  std::vector<bool> is_placed(of_joints_.size(), false);
  read_carried({0}, is_placed);
  for (const Step& step : steps) {
    if (const auto* rods = std::get_if<TwoRods>(&step)) {
      DyadNumbers& of = of_joints_[index(rods->joint)];
      of.first = numbers_of(rods->first, rods->joint);
      of.second = numbers_of(rods->second, rods->joint);
      of.greater = number(of.first.exactly_squared - of.second.exactly_squared);
    }
    if (const auto* rod = std::get_if<RodAndTrack>(&step))
      of_joints_[index(rod->joint)].first = numbers_of(rod->rod, rod->joint);
    for (const Hung& hung : hung_by(step)) read_carried(hung, is_placed);
  }
}

template <class T>
void CarriedOut<T>::read_carried(const Hung& hung, std::vector<bool>& is_placed) {
  for (const int point : {hung.pin, hung.joint})
    if (point != nothing) is_placed[index(point)] = true;
  Carried& of = carried_[index(hung.link)];
  const Link& link = linkage_.links[index(hung.link)];
  of.has_lines = !link.lines.empty();
  const Own pin = hung.pin == nothing ? Own{0, 0} : linkage_.place(hung.link, hung.pin);
  if (pin.x != 0 || pin.y != 0) of.pin = own(hung.link, hung.pin);
  // By this a complex number becomes its part of the vector that places the link.
  Own part{1, 0};
  if (hung.joint != nothing) {
    const Own& X = linkage_.place(hung.link, hung.joint);
    const Own r{X.x - pin.x, X.y - pin.y};
    const Rational over_squared = 1 / (r.x * r.x + r.y * r.y);
    part = {r.x * over_squared, -r.y * over_squared};
    of.rod = own(hung.link, hung.joint) - own(hung.link, hung.pin);
    of.over_squared = number(over_squared);
  }
  for (const LinkPoint& p : link.points) {
    if (is_placed[index(p.point)]) continue;
    is_placed[index(p.point)] = true;
    const Rational x = p.at.x - pin.x, y = p.at.y - pin.y;
    of.points.push_back({p.point, {number(x * part.x - y * part.y), number(x * part.y + y * part.x)}});
  }
}

template <class T>
LinkagePosition<T> CarriedOut<T>::position_before(std::size_t step, const std::optional<DriveAt<T>>& elsewhere,
                                                  const std::optional<RoomTold<T>>& told) const {
  LinkagePosition<T> at{
      {linkage_.links.size(), {{T(0), T(0)}, {T(1), T(0)}}}, {of_joints_.size(), {T(0), T(0)}}, elsewhere};
  place_frame(at);
  for (std::size_t k = 0; k < step; ++k)
    at_step(k, [&] {
      std::visit(
          [&](const auto& s) {
            if (told && told->step == k)
              place(s, told->root_of_room, at);
            else
              place(s, at);
          },
          steps_[k]);
    });
  return at;
}

template <class T>
void CarriedOut<T>::place_all(LinkagePosition<T>& at) const {
  assert(at.links.size() == carried_.size() && at.points.size() == of_joints_.size());
  if (at.wanted == Wanted::links) place_frame(at);  // other links have put its points
  for (std::size_t k = 0; k < steps_.size(); ++k)
    at_step(k, [&] { std::visit([&](const auto& s) { place(s, at); }, steps_[k]); });
}

template <class T>
LinkageMotion<T> CarriedOut<T>::motion(const LinkagePosition<T>& at, const Rates& rates) const {
  LinkageMotion<T> so_far = at_rest(at);
  so_far.steps.resize(steps_.size());
  for (std::size_t k = 0; k < steps_.size(); ++k)
    at_step(k, [&] { std::visit([&](const auto& s) { move(s, at, rates, so_far, &so_far.steps[k]); }, steps_[k]); });
  return so_far;
}

template <class T>
void CarriedOut<T>::move_all(LinkageMotion<T>& motion, const LinkagePosition<T>& at, const Rates& rates) const {
  assert(motion.links.size() == at.links.size() && motion.points.size() == at.points.size());
  if (at.wanted == Wanted::links) rest_frame(at, motion);
  for (std::size_t k = 0; k < steps_.size(); ++k)
    at_step(k, [&] { std::visit([&](const auto& s) { move(s, at, rates, motion, nullptr); }, steps_[k]); });
}

template <class T>
std::vector<DriveRates<T>> CarriedOut<T>::rates() const {
  Rates all;
  for (const Drive& drive : linkage_.drives) {
    if (const auto* turned = std::get_if<TurnedLink>(&drive))
      all.push_back({radians<T>(turned->omega), radians<T>(turned->alpha)});
    else if (const auto* slid = std::get_if<SlidPoint>(&drive))
      all.push_back({number(slid->velocity), number(slid->acceleration)});
    else
      all.push_back({number(std::get<Stretched>(drive).velocity), number(std::get<Stretched>(drive).acceleration)});
  }
  return all;
}

template <class T>
typename CarriedOut<T>::Rail CarriedOut<T>::in_plane(int l, const LinkagePosition<T>& at) const {
  const OwnLine& own_line = line(l);
  if (own_line.link == 0) return {{own_line.through.x, own_line.through.y}, own_line.along};
  const PlacedLink<T>& link = at.links[index(own_line.link)];
  return {link.at(own_line.through), link.turned(own_line.along)};
}

template <class T>
T CarriedOut<T>::left_of(int l, int point) const {
  return cross(line(l).along, own(line(l).link, point) - line(l).through);
}

template <class T>
typename CarriedOut<T>::Rail CarriedOut<T>::rail(const Track& track, int joint, const LinkagePosition<T>& at) const {
  const Rail guide = in_plane(track.line, at);
  if (track.block == nothing) return guide;
  return {guide.G + left_of(track.moving, joint) * quarter_turn(guide.s), guide.s};
}

template <class T>
typename CarriedOut<T>::RodNumbers CarriedOut<T>::numbers_of(const Rod& rod, int joint) const {
  RodNumbers of;
  if (rod.link == nothing) {
    of.exactly = std::get<Stretched>(linkage_.drives[index(rod.cylinder)]).length;
    of.exactly_squared = *of.exactly * *of.exactly;
    if (*of.exactly != 0) of.over_length = number(1 / *of.exactly);
  } else {
    const auto &P = linkage_.place(rod.link, rod.pin), &X = linkage_.place(rod.link, joint);
    of.exactly_squared = (X.x - P.x) * (X.x - P.x) + (X.y - P.y) * (X.y - P.y);
    of.exactly = FieldOf<Rational>::root(of.exactly_squared);
  }
  of.squared = number(of.exactly_squared);
  if (of.exactly) of.length = number(*of.exactly);
  return of;
}

}  // namespace epure::geometry

// The steps one by one.
#include "geometry/linkages/moving_steps.h"
#include "geometry/linkages/placing_steps.h"
