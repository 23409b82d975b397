// The forces in the joints of a linkage as the force plan finds them: the groups in the reverse of the order in which
// they were placed, on any number. A group bears what acts on its links and what later groups have handed to its
// pins; two moments, or a moment and a direction, give the force in its inner joint, a force polygon those in its
// outer ones, which are handed on. At last the crank is left, with what the drive must provide.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "geometry/linkages/carried_out.h"
#include "geometry/linkages/friction_circles.h"
#include "geometry/linkages/loads.h"

namespace epure::geometry {

template <class T>
class ForcesByGroups {
 public:
  ForcesByGroups(const Linkage& linkage, const LinkagePosition<T>& at)
      : linkage_(linkage),
        at_(at),
        found_(linkage),
        pin_slopes_(linkage.pins.size(), T(0)),
        block_slopes_(linkage.blocks.size(), T(0)),
        on_pin_(at.points.size(), Vector<T>{T(0), T(0)}),
        known_(linkage.links.size()) {}

  // `moving`: as the masses; without inertia where it is empty. `sliding`: how fast what rubs slides along its line,
  // as the frictions; `turning`: how fast the second link of each hinge turns on the first. Throws Impossible where a
  // group is at a limit, or jams, Undecided where that cannot be told.
  JointForces<T> under(const Loads& loads, const std::vector<Step>& steps,
                       const std::vector<MassInMotion<T>>& moving = {}, const std::vector<T>& sliding = {},
                       const std::vector<T>& turning = {}) {
    const FrictionCircles<T> circles(linkage_, loads, turning);
    if (!circles.rub()) {
      push(loads, moving);
      return released(steps, loads.frictions, sliding);
    }
    // The couples need forces of all groups: so all senses are tried at once, not group by group.
    const SoFar nothing_yet = so_far();
    std::vector<Rubbing> rubbing = rubbing_of(loads.frictions, sliding);
    return forces_with_friction<JointForces<T>>(
        rubbing.size(),
        [&](const std::vector<int>& senses) {
          try_senses(rubbing, senses);
          return circles.forces([&](const std::vector<T>& couples, bool is_loaded) {
            go_back_to(nothing_yet);
            for (std::size_t k = 0; k < couples.size(); ++k) push_couple(found_.hinges[k], couples[k]);
            if (is_loaded) push(loads, moving);
            return released(steps, {}, {});
          });
        },
        [&](const JointForces<T>& found, std::size_t i) { return found.normal(loads.frictions[i]); },
        [](const JointForces<T>& a, const JointForces<T>& b) { return either(a, b); });
  }

  // Of a LinkForce or a LinkMass.
  template <class Load>
  Point<T> place(const Load& load) const {
    return at_.links[index(load.link)].at({from_rational<T>(load.at.x), from_rational<T>(load.at.y)});
  }
  static Vector<T> weight(const LinkMass& body, const Own& gravity) {
    return {from_rational<T>(body.mass * gravity.x), from_rational<T>(body.mass * gravity.y)};
  }
  static Vector<T> inertia(const LinkMass& body, const MassInMotion<T>& moving) {
    const T m = from_rational<T>(body.mass);
    return {-(m * moving.a_x), -(m * moving.a_y)};
  }
  static Vector<T> vector(const LinkForce& load) {
    const T c = cosine<T>(load.turned), s = sine<T>(load.turned);
    const T x = from_rational<T>(load.components.x), y = from_rational<T>(load.components.y);
    return {x * c - y * s, x * s + y * c};
  }

  // The point that a line is given through.
  Point<T> through(int line) const {
    const Own& own = linkage_.line(line).through;
    return at_.links[index(linkage_.link_of_line(line))].at({from_rational<T>(own.x), from_rational<T>(own.y)});
  }

  Vector<T> along(int line) const {
    return at_.links[index(linkage_.link_of_line(line))].turned(linkages::unit_vector<T>(linkage_.line(line).along));
  }

 private:
  struct Acting {
    Point<T> at;
    Vector<T> force;
  };
  struct Known {
    std::vector<Acting> forces = {};
    T couple{0};
  };
  // What one side of a group says of the force `a` that the pin of its inner joint exerts on it: r x a = moment.
  struct Condition {
    Vector<T> r;
    T moment;
  };

  // Its force along the line is -sense slope N.
  struct Rubbing {
    LineFriction of;
    T slope;
  };
  // What is known and found so far.
  struct SoFar {
    JointForces<T> found;
    std::vector<Vector<T>> on_pin;
    std::vector<Known> known;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void push(const Loads& loads, const std::vector<MassInMotion<T>>& moving) {
    for (const LinkForce& load : loads.forces) push(load.link, place(load), vector(load));
    for (const LinkCouple& load : loads.couples) known_[index(load.link)].couple += from_rational<T>(load.moment);
    for (std::size_t k = 0; k < loads.masses.size(); ++k) {
      const LinkMass& body = loads.masses[k];
      push(body.link, place(body), weight(body, loads.gravity));
      if (moving.empty()) continue;
      push(body.link, place(body), inertia(body, moving[k]));
      known_[index(body.link)].couple -= from_rational<T>(body.inertia) * moving[k].alpha;
    }
  }
  void push_couple(typename JointForces<T>::Hinge& hinge, const T& couple) {
    hinge.couple = couple;
    known_[index(hinge.on)].couple += couple;
    known_[index(hinge.by)].couple -= couple;
  }
  // Where these rub the senses are found step by step.
  JointForces<T> released(const std::vector<Step>& steps, const std::vector<LineFriction>& frictions,
                          const std::vector<T>& sliding) {
    placed_ = steps_of_links(steps);
    const std::vector<std::size_t> at_steps = steps_of(frictions, steps);
    const std::vector<Rubbing> all = rubbing_of(frictions, sliding);
    for (std::size_t k = steps.size(); k-- > 0;) {
      std::vector<Rubbing> rubbing;
      for (std::size_t i = 0; i < at_steps.size(); ++i)
        if (at_steps[i] == k) rubbing.push_back(all[i]);
      if (rubbing.empty())
        std::visit([this](const auto& s) { release(s); }, steps[k]);
      else
        release_rubbing(steps[k], rubbing);
    }
    return found_;
  }

  std::vector<std::size_t> steps_of_links(const std::vector<Step>& steps) const {
    std::vector<std::size_t> of_links(linkage_.links.size(), 0);
    for (std::size_t k = 0; k < steps.size(); ++k)
      for (const int link : placed_by(steps[k])) of_links[index(link)] = k;
    return of_links;
  }

  // --- friction ---
  // With which step each contact is found: the last that brings a part of it to its place.
  std::vector<std::size_t> steps_of(const std::vector<LineFriction>& frictions,
                                    const std::vector<Step>& steps) const {
    std::vector<std::size_t> all;
    std::vector<std::optional<std::size_t>> of_points(at_.points.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (const auto* pin = std::get_if<SlidPin>(&steps[k])) of_points[index(pin->point)] = k;
      if (const auto* two = std::get_if<TwoTracks>(&steps[k])) of_points[index(two->joint)] = k;
      if (const auto* rod = std::get_if<RodAndTrack>(&steps[k])) of_points[index(rod->joint)] = k;
    }
    const auto of_line = [&](int line) { return placed_[index(linkage_.link_of_line(line))]; };
    for (const LineFriction& each : frictions) {
      if (each.is_of_block) {
        const LineOnLine& block = linkage_.blocks[index(each.which)];
        all.push_back(std::max(of_line(block.moving), of_line(block.guide)));
        continue;
      }
      const PinOnLine& pin = linkage_.pins[index(each.which)];
      const std::optional<std::size_t>& alone = of_points[index(pin.point)];
      all.push_back(std::max(of_line(pin.line), alone ? *alone : first_link(pin.point)));
    }
    return all;
  }
  std::size_t first_link(int point) const {
    std::size_t first = placed_.size();
    for (const int link : linkage_.links_at(point)) first = std::min(first, placed_[index(link)]);
    return first;
  }
  static Vector<T> one_of_vectors(const Vector<T>& a, const Vector<T>& b) {
    return {either(a.x, b.x), either(a.y, b.y)};
  }
  static SoFar one_of(SoFar a, const SoFar& b) {
    a.found = either(a.found, b.found);
    for (std::size_t p = 0; p < a.on_pin.size(); ++p) a.on_pin[p] = one_of_vectors(a.on_pin[p], b.on_pin[p]);
    for (std::size_t i = 0; i < a.known.size(); ++i) {
      a.known[i].couple = either(a.known[i].couple, b.known[i].couple);
      for (std::size_t k = 0; k < a.known[i].forces.size(); ++k)
        a.known[i].forces[k].force = one_of_vectors(a.known[i].forces[k].force, b.known[i].forces[k].force);
    }
    return a;
  }
  static std::vector<Rubbing> rubbing_of(const std::vector<LineFriction>& frictions, const std::vector<T>& sliding) {
    std::vector<Rubbing> all;
    for (std::size_t i = 0; i < frictions.size(); ++i)
      all.push_back({frictions[i], T(sense_of_sliding(sliding[i])) * frictions[i].template coefficient<T>()});
    return all;
  }
  void try_senses(const std::vector<Rubbing>& rubbing, const std::vector<int>& senses) {
    for (std::size_t i = 0; i < rubbing.size(); ++i)
      (rubbing[i].of.is_of_block ? block_slopes_ : pin_slopes_)[index(rubbing[i].of.which)] =
          T(senses[i]) * rubbing[i].slope;
  }
  SoFar so_far() const { return {found_, on_pin_, known_}; }
  void go_back_to(const SoFar& so_far) {
    found_ = so_far.found;
    on_pin_ = so_far.on_pin;
    known_ = so_far.known;
  }
  void release_rubbing(const Step& step, const std::vector<Rubbing>& rubbing) {
    const SoFar before = so_far();
    go_back_to(forces_with_friction<SoFar>(
        rubbing.size(),
        [&](const std::vector<int>& senses) {
          go_back_to(before);
          try_senses(rubbing, senses);
          std::visit([this](const auto& s) { release(s); }, step);
          return std::vector<SoFar>{so_far()};
        },
        [&](const SoFar& found, std::size_t i) { return found.found.normal(rubbing[i].of); }, one_of));
  }
  // By how much friction turns what a line exerts on the pin in it, or on another line: the force is N (n - slope s).
  T slope_on_pin(int pin, int line) const {
    for (std::size_t i = 0; i < linkage_.pins.size(); ++i)
      if (linkage_.pins[i].point == pin && linkage_.pins[i].line == line) return pin_slopes_[i];
    return T(0);
  }
  T slope_between(int line, int other) const {
    for (std::size_t i = 0; i < linkage_.blocks.size(); ++i) {
      const LineOnLine& block = linkage_.blocks[i];
      if ((block.moving == line && block.guide == other) || (block.moving == other && block.guide == line))
        return block_slopes_[i];
    }
    return T(0);
  }
  T slope(const Track& track, int joint) const {
    return track.block == nothing ? slope_on_pin(joint, track.line) : slope_between(track.moving, track.line);
  }
  // What the line exerts is along the one, and does nothing along the other.
  Vector<T> pressed_along(int line, const T& slope) const { return left_of(line) - slope * along(line); }
  Vector<T> free_along(int line, const T& slope) const { return along(line) + slope * left_of(line); }

  const Point<T>& X(int point) const { return at_.points[index(point)]; }
  Vector<T> left_of(int line) const { return quarter_turn(along(line)); }

  static T over(const T& numerator, const T& denominator) {
    const Sign decided = sign(denominator);
    if (decided == Sign::undecided)
      throw Undecided("whether a group is at a dead centre, where its forces grow beyond all bounds",
                      "se un gruppo sia in un punto morto, dove le sue forze crescono oltre ogni limite");
    if (decided == Sign::zero)
      throw Impossible("a group is at a dead centre: its joints cannot bear the loads",
                       "un gruppo è in un punto morto: i suoi vincoli non possono portare i carichi");
    return quotient(numerator, denominator);
  }

  void push(int link, const Point<T>& at, const Vector<T>& force) {
    known_[index(link)].forces.push_back({at, force});
  }
  Vector<T> resultant(int link) const {
    Vector<T> sum{T(0), T(0)};
    for (const Acting& each : known_[index(link)].forces) sum = sum + each.force;
    return sum;
  }
  T moment(int link, const Point<T>& about) const {
    T sum = known_[index(link)].couple;
    for (const Acting& each : known_[index(link)].forces) sum += cross(each.at - about, each.force);
    return sum;
  }

  // The force of a pin on a link.
  void bear(int link, int point, const Vector<T>& force) {
    push(link, X(point), force);
    on_pin_[index(point)] = on_pin_[index(point)] - force;
    for (auto& hinge : found_.hinges)
      if (hinge.point == point && hinge.on == link) {
        hinge.x = force.x;
        hinge.y = force.y;
      }
  }
  // What later groups have handed to the link's pins, but for the joints of its own group.
  void take_pins(int link, const std::vector<int>& but_for) {
    for (const LinkPoint& p : linkage_.links[index(link)].points)
      if (std::find(but_for.begin(), but_for.end(), p.point) == but_for.end())
        bear(link, p.point, Vector<T>(on_pin_[index(p.point)]));
  }
  // All that is left of a link's equilibrium is a force through its pin.
  void close_in(int link, int pin) { bear(link, pin, -resultant(link)); }

  // The line presses on the pin with this force to its left.
  void press(int pin, int line, const T& force) {
    const T slope = slope_on_pin(pin, line);
    for (std::size_t i = 0; i < linkage_.pins.size(); ++i)
      if (linkage_.pins[i].point == pin && linkage_.pins[i].line == line) {
        found_.pins[i] = force;
        found_.pin_frictions[i] = -(slope * force);
      }
    const Vector<T> on_pin = force * pressed_along(line, slope);
    on_pin_[index(pin)] = on_pin_[index(pin)] + on_pin;
    push(linkage_.link_of_line(line), X(pin), -on_pin);
  }
  // Between two lines that stay on each other: a force on the link, in Y, and a couple.
  void guide(int link, int line, int other, const Vector<T>& force, const Point<T>& Y, const T& couple) {
    for (std::size_t i = 0; i < linkage_.blocks.size(); ++i) {
      const LineOnLine& block = linkage_.blocks[i];
      const bool is_moving = block.moving == line && block.guide == other;
      if (!is_moving && !(block.moving == other && block.guide == line)) continue;
      const T across = dot(left_of(block.guide), force), about = couple + cross(Y - through(block.moving), force);
      found_.guides[i] =
          is_moving ? typename JointForces<T>::Guide{across, about} : typename JointForces<T>::Guide{-across, -about};
      found_.guides[i].friction = -(block_slopes_[i] * found_.guides[i].force);
    }
    const int by = linkage_.link_of_line(other);
    push(link, Y, force);
    push(by, Y, -force);
    known_[index(link)].couple += couple;
    known_[index(by)].couple -= couple;
  }
  // All that is left of a block's equilibrium is what its guide does.
  void close_in_guide(const Track& track) {
    const Point<T> Y = through(track.moving);
    guide(track.block, track.moving, track.line, -resultant(track.block), Y, -moment(track.block, Y));
  }

  void release(const TurnedCrank& step) {
    take_pins(step.link, {step.hinge});
    found_.drives[index(step.drive)] = -moment(step.link, X(step.hinge));
    close_in(step.link, step.hinge);
  }
  // Its teeth press on those of the one wheel that was placed before it (wheels_in_order.h).
  static void release(const RolledWheel&) {}  // of mechanisms without forces
  void release(const GearedWheel& step) {
    take_pins(step.link, {step.hinge});
    for (std::size_t k = 0; k < linkage_.gears.size(); ++k) {
      const MeshingLinks& gear = linkage_.gears[k];
      if (gear.first != step.link && gear.second != step.link) continue;
      const int other = gear.first == step.link ? gear.second : gear.first;
      if (other == 0 || placed_[index(other)] < placed_[index(step.link)]) mesh(k, step);
    }
    close_in(step.link, step.hinge);
  }
  void mesh(std::size_t k, const GearedWheel& wheel) {
    const MeshingLinks& gear = linkage_.gears[k];
    const Own pitch = linkage_.pitch_point(gear);
    const PlacedLink<T>& carrier = at_.links[index(gear.carrier)];
    const Point<T> P = carrier.at({from_rational<T>(pitch.x), from_rational<T>(pitch.y)});
    const Vector<T> apart = carrier.turned(linkages::unit_vector<T>(linkage_.line_of_centres(gear))),
                    along = quarter_turn(apart);
    // The part along the line of centres goes through the wheel's own.
    T on_wheel = over(-moment(wheel.link, X(wheel.hinge)), cross(P - X(wheel.hinge), along));
    auto& tooth = found_.teeth[k];
    tooth.tangential = gear.second == wheel.link ? on_wheel : -on_wheel;
    const T size = size_of(tooth.tangential);
    if (sign(size) != Sign::zero) tooth.radial = slope_of_teeth<T>(gear) * size;
    const Vector<T> force = tooth.tangential * along + tooth.radial * apart;
    push(gear.second, P, force);
    push(gear.first, P, -force);
  }
  static T size_of(const T& x) {
    const Sign decided = sign(x);
    if (decided != Sign::undecided) return decided == Sign::negative ? -x : x;
    if constexpr (NumberWithAngles<T>)
      return root(square(x));
    else
      throw Undecided("from which side a tooth presses", "da quale parte prema un dente");
  }
  void release(const SlidBlock& step) {
    take_pins(step.track.block, {step.point});
    const Vector<T> borne = resultant(step.track.block) + on_pin_[index(step.point)];
    const T drive = -dot(free_along(step.track.line, slope(step.track, nothing)), borne);
    found_.drives[index(step.drive)] = drive;
    push_along(step.track.line, step.point, drive);
    take_pins(step.track.block, {});
    close_in_guide(step.track);
  }
  void release(const SlidPin& step) {
    const int line = std::get<SlidPoint>(linkage_.drives[index(step.drive)]).guide;
    const Vector<T> handed = on_pin_[index(step.point)];
    const T drive = -dot(free_along(line, slope_on_pin(step.point, line)), handed);
    found_.drives[index(step.drive)] = drive;
    push_along(line, step.point, drive);
    press(step.point, line, -dot(left_of(line), handed));
  }
  // A drive between a point and the link of its guide.
  void push_along(int line, int point, const T& force) {
    const Vector<T> on_pin = force * along(line);
    on_pin_[index(point)] = on_pin_[index(point)] + on_pin;
    push(linkage_.link_of_line(line), X(point), -on_pin);
  }

  void release(const TwoRods& step) { release(step.first, step.second, step.joint); }
  void release(const RodAndTrack& step) { release(step.rod, step.track, step.joint); }
  void release(const TwoTracks& step) { release(step.first, step.second, step.joint); }
  // a + b is what was handed to the pin of the inner joint.
  template <class First, class Second>
  void release(const First& first, const Second& second, int joint) {
    const Condition of_a = condition(first, joint), of_b = condition(second, joint);
    const Vector<T> handed = on_pin_[index(joint)];
    const T other = cross(of_b.r, handed) - of_b.moment, between = cross(of_a.r, of_b.r);
    const Vector<T> both = of_a.moment * of_b.r - other * of_a.r, a{over(both.x, between), over(both.y, between)};
    close(first, joint, a);
    close(second, joint, handed - a);
  }
  Condition condition(const Rod& rod, int joint) {
    const Vector<T> r = X(joint) - X(rod.pin);
    if (rod.link == nothing) return {r, T(0)};
    take_pins(rod.link, {rod.pin, joint});
    return {r, -moment(rod.link, X(rod.pin))};
  }
  Condition condition(const Track& track, int joint) {
    const Vector<T> u = free_along(track.line, slope(track, joint));
    if (track.block == nothing) return {-quarter_turn(u), T(0)};
    take_pins(track.block, {joint});
    return {-quarter_turn(u), -dot(u, resultant(track.block))};
  }
  void close(const Rod& rod, int joint, const Vector<T>& a) {
    if (rod.link != nothing) {
      bear(rod.link, joint, a);
      close_in(rod.link, rod.pin);
      return;
    }
    const Rational& length = std::get<Stretched>(linkage_.drives[index(rod.cylinder)]).length;
    found_.drives[index(rod.cylinder)] = quotient(-dot(a, X(joint) - X(rod.pin)), from_rational<T>(length));
    on_pin_[index(joint)] = on_pin_[index(joint)] - a;
    on_pin_[index(rod.pin)] = on_pin_[index(rod.pin)] + a;
  }
  void close(const Track& track, int joint, const Vector<T>& a) {
    if (track.block == nothing) return press(joint, track.line, -dot(left_of(track.line), a));
    bear(track.block, joint, a);
    close_in_guide(track);
  }

  void release(const SlotOnPin& step) {
    const T slope = step.block == nothing ? slope_on_pin(step.pin, step.line) : slope_between(step.line, step.moving);
    const Vector<T> pressed = pressed_along(step.line, slope);
    take_pins(step.link, {step.hinge});
    T turning = moment(step.link, X(step.hinge));
    if (step.block != nothing) {
      take_pins(step.block, {step.pin});
      turning += moment(step.block, X(step.pin));
    }
    const T force = over(turning, cross(X(step.pin) - X(step.hinge), pressed));
    if (step.block == nothing) {
      press(step.pin, step.line, force);
    } else {
      bear(step.block, step.pin, -(resultant(step.block) + force * pressed));
      close_in_guide({step.line, step.block, step.moving});
    }
    close_in(step.link, step.hinge);
  }
  void release(const BlockOnPin& step) {
    const Vector<T> u = free_along(step.track.line, slope(step.track, nothing));
    const Vector<T> pressed = pressed_along(step.line, slope_on_pin(step.pin, step.line));
    take_pins(step.track.block, {});
    press(step.pin, step.line, over(dot(u, resultant(step.track.block)), dot(u, pressed)));
    close_in_guide(step.track);
  }
  void release(const CrossedBlock& step) {
    const Vector<T> u = free_along(step.track.line, slope(step.track, nothing));
    const Vector<T> pressed = pressed_along(step.line, slope_between(step.line, step.crossing));
    take_pins(step.link, {step.hinge});
    take_pins(step.track.block, {});
    const T force = over(dot(u, resultant(step.track.block)), dot(u, pressed));
    guide(step.link, step.line, step.crossing, force * pressed, X(step.hinge), -moment(step.link, X(step.hinge)));
    close_in(step.link, step.hinge);
    close_in_guide(step.track);
  }

  const Linkage& linkage_;
  const LinkagePosition<T>& at_;
  JointForces<T> found_;
  std::vector<std::size_t> placed_ = {};      // by which step: links
  std::vector<T> pin_slopes_, block_slopes_;  // of friction, with the sense that is tried
  std::vector<Vector<T>> on_pin_;             // what is exerted on a pin by all that is known
  std::vector<Known> known_;                  // what acts on a link
};

}  // namespace epure::geometry
