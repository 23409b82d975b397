// The pair of gears twice: constructed with circles and the line of action, and by closed formulas.
#pragma once

#include "exercises/gear-pair/problem.h"
#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/driving_crank.h"
#include "geometry/analytic/gear_limits.h"
#include "geometry/gears/limits.h"
#include "geometry/gears/sliding.h"
#include "geometry/gears/tooth_thickness.h"

namespace epure::gear_pair {

using geometry::PairData;
using geometry::PairKind;

inline constexpr Phrase no_circle{"wheel 2 is a rack: it has no centre and no number of teeth",
                                  "la ruota 2 è una dentiera: non ha centro né numero di denti"};
inline constexpr Phrase no_limit_in_recess{
    "only two external wheels can interfere in the recess: a ring and a rack have no tangent point there",
    "solo due ruote esterne possono interferire in recesso: una corona e una dentiera non hanno lì un punto di "
    "tangenza"};

// The same pair for the formulas, which share nothing with the construction but the numbers.
inline geometry::analytic::Gears gears_of(const PairData& of) {
  using geometry::analytic::Mate;
  const Mate mate = of.kind == PairKind::internal ? Mate::ring : of.kind == PairKind::rack ? Mate::rack : Mate::wheel;
  return {mate, of.z1, of.z2, of.m, of.alpha, of.x1, of.x2, of.ha, of.hf, of.k, of.j};
}

// "r_tip_" and 1: "r_tip_1".
inline std::string on(const std::string& name, int wheel, const std::string& after = "") {
  return name + std::to_string(wheel) + after;
}

template <class T>
T magnitude(const T& x) {
  return size(geometry::Vector<T>{x, T(0)});
}

// Writes down one route; what belongs to the circles of wheel 2 is absent of a rack.
template <class T>
struct PairLedger {
  Ledger<T>& ledger;
  bool rack;

  void put(const std::string& name, const std::function<T()>& find) const { ledger.put(name, find); }
  void of_circle(int wheel, const std::string& name, const std::function<T()>& find) const {
    ledger.put(name, [&]() -> T {
      if (wheel == 2 && rack) throw geometry::Impossible(no_circle);
      return find();
    });
  }
};

// By construction.
template <class T>
class Constructed {
 public:
  Constructed(Ledger<T>& ledger, const PairData& of, const T& omega_1)
      : to_{ledger, of.kind == PairKind::rack}, of_(of), pair_(geometry::gear_pair<T>(of)), omega_1_(omega_1) {
    ledger.route("construction");
  }

  void write() const {
    for (const int wheel : {1, 2}) {
      write_circles(wheel);
      write_height(wheel);
      write_tooth(wheel);
    }
    write_pair();
    write_path();
    write_sliding();
    write_limits();
  }

 private:
  using Point = geometry::Point<T>;

  static T number(const Rational& q) { return geometry::from_rational<T>(q); }
  const geometry::WheelCircles<T>& circles(int wheel) const { return wheel == 1 ? pair_.wheel1 : *pair_.wheel2; }
  int outwards(int wheel) const { return wheel == 2 && of_.kind == PairKind::internal ? -1 : 1; }

  void write_circles(int wheel) const {
    to_.of_circle(wheel, on("r", wheel), [&] { return circles(wheel).r; });
    to_.of_circle(wheel, on("r_tip_", wheel), [&] { return circles(wheel).r_tip; });
    to_.of_circle(wheel, on("r_root_", wheel), [&] { return circles(wheel).r_root; });
    // The line at α through the reference circle's pitch point touches the base circle.
    to_.of_circle(wheel, on("r_base_", wheel),
                  [&] { return distance(centre_of_reference(wheel), tangent_point(wheel)); });
    to_.of_circle(wheel, on("r_w_", wheel), [&] { return distance(wheel == 1 ? pair_.O1 : *pair_.O2, pair_.P0); });
    to_.of_circle(wheel, on("z", wheel), [&] { return geometry::quotient(T(2) * circles(wheel).r, number(of_.m)); });
  }

  // The wheel on its generating rack, pitch point in the origin and the rack above.
  Point centre_of_reference(int wheel) const { return {T(0), -circles(wheel).r}; }
  Point tangent_point(int wheel) const {
    const geometry::Vector<T> along{-pair_.alpha.cosine, pair_.alpha.sine};
    return geometry::foot(centre_of_reference(wheel), geometry::line(Point{T(0), T(0)}, along));
  }

  void write_height(int wheel) const {
    const std::string which = wheel == 1 ? "" : "_2";
    const geometry::RackLines lines = geometry::rack_lines(of_);
    to_.put("addendum" + which, [&]() -> T {
      if (wheel == 2 && to_.rack) return number(lines.reference - lines.tip);
      return T(outwards(wheel)) * (circles(wheel).r_tip - circles(wheel).r);
    });
    to_.put("dedendum" + which, [&]() -> T {
      if (wheel == 2 && to_.rack) return number(lines.root - lines.reference);
      return T(outwards(wheel)) * (circles(wheel).r - circles(wheel).r_root);
    });
    to_.put("clearance" + which, [&] { return clearance(wheel); });
  }

  // Along the line of centres, heights above P0.
  T clearance(int wheel) const {
    const auto height = [&](int of_wheel, bool tip) -> T {
      if (of_wheel == 2 && to_.rack)
        return number(tip ? geometry::rack_lines(of_).tip : geometry::rack_lines(of_).root);
      const T r = tip ? circles(of_wheel).r_tip : circles(of_wheel).r_root;
      if (of_wheel == 1) return pair_.O1.y + r;
      return pair_.O2->y + (of_.kind == PairKind::internal ? r : -r);
    };
    return wheel == 1 ? height(2, false) - height(1, true) : height(2, true) - height(1, false);
  }

  void write_tooth(int wheel) const {
    const bool of_rack = wheel == 2 && to_.rack;
    to_.put(on("tooth_thickness_pitch_", wheel), [&]() -> T {
      if (of_rack) return geometry::rack_tooth_thickness(pair_, T(0));
      return geometry::tooth_thickness(pair_, wheel, circles(wheel).r, pair_.alpha);
    });
    to_.put(on("tooth_thickness_working_", wheel), [&]() -> T {
      if (of_rack) return geometry::rack_tooth_thickness(pair_, number(geometry::rack_lines(of_).reference));
      return geometry::tooth_thickness(pair_, wheel, circles(wheel).r_w, pair_.alpha_w);
    });
    to_.of_circle(wheel, on("tooth_thickness_base_", wheel), [&] { return geometry::base_thickness(pair_, wheel); });
    to_.put(on("tooth_thickness_tip_", wheel), [&] { return geometry::tip_thickness(pair_, wheel); });
    to_.put(on("tip_pressure_angle_", wheel, "_deg"), [&]() -> T {
      if (of_rack) return given_in_degrees<T>(of_.alpha);
      const auto at_tip = geometry::pressure_angle_at(circles(wheel).r_tip, circles(wheel).r_b);
      return in_degrees(slope_angle(geometry::Vector<T>{at_tip.cosine, at_tip.sine}));
    });
  }

  void write_pair() const {
    to_.put("centre_distance", [&] { return distance(pair_.O1, pair_.O2 ? *pair_.O2 : pair_.P0); });
    to_.put("working_pressure_angle_deg", [&] {
      return in_degrees(slope_angle(geometry::Vector<T>{pair_.alpha_w.cosine, pair_.alpha_w.sine}));
    });
    to_.put("tooth_height", [&] { return pair_.wheel1.r_tip - pair_.wheel1.r_root; });
    to_.put("circular_pitch", [&] { return pitch_of(pair_.wheel1.r); });
    to_.put("base_pitch", [&] { return pitch_of(pair_.wheel1.r_b); });
  }
  T pitch_of(const T& radius) const {
    return geometry::quotient(T(2) * geometry::pi<T>() * radius, number(Rational(of_.z1)));
  }

  // Arcs on the working pitch circles: the pitch point of a wheel moves 1/cos α_w times as fast as the contact.
  T arc(const T& path) const { return geometry::quotient(path, pair_.alpha_w.cosine); }
  T approach() const { return -pair_.position(pair_.A()); }
  T recess() const { return pair_.position(pair_.E()); }

  void write_path() const {
    to_.put("path_of_approach", [&] { return approach(); });
    to_.put("path_of_recess", [&] { return recess(); });
    to_.put("path_of_contact", [&] { return recess() + approach(); });
    to_.put("arc_of_approach", [&] { return arc(approach()); });
    to_.put("arc_of_recess", [&] { return arc(recess()); });
    to_.put("arc_of_action", [&] { return arc(approach()) + arc(recess()); });
    to_.put("contact_ratio",
            [&] { return geometry::quotient(arc(approach()) + arc(recess()), pitch_of(pair_.wheel1.r_w)); });
    to_.put("start_of_active_profile_radius_1", [&] { return distance(pair_.O1, pair_.A()); });
    to_.of_circle(2, "start_of_active_profile_radius_2", [&] { return distance(*pair_.O2, pair_.E()); });
  }

  void write_sliding() const {
    const geometry::PairSpeeds<T> speeds = geometry::pair_speeds(pair_, omega_1_);
    to_.put("omega_1", [&] { return speeds.omega_1; });
    to_.put("omega_2", [&] { return speeds.omega_2; });
    to_.put("omega_relative", [&] { return magnitude<T>(speeds.relative()); });
    const auto end = [&](const std::string& where, const std::function<Point()>& point) {
      const auto velocities = [&] { return geometry::flank_velocities(pair_, omega_1_, point()); };
      to_.put("sliding_velocity_" + where, [&] { return magnitude<T>(velocities().sliding()); });
      to_.put("specific_sliding_1_" + where, [&] { return velocities().specific_1(); });
      to_.put("specific_sliding_2_" + where, [&] { return velocities().specific_2(); });
    };
    end("approach", [&] { return pair_.A(); });
    end("recess", [&] { return pair_.E(); });
  }

  void write_limits() const {
    to_.put("interference_limit_approach", [&] { return distance(pair_.P0, pair_.T1); });
    to_.put("interference_limit_recess", [&] { return distance(pair_.P0, T2()); });
    to_.of_circle(2, "max_tip_radius_2_without_interference", [&] { return distance(*pair_.O2, pair_.T1); });
    to_.put("max_tip_radius_1_without_interference", [&] { return distance(pair_.O1, T2()); });
    to_.put("undercut_limit_addendum_1",
            [&] { return number(geometry::rack_lines(of_).reference) - tangent_point(1).y; });
    // The depth of T, of the reference pitch circle, is as the number of teeth.
    to_.put("undercut_limit_teeth", [&] {
      return geometry::quotient(number(Rational(of_.z1) * of_.m * (of_.ha - of_.x1)), -tangent_point(1).y);
    });
    to_.put("interference_limit_teeth", [&] { return geometry::interference_limit_teeth<T>(of_); });
  }
  const Point& T2() const {
    if (of_.kind != PairKind::external) throw geometry::Impossible(no_limit_in_recess);
    return *pair_.T2;
  }

  PairLedger<T> to_;
  const PairData& of_;
  geometry::GearPair<T> pair_;
  T omega_1_;
};

// By closed formulas.
template <class T>
class Calculated {
 public:
  Calculated(Ledger<T>& ledger, const PairData& of, const T& omega_1)
      : to_{ledger, of.kind == PairKind::rack},
        by_(geometry::analytic::gear_formulas<T>(gears_of(of))),
        omega_1_(omega_1) {
    ledger.route("analytic");
  }

  void write() const {
    for (const int wheel : {1, 2}) {
      write_circles(wheel);
      write_height(wheel);
      write_tooth(wheel);
    }
    write_pair();
    write_path();
    write_sliding();
    write_limits();
  }

 private:
  static T number(const Rational& q) { return geometry::from_rational<T>(q); }
  const geometry::analytic::Gears& of() const { return by_.of; }
  bool is_rack(int wheel) const { return wheel == 2 && to_.rack; }

  void write_circles(int wheel) const {
    to_.of_circle(wheel, on("r", wheel), [&] { return by_.r(wheel); });
    to_.of_circle(wheel, on("r_tip_", wheel), [&] { return by_.r_tip(wheel); });
    to_.of_circle(wheel, on("r_root_", wheel), [&] { return by_.r_root(wheel); });
    to_.of_circle(wheel, on("r_base_", wheel), [&] { return by_.r_b(wheel); });
    to_.of_circle(wheel, on("r_w_", wheel), [&] { return by_.r_w(wheel); });
    to_.of_circle(wheel, on("z", wheel), [&] { return number(by_.z(wheel)); });
  }

  void write_height(int wheel) const {
    const std::string which = wheel == 1 ? "" : "_2";
    const Rational shift = is_rack(wheel) ? Rational(0) : Rational(by_.s(wheel) * by_.x(wheel));
    to_.put("addendum" + which, [&] { return number(of().m * (of().ha - of().k + shift)); });
    to_.put("dedendum" + which, [&] { return number(of().m * (of().hf - shift)); });
    to_.put("clearance" + which, [&] { return by_.clearance(wheel); });
  }

  void write_tooth(int wheel) const {
    to_.put(on("tooth_thickness_pitch_", wheel),
            [&] { return is_rack(wheel) ? by_.rack_thickness(0) : by_.reference_thickness(wheel); });
    to_.put(on("tooth_thickness_working_", wheel),
            [&] { return is_rack(wheel) ? by_.rack_thickness(of().m * of().x1) : by_.working_thickness(wheel); });
    to_.of_circle(wheel, on("tooth_thickness_base_", wheel), [&] { return by_.base_thickness(wheel); });
    to_.put(on("tooth_thickness_tip_", wheel), [&] {
      return is_rack(wheel) ? by_.rack_thickness(of().m * (of().ha - of().k)) : by_.tip_thickness(wheel);
    });
    to_.put(on("tip_pressure_angle_", wheel, "_deg"), [&] {
      return is_rack(wheel) ? given_in_degrees<T>(of().alpha) : in_degrees(by_.tip_pressure_angle(wheel));
    });
  }

  void write_pair() const {
    to_.put("centre_distance", [&] { return by_.a(); });
    to_.put("working_pressure_angle_deg", [&]() -> T {
      if (!of().is_shifted()) return given_in_degrees<T>(of().alpha);
      return in_degrees(slope_angle(geometry::Vector<T>{by_.alpha_w.cosine, by_.alpha_w.sine}));
    });
    to_.put("tooth_height", [&] { return number(of().m * (of().ha + of().hf - of().k)); });
    to_.put("circular_pitch", [&] { return number(of().m) * geometry::pi<T>(); });
    to_.put("base_pitch", [&] { return by_.base_pitch(); });
  }

  void write_path() const {
    to_.put("path_of_approach", [&] { return by_.path_of_approach(); });
    to_.put("path_of_recess", [&] { return by_.path_of_recess(); });
    to_.put("path_of_contact", [&] { return by_.path_of_contact(); });
    to_.put("arc_of_approach", [&] { return by_.arc(by_.path_of_approach()); });
    to_.put("arc_of_recess", [&] { return by_.arc(by_.path_of_recess()); });
    to_.put("arc_of_action", [&] { return by_.arc(by_.path_of_contact()); });
    to_.put("contact_ratio", [&] { return by_.contact_ratio(); });
    to_.put("start_of_active_profile_radius_1", [&] { return by_.start_of_active_profile(1); });
    to_.of_circle(2, "start_of_active_profile_radius_2", [&] { return by_.start_of_active_profile(2); });
  }

  void write_sliding() const {
    const Rational ratio = by_.speed_ratio();  // ω2/ω1 < 1
    to_.put("omega_1", [&] { return omega_1_; });
    to_.put("omega_2", [&] { return number(ratio) * omega_1_; });
    const auto relative = [&] { return number(1 - ratio) * omega_1_; };
    to_.put("omega_relative", relative);
    const auto end = [&](const std::string& where, const std::function<T()>& xi) {
      to_.put("sliding_velocity_" + where, [&] { return magnitude<T>(relative() * xi()); });
      to_.put("specific_sliding_1_" + where, [&] { return by_.specific_sliding_1(xi()); });
      to_.put("specific_sliding_2_" + where, [&] { return by_.specific_sliding_2(xi()); });
    };
    end("approach", [&] { return -by_.path_of_approach(); });
    end("recess", [&] { return by_.path_of_recess(); });
  }

  void write_limits() const {
    const auto external = [&](const std::function<T()>& find) {
      return [&, find]() -> T {
        if (of().mate != geometry::analytic::Mate::wheel) throw geometry::Impossible(no_limit_in_recess);
        return find();
      };
    };
    to_.put("interference_limit_approach", [&] { return by_.limit_of_path(1); });
    to_.put("interference_limit_recess", external([&] { return by_.limit_of_path(2); }));
    to_.of_circle(2, "max_tip_radius_2_without_interference", [&] { return by_.limit_of_tip(2); });
    to_.put("max_tip_radius_1_without_interference", external([&] { return by_.limit_of_tip(1); }));
    to_.put("undercut_limit_addendum_1", [&] { return by_.undercut_limit_addendum(); });
    to_.put("undercut_limit_teeth", [&] { return geometry::analytic::undercut_limit_teeth<T>(of()); });
    to_.put("interference_limit_teeth", [&] { return geometry::analytic::interference_limit_teeth<T>(of()); });
  }

  PairLedger<T> to_;
  geometry::analytic::GearFormulas<T> by_;
  T omega_1_;
};

// The least whole numbers of teeth are decisions, taken once for all numbers.
struct LeastTeeth {
  long rack, pinion;
};

struct Routes {
  Routes(const PairData& given, const Angle& turning)
      : of(given),
        speed(turning),
        by_construction{geometry::minimum_teeth_against_rack(of, of.x1), geometry::minimum_teeth_of_pinion(of)},
        by_formulas{geometry::analytic::minimum_teeth_against_rack(gears_of(of)),
                    geometry::analytic::minimum_teeth_of_pinion(gears_of(of))} {}

  PairData of;
  Angle speed;  // of wheel 1, in a second
  LeastTeeth by_construction, by_formulas;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    const T omega_1 = crank_speed<T>(speed, {});
    Constructed<T>(ledger, of, omega_1).write();
    write(ledger, by_construction);
    Calculated<T>(ledger, of, omega_1).write();
    write(ledger, by_formulas);
    return ledger;
  }

 private:
  template <class T>
  static void write(Ledger<T>& ledger, const LeastTeeth& least) {
    ledger.put("minimum_teeth_no_undercut_rack", geometry::from_rational<T>(Rational(least.rack)));
    ledger.put("minimum_teeth_pinion_for_this_ratio", geometry::from_rational<T>(Rational(least.pinion)));
  }
};

}  // namespace epure::gear_pair
