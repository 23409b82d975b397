#include "exercises/spool-slip/spool.h"

#include "exercises/kit/statement/given_number.h"

#include <algorithm>

namespace epure::spool_slip {
std::vector<GivenSpec> stated_givens() {
  return {
      {"m_a", {"mass of the spool", "massa della bobina"}, "kg", "20", Range::positive, "$m_{a}$"},
      {"m_b", {"mass of the counterweight", "massa del contrappeso"}, "kg", "30", Range::not_negative, "$m_{b}$"},
      {"m_b_heavy",
       {"mass of a heavy counterweight", "massa di un contrappeso pesante"},
       "kg",
       "60",
       Range::not_negative,
       "$m_{b,h}$"},
      {"m_b_light",
       {"mass of a light counterweight", "massa di un contrappeso leggero"},
       "kg",
       "0.3",
       Range::not_negative,
       "$m_{b,l}$"},
      {"R", {"outer radius of the spool", "raggio esterno della bobina"}, "m", "0.5", Range::positive, "$\\it{R}$"},
      {"r", {"radius of the core", "raggio del nocciolo"}, "m", "0.25", Range::positive, "$r$"},
      {"f_a", {"static friction", "attrito di aderenza"}, "1", "1", Range::not_negative, "$f_{a}$"},
      {"f_r", {"kinetic friction", "attrito radente"}, "1", "0.8", Range::not_negative, "$f_{r}$"},
      {"f_v", {"rolling friction", "attrito volvente"}, "1", "0.01", Range::not_negative, "$f_{v}$"},
      {"g", {"acceleration of gravity", "accelerazione di gravità"}, "m/s^2", "9.81", Range::positive, "$g$"}};
}

bool Spool::rolls_off(const Rational& m_b) const { return m_b * height() > m_a * f_v * R; }

Rational Spool::friction_needed(const Rational& m_b) const {
  const Rational mu = m_b / m_a, k = height() / R;
  if (!rolls_off(m_b)) return mu;
  return (mu * (Rational(5, 4) - k + f_v * k) + f_v) / (Rational(5, 4) + k * k * mu);
}

Regime Spool::regime(const Rational& m_b) const {
  if (friction_needed(m_b) > f_a) return Regime::slipping;
  return rolls_off(m_b) ? Regime::rolling : Regime::at_rest;
}

Rational Spool::offset_while_slipping(const Rational& m_b) const {
  const Rational most = f_v * R, N = m_a * g, T = m_b * (N + f_r * N) / (m_a + m_b);  // not turning
  return std::clamp<Rational>((f_r * N * R - T * r) / N, -most, most);
}

bool Spool::slips_from_rest() const { return f_v * R > f_a * height(); }
bool Spool::always_rolls() const {
  const Rational k = height() / R;
  return Rational(5, 4) - k + f_v * k <= k * k * f_a;
}

Spool spool(const Givens& givens) {
  const Spool of{givens["m_a"], givens["R"], givens["r"], givens["f_a"], givens["f_r"], givens["f_v"], givens["g"]};
  require(of.r < of.R, format_words("r = {} m must be less than R = {} m: the rope leaves the core R - r above the "
                                    "plane, and at or below it would not roll the spool to the right",
                                    "r = {} m dev'essere minore di R = {} m: la fune lascia il nocciolo R - r sopra "
                                    "il piano, e al suo livello o sotto non farebbe rotolare la bobina verso destra",
                                    told_value(of.r), told_value(of.R)));
  require(of.f_r <= of.f_a, format_words("f_r = {} is more than f_a = {}: what slides is not held better than what "
                                         "adheres, and between them the spool could neither roll nor slip",
                                         "f_r = {} supera f_a = {}: ciò che striscia non è trattenuto meglio di ciò "
                                         "che aderisce, e fra i due la bobina non potrebbe né rotolare né strisciare",
                                         told_value(of.f_r), told_value(of.f_a)));
  return of;
}

}  // namespace epure::spool_slip
