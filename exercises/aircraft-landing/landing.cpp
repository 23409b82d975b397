#include "exercises/aircraft-landing/landing.h"

#include <cmath>

#include "exercises/kit/statement/given_number.h"

namespace epure::aircraft_landing {
std::vector<GivenSpec> given_specs() {
  return {{"v_0", {"speed at touch-down", "velocità al contatto"}, "km/h", "250", Range::positive, "$v_{0}$"},
          {"m_a", {"mass of the aircraft", "massa dell'aereo"}, "kg", "9000", Range::positive, "$m_{a}$"},
          {"m_r", {"mass of the wheel", "massa della ruota"}, "kg", "60", Range::positive, "$m_{r}$"},
          {"R", {"radius of the wheel", "raggio della ruota"}, "m", "0.4", Range::positive, "$\\it{R}$"},
          {"J_r",
           {"moment of inertia of the wheel", "momento d'inerzia della ruota"},
           "kg m^2",
           "4.9",
           Range::positive,
           "$\\it{J}_{r}$"},
          {"c_x",
           {"drag of the flaps over v²", "resistenza dei flap su v²"},
           "N s^2/m^2",
           "2",
           Range::not_negative,
           "$c_{x}$"},
          {"c_y",
           {"downward force of the flaps over v²", "forza dei flap verso il basso su v²"},
           "N s^2/m^2",
           "2",
           Range::any,
           "$c_{y}$"},
          {"f_r", {"kinetic friction", "attrito radente"}, "1", "1", Range::positive, "$f_{r}$"},
          {"f_a", {"static friction", "attrito di aderenza"}, "1", "1.2", Range::not_negative, "$f_{a}$"},
          {"f_v", {"rolling friction", "attrito volvente"}, "1", "0.001", Range::not_negative, "$f_{v}$"},
          {"g", {"acceleration of gravity", "accelerazione di gravità"}, "m/s^2", "9.81", Range::positive, "$g$"},
          {.symbol = "Delta_t",
           .meaning = {"Euler's step (the finer ones are a hundredth and a thousandth of it)",
                       "passo di Eulero (i più fitti sono un centesimo e un millesimo di esso)"},
           .unit = "s",
           .stated = "0.1",
           .letters = "Δ$t$",
           .also = {"dt"}},
          {.symbol = "rim_0",
           .meaning = {"speed of the rim at touch-down", "velocità periferica della ruota al contatto"},
           .unit = "m/s",
           .stated = "0",
           .range = Range::not_negative,
           .letters = "$(ω\\it{R})_{0}$",
           .beyond_source = true}};
}

Landing::Landing(const Givens& givens)
    : v_0(givens["v_0"] / Rational(36, 10)),
      m_a(givens["m_a"]),
      m_r(givens["m_r"]),
      R(givens["R"]),
      J_r(givens["J_r"]),
      c_x(givens["c_x"]),
      c_y(givens["c_y"]),
      f_r(givens["f_r"]),
      f_a(givens["f_a"]),
      f_v(givens["f_v"]),
      g(givens["g"]),
      step(givens["Delta_t"]),
      rim_0(givens["rim_0"]) {
  if (f_r <= f_v)
    throw BadGivens(
        format_words("f_r = {} must be greater than f_v = {}: rolling friction holds the wheel, so slip never ends, "
                     "and the aircraft stops first",
                     "f_r = {} dev'essere maggiore di f_v = {}: l'attrito volvente trattiene la ruota, lo "
                     "strisciamento non finisce mai e l'aereo si ferma prima",
                     told_value(f_r), told_value(f_v)));
  if (rim_0 == v_0)
    throw BadGivens(format_words(
        "rim_0 = {} m/s must be less than v_0 = {} m/s: the wheel already rolls at touch-down, and nothing slips",
        "rim_0 = {} m/s dev'essere minore di v_0 = {} m/s: la ruota al contatto rotola già, e nulla striscia",
        told_value(rim_0), told_value(v_0)));
  if (rim_0 > v_0)
    throw BadGivens(
        format_words("rim_0 = {} m/s must be less than v_0 = {} m/s: the wheel spins faster than it would roll, and "
                     "slips forwards, which is not the landing that is asked about",
                     "rim_0 = {} m/s dev'essere minore di v_0 = {} m/s: la ruota gira più in fretta di quanto "
                     "rotolerebbe, e striscia in avanti: non è l'atterraggio in esame",
                     told_value(rim_0), told_value(v_0)));
  if (const auto why = airborne()) throw BadGivens(*why);
}

std::optional<Words> Landing::airborne() const {
  if (normal(v_0) > 0) return {};
  const double grips_at = std::sqrt(CGAL::to_double(M() * g / -c_y));
  return format_words(
      "v_0 = {} m/s: the flaps lift the aircraft (N_0 = {} N), and the wheel presses on the ground only below {} m/s",
      "v_0 = {} m/s: i flap sollevano l'aereo (N_0 = {} N), e la ruota preme sul terreno solo sotto {} m/s",
      told_value(v_0), told_value(normal(v_0)), decimal(grips_at, 6));
}

Landing Landing::with_doubled_wheel() const {
  Landing other = *this;
  other.m_r = Rational(2) * m_r;
  other.J_r = Rational(2) * J_r;
  return other;
}

Landing Landing::with_lift() const {
  Landing other = *this;
  other.c_y = -c_y;
  return other;
}

geometry::analytic::SpinUp Landing::law() const {
  return {.A = f_r * g,
          .B = (f_r * c_y + c_x) / M(),
          .C = turning() * M() * g,
          .D = turning() * c_y,
          .v_0 = v_0,
          .omega_0 = rim_0 / R,
          .R = R};
}

}  // namespace epure::aircraft_landing
