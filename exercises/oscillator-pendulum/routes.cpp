#include "exercises/oscillator-pendulum/routes.h"

namespace epure::oscillator_pendulum {

Deep within_doubles(Deep x) {
  constexpr long most = 996;  // 2^996 is 10^300
  if (arf_cmpabs_2exp_si(arb_midref(x.ball()), most) > 0) throw geometry::Impossible(beyond_doubles);
  return x;
}

std::optional<std::size_t> row_of_return(const std::vector<Deep>& theta, const std::vector<Deep>& rates) {
  const auto sign_of = [](const Deep& x) {
    const geometry::Sign sign = geometry::sign(x);
    if (sign == geometry::Sign::undecided)
      throw geometry::Undecided("in which row the table turns", "in quale riga la tabella si inverte");
    return static_cast<int>(sign);
  };
  const Deep pi = geometry::pi<Deep>();
  int before = 0, turns = 0;
  for (std::size_t i = 1; i < rates.size(); ++i) {
    if (sign_of(geometry::absolute(theta[i]) - pi) > 0) throw geometry::Impossible(over_the_top);
    const int now = sign_of(rates[i]);
    if (now * before < 0 && ++turns == 2) return i;
    if (now != 0) before = now;
  }
  return {};
}

long steps_to(const Rational& t, const Rational& dt) {
  const Rational steps = t / dt;
  if (steps.denominator() != 1) throw geometry::Impossible(between_steps);
  return static_cast<long>(CGAL::to_double(steps));
}

}  // namespace epure::oscillator_pendulum
