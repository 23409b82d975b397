// Areas, works and powers: the piston by its rings, the cycle by its works, the torque by quadrature.
#include "exercises/pump-flywheel/routes.h"
#include "geometry/analytic/integral.h"
#include "geometry/numbers/greater.h"

namespace epure::pump_flywheel {

namespace {

using geometry::ComplexBall;
using geometry::pi;
using geometry::square;

// Of rings 2πρ dρ.
Deep disc(const Rational& diameter) {
  const Deep pi_ = pi<Deep>();
  return geometry::analytic::integral(
      [&](acb_ptr result, acb_srcptr rho, bool, long bits) {
        acb_mul_arb(result, rho, pi_.ball(), bits);
        acb_mul_2exp_si(result, result, 1);
      },
      Deep(0), number(diameter / 2));
}
Deep degrees_of(const Deep& angle) { return Deep(360) * (angle / (Deep(2) * pi<Deep>())); }

struct ByAreas {
  Pump of;

  Deep swept() const { return disc(of.D) * number(of.c); }
  Deep frequency() const { return number(of.Q) / swept(); }
  Deep omega() const { return Deep(2) * pi<Deep>() * frequency(); }
  // Turns a second.
  Deep turns(const Angle& speed) const { return geometry::quotient_of<Deep>(speed, Angle{1}); }
  Deep rated() const { return turns(of.rated); }
  Deep work(const Rational& pressure) const { return swept() * number(pressure); }
  Deep mean() const { return (work(of.p_a) + work(of.p_m)) / (Deep(2) * pi<Deep>()); }
  Deep tau() const { return frequency() / rated(); }
  // Over a half turn the work of C sin α is 2 C.
  Deep coefficient(const Rational& pressure) const { return work(pressure) / Deep(2); }
  // The greatest kinetic energy of the mass, whose speed is then π c f.
  Deep energy_of_mass() const { return number(of.m / 2) * square(pi<Deep>() * number(of.c) * frequency()); }
  Deep stiffness() const {
    return number(of.W_t) / (Deep(4) * square(pi<Deep>()) * rated() * turns(of.synchronous - of.rated));
  }
  Deep cut_off(const Deep& J) const { return stiffness() / (J * Deep(2) * pi<Deep>() * rated()); }
  HalfTurn delivery(const Deep& K) const { return {mean(), coefficient(of.p_m), K}; }
  HalfTurn suction(const Deep& K) const { return {mean(), coefficient(of.p_a), K}; }
  Deep suction_end() const {
    if (of.p_a == of.p_m) return Deep(0);  // both halves are alike
    return summed::energy(suction(Deep(0)), Deep(0), pi<Deep>());
  }
  Deep peak(const Deep& K) const {
    const HalfTurn turn = delivery(K);
    return suction_end() + summed::energy(turn, Deep(0), summed::first_zero(turn));
  }
  // Backwards from the end of the turn, where nothing has been gained.
  Deep late_trough(const Deep& K) const {
    const HalfTurn turn = delivery(K);
    return -summed::energy(turn, summed::second_zero(turn), pi<Deep>());
  }
  std::optional<Deep> early_angle(const Deep& K) const {
    const HalfTurn turn = suction(K);
    if (of.p_a == of.p_m || sign(K) == geometry::Sign::zero || !turn.has_zeros()) return {};
    const Deep angle = summed::second_zero(turn), gained = summed::energy(turn, Deep(0), angle);
    if (sign(late_trough(K) - gained) != geometry::Sign::positive) return {};
    return angle;
  }
  Deep trough(const Deep& K) const {
    if (const auto early = early_angle(K)) return summed::energy(suction(K), Deep(0), *early);
    return late_trough(K);
  }
  Deep trough_angle(const Deep& K) const {
    if (const auto early = early_angle(K)) return *early - pi<Deep>();
    return summed::second_zero(delivery(K));
  }
  Deep polygon_off_at_most(const Deep& K) const {
    const HalfTurn turn = delivery(K);
    const auto late = strips_of_delivery(summed::first_zero(turn), summed::second_zero(turn), pi<Deep>());
    return geometry::greater(summed::chords_off_at_most(suction(K), strips_of_suction(pi<Deep>())),
                             summed::chords_off_at_most(turn, late));
  }
  // The area between the zeros; where the least energy is before, what lies between.
  Deep change(const Deep& upper, const Deep& lower) const { return peak(upper) - trough(lower); }
  Deep at_crank(const Deep& change) const {
    const Deep most = omega() * number(Rational(1) + of.i / 2), least = omega() * number(Rational(1) - of.i / 2);
    return Deep(2) * change / ((most - least) * (most + least));
  }
};

void put_inertia_of(const Put& put, const ByAreas& by, const Find& change) {
  const auto at_crank = [=] { return by.at_crank(change()); };
  const auto at_motor = [=] { return at_crank() * square(by.tau()); };
  put("J_crank", at_crank);
  put("J_motor_shaft", at_motor);
  put("J_flywheel", [=] { return at_motor() - number(by.of.J_m); });
  put("n_t_flywheel", [=] { return by.cut_off(at_motor()); });
}

}  // namespace

void by_areas(const Pump& of, const Put& put, const Begin& begin) {
  const ByAreas by{of};
  const auto none = [] { return Deep(0); };
  put("A_p", [=] { return disc(of.D); });
  put("V", [=] { return by.swept(); });
  put("n_rpm", [=] { return Deep(60) * by.frequency(); });
  put("omega", [=] { return by.omega(); });
  put("f", [=] { return by.frequency(); });
  put("r", [=] { return number(of.c) / Deep(2); });
  put("F_a", [=] { return by.work(of.p_a) / number(of.c); });
  put("F_m", [=] { return by.work(of.p_m) / number(of.c); });
  put("L_suction", [=] { return by.work(of.p_a); });
  put("L_delivery", [=] { return by.work(of.p_m); });
  put("L_r", [=] { return by.work(of.p_a) + by.work(of.p_m); });
  put("M_r_mean", [=] { return by.mean(); });
  put("W_r", [=] { return by.mean() * by.omega(); });
  put("tau", [=] { return by.tau(); });
  put("M_r_suction_coefficient", [=] { return by.coefficient(of.p_a); });
  put("M_r_delivery_coefficient", [=] { return -by.coefficient(of.p_m); });
  put("M_r_harmonic_1", [=] { return by.coefficient(of.p_m - of.p_a) * summed::sine_squared() / pi<Deep>(); });
  const auto even = [=](int k) {
    return -by.coefficient(of.p_m + of.p_a) * summed::sine_times_cosine(k) / pi<Deep>();
  };
  put("M_r_harmonic_2", [=] { return even(2); });
  put("M_r_harmonic_30", [=] { return even(30); });
  put("omega_m", [=] { return Deep(2) * pi<Deep>() * by.rated(); });
  put("omega_sync", [=] { return Deep(2) * pi<Deep>() * by.turns(of.synchronous); });
  put("M_t", [=] { return by.stiffness() * Deep(2) * pi<Deep>() * by.turns(of.synchronous - of.rated); });
  put("k_m", [=] { return by.stiffness(); });
  const auto n_t = [=] { return by.cut_off(number(of.J_m)); };
  put("n_t", n_t);
  put("n_1", [=] { return by.tau(); });
  put("n_30", [=] { return number(Rational(30) * of.Q) / (by.swept() * by.rated()); });
  put("motor_alone_suffices", [=] { return is_less(n_t(), by.tau()); });
  put("M_inertia_max", [=] { return by.energy_of_mass(); });
  put("J_s_max", [=] { return number(of.m * of.c * of.c) / Deep(4); });
  const auto alpha_1 = [=] { return summed::first_zero(by.delivery(none())); };
  const auto alpha_2 = [=] { return summed::second_zero(by.delivery(none())); };
  put("alpha_1", alpha_1);
  put("alpha_2", alpha_2);
  put("alpha_1_deg", [=] { return degrees_of(alpha_1()); });
  put("alpha_2_deg", [=] { return degrees_of(alpha_2()); });
  put("Delta_T_suction_end", [=] { return by.suction_end(); });
  put("Delta_T_peak", [=] { return by.peak(none()); });
  put("Delta_T_trough", [=] { return by.late_trough(none()); });
  const auto change = [=] { return -summed::energy(by.delivery(none()), alpha_1(), alpha_2()); };
  put("Delta_T_max", change);
  put("polygon_off_at_most", [=] { return by.polygon_off_at_most(none()); });
  put_inertia_of(put, by, change);
  put("stiffness_negligible_with_flywheel",
      [=] { return is_less(by.cut_off(by.at_crank(change()) * square(by.tau())), by.tau()); });
  put("omega_max", [=] { return by.omega() + by.omega() * number(of.i / 2); });
  put("omega_min", [=] { return by.omega() - by.omega() * number(of.i / 2); });
  put("J_s_max_over_J_crank", [=] { return number(of.m * of.c * of.c) / (Deep(4) * by.at_crank(change())); });

  begin("reciprocating_mass.", with_mass);
  const auto K = [=] { return by.energy_of_mass(); };
  const auto first = [=] { return summed::first_zero(by.delivery(K())); };
  const auto second = [=] { return summed::second_zero(by.delivery(K())); };
  put("alpha_1", first);
  put("alpha_2", second);
  put("alpha_1_deg", [=] { return degrees_of(first()); });
  put("alpha_2_deg", [=] { return degrees_of(second()); });
  put("Delta_T_max", [=] { return by.change(K(), K()); });
  put("polygon_off_at_most", [=] { return by.polygon_off_at_most(K()); });
  put_inertia_of(put, by, [=] { return by.change(K(), K()); });

  begin("wittenbauer.", by_wittenbauer);
  const auto with_speed = [=](const Rational& share) { return by.energy_of_mass() * number(share * share); };
  const auto upper = [=] { return with_speed(Rational(1) + of.i / 2); };
  const auto lower = [=] { return with_speed(Rational(1) - of.i / 2); };
  const auto slope = [=](const Rational& share) { return square(by.omega()) * number(share * share / 2); };
  put("slope_max", [=] { return slope(Rational(1) + of.i / 2); });
  put("slope_min", [=] { return slope(Rational(1) - of.i / 2); });
  put("alpha_1", [=] { return summed::first_zero(by.delivery(upper())); });
  put("alpha_2", [=] { return by.trough_angle(lower()); });
  put("intercept_max", [=] { return by.peak(upper()); });
  put("intercept_min", [=] { return by.trough(lower()); });
  put_inertia_of(put, by, [=] { return by.change(upper(), lower()); });

  begin("text_diameter.", of_the_text);
  const auto swept = [=] { return disc(Pump::diameter_of_the_text()) * number(of.c); };
  put("V", swept);
  put("n_rpm", [=] { return Deep(60) * number(of.Q) / swept(); });
}

}  // namespace epure::pump_flywheel
