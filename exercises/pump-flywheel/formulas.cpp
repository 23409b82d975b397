// The formulas, and the primitive of the torque between its zeros.
#include "exercises/pump-flywheel/routes.h"
#include "geometry/numbers/at_each_precision.h"
#include "geometry/numbers/greater.h"

namespace epure::pump_flywheel {
namespace {

using geometry::at_each_precision;
using geometry::pi;
using geometry::square;

Deep in_degrees(const Deep& angle) { return Deep(180) * angle / pi<Deep>(); }

// On Deep, at the precision that is open.
struct ByFormulas {
  Pump of;

  Deep area() const { return pi<Deep>() * number(of.D * of.D / 4); }
  // n = 60 Q/(π D² c/4), ω = 2π n/60: π goes out.
  Deep omega() const { return number(Rational(8) * of.Q / (of.D * of.D * of.c)); }
  Deep omega_m() const { return geometry::radians<Deep>(of.rated); }
  Deep omega_0() const { return geometry::radians<Deep>(of.synchronous); }
  Deep k_m() const { return number(of.W_t) / (omega_m() * (omega_0() - omega_m())); }
  Deep cut_off(const Deep& J) const { return k_m() / (J * omega_m()); }
  Deep tau() const { return omega() / omega_m(); }
  Deep mean() const { return number(of.D * of.D * of.c * (of.p_a + of.p_m) / 8); }
  Deep coefficient(const Rational& pressure) const { return area() * number(pressure * of.r()); }
  // The torque of the mass in a half turn: K sin 2α, K = m r² ω²/2.
  Deep K(const Deep& speed) const { return number(of.m * of.r() * of.r() / 2) * square(speed); }
  HalfTurn half_turn(const Rational& pressure, const Deep& K) const { return {mean(), coefficient(pressure), K}; }
  HalfTurn delivery(const Deep& K) const { return half_turn(of.p_m, K); }
  HalfTurn suction(const Deep& K) const { return half_turn(of.p_a, K); }

  Deep suction_end() const { return area() * number((of.p_m - of.p_a) * of.r()); }
  Deep peak(const Deep& K) const {
    const HalfTurn turn = delivery(K);
    return suction_end() + closed::energy(turn, closed::first_zero(turn));
  }
  // And where it lies, from the start of delivery: in suction when the mass asks for more than there the fluid
  // leaves.
  struct Least {
    Deep energy, angle;
  };
  Least trough(const Deep& K) const {
    const HalfTurn turn = delivery(K), other = suction(K);
    const Deep angle = closed::second_zero(turn);
    const Least late{suction_end() + closed::energy(turn, angle), angle};
    if (of.p_a == of.p_m || sign(K) == geometry::Sign::zero || !other.has_zeros()) return late;
    const Deep before = closed::second_zero(other);
    const Least early{closed::energy(other, before), before - pi<Deep>()};
    switch (sign(early.energy - late.energy)) {
      case geometry::Sign::negative:
        return early;
      case geometry::Sign::undecided:
        throw geometry::Undecided("in which half of the turn the energy is least",
                                  "in quale metà del giro l'energia è minima");
      default:
        return late;
    }
  }
  Deep polygon_off_at_most(const Deep& K) const {
    const HalfTurn turn = delivery(K);
    const auto late = strips_of_delivery(closed::first_zero(turn), closed::second_zero(turn), pi<Deep>());
    return geometry::greater(closed::chords_off_at_most(suction(K), strips_of_suction(pi<Deep>())),
                             closed::chords_off_at_most(turn, late));
  }
  Deep greatest_change(const Deep& K) const { return peak(K) - trough(K).energy; }
  Deep inertia(const Deep& change) const { return change / (number(of.i) * square(omega())); }
  Deep omega_max() const { return omega() * number(Rational(1) + of.i / 2); }
  Deep omega_min() const { return omega() * number(Rational(1) - of.i / 2); }
};

void put_inertia(const Put& put, const ByFormulas& by, const Find& change) {
  const auto at_crank = [=] { return by.inertia(change()); };
  const auto at_motor = [=] { return at_crank() * square(by.tau()); };
  put("J_crank", at_crank);
  put("J_motor_shaft", at_motor);
  put("J_flywheel", [=] { return at_motor() - number(by.of.J_m); });
  put("n_t_flywheel", [=] { return by.cut_off(at_motor()); });
}

}  // namespace

Deep is_less(const Deep& a, const Deep& b) {
  const geometry::Sign found = sign(b - a);
  if (found == geometry::Sign::undecided)
    throw geometry::Undecided("on which side of a harmonic the cut-off lies",
                              "da che parte di un'armonica cada la frequenza di taglio");
  return Deep(found == geometry::Sign::positive ? 1 : 0);
}

void by_formulas(const Pump& of, const Put& put, const Begin& begin) {
  const ByFormulas by{of};
  const Rational r = of.r();
  const auto exact = [&](const char* name, const Rational& q) { put(name, [=] { return number(q); }); };
  const auto cycles = [=] { return number(Rational(4) * of.Q / (of.D * of.D * of.c)) / pi<Deep>(); };
  const auto none = [] { return Deep(0); };
  put("A_p", [=] { return by.area(); });
  put("V", [=] { return by.area() * number(of.c); });
  put("n_rpm", [=] { return Deep(60) * cycles(); });
  put("omega", [=] { return by.omega(); });
  put("f", cycles);
  exact("r", r);
  put("F_a", [=] { return by.area() * number(of.p_a); });
  put("F_m", [=] { return by.area() * number(of.p_m); });
  put("L_suction", [=] { return by.area() * number(of.p_a * of.c); });
  put("L_delivery", [=] { return by.area() * number(of.p_m * of.c); });
  put("L_r", [=] { return by.area() * number((of.p_a + of.p_m) * of.c); });
  put("M_r_mean", [=] { return by.mean(); });
  exact("W_r", (of.p_a + of.p_m) * of.Q);
  put("tau", [=] { return by.tau(); });
  put("M_r_suction_coefficient", [=] { return by.coefficient(of.p_a); });
  put("M_r_delivery_coefficient", [=] { return -by.coefficient(of.p_m); });
  // M_r = (F_m + F_a) r |sin α|/2 - (F_m - F_a) r sin α/2; and |sin α| = 2/π - (4/π) Σ cos 2jα/(4j² - 1).
  put("M_r_harmonic_1", [=] { return by.coefficient(of.p_m - of.p_a) / Deep(2); });
  const auto even = [=](int k) {
    return by.coefficient(of.p_m + of.p_a) * number(Rational(2, k * k - 1)) / pi<Deep>();
  };
  put("M_r_harmonic_2", [=] { return even(2); });
  put("M_r_harmonic_30", [=] { return even(30); });
  put("omega_m", [=] { return by.omega_m(); });
  put("omega_sync", [=] { return by.omega_0(); });
  put("M_t", [=] { return number(of.W_t) / by.omega_m(); });
  put("k_m", [=] { return by.k_m(); });
  const auto n_t = [=] { return by.cut_off(number(of.J_m)); };
  put("n_t", n_t);
  put("n_1", [=] { return by.tau(); });
  put("n_30", [=] { return Deep(30) * by.tau(); });
  put("motor_alone_suffices", [=] { return is_less(n_t(), by.tau()); });
  put("M_inertia_max", [=] { return by.K(by.omega()); });
  exact("J_s_max", of.m * r * r);
  const auto alpha_1 = [=] { return closed::first_zero(by.delivery(none())); };
  const auto alpha_2 = [=] { return closed::second_zero(by.delivery(none())); };
  put("alpha_1", alpha_1);
  put("alpha_2", alpha_2);
  put("alpha_1_deg", [=] { return in_degrees(alpha_1()); });
  put("alpha_2_deg", [=] { return in_degrees(alpha_2()); });
  put("Delta_T_suction_end", [=] { return by.suction_end(); });
  put("Delta_T_peak", [=] { return by.peak(none()); });
  put("Delta_T_trough", [=] { return by.trough(none()).energy; });
  const auto change = at_each_precision([=] { return by.greatest_change(none()); });
  put("Delta_T_max", change);
  put("polygon_off_at_most", [=] { return by.polygon_off_at_most(none()); });
  put_inertia(put, by, change);
  put("stiffness_negligible_with_flywheel",
      [=] { return is_less(by.cut_off(by.inertia(change()) * square(by.tau())), by.tau()); });
  put("omega_max", [=] { return by.omega_max(); });
  put("omega_min", [=] { return by.omega_min(); });
  put("J_s_max_over_J_crank", [=] { return number(of.m * r * r) / by.inertia(change()); });

  begin("reciprocating_mass.", with_mass);
  const auto K = [=] { return by.K(by.omega()); };
  const auto first = at_each_precision([=] { return closed::first_zero(by.delivery(K())); });
  const auto second = at_each_precision([=] { return closed::second_zero(by.delivery(K())); });
  put("alpha_1", first);
  put("alpha_2", second);
  put("alpha_1_deg", [=] { return in_degrees(first()); });
  put("alpha_2_deg", [=] { return in_degrees(second()); });
  const auto with_mass_change = at_each_precision([=] { return by.greatest_change(K()); });
  put("Delta_T_max", with_mass_change);
  put("polygon_off_at_most", [=] { return by.polygon_off_at_most(K()); });
  put_inertia(put, by, with_mass_change);

  // W - (ω²/2) m r² sin² α is greatest (with ω_max) and least (with ω_min) where the tangents touch.
  begin("wittenbauer.", by_wittenbauer);
  const auto upper = [=] { return by.K(by.omega_max()); };
  const auto lower = [=] { return by.K(by.omega_min()); };
  const auto highest = at_each_precision([=] { return by.peak(upper()); });
  const auto lowest = at_each_precision([=] { return by.trough(lower()); });
  put("slope_max", [=] { return square(by.omega_max()) / Deep(2); });
  put("slope_min", [=] { return square(by.omega_min()) / Deep(2); });
  put("alpha_1", [=] { return closed::first_zero(by.delivery(upper())); });
  put("alpha_2", [=] { return lowest().angle; });
  put("intercept_max", highest);
  put("intercept_min", [=] { return lowest().energy; });
  put_inertia(put, by, [=] { return highest() - lowest().energy; });

  begin("text_diameter.", of_the_text);
  const Rational D = Pump::diameter_of_the_text();
  put("V", [=] { return pi<Deep>() * number(D * D * of.c / 4); });
  put("n_rpm", [=] { return number(Rational(240) * of.Q / (D * D * of.c)) / pi<Deep>(); });
}

}  // namespace epure::pump_flywheel
