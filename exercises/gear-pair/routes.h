// The pair of gears twice: constructed with circles and the line of action, and by closed formulas, which share
// nothing with the construction but the numbers given.
#pragma once

#include "exercises/gear-pair/base_tangent.h"
#include "exercises/gear-pair/quantities.h"
#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/driving_crank.h"
#include "geometry/analytic/gear_limits.h"
#include "geometry/gears/contact_path.h"
#include "geometry/gears/limits.h"
#include "geometry/gears/sliding.h"

namespace epure::gear_pair {

using geometry::PairData;
using geometry::PairKind;

inline constexpr Phrase no_circle{"wheel 2 is a rack: it has no centre and no number of teeth",
                                  "la ruota 2 è una dentiera: non ha centro né numero di denti"};
inline constexpr Phrase no_limit_in_recess{
    "only two external wheels can interfere in the recess: a ring and a rack have no tangent point there",
    "solo due ruote esterne possono interferire in recesso: una corona e una dentiera non hanno lì un punto di "
    "tangenza"};

inline geometry::analytic::Gears gears_of(const PairData& of) {
  using geometry::analytic::Mate;
  const Mate mate = of.kind == PairKind::internal ? Mate::ring : of.kind == PairKind::rack ? Mate::rack : Mate::wheel;
  return {mate, of.z1, of.z2, of.m, of.alpha, of.x1, of.x2, of.ha, of.hf, of.k, of.j};
}

// The least whole numbers of teeth are decisions, taken once for all numbers.
struct LeastTeeth {
  long rack, pinion;
};

template <class T>
class PairRoutes {
 public:
  PairRoutes(Ledger<T>& ledger, const PairData& of, const T& omega_1)
      : ledger_(ledger),
        of_(of),
        pair_(geometry::gear_pair<T>(of)),
        by_(geometry::analytic::gear_formulas<T>(gears_of(of))),
        omega_1_(omega_1) {}

  void write(const LeastTeeth& constructed, const LeastTeeth& calculated) const {
    write_circles();
    write_heights();
    write_path();
    write_sliding();
    for (const int wheel : {1, 2}) write_tooth(wheel);
    write_limits(constructed, calculated);
  }

  // What the sheets draw and print besides.
  void write_drawn() const {
    write_data();
    write_flanks();
  }

 private:
  using Point = geometry::Point<T>;
  using Find = std::function<T()>;
  using End = Point (geometry::GearPair<T>::*)() const;

  void put(const Quantity& quantity, const Find& constructed, const Find& calculated) const {
    ledger_.route("construction");
    ledger_.put(quantity, constructed);
    ledger_.route("analytic");
    ledger_.put(quantity, calculated);
  }
  // Absent of a rack.
  void put_of_circle(int wheel, const Quantity& quantity, const Find& constructed, const Find& calculated) const {
    if (is_rack(wheel))
      put(quantity, impossible(no_circle), impossible(no_circle));
    else
      put(quantity, constructed, calculated);
  }

  static Find impossible(const Phrase& why) {
    return [why]() -> T { throw geometry::Impossible(why); };
  }
  bool is_rack(int wheel) const { return wheel == 2 && of_.kind == PairKind::rack; }
  bool is_ring(int wheel) const { return wheel == 2 && of_.kind == PairKind::internal; }
  const geometry::WheelCircles<T>& circles(int wheel) const { return wheel == 1 ? pair_.wheel1 : *pair_.wheel2; }
  const Point& centre(int wheel) const { return wheel == 1 ? pair_.O1 : *pair_.O2; }
  static T degrees_of(const geometry::PressureAngle<T>& a) {
    return in_degrees(slope_angle(geometry::Vector<T>{a.cosine, a.sine}));
  }

  // The wheel on its generating rack, pitch point in the origin and the rack above: the line at α through the pitch
  // point touches the base circle.
  Point centre_below(int wheel) const { return {T(0), -circles(wheel).r}; }
  Point tangent_point(int wheel) const {
    const geometry::Vector<T> along{-pair_.alpha.cosine, pair_.alpha.sine};
    return geometry::foot(centre_below(wheel), geometry::line(Point{T(0), T(0)}, along));
  }

  void write_circles() const {
    const auto radii = [&](const char* name, const char* index, const Words& what, const auto& constructed,
                           const auto& calculated) {
      for (const int w : {1, 2})
        put_of_circle(
            w, of_wheel(w, name, "r", index, what), [&, w] { return constructed(w); },
            [&, w] { return calculated(w); });
    };
    radii(
        "r", "", {"pitch radius", "raggio primitivo"}, [&](int w) { return circles(w).r; },
        [&](int w) { return by_.r(w); });
    radii(
        "r_tip_", "a", {"tip radius", "raggio di troncatura esterna"}, [&](int w) { return circles(w).r_tip; },
        [&](int w) { return by_.r_tip(w); });
    radii(
        "r_root_", "f", {"root radius", "raggio di troncatura interna"}, [&](int w) { return circles(w).r_root; },
        [&](int w) { return by_.r_root(w); });
    radii(
        "r_base_", "b", {"base radius", "raggio di base"},
        [&](int w) { return distance(centre_below(w), tangent_point(w)); }, [&](int w) { return by_.r_b(w); });
    radii(
        "r_w_", "w", {"working pitch radius", "raggio della primitiva di funzionamento"},
        [&](int w) { return distance(centre(w), pair_.P0); }, [&](int w) { return by_.r_w(w); });
    put(
        length("centre_distance", "a", {"centre distance", "interasse"}),
        [&] { return distance(pair_.O1, pair_.O2 ? *pair_.O2 : pair_.P0); }, [&] { return by_.a(); });
    put(
        quantity("working_pressure_angle_deg", "α_{w}", "deg",
                 {"working pressure angle", "angolo di pressione di funzionamento"}),
        [&] { return degrees_of(pair_.alpha_w); },
        [&]() -> T {
          if (!by_.of.is_shifted()) return given_in_degrees<T>(of_.alpha);
          return in_degrees(slope_angle(geometry::Vector<T>{by_.alpha_w.cosine, by_.alpha_w.sine}));
        });
  }

  void write_heights() const {
    const geometry::RackLines lines = geometry::rack_lines(of_);
    for (const int w : {1, 2}) {
      const std::string name = w == 1 ? "" : "_2";
      const T outwards(is_ring(w) ? -1 : 1);
      const Rational shift = is_rack(w) ? Rational(0) : Rational(by_.s(w) * by_.x(w));
      Quantity addendum = of_wheel(w, "", "h", "a", {"addendum", "addendum"}),
               dedendum = of_wheel(w, "", "h", "f", {"dedendum", "dedendum"});
      addendum.name = "addendum" + name;
      dedendum.name = "dedendum" + name;
      put(
          addendum,
          [&] {
            return is_rack(w) ? number<T>(lines.reference - lines.tip) : outwards * (circles(w).r_tip - circles(w).r);
          },
          [&] { return number<T>(of_.m * (of_.ha - of_.k + shift)); });
      put(
          dedendum,
          [&] {
            return is_rack(w) ? number<T>(lines.root - lines.reference)
                              : outwards * (circles(w).r - circles(w).r_root);
          },
          [&] { return number<T>(of_.m * (of_.hf - shift)); });
    }
    put(
        length("tooth_height", "h", {"height of the teeth", "altezza dei denti"}),
        [&] { return pair_.wheel1.r_tip - pair_.wheel1.r_root; },
        [&] { return number<T>(of_.m * (of_.ha + of_.hf - of_.k)); });
    put(
        length("clearance", "δ", {"clearance between tip 1 and root 2", "gioco tra la testa 1 e il fondo 2"}),
        [&] { return height(2, false) - height(1, true); }, [&] { return by_.clearance(1); });
    put(
        length("clearance_2", "δ_{2}", {"clearance between tip 2 and root 1", "gioco tra la testa 2 e il fondo 1"}),
        [&] { return height(2, true) - height(1, false); }, [&] { return by_.clearance(2); });
    for (const int w : {1, 2})
      put_of_circle(
          w, pure(on("z", w), on("z_{", w) + "}", format_words("teeth of wheel {}", "denti della ruota {}", w)),
          [&, w] { return geometry::quotient(T(2) * circles(w).r, number<T>(of_.m)); },
          [&, w] { return number<T>(by_.z(w)); });
    put(
        length("circular_pitch", "p", {"circular pitch", "passo circonferenziale"}),
        [&] { return pitch_of(pair_.wheel1.r); }, [&] { return number<T>(of_.m) * geometry::pi<T>(); });
    put(
        length("base_pitch", "p_{b}", {"base pitch", "passo di base"}), [&] { return pitch_of(pair_.wheel1.r_b); },
        [&] { return by_.base_pitch(); });
  }
  // Of the tip or root on the line of centres in the mesh, above P0.
  T height(int wheel, bool tip) const {
    if (is_rack(wheel)) return number<T>(tip ? geometry::rack_lines(of_).tip : geometry::rack_lines(of_).root);
    const T r = tip ? circles(wheel).r_tip : circles(wheel).r_root;
    return wheel == 1 || is_ring(wheel) ? centre(wheel).y + r : centre(wheel).y - r;
  }
  T pitch_of(const T& radius) const {
    return geometry::quotient(T(2) * geometry::pi<T>() * radius, number<T>(Rational(of_.z1)));
  }

  // Arcs are on the working pitch circles: the pitch point of a wheel moves 1/cos α_w times as fast as the contact.
  T arc(const T& path) const { return geometry::quotient(path, pair_.alpha_w.cosine); }
  T approach() const { return -pair_.position(pair_.A()); }
  T recess() const { return pair_.position(pair_.E()); }

  void write_path() const {
    put(
        length("path_of_approach", "P_{0}A", {"path of approach", "linea di ingranamento di accesso"}),
        [&] { return approach(); }, [&] { return by_.path_of_approach(); });
    put(
        length("path_of_recess", "P_{0}E", {"path of recess", "linea di ingranamento di recesso"}),
        [&] { return recess(); }, [&] { return by_.path_of_recess(); });
    put(
        length("path_of_contact", "AE", {"path of contact", "linea di ingranamento"}),
        [&] { return recess() + approach(); }, [&] { return by_.path_of_contact(); });
    put(
        length("arc_of_approach", "e_{a}", {"arc of approach", "arco di accesso"}), [&] { return arc(approach()); },
        [&] { return by_.arc(by_.path_of_approach()); });
    put(
        length("arc_of_recess", "e_{r}", {"arc of recess", "arco di recesso"}), [&] { return arc(recess()); },
        [&] { return by_.arc(by_.path_of_recess()); });
    put(
        length("arc_of_action", "e", {"arc of action", "arco di azione"}),
        [&] { return arc(approach()) + arc(recess()); }, [&] { return by_.arc(by_.path_of_contact()); });
    put(
        pure("contact_ratio", "f", {"contact ratio", "fattore di ricoprimento"}),
        [&] { return geometry::quotient(arc(approach()) + arc(recess()), pitch_of(pair_.wheel1.r_w)); },
        [&] { return by_.contact_ratio(); });
    for (const int w : {1, 2})
      put_of_circle(
          w,
          length(on("start_of_active_profile_radius_", w), w == 1 ? "O_{1}A" : "O_{2}E",
                 format_words("radius at which the active profile of wheel {} begins",
                              "raggio al quale inizia il profilo attivo della ruota {}", w)),
          [&, w] { return distance(centre(w), w == 1 ? pair_.A() : pair_.E()); },
          [&, w] { return by_.start_of_active_profile(w); });
  }

  void write_sliding() const {
    const auto speeds = geometry::pair_speeds(pair_, omega_1_);
    const Rational ratio = by_.speed_ratio();
    const auto omega = [&](const char* name, const char* index, const Words& meaning, const Find& constructed,
                           const Find& calculated) {
      put(quantity(std::string("omega_") + name, std::string("ω_{") + index + "}", "rad/s", meaning), constructed,
          calculated);
    };
    const auto relative = [&] { return number<T>(1 - ratio) * omega_1_; };
    omega(
        "1", "1", {"angular velocity of wheel 1", "velocità angolare della ruota 1"}, [&] { return speeds.omega_1; },
        [&] { return omega_1_; });
    omega(
        "2", "2",
        {"angular velocity of wheel 2, as wheel 1 positive", "velocità angolare della ruota 2, positiva come la 1"},
        [&] { return speeds.omega_2; }, [&] { return number<T>(ratio) * omega_1_; });
    omega(
        "relative", "r", {"relative angular velocity", "velocità angolare relativa"},
        [&] { return magnitude_of(speeds.relative()); }, relative);
    struct Where {
      const char *name, *letter;
      End point;
      Find xi;
    };
    const std::array ends{Where{"approach", "A", &geometry::GearPair<T>::A, [&] { return -by_.path_of_approach(); }},
                          Where{"recess", "E", &geometry::GearPair<T>::E, [&] { return by_.path_of_recess(); }}};
    for (const Where& at : ends)
      put(
          quantity(std::string("sliding_velocity_") + at.name, std::string("v_{") + at.letter + "}", "m/s",
                   format_words("sliding velocity in {}", "velocità di strisciamento in {}", at.letter)),
          [&] { return magnitude_of(velocities((pair_.*at.point)()).sliding()); },
          [&] { return magnitude_of(relative() * at.xi()); });
    for (const Where& at : ends)
      for (const int w : {1, 2})
        put(
            pure(on("specific_sliding_", w) + "_" + at.name, on("ζ_{", w) + at.letter + "}",
                 format_words("specific sliding of flank {} in {}", "strisciamento specifico del fianco {} in {}", w,
                              at.letter)),
            [&, w] {
              const auto of = velocities((pair_.*at.point)());
              return w == 1 ? of.specific_1() : of.specific_2();
            },
            [&, w] { return w == 1 ? by_.specific_sliding_1(at.xi()) : by_.specific_sliding_2(at.xi()); });
  }
  geometry::FlankVelocities<T> velocities(const Point& at) const {
    return geometry::flank_velocities(pair_, omega_1_, at);
  }

  void write_tooth(int w) const {
    const auto thickness = [&](const char* circle, const char* index, const Words& where) {
      return of_wheel(w, std::string("tooth_thickness_") + circle + "_", "s", index,
                      format_words("tooth thickness on the {}", "spessore del dente sulla circonferenza {}", where));
    };
    put(
        thickness("pitch", "", {"pitch circle", "primitiva"}),
        [&] {
          return is_rack(w) ? geometry::rack_tooth_thickness(pair_, T(0))
                            : geometry::tooth_thickness(pair_, w, circles(w).r, pair_.alpha);
        },
        [&] { return is_rack(w) ? by_.rack_thickness(0) : by_.reference_thickness(w); });
    put(
        thickness("working", "w", {"working pitch circle", "primitiva di funzionamento"}),
        [&] {
          return is_rack(w) ? geometry::rack_tooth_thickness(pair_, number<T>(geometry::rack_lines(of_).reference))
                            : geometry::tooth_thickness(pair_, w, circles(w).r_w, pair_.alpha_w);
        },
        [&] { return is_rack(w) ? by_.rack_thickness(of_.m * of_.x1) : by_.working_thickness(w); });
    put_of_circle(
        w, thickness("base", "b", {"base circle", "di base"}), [&] { return geometry::base_thickness(pair_, w); },
        [&] { return by_.base_thickness(w); });
    put(
        thickness("tip", "a", {"tip circle", "di troncatura esterna"}),
        [&] { return geometry::tip_thickness(pair_, w); },
        [&] { return is_rack(w) ? by_.rack_thickness(of_.m * (of_.ha - of_.k)) : by_.tip_thickness(w); });
    put(
        quantity(
            on("tip_pressure_angle_", w) + "_deg", on("α_{a", w) + "}", "deg",
            format_words("pressure angle at the tip of wheel {}", "angolo di pressione in testa della ruota {}", w)),
        [&] {
          return is_rack(w) ? given_in_degrees<T>(of_.alpha)
                            : degrees_of(geometry::pressure_angle_at(circles(w).r_tip, circles(w).r_b));
        },
        [&] { return is_rack(w) ? given_in_degrees<T>(of_.alpha) : in_degrees(by_.tip_pressure_angle(w)); });
  }

  // T2 limits the recess of external wheels only.
  Find external(const Find& find) const {
    if (of_.kind == PairKind::external) return find;
    return impossible(no_limit_in_recess);
  }

  void write_limits(const LeastTeeth& constructed, const LeastTeeth& calculated) const {
    put(
        length("interference_limit_approach", "P_{0}T_{1}",
               {"longest path of approach without interference", "massima linea di accesso senza interferenza"}),
        [&] { return distance(pair_.P0, pair_.T1); }, [&] { return by_.limit_of_path(1); });
    put(length("interference_limit_recess", "P_{0}T_{2}",
               {"longest path of recess without interference", "massima linea di recesso senza interferenza"}),
        external([&] { return distance(pair_.P0, *pair_.T2); }), external([&] { return by_.limit_of_path(2); }));
    const auto limit_of_tip = [](int w, const char* letters) {
      return length(on("max_tip_radius_", w) + "_without_interference", letters,
                    format_words("tip radius of wheel {} at which interference begins",
                                 "raggio di testa della ruota {} al quale inizia l'interferenza", w));
    };
    put_of_circle(
        2, limit_of_tip(2, "O_{2}T_{1}"), [&] { return distance(*pair_.O2, pair_.T1); },
        [&] { return by_.limit_of_tip(2); });
    put(limit_of_tip(1, "O_{1}T_{2}"), external([&] { return distance(pair_.O1, *pair_.T2); }),
        external([&] { return by_.limit_of_tip(1); }));
    put(
        length("undercut_limit_addendum_1", "h_{lim1}",
               {"largest addendum of the rack that does not undercut wheel 1",
                "massimo addendum della dentiera che non sottotaglia la ruota 1"}),
        [&] { return number<T>(geometry::rack_lines(of_).reference) - tangent_point(1).y; },
        [&] { return by_.undercut_limit_addendum(); });
    // The depth of T, of the reference pitch circle, is as the number of teeth.
    put(
        pure("undercut_limit_teeth", "z_{lim}",
             {"limit of undercut by the rack, in teeth of wheel 1",
              "limite di sottotaglio con la dentiera, in denti della ruota 1"}),
        [&] {
          return geometry::quotient(number<T>(Rational(of_.z1) * of_.m * (of_.ha - of_.x1)), -tangent_point(1).y);
        },
        [&] { return geometry::analytic::undercut_limit_teeth<T>(by_.of); });
    put(
        pure("minimum_teeth_no_undercut_rack", "z_{min}",
             {"least teeth of wheel 1 without undercut by the rack",
              "minimo numero di denti della ruota 1 senza sottotaglio"}),
        [&] { return number<T>(Rational(constructed.rack)); }, [&] { return number<T>(Rational(calculated.rack)); });
    put(
        pure("interference_limit_teeth", "z_{int}",
             {"limit of interference at this ratio, in teeth of wheel 1",
              "limite di interferenza con questo rapporto, in denti della ruota 1"}),
        [&] { return geometry::interference_limit_teeth<T>(of_); },
        [&] { return geometry::analytic::interference_limit_teeth<T>(by_.of); });
    put(
        pure("minimum_teeth_pinion_for_this_ratio", "z_{1min}",
             {"least teeth of wheel 1 without interference at this ratio",
              "minimo numero di denti della ruota 1 senza interferenza con questo rapporto"}),
        [&] { return number<T>(Rational(constructed.pinion)); },
        [&] { return number<T>(Rational(calculated.pinion)); });
  }

  // Of a workshop: diameters, the base tangent; the source's ratio.
  void write_data() const {
    for (const int w : {1, 2}) {
      if (is_rack(w)) continue;
      const geometry::WheelCircles<T>& c = circles(w);
      const std::array diameters{std::pair{"", c.r}, std::pair{"w", c.r_w}, std::pair{"b", c.r_b},
                                 std::pair{"a", c.r_tip}, std::pair{"f", c.r_root}};
      for (const auto& [index, r] : diameters)
        ledger_.draws(of_wheel(w, std::string("d") + index + "_", "d", index, {"diameter", "diametro"}),
                      [&r = r] { return T(2) * r; });
      ledger_.draws(pure(on("k_", w), on("k_{", w) + "}", {"teeth of the base tangent", "denti dello scartamento"}),
                    [&] { return number<T>(Rational(base_tangent(pair_, w).teeth)); });
      ledger_.draws(of_wheel(w, "W_", "𝑊", "", {"base tangent length", "scartamento"}),
                    [&] { return base_tangent(pair_, w).length; });
    }
    ledger_.draws(length("rho", "ρ", {"rounding of the cutter's tip", "raccordo di testa dell'utensile"}),
                  [&] { return number<T>(of_.rho * of_.m); });
    if (is_rack(2))
      ledger_.draws(quantity("v", "v", "m/s", {"speed of the rack", "velocità della dentiera"}),
                    [&] { return omega_1_ * pair_.wheel1.r_w; });
    else
      ledger_.draws(pure("tau", "τ", {"ratio of the radii", "rapporto dei raggi"}),
                    [&] { return geometry::quotient(pair_.wheel1.r, pair_.wheel2->r); });
  }

  // As far as they reach (geometry/gears/contact_path.h). Contact begins in A, or in F1, where a flank 1 that is cut
  // away begins, or in V2, with pointed teeth of wheel 2; it ends in E, F2 or V1. Of these points those exist in
  // which it does so.
  void write_flanks() const {
    using By = geometry::EndOfContact::By;
    std::optional<geometry::ContactPath> path;
    try {
      path = geometry::contact_path(of_);
    } catch (const geometry::Impossible&) {
    } catch (const geometry::Undecided&) {
    }
    const auto draw_position = [&](const std::string& at, const Find& xi) {
      ledger_.draws(position(at), xi);
      for (const int w : {1, 2}) {
        ledger_.draws(flank_velocity(w, at), [&] { return w == 1 ? at_xi(xi()).of_1 : at_xi(xi()).of_2; });
        ledger_.draws(specific_sliding(w, at),
                      [&] { return w == 1 ? at_xi(xi()).specific_1() : at_xi(xi()).specific_2(); });
      }
      ledger_.draws(quantity("v_s_" + at, "v_{s}", "m/s", {"sliding velocity", "velocità di strisciamento"}),
                    [&] { return magnitude_of(at_xi(xi()).sliding()); });
    };
    draw_position("A", [&] { return -approach(); });
    draw_position("E", [&] { return recess(); });
    draw_position("T1", [&] { return pair_.position(pair_.T1); });
    draw_position("T2", pair_.T2 ? Find([&] { return pair_.position(*pair_.T2); }) : impossible(no_circle));
    if (!path) return;
    const auto name = [](By by, const char* root, const char* point) { return by == By::root ? root : point; };
    if (path->begins.by != By::tip) draw_position(name(path->begins.by, "F1", "V2"), [&] { return path->begins.xi; });
    if (path->ends.by != By::tip) draw_position(name(path->ends.by, "F2", "V1"), [&] { return path->ends.xi; });
    ledger_.draws(length("contact", "", {"contact of the flanks", "contatto dei fianchi"}),
                  [&] { return path->length(); });
    ledger_.draws(pure("true_contact_ratio", "f", {"contact ratio", "fattore di ricoprimento"}),
                  [&] { return geometry::quotient(path->length(), pitch_of(pair_.wheel1.r_b)); });
    ledger_.draws(length("overlap", "", {"contact beyond the base pitch", "contatto oltre il passo di base"}),
                  [&] { return path->length() - pitch_of(pair_.wheel1.r_b); });
  }
  geometry::FlankVelocities<T> at_xi(const T& xi) const { return velocities(pair_.at(xi)); }

  Ledger<T>& ledger_;
  const PairData& of_;
  geometry::GearPair<T> pair_;
  geometry::analytic::GearFormulas<T> by_;
  T omega_1_;
};

struct Routes {
  Routes(const PairData& given, const Angle& turning, bool drawn)
      : of(given),
        speed(turning),
        is_drawn(drawn),
        constructed{geometry::minimum_teeth_against_rack(of, of.x1), geometry::minimum_teeth_of_pinion(of)},
        calculated{geometry::analytic::minimum_teeth_against_rack(gears_of(of)),
                   geometry::analytic::minimum_teeth_of_pinion(gears_of(of))} {}

  PairData of;
  Angle speed;  // of wheel 1, in a second
  bool is_drawn;
  LeastTeeth constructed, calculated;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    const PairRoutes<T> routes(ledger, of, crank_speed<T>(speed, {}));
    routes.write(constructed, calculated);
    if constexpr (std::is_same_v<T, geometry::Deep>) {
      if (is_drawn) routes.write_drawn();
    }
    return ledger;
  }
};

}  // namespace epure::gear_pair
