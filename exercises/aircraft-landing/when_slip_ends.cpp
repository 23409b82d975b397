#include "exercises/aircraft-landing/when_slip_ends.h"

#include <set>

#include "exercises/aircraft-landing/euler.h"

namespace epure::aircraft_landing {
namespace {

using geometry::at_each_precision;
using geometry::Sign;

bool is_not_negative(const Deep& rest) {
  const Sign found = geometry::sign(rest);
  if (found == Sign::undecided)
    throw geometry::Undecided("whether the wheel adheres to the ground", "se la ruota aderisca al terreno");
  return found != Sign::negative;
}

}  // namespace

Put pressing(const Landing& of, Extent extent, const Put& put) {
  static const std::set<std::string> of_the_whole{"v_0",
                                                  "omega_rolling_0",
                                                  "u",
                                                  "F_x_0",
                                                  "F_y_0",
                                                  "drag_work_s",
                                                  "rolling_work_s",
                                                  "v_10ms",
                                                  "omega_10ms",
                                                  "hub_force_0",
                                                  "hub_force_0_x",
                                                  "hub_force_0_y",
                                                  "hub_force_after",
                                                  "hub_force_after_x",
                                                  "hub_force_after_y",
                                                  "wheel_weight",
                                                  "wheel_inertia_0",
                                                  "wheel_inertia_after",
                                                  "polygon_off_at_most"};
  const auto airborne = of.airborne();
  return [=](const std::string& name, const Find& find) {
    if (extent == Extent::of_a_case && of_the_whole.contains(name)) return;
    put(name, [&] {
      if (airborne) throw geometry::Impossible(*airborne);
      return find();
    });
  };
}

SpinState before_slip_ends(const WhenSlipEnds& end, SpinState (*after)(const SpinUp&, const Deep& t)) {
  const Words ended{"slip has ended by then, and the wheel rolls", "lo strisciamento è già finito e la ruota rotola"};
  const Deep t = number(Rational(1, 100));
  switch (geometry::sign(end().t - t)) {
    case Sign::positive:
      return after(end.law(), t);
    case Sign::undecided:
      throw geometry::Undecided(Words{"whether ", "se "} + ended);
    default:
      throw geometry::Impossible(ended);
  }
}

Deep adheres(const Landing& of, const Deep& F, const Deep& N) {
  // Without drag F/N is a fraction, which may be f_a itself.
  if (of.c_x == 0) return Deep(of.f_v * of.M() <= of.f_a * (of.M() + of.J_r / (of.R * of.R)) ? 1 : 0);
  const Deep allowed = number(of.f_a) * N;
  return Deep(is_not_negative(allowed - F) && is_not_negative(allowed + F) ? 1 : 0);
}

std::vector<EulerCase> euler_cases(const Landing& of) {
  return {{"euler_100ms.", {" of Euler's scheme, step Δt", " dello schema di Eulero, passo Δt"}, of.step, {1}},
          {"euler_1ms.",
           {" of Euler's scheme, step Δt/100", " dello schema di Eulero, passo Δt/100"},
           of.step / 100,
           {10, 20}},
          {"euler_100us.",
           {" of Euler's scheme, step Δt/1000", " dello schema di Eulero, passo Δt/1000"},
           of.step / 1000,
           {100, 200}}};
}

void by_euler(const Landing& of, const EulerCase& scheme, bool as_map, const Put& put) {
  const auto how = as_map ? Arrangement::as_map : Arrangement::stepwise;
  const SpinUp law = of.law();
  const Rational step = scheme.step;
  for (const int k : scheme.after) {
    const std::string index = std::to_string(k);
    const auto after = at_each_precision([=] { return after_steps(law, step, k, how); });
    put("v_" + index, [=] { return after().v; });
    put("omega_" + index, [=] { return after().omega; });
  }
  if (scheme.after.front() == 1) {
    put("rim_speed_over_speed_1", [=] {
      if (stops_at_once(law, step))
        throw geometry::Impossible("the first step ends with the aircraft standing still",
                                   "il primo passo finisce con l'aereo fermo");
      const EulerState first = after_steps(law, step, 1, how);
      return number(law.R) * first.omega / first.v;
    });
    return;
  }
  const auto end = at_each_precision([=] { return end_of_slip(law, step, how); });
  put("steps", [=] { return Deep(end().steps); });
  put("t_s", [=] { return end().t_s; });
}

}  // namespace epure::aircraft_landing
