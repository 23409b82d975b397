// A linkage placed and moved by ruler and compass, step after step (assur_groups.h), on any number. Metres, radians,
// seconds; counter-clockwise positive.
#pragma once

#include <cassert>
#include <cstdlib>
#include <optional>
#include <vector>

#include "geometry/linkages/assur_groups.h"
#include "geometry/mechanisms/dyad.h"
#include "geometry/numbers/rational_field.h"

namespace epure::geometry {

// The numbers that have the sine of an angle.
template <class T>
concept NumberWithSines = requires(const T& angle) {
  { sine_of_angle(angle) } -> std::same_as<T>;
};

namespace linkages {
// u v and u v* as complex numbers.
template <class T>
Vector<T> times(const Vector<T>& u, const Vector<T>& v) {
  return v.x * u + v.y * quarter_turn(u);
}
template <class T>
Vector<T> times_mirrored(const Vector<T>& u, const Vector<T>& v) {
  return v.x * u - v.y * quarter_turn(u);
}
}  // namespace linkages

// Where a link is: the origin of its axes, and its x axis, a unit vector.
template <class T>
struct PlacedLink {
  Point<T> O;
  Vector<T> x;
  // Of a wheel that rolls on a line, on numbers without sines: where it points is not known, nor is it needed.
  bool is_axis_known = true;

  const Vector<T>& axis() const {
    if (!is_axis_known)
      throw Undecided("which way a wheel points that has rolled: its angle is a length over a radius",
                      "dove punti una ruota che ha rotolato: il suo angolo è una lunghezza su un raggio");
    return x;
  }

  Vector<T> turned(const Vector<T>& own) const { return linkages::times(x, own); }
  Point<T> at(const Vector<T>& own) const { return O + turned(own); }
};

// One of the drives, elsewhere than the linkage says: its link's x axis in this direction, turned so many times from
// +x (wheels may make a part of its turns), or its point or cylinder so far along.
template <class T>
struct DriveAt {
  int drive;
  Vector<T> direction;
  T way;
  int times = 1;
};

// A step near its limit: the root of from_limit, which is not found there of a place that is not known exactly.
template <class T>
struct RoomTold {
  std::size_t step;
  T root_of_room;
};

// What is found of a linkage, and how.
//   links   the axes of every link; a point of several links is where the last of them to be placed puts it
//   points  of the axes only those of links that have lines; a point is where the first of its links puts it, and
//           enclosures are narrower
enum class Wanted { links, points };

template <class T>
struct LinkagePosition {
  std::vector<PlacedLink<T>> links;
  std::vector<Point<T>> points;
  std::optional<DriveAt<T>> elsewhere = {};
  Wanted wanted = Wanted::links;
};

// The two polygons of a step that has any.
template <class T>
struct StepPolygons {
  std::optional<DyadVelocity<T>> velocity;
  std::optional<DyadAcceleration<T>> acceleration;
};

template <class T>
struct LinkageMotion {
  std::vector<PlaneMotion<T>> links;
  std::vector<Pin<T>> points;
  std::vector<StepPolygons<T>> steps;  // as the steps
};

// A group of links does not close, or is at a limit: which step.
struct NotClosed : Impossible {
  NotClosed(std::size_t step_, const Words& why) : Impossible(why), step(step_) {}
  std::size_t step;
};

// A drive's rates as numbers: rad/s and rad/s², or m/s and m/s².
template <class T>
struct DriveRates {
  T first, second;
};

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

// ---------------------------------------------------------------------------------------------------------------------

namespace linkages {

// What does not change while a drive moves: of a series it is made of its coefficients (every_place.h).
template <class T>
struct Constant {
  static Vector<T> direction(const Angle& angle) { return {cosine<T>(angle), sine<T>(angle)}; }
};

// The unit vector of a direction: without a root where the vector has a rational length.
template <class T>
Vector<T> unit_vector(const Direction& direction) {
  if (const auto* angle = std::get_if<Angle>(&direction)) return Constant<T>::direction(*angle);
  const auto& [x, y] = std::get<Own>(direction);
  const Rational squared = x * x + y * y;
  if (const auto length = FieldOf<Rational>::root(squared))
    return {from_rational<T>(x / *length), from_rational<T>(y / *length)};
  const T over = quotient(T(1), root(from_rational<T>(squared)));
  return {from_rational<T>(x) * over, from_rational<T>(y) * over};
}

// A unit vector turned from +x by so many times its angle.
template <class T>
Vector<T> turned_times(const Vector<T>& direction, int times) {
  const Vector<T> each = times < 0 ? Vector<T>{direction.x, -direction.y} : direction;
  if (times == 0) return {T(1), T(0)};
  Vector<T> all = each;
  for (int i = std::abs(times); i > 1; --i) all = linkages::times(all, each);
  return all;
}

template <class T>
T positive_or_zero(const T& squared, const Words& whether, const Words& impossible) {
  const Sign decided = sign(squared);
  if (decided == Sign::negative) throw Impossible(impossible);
  if (decided == Sign::undecided) throw Undecided(whether);
  return squared;
}

// P and so far along d and to a side of it: both are twice these lengths, times that of d.
template <class T>
Point<T> beside(const Point<T>& P, const Vector<T>& d, const T& twice_along, const T& twice_across, Side side) {
  const T twice = T(2) * length_squared(d), along = quotient(twice_along, twice),
          across = quotient(twice_across, twice);
  return P + (along * d + (side == Side::left ? across : -across) * quarter_turn(d));
}

// The point at the distances from P and Q of which the squares are given (r2, and by how much it is greater than the
// other), on the named side of P -> Q: circles whose radii need no root. Errors as in circle.h.
template <class T>
Point<T> meet_by_squares(const Point<T>& P, const T& r2, const Point<T>& Q, const T& greater, Side side) {
  const Vector<T> d = Q - P;
  const T d2 = length_squared(d);
  if (sign(d2) == Sign::zero) throw Impossible("the circles are concentric", "le circonferenze sono concentriche");
  const T twice_along = d2 + greater;
  const T across = root(positive_or_zero(T(4) * d2 * r2 - square(twice_along),
                                         {"whether two circles meet", "se due circonferenze si incontrino"},
                                         {"the circles do not meet", "le circonferenze non si incontrano"}));
  return beside(P, d, twice_along, across, side);
}
}  // namespace linkages

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
