// The formulas of the source's equations, solved.
#include "exercises/aircraft-landing/routes.h"
#include "exercises/aircraft-landing/when_slip_ends.h"
#include "geometry/numbers/greater.h"

namespace epure::aircraft_landing {
using geometry::square;

namespace {

// As much at most the polygon of times is off, the integral of 1/|a| = 1/(A + B v²) over the speed: of each strip the
// width²/8 times the steepest slope there, 2 |B| v/a², which is greatest at v² = A/(3 B).
Deep chords_off_at_most(const WhenSlipEnds& end) {
  const SpinUp& law = end.law();
  if (law.B == 0) return Deep(0);
  const Deep twice_B = number(Rational(2) * CGAL::abs(law.B));
  const auto slope = [&](const Deep& v) { return twice_B * v / square(number(law.A) + number(law.B) * square(v)); };
  Deep most(0), fast = number(law.v_0);
  for (int i = 1; i <= Landing::strips; ++i) {
    const Deep slow = i == Landing::strips ? end().v : spun_up(law, number(Rational(i, Landing::strips)) * end().t).v;
    Deep steepest = geometry::greater(slope(fast), slope(slow));
    if (law.B > 0) {
      const Deep greatest_at = geometry::root(number(law.A / (Rational(3) * law.B)));
      steepest = geometry::greater(steepest, slope(geometry::within(slow, greatest_at, fast)));
    }
    most = geometry::greater(most, square(fast - slow) / Deep(8) * steepest);
    fast = slow;
  }
  return most;
}

}  // namespace

void by_closed_form(const Landing& of, Extent extent, const Put& put_all) {
  const WhenSlipEnds end(of.law(), geometry::analytic::end_of_slip);
  const Put put = pressing(of, extent, put_all);
  const Rational v2 = of.v_0 * of.v_0, M = of.M(), N_0 = of.normal(of.v_0);
  const Rational a_0 = -(of.f_r * N_0 + of.c_x * v2) / M, turned_0 = of.turning() * N_0, turned = of.rim_0 / of.R;
  const auto exact = [&](const char* name, const Rational& q) { put(name, [=] { return number(q); }); };
  exact("v_0", of.v_0);
  exact("omega_rolling_0", of.v_0 / of.R);
  exact("u", of.f_v * of.R);
  exact("F_x_0", of.c_x * v2);
  exact("F_y_0", of.c_y * v2);
  exact("N_0", N_0);
  exact("F_0", of.f_r * N_0);
  exact("a_0", a_0);
  exact("omega_dot_0", turned_0);
  const Rational closing = of.R * turned_0 - a_0, crossing = (of.v_0 - of.rim_0) / closing;
  exact("t_s_tangents", crossing);
  exact("v_s_tangents", of.v_0 + a_0 * crossing);

  const auto v = [=] { return end().v; };
  const auto v_squared = [=] { return square(end().v); };
  const auto N = [=] { return number(of.M() * of.g) + number(of.c_y) * v_squared(); };
  const auto omega = [=] { return end().omega; };
  put("t_s", [=] { return end().t; });
  put("v_s", v);
  put("omega_s", omega);
  put("N_s", N);
  put("a_s", [=] { return -(number(of.law().A) + number(of.law().B) * v_squared()); });
  put("omega_dot_s", [=] { return number(of.turning()) * N(); });
  put("polygon_off_at_most", [=] { return chords_off_at_most(end); });
  put("ground_path_s", [=] { return end().path; });
  put("wheel_angle_s", [=] { return end().angle; });
  put("rolled_path_s", [=] { return number(of.R) * end().angle; });
  put("slip_path_s", [=] { return end().path - number(of.R) * end().angle; });
  // Of the wheel: (F - f_v N) R θ' is what its energy gains; of all: what friction, drag and rolling take.
  const auto gained = [=] { return number(of.J_r / 2) * (square(omega()) - number(turned * turned)); };
  const auto drag = [=] { return number(of.c_x) * end().cubes; };
  const auto rolling = [=] { return number(of.f_v / (of.f_r - of.f_v)) * gained(); };
  put("wheel_energy_s", [=] { return number(of.J_r / (Rational(2) * of.R * of.R)) * v_squared(); });
  put("drag_work_s", drag);
  put("rolling_work_s", rolling);
  put("friction_work_s",
      [=] { return number(of.M() / 2) * (number(of.v_0 * of.v_0) - v_squared()) - gained() - drag() - rolling(); });
  const auto at_10ms = [=] { return before_slip_ends(end, geometry::analytic::spun_up); };
  put("v_10ms", [=] { return at_10ms().v; });
  put("omega_10ms", [=] { return at_10ms().omega; });

  const Rational rolling_mass = of.M() + of.J_r / (of.R * of.R);
  const auto a_after = [=] { return -(number(of.c_x) * v_squared() + number(of.f_v) * N()) / number(rolling_mass); };
  const auto F_after = [=] { return number(of.J_r / (of.R * of.R)) * a_after() + number(of.f_v) * N(); };
  put("a_after", a_after);
  put("F_after", F_after);
  // The aircraft cut free from its wheel: the hub holds its weight and flaps, and brakes it; the wheel has it back.
  const auto put_hub = [=](const std::string& when, const Find& v2_now, const Find& a) {
    const auto level = [=] { return number(of.m_a) * a() + number(of.c_x) * v2_now(); };
    const auto upright = [=] { return number(of.m_a * of.g) + number(of.c_y) * v2_now(); };
    put("hub_force_" + when, [=] { return geometry::root(square(level()) + square(upright())); });
    put("hub_force_" + when + "_x", [=] { return -level(); });
    put("hub_force_" + when + "_y", [=] { return -upright(); });
    put("wheel_inertia_" + when, [=] { return -(number(of.m_r) * a()); });
  };
  put_hub(
      "0", [=] { return number(v2); }, [=] { return number(a_0); });
  put_hub("after", v_squared, a_after);
  exact("wheel_weight", of.m_r * of.g);
  put("F_after_over_N", [=] { return F_after() / N(); });
  put("adheres", [=] { return adheres(of, F_after(), N()); });
}

}  // namespace epure::aircraft_landing
