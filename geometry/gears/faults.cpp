#include "geometry/gears/faults.h"

#include "geometry/gears/corner_room.h"
#include "geometry/gears/limits.h"
#include "geometry/gears/tooth_thickness.h"

#include <algorithm>
#include <optional>

namespace epure::geometry {
namespace {

// The double next to a number of the figure, for the sentence.
template <class Find>
double nearest_double(const Find& find) {
  const Arithmetic<Deep> scope(128);
  const Enclosure ends = enclosure(find());
  return ends.lower <= 0 && ends.upper >= 0 ? 0 : ends.value;  // a zero is no 1e-38
}

bool is_rack(const PairData& of, int wheel) { return wheel == 2 && of.kind == PairKind::rack; }
bool is_ring(const PairData& of, int wheel) { return wheel == 2 && of.kind == PairKind::internal; }

template <class T>
const WheelCircles<T>& circles_of(const GearPair<T>& pair, int wheel) {
  return wheel == 1 ? pair.wheel1 : *pair.wheel2;
}

template <class T>
T path_of_contact(const GearPair<T>& pair) {
  return pair.position(pair.E()) - pair.position(pair.A());
}
template <class T>
T base_pitch(const GearPair<T>& pair) {
  return from_rational<T>(pair.given.m) * pi<T>() * pair.alpha.cosine;
}

// Between the tip of the wheel and the root of the other.
template <class T>
T clearance(const GearPair<T>& pair, int wheel) {
  const PairData& of = pair.given;
  if (of.kind == PairKind::rack) return from_rational<T>(of.m * (of.hf - of.ha + of.k));
  if (of.kind == PairKind::external)
    return pair.centre_distance - circles_of(pair, wheel).r_tip - circles_of(pair, 3 - wheel).r_root;
  return wheel == 1 ? pair.wheel2->r_root - pair.centre_distance - pair.wheel1.r_tip
                    : pair.wheel2->r_tip - pair.centre_distance - pair.wheel1.r_root;
}

// What is left of the cutter's tip, over m: at the depth hf its tooth is π/2 - 2 hf tan α wide, and each rounding,
// tangent to edge and tip, takes rho tan(45° - α/2) = rho (1 - sin α)/cos α of it.
template <class T>
T cutter_tip(const PairData& of) {
  const PressureAngle<T> alpha = pressure_angle<T>(of.alpha);
  return from_rational<T>(Rational(1, 2)) * pi<T>() - from_rational<T>(2 * of.hf) * alpha.tangent -
         quotient(from_rational<T>(2 * of.rho) * (T(1) - alpha.sine), alpha.cosine);
}

// Along the line of action from T, the depth of the cutter's edge ends the flank: what lies nearer to T is fillet.
template <class T>
T start_of_flank(const GearPair<T>& pair, int wheel) {
  const T depth = depth_of_tangent_point<T>(pair.given, teeth_of(pair.given, wheel), shift_of(pair.given, wheel)) -
                  depth_of_straight_edge<T>(pair.given);
  return quotient(from_rational<T>(pair.given.m) * depth, pair.alpha.sine);
}
// The same of the last point of the wheel that the mate touches.
template <class T>
T start_of_contact(const GearPair<T>& pair, int wheel) {
  return wheel == 1 ? pair.position(pair.A()) - pair.position(pair.T1)
                    : pair.position(*pair.T2) - pair.position(pair.E());
}
template <class T>
T radius_at(const GearPair<T>& pair, int wheel, const T& along_tangent) {
  return root(square(circles_of(pair, wheel).r_b) + square(along_tangent));
}

// The tips of a ring too small run into each other where the tip circles cross, beyond the line of action.
//
// Let Q be the crossing on the side to which the teeth leave, at the angle θ1 about O1 and θ2 about O2 from the line
// of centres. Start with the driving flanks in contact at P0. The corner of tooth 1 lies inv α_tip1 - inv α_w behind
// P0, so it reaches Q when wheel 1 has turned by φ1 = θ1 + inv α_tip1 - inv α_w; the corner of the ring's tooth that
// it drove lies inv α_w - inv α_tip2 ahead of P0, and must have passed Q by then:
//   φ1 z1/z2 + inv α_w - inv α_tip2 >= θ2.
// (On the other side of the mesh the back flanks meet the same way, with the backlash as further room.) The condition
// is that of J. R. Colbourne, The Geometry of Involute Gears (1987), for tip interference of internal gears.
// Returned is the room between the corners, as an arc of the ring's tip circle. (Seen from O1 towards O2 below it,
// the teeth leave to the right.)
template <class T>
T room_between_tips(const PairData& of) {
  if constexpr (NumberWithAngles<T>) {
    const GearPair<T> pair = gear_pair<T>(of);
    const auto inv_at = [](const WheelCircles<T>& w) { return involute(pressure_angle_at(w.r_tip, w.r_b).tangent); };
    const Point<T> Q =
        meet(Circle<T>{pair.O1, pair.wheel1.r_tip}, Circle<T>{*pair.O2, pair.wheel2->r_tip}, Side::right);
    const auto angle_about = [&](const Point<T>& O) { return arc_tangent(T(O.x - Q.x), T(Q.y - O.y)); };
    const T inv_w = involute(pair.alpha_w.tangent);
    const T phi_1 = angle_about(pair.O1) + inv_at(pair.wheel1) - inv_w;
    const T phi_2 = from_rational<T>(Rational(of.z1) / Rational(of.z2)) * phi_1;
    return pair.wheel2->r_tip * (phi_2 - (angle_about(*pair.O2) - inv_w + inv_at(*pair.wheel2)));
  } else {
    throw LeavesTheTower("angles of involute functions", "angoli di funzioni involute");
  }
}

// Where no room at all is a fault too.
Decision zero_is_none(Decision room) {
  if (room.sign == Sign::zero) room.sign = Sign::negative;
  return room;
}

// Asks the questions one after the other and writes down what is amiss.
class Examination {
 public:
  explicit Examination(const PairData& of) : of_(of) {}

  std::vector<Fault> all() {
    bool flanks = true;
    for (const int wheel : {1, 2}) {
      const bool reaches = examine_tip(wheel);
      flanks = flanks && reaches;
      if (!is_ring(of_, wheel) && !is_rack(of_, wheel)) examine_undercut(wheel);
    }
    for (const int wheel : {1, 2}) examine_clearance(wheel);
    note({Fault::Kind::pointed_cutter}, decide([&]<class T>() { return cutter_tip<T>(of_); }), [&](Fault& f) {
      f.value = nearest_double([&] { return from_rational<Deep>(of_.m) * cutter_tip<Deep>(of_); });
    });
    if (flanks) examine_contact();
    return faults_;
  }

 private:
  // Adds the fault when the room is negative, or undecided. Returns whether there is room.
  template <class Fill>
  bool note(Fault fault, const Decision& room, const Fill& fill) {
    if (room.sign == Sign::positive || room.sign == Sign::zero) return true;
    fault.undecided = room.sign == Sign::undecided;
    fault.reason = room.reason;
    if (!fault.undecided) fill(fault);
    faults_.push_back(fault);
    return false;
  }

  // Whether there are flanks.
  bool examine_tip(int wheel) {
    using Kind = Fault::Kind;
    if (!is_rack(of_, wheel)) {
      const auto beyond_base = [&]<class T>() -> T {
        const GearPair<T> pair = gear_pair<T>(of_);
        return circles_of(pair, wheel).r_tip - circles_of(pair, wheel).r_b;
      };
      const bool reaches = note({Kind::tip_inside_base, wheel}, decide(beyond_base), [&](Fault& f) {
        const Arithmetic<Deep> scope(128);
        const GearPair<Deep> pair = gear_pair<Deep>(of_);
        f.value = enclosure(circles_of(pair, wheel).r_tip).value;
        f.limit = enclosure(circles_of(pair, wheel).r_b).value;
      });
      if (!reaches) return false;
    }
    const Decision thickness =
        zero_is_none(decide([&]<class T>() -> T { return tip_thickness(gear_pair<T>(of_), wheel); }));
    note({Kind::pointed, wheel}, thickness,
         [&](Fault& f) { f.value = nearest_double([&] { return tip_thickness(gear_pair<Deep>(of_), wheel); }); });
    return true;
  }

  void examine_undercut(int wheel) {
    const auto teeth_at_depth = [&](const Deep& depth) {
      const Deep above = depth - from_rational<Deep>(shift_of(of_, wheel));
      return quotient(Deep(2) * above, square(sine<Deep>(of_.alpha)));
    };
    const auto z = static_cast<double>(teeth_of(of_, wheel));
    const bool above_rack = note({Fault::Kind::undercut, wheel, z}, room_above_undercut(of_, wheel), [&](Fault& f) {
      f.limit = nearest_double([&] { return undercut_limit_teeth<Deep>(of_, shift_of(of_, wheel)); });
    });
    if (above_rack)
      note({Fault::Kind::undercut_by_edge, wheel, z}, room_above_cutter_edge(of_, wheel), [&](Fault& f) {
        f.limit = nearest_double([&] { return teeth_at_depth(depth_of_straight_edge<Deep>(of_)); });
      });
  }

  void examine_clearance(int wheel) {
    note({Fault::Kind::negative_clearance, wheel},
         decide([&]<class T>() -> T { return clearance(gear_pair<T>(of_), wheel); }),
         [&](Fault& f) { f.value = nearest_double([&] { return clearance(gear_pair<Deep>(of_), wheel); }); });
  }

  void examine_contact() {
    using Kind = Fault::Kind;
    const bool approach = note({Kind::interference_approach}, room_in_approach(of_), [&](Fault& f) {
      const Arithmetic<Deep> scope(128);
      const GearPair<Deep> pair = gear_pair<Deep>(of_);
      f.value = enclosure(-pair.position(pair.A())).value;
      f.limit = enclosure(-pair.position(pair.T1)).value;
    });
    const bool recess = note({Kind::interference_recess}, room_in_recess(of_), [&](Fault& f) {
      const Arithmetic<Deep> scope(128);
      const GearPair<Deep> pair = gear_pair<Deep>(of_);
      f.value = enclosure(pair.position(pair.E())).value;
      f.limit = enclosure(pair.position(*pair.T2)).value;
    });
    note({Kind::contact_ratio_below_one}, decide([&]<class T>() -> T {
           const GearPair<T> pair = gear_pair<T>(of_);
           return path_of_contact(pair) - base_pitch(pair);
         }),
         [&](Fault& f) {
           f.limit = 1;
           f.value = nearest_double([&] {
             const GearPair<Deep> pair = gear_pair<Deep>(of_);
             return quotient(path_of_contact(pair), base_pitch(pair));
           });
         });
    if (approach && examine_fillet(1)) examine_corner(1);
    if (recess && of_.kind == PairKind::external && examine_fillet(2)) examine_corner(2);
    if (of_.kind == PairKind::internal) examine_tips();
  }

  // Whether contact ends on the flank. An undercut wheel has none that begins where the edge ends.
  bool examine_fillet(int wheel) {
    if (room_above_cutter_edge(of_, wheel).sign == Sign::negative) return true;
    const auto room = [&]<class T>() -> T {
      const GearPair<T> pair = gear_pair<T>(of_);
      return start_of_contact(pair, wheel) - start_of_flank(pair, wheel);
    };
    return note({Fault::Kind::contact_on_fillet, wheel}, decide(room), [&](Fault& f) {
      const Arithmetic<Deep> scope(128);
      const GearPair<Deep> pair = gear_pair<Deep>(of_);
      f.value = enclosure(radius_at(pair, wheel, start_of_contact(pair, wheel))).value;
      f.limit = enclosure(radius_at(pair, wheel, start_of_flank(pair, wheel))).value;
    });
  }

  // A rack needs no look: the cutter's tooth holds its, and passes deeper. Of a ring it is not looked for.
  void examine_corner(int wheel) {
    if (of_.kind != PairKind::external || has(Fault::Kind::negative_clearance)) return;
    try {
      const auto missing = doubles_first(128, [&]() -> std::optional<double> {
        const Deep room = corner_room(of_, wheel);
        if (sign(room) != Sign::negative) return {};
        return enclosure(room).value;
      });
      if (missing) faults_.push_back({Fault::Kind::corner_in_root, wheel, *missing});
    } catch (const Impossible&) {  // no outline, which other faults say; or no corner so deep
    } catch (const Undecided&) {
    }
  }

  void examine_tips() {
    // Towards the mesh tip circle 1 must reach beyond the ring's, or they never cross (touching in P0, where the
    // flanks roll, is no collision); at the back it must not.
    const auto inside = [&]<class T>() -> T {
      const GearPair<T> pair = gear_pair<T>(of_);
      return pair.wheel2->r_tip - pair.centre_distance - pair.wheel1.r_tip;
    };
    const auto room_behind = [&]<class T>() -> T {
      const GearPair<T> pair = gear_pair<T>(of_);
      return pair.wheel2->r_tip + pair.centre_distance - pair.wheel1.r_tip;
    };
    if (const Sign gap = decide(inside).sign; gap == Sign::positive || gap == Sign::zero) return;
    const bool they_cross = note({Fault::Kind::tips_collide}, zero_is_none(decide(room_behind)), [&](Fault& f) {
      f.value = nearest_double([&] { return room_behind.operator()<Deep>(); });
    });
    if (they_cross)
      note({Fault::Kind::tips_collide}, decide([&]<class T>() -> T { return room_between_tips<T>(of_); }),
           [&](Fault& f) { f.value = nearest_double([&] { return room_between_tips<Deep>(of_); }); });
  }

  bool has(Fault::Kind kind) const {
    return std::any_of(faults_.begin(), faults_.end(), [&](const Fault& fault) { return fault.kind == kind; });
  }

  const PairData& of_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> faults(const PairData& of) { return Examination(of).all(); }

}  // namespace epure::geometry
