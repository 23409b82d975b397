// The spool and its counterweight by Newton's and Euler's equations as one linear system; and by the balance of
// powers about the instantaneous centre, with forces from moments about points that leave the others out.
#pragma once

#include <functional>
#include <string>

#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "exercises/spool-slip/quantities.h"
#include "exercises/spool-slip/spool.h"
#include "geometry/analytic/equilibrium.h"
#include "geometry/constructions/vector_polygon.h"

namespace epure::spool_slip {

inline constexpr Phrase no_force{
    "no force holds the spool back: no line of action crosses its vertical",
    "nessuna forza trattiene la bobina: nessuna retta d'azione ne incontra la verticale"};
inline constexpr Phrase never_slips{"the spool rolls however heavy the counterweight: F/N never comes to f_a",
                                    "la bobina rotola per quanto pesi il contrappeso: F/N non arriva mai a f_a"};
inline constexpr Phrase slips_first{"the spool slips before it can roll: u/(R - r) is more than f_a",
                                    "la bobina striscia prima di poter rotolare: u/(R - r) supera f_a"};

// a down for b, a_G to the right, alpha clockwise, F to the left, N up, `offset` of N to the right of the foot of G.
template <class T>
struct Motion {
  T a, a_G, alpha, pull, F, offset;
};

template <class T>
struct Numbers {
  explicit Numbers(const Spool& of)
      : m_a(number<T>(of.m_a)),
        R(number<T>(of.R)),
        r(number<T>(of.r)),
        h(number<T>(of.height())),
        f_a(number<T>(of.f_a)),
        f_r(number<T>(of.f_r)),
        f_v(number<T>(of.f_v)),
        g(number<T>(of.g)) {}

  T m_a, R, r, h, f_a, f_r, f_v, g;
};

// Each route says the same of a spool with the counterweight m_b in a regime.
template <class T>
class ByEquations {
 public:
  explicit ByEquations(const Spool& of) : of_(of), n_(of) {}

  // J = m_a i² with the radius of gyration i = R/2.
  T J() const { return n_.m_a * geometry::square(geometry::quotient(n_.R, T(2))); }
  T u() const { return n_.f_v * n_.R; }
  T N() const { return n_.m_a * n_.g; }
  T velocity_ratio() const { return geometry::quotient(n_.R - n_.r, n_.R); }
  // The moment of the force of inertia about G is its couple.
  T inertia_height() const { return n_.R + geometry::quotient(J(), n_.m_a * n_.R); }

  Motion<T> motion(const Rational& mass, Regime regime) const {
    const T m_b = number<T>(mass), none(0);
    if (regime == Regime::at_rest) return {none, none, none, m_b * n_.g, m_b * n_.g, rest_offset(m_b)};
    return regime == Regime::rolling ? rolling(m_b) : slipping(mass, m_b);
  }
  T reaction(const Motion<T>& of) const { return size(geometry::Vector<T>{of.F, N()}); }
  static T angle(const T& F, const T& N) { return slope_angle(geometry::Vector<T>{N, F}); }
  T resultant_height(const Motion<T>& of) const { return Ledger<T>::ratio(N() * of.offset, of.F, no_force); }

  // With F = f_a N: m_a a_G = T - F and T (R - r) = N u + (J + m_a R²) α, then m_b = T/(g - a).
  T slip_ratio() const {
    const T F = n_.f_a * N();
    const auto x = geometry::analytic::solve_linear<T>(
        {{T(1), -n_.m_a}, {n_.h, -geometry::quotient(J() + n_.m_a * geometry::square(n_.R), n_.R)}}, {F, N() * u()});
    return geometry::quotient(x[0], n_.m_a * (n_.g - velocity_ratio() * x[1]));
  }
  // At rest the reaction leans from the vertical as T/N; its line meets those of rope and weight.
  T start_ratio() const { return geometry::quotient(u(), n_.h); }

 private:
  T rest_offset(const T& m_b) const { return geometry::quotient(m_b * n_.h, n_.m_a); }
  // Unknown: a_G, T, F, N.
  Motion<T> rolling(const T& m_b) const {
    const T k = velocity_ratio(), o(0), one(1);
    const auto x = geometry::analytic::solve_linear<T>({{m_b * k, one, o, o},
                                                        {n_.m_a, -one, one, o},
                                                        {o, o, o, one},
                                                        {geometry::quotient(J(), n_.R), n_.r, -n_.R, u()}},
                                                       {m_b * n_.g, o, N(), o});
    return {k * x[0], x[0], geometry::quotient(x[0], n_.R), x[1], x[2], u()};
  }
  // Unknown: a, a_G, α, T.
  Motion<T> slipping(const Rational& mass, const T& m_b) const {
    const Rational e = of_.offset_while_slipping(mass);
    const T offset = number<T>(e), F = n_.f_r * N(), o(0), one(1);
    const bool turns = CGAL::abs(e) == of_.f_v * of_.R;
    const auto x = geometry::analytic::solve_linear<T>(
        {{m_b, o, o, one}, {o, n_.m_a, o, -one}, {one, -one, n_.r, o}, {o, o, turns ? J() : one, turns ? n_.r : o}},
        {m_b * n_.g, -F, o, turns ? F * n_.R - N() * offset : o});
    return {x[0], x[1], turns ? x[2] : o, x[3], F, offset};
  }

  Spool of_;
  Numbers<T> n_;
};

template <class T>
class ByPower {
 public:
  explicit ByPower(const Spool& of) : of_(of), n_(of) {}

  // About the contact, less m_a R² (Huygens).
  T about_contact() const { return number<T>(Rational(5, 4)) * n_.m_a * geometry::square(n_.R); }
  T J() const { return about_contact() - n_.m_a * geometry::square(n_.R); }
  T u() const { return geometry::quotient(n_.f_v * N() * n_.R, N()); }  // the couple lost, over N
  T N() const { return geometry::closing_side(geometry::Vector<T>{T(0), -(n_.m_a * n_.g)}, {T(0), T(0)}).y; }
  // v_A = v_G - ω r.
  T velocity_ratio() const { return T(1) - geometry::quotient(n_.r, n_.R); }
  // The spool turns about the contact: the centre of percussion.
  T inertia_height() const { return geometry::quotient(about_contact(), n_.m_a * n_.R); }

  Motion<T> motion(const Rational& mass, Regime regime) const {
    const T m_b = number<T>(mass), none(0);
    if (regime == Regime::at_rest) {
      const T rope = number<T>(mass * of_.g);
      return {none, none, none, rope, rope, geometry::quotient(rope * n_.h, N())};
    }
    return regime == Regime::rolling ? rolling(m_b) : slipping(mass, m_b);
  }
  // The size of the reaction from its lean.
  T reaction(const Motion<T>& of) const {
    const T lean = geometry::quotient(of.F, N());
    if constexpr (signs_only<T>) {
      return geometry::square(N()) * (T(1) + geometry::square(lean));
    } else {
      return N() * geometry::root(T(1) + geometry::square(lean));
    }
  }
  // Twice the angle on the circumference.
  static T angle(const T& F, const T& N) {
    if constexpr (signs_only<T>) {
      return F;
    } else {
      return T(2) * geometry::arc_tangent(F, T(N + geometry::root(geometry::square(F) + geometry::square(N))));
    }
  }
  // Moments about the contact: of the rope's pull and of the inertia, over their sum.
  T resultant_height(const Motion<T>& of) const {
    const T about = of.pull * n_.h - of.a_G * n_.m_a * n_.R - J() * of.alpha;
    return Ledger<T>::ratio(about, of.pull - n_.m_a * of.a_G, no_force);
  }

  T slip_ratio() const {
    const T k = velocity_ratio(), c = number<T>(Rational(5, 4));
    return geometry::quotient(c * n_.f_a - n_.f_v, c - k + n_.f_v * k - geometry::square(k) * n_.f_a);
  }
  // The rope's power is what rolling takes.
  T start_ratio() const { return geometry::quotient(n_.f_v, velocity_ratio()); }

 private:
  // m_b g v_b - N u ω = (m_a + J/R² + m_b k²) a_G v_G. T from moments about the contact, F from those about the place
  // where the rope's line crosses the vertical through G.
  Motion<T> rolling(const T& m_b) const {
    const T k = velocity_ratio();
    const T mass = geometry::quotient(about_contact(), geometry::square(n_.R)) + m_b * geometry::square(k);
    const T a_G = geometry::quotient(n_.g * (m_b * k - n_.m_a * n_.f_v), mass), alpha = geometry::quotient(a_G, n_.R);
    const T pull = geometry::quotient(about_contact() * alpha + N() * u(), n_.h);
    const T F = geometry::quotient(N() * u() + n_.m_a * a_G * n_.r + J() * alpha, n_.h);
    return {n_.h * alpha, a_G, alpha, pull, F, u()};
  }
  // Virtual displacements of G to the right and of the spool clockwise, one at a time.
  Motion<T> slipping(const Rational& mass, const T& m_b) const {
    const Rational e = of_.offset_while_slipping(mass);
    const T offset = number<T>(e), F = n_.f_r * N(), weight = m_b * n_.g, coupled = -(m_b * n_.r);
    const T along = n_.m_a + m_b, around = J() + m_b * geometry::square(n_.r);
    const T drives = weight - F, turns = F * n_.R - N() * offset - weight * n_.r;
    if (CGAL::abs(e) != of_.f_v * of_.R) {
      const T a = geometry::quotient(drives, along);
      return {a, a, T(0), m_b * (n_.g - a), F, offset};
    }
    const T whole = along * around - geometry::square(coupled);
    const T a_G = geometry::quotient(drives * around - coupled * turns, whole),
            alpha = geometry::quotient(along * turns - coupled * drives, whole), a = a_G - n_.r * alpha;
    return {a, a_G, alpha, m_b * (n_.g - a), F, offset};
  }

  Spool of_;
  Numbers<T> n_;
};

struct Routes {
  Spool of;
  Rational m_b, m_b_heavy, m_b_light;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("Newton-Euler");
    by(ledger, ByEquations<T>(of));
    ledger.begin_case("");
    ledger.route("power balance");
    by(ledger, ByPower<T>(of));
    ledger.begin_case("");
    unit_velocities(ledger);
    return ledger;
  }

 private:
  template <class T, class Way>
  void by(Ledger<T>& ledger, const Way& way) const {
    const Numbers<T> n(of);
    const T F_max = n.f_a * way.N();
    ledger.put(quantity("J"), way.J());
    ledger.put(quantity("u"), way.u());
    ledger.put(quantity("N"), way.N());
    ledger.put(quantity("weight_b"), way.motion(m_b, Regime::at_rest).pull);
    ledger.put(quantity("F_max"), F_max);
    ledger.put(quantity("friction_cone_half_angle"), [&] { return way.angle(F_max, way.N()); });
    ledger.put(quantity("rope_to_centre_velocity_ratio"), way.velocity_ratio());
    ledger.put(quantity("inertia_force_height"), way.inertia_height());
    limits(ledger, way);
    whole(ledger, way, m_b, of.regime(m_b), {"", {}});
    whole(ledger, way, m_b_heavy, trial(m_b_heavy),
          {"heavy_if_rolling.", {", heavy, if it rolled", ", pesante, se rotolasse"}});
    heavy(ledger, way);
    light(ledger, way);
  }

  // Of G and of the rope, for ω = 1 rad/s about the contact C; A lies on the core where the rope leaves it.
  template <class T>
  void unit_velocities(Ledger<T>& ledger) const {
    const Numbers<T> n(of);
    const T o(0);
    ledger.draws_point("C", geometry::Point<T>{o, o});
    ledger.draws_point("G", geometry::Point<T>{o, n.R});
    ledger.draws_point("A", geometry::Point<T>{o, n.h});
    ledger.draws_vector("v_G", {n.R, o});
    ledger.draws_vector("v_AG", {-n.r, o});
    ledger.draws_vector("v_A", {n.h, o});
  }

  Regime trial(const Rational& mass) const { return of.rolls_off(mass) ? Regime::rolling : Regime::at_rest; }

  template <class T, class Way>
  void limits(Ledger<T>& ledger, const Way& way) const {
    const T m_a = geometry::from_rational<T>(of.m_a);
    const auto slip = [&] {
      if (of.slips_from_rest()) throw geometry::Impossible(slips_first);
      if (of.always_rolls()) throw geometry::Impossible(never_slips);
      return way.slip_ratio();
    };
    ledger.put(quantity("mass_ratio_slip"), slip);
    ledger.put(quantity("m_b_slip"), [&] { return m_a * slip(); });
    ledger.put(quantity("mass_ratio_start"), way.start_ratio());
    ledger.put(quantity("m_b_start"), m_a * way.start_ratio());
  }

  // What moves, and what acts on it.
  template <class T, class Way>
  void motion(Ledger<T>& ledger, const Way& way, const Motion<T>& at) const {
    ledger.put(quantity("a"), at.a);
    ledger.put(quantity("a_G"), at.a_G);
    ledger.put(quantity("alpha"), at.alpha);
    ledger.put(quantity("T"), at.pull);
    ledger.put(quantity("F"), at.F);
    ledger.put(quantity("ground_reaction"), [&] { return way.reaction(at); });
    ledger.put(quantity("ground_reaction_inclination"), [&] { return way.angle(at.F, way.N()); });
    ledger.put(quantity("inertia_force"), number<T>(of.m_a) * at.a_G);
    ledger.put(quantity("inertia_couple"), magnitude_of<T>(way.J() * at.alpha));
    draw(ledger, way, at);
  }

  struct Case {
    std::string prefix;
    Words words;
  };
  template <class T, class Way>
  void whole(Ledger<T>& ledger, const Way& way, const Rational& mass, Regime regime, const Case& named) const {
    ledger.begin_case(named.prefix, named.words);
    const Motion<T> at = way.motion(mass, regime),
                    tried = regime == Regime::slipping ? way.motion(mass, trial(mass)) : at;
    motion(ledger, way, at);
    const T F_max = number<T>(of.f_a) * way.N();
    if (named.prefix.empty()) ledger.put(quantity("F_required"), tried.F);  // if it rolled, F itself
    ledger.put(quantity("F_over_N"), geometry::quotient(tried.F, way.N()));
    ledger.put(quantity("slip_margin"), F_max - tried.F);
    ledger.put(quantity("resultant_height"), [&] { return way.resultant_height(at); });
    ledger.put(quantity("slips"), T(of.regime(mass) == Regime::slipping ? 1 : 0));
    if (named.prefix.empty()) ledger.put(quantity("starts"), T(regime == Regime::at_rest ? 0 : 1));
    ledger.tells({"F_over_N_now", "$\\it{F}$/$\\it{N}$", "1", {}}, [&] { return geometry::quotient(at.F, way.N()); });
  }

  template <class T, class Way>
  void heavy(Ledger<T>& ledger, const Way& way) const {
    ledger.begin_case("heavy.", {", heavy counterweight", ", contrappeso pesante"});
    const Regime regime = of.regime(m_b_heavy);
    const Motion<T> at = way.motion(m_b_heavy, regime);
    motion(ledger, way, at);
    const bool slips = regime == Regime::slipping;
    ledger.put(quantity("slip_acceleration"), slips ? T(at.a_G - at.alpha * number<T>(of.R)) : T(0));
    ledger.put(quantity("slips"), T(slips ? 1 : 0));
  }

  template <class T, class Way>
  void light(Ledger<T>& ledger, const Way& way) const {
    ledger.begin_case("light.", {", light counterweight", ", contrappeso leggero"});
    const Regime regime = of.regime(m_b_light);
    const Motion<T> at = way.motion(m_b_light, regime);
    ledger.put(quantity("T"), at.pull);
    ledger.put(quantity("F"), at.F);
    ledger.put(quantity("u_required"), at.offset);
    ledger.put(quantity("a"), at.a);
    ledger.put(quantity("starts"), T(regime == Regime::at_rest ? 0 : 1));
    draw(ledger, way, at);
  }

  // The sides of the polygons, and where the normal reaction stands.
  template <class T, class Way>
  void draw(Ledger<T>& ledger, const Way& way, const Motion<T>& at) const {
    const T o(0);
    ledger.draws_vector("side_pull", {at.pull, o});
    ledger.draws_vector("side_weight", {o, -way.N()});
    ledger.draws_vector("side_inertia", {-(number<T>(of.m_a) * at.a_G), o});
    ledger.draws_vector("side_reaction", {-at.F, way.N()});
    ledger.draws_point("foot", {at.offset, o});
  }
};

}  // namespace epure::spool_slip
