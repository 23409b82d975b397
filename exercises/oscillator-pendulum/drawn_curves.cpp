#include "exercises/oscillator-pendulum/drawn_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/statement/decimal.h"

namespace epure::oscillator_pendulum {
namespace {

struct Values {
  double zeta, omega, v_0, dt;
  explicit Values(const Givens& givens)
      : zeta(nearest(givens["zeta"])),
        omega(geometry::to_double(givens.angle("omega_n"))),
        v_0(nearest(givens["v_0"])),
        dt(nearest(givens["dt"])) {}
};

// s(τ), s'(τ): see geometry/vibration/free_oscillation.h.
std::pair<double, double> law(double zeta, double tau) {
  const double discriminant = zeta * zeta - 1, b = std::sqrt(std::abs(discriminant));
  if (discriminant < 0) {
    const double sine = b * tau < 1e-6 ? tau : std::sin(b * tau) / b, decay = std::exp(-zeta * tau);
    return {decay * sine, decay * (std::cos(b * tau) - zeta * sine)};
  }
  const double D = b * tau < 1e-9 ? tau : -std::expm1(-2 * b * tau) / (2 * b), fast = -(zeta + b),
               decay = std::exp(tau / fast);
  return {decay * D, decay * (1 + fast * D)};
}

}  // namespace

double time_shown(const Givens& givens) {
  constexpr double table = 20, own_times = 40;
  return std::min(table, own_times / Values(givens).omega);
}

std::vector<Moving> oscillation(const Givens& givens, double to, int steps) {
  const Values of(givens);
  std::vector<Moving> all;
  for (int i = 0; i <= steps; ++i) {
    const double t = to * i / steps;
    const auto [s, rate] = law(of.zeta, of.omega * t);
    all.push_back({t, of.v_0 / of.omega * s, of.v_0 * rate});
  }
  return all;
}

std::vector<Moving> euler_polygon(const Givens& givens, double to) {
  const Values of(givens);
  std::vector<Moving> all;
  double x = 0, v = of.v_0;
  for (int i = 0; i * of.dt <= to * (1 + 1e-9) && std::abs(x) < 1e100; ++i) {
    all.push_back({i * of.dt, x, v});
    const double a = -2 * of.zeta * of.omega * v - of.omega * of.omega * x;
    x += v * of.dt, v += a * of.dt;
  }
  return all;
}

std::vector<Moving> swing(const Givens& givens, double Omega, double to, int steps) {
  constexpr int within = 8;
  const double h = to / (steps * within);
  double theta = geometry::to_double(givens.angle("theta_0")), rate = 0;
  const auto acceleration = [&](double at) { return -Omega * Omega * std::sin(at); };
  std::vector<Moving> all{{0, theta, rate}};
  for (int i = 1; i <= steps * within; ++i) {
    const double a1 = acceleration(theta), v2 = rate + h / 2 * a1, a2 = acceleration(theta + h / 2 * rate),
                 v3 = rate + h / 2 * a2, a3 = acceleration(theta + h / 2 * v2), v4 = rate + h * a3,
                 a4 = acceleration(theta + h * v3);
    theta += h / 6 * (rate + 2 * v2 + 2 * v3 + v4);
    rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    if (i % within == 0) all.push_back({h * i, theta, rate});
  }
  return all;
}

std::vector<Moving> swing_of_table(const Givens& givens, double Omega, double to) {
  const double dt = nearest(givens["dt_p"]), step = Omega * Omega * dt * dt;
  double theta = geometry::to_double(givens.angle("theta_0")), next = theta;
  std::vector<Moving> all;
  for (int i = 0; i * dt <= to * (1 + 1e-9) && std::abs(theta) < 1e100; ++i) {
    all.push_back({i * dt, theta, (next - theta) / dt});
    const double second = 2 * next - theta - step * std::sin(theta);
    theta = next, next = second;
  }
  return all;
}

RunOfTable run_of_table(const std::vector<Moving>& rows, double Omega) {
  RunOfTable run{.goes_over = false, .gains_always = true};
  const auto energy = [&](const Moving& at) { return at.rate * at.rate / 2 - Omega * Omega * std::cos(at.position); };
  for (std::size_t i = 1; i < rows.size(); ++i) {
    run.goes_over = run.goes_over || std::abs(rows[i].position) > std::numbers::pi;
    run.gains_always = run.gains_always && energy(rows[i]) > energy(rows[i - 1]);
  }
  return run;
}

}  // namespace epure::oscillator_pendulum
