#include "exercises/point-mass/motion.h"

namespace epure::point_mass {
namespace {

Rational power(const Rational& of, int exponent) {
  return exponent == 0 ? Rational(1) : of * power(of, exponent - 1);
}

}  // namespace

// f'' = (-f(-2h) + 16 f(-h) - 30 f(0) + 16 f(h) - f(2h))/12 h², exact up to the fifth degree.
Rational ByQuadrature::acceleration(const Rational& t) const {
  const Powers s = ByPowers(of).s;
  const Rational h = of.end() / 4;
  constexpr std::array<int, 5> weights{-1, 16, -30, 16, -1};
  Rational sum = 0;
  for (int i = -2; i <= 2; ++i) sum += Rational(weights[i + 2]) * s.at<Rational>(t + Rational(i) * h);
  return sum / (12 * h * h);
}

Rational ByQuadrature::centroid(const Rational& t) const {
  constexpr std::array<int, 5> weights{7, 32, 12, 32, 7};
  Rational sum = 0;
  for (int i = 0; i < 5; ++i) {
    const Rational at = Rational(i, 4) * t;
    sum += Rational(weights[i]) * at * force(at);
  }
  return t / 90 * sum / momentum(t);
}

Instant<Rational> ByQuadrature::at(const Rational& t) const {
  const Rational a = acceleration(t);
  return {of.m * a, a, velocity(t), momentum(t), energy(t), space(t)};
}

std::vector<Rational> by_bezout(const std::vector<Rational>& y, const Rational& dt) {
  std::vector<Rational> Y{0};
  for (std::size_t i = 1; i < y.size(); ++i) Y.push_back(Y.back() + dt * (y[i - 1] + y[i]) / 2);
  return Y;
}

std::vector<Rational> by_simpson(const std::vector<Rational>& y, const Rational& dt) {
  std::vector<Rational> Y{0, dt * (5 * y[0] + 8 * y[1] - y[2]) / 12};
  for (std::size_t i = 2; i < y.size(); ++i) Y.push_back(Y[i - 2] + 2 * dt * (y[i - 2] + 4 * y[i - 1] + y[i]) / 6);
  return Y;
}

BySteps::BySteps(const Problem& of) {
  const Powers a = 1 / of.m * of.force();
  std::vector<Rational> accelerations;
  for (long i = 0; i <= of.rows(); ++i) accelerations.push_back(a.at<Rational>(of.dt * Rational(i)));
  bezout_.v = by_bezout(accelerations, of.dt);
  bezout_.s = by_bezout(bezout_.v, of.dt);
  simpson_.v = by_simpson(accelerations, of.dt);
  simpson_.s = by_simpson(simpson_.v, of.dt);
}

TableRow BySteps::at(const std::string& method, long row) const {
  const Column& column = method == "bezout" ? bezout_ : simpson_;
  const auto i = static_cast<std::size_t>(row);
  return {column.v.at(i), column.s.at(i)};
}

InClosedForm::InClosedForm(const Problem& of)
    : dt_(of.dt),
      v_((1 / of.m * of.force()).integral()),
      s_(v_.integral()),
      v_bezout_((1 / of.m * of.force()).trapezoids(of.dt)),
      s_bezout_(v_bezout_.trapezoids(of.dt)),
      third_(2 * of.B / of.m),
      fourth_(6 * of.A / of.m) {}

TableRow InClosedForm::at(const std::string& method, long row) const {
  const Rational t = dt_ * Rational(row);
  if (method == "bezout") return {v_bezout_.at(t), s_bezout_.at(t)};
  const Rational h4 = power(dt_, 4), v = v_.at(t), s = s_.at(t);
  if (row % 2 == 0) return {v, s - fourth_ * h4 * t / 45};
  return {v - fourth_ * h4 / 24, s - h4 * (third_ / 24 + fourth_ * (23 * dt_ / 360 + (t - dt_) / 120))};
}

}  // namespace epure::point_mass
