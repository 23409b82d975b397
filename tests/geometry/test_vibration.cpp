// The free oscillator and the pendulum, by both rooms, against mpmath (tests/corpus/make_vibration.py).
#include "geometry/analytic/oscillation_by_matrix.h"
#include "geometry/analytic/pendulum_by_theta.h"
#include "geometry/vibration/free_oscillation.h"
#include "geometry/vibration/pendulum.h"
#include "geometry/vibration/recursion.h"
#include "tests/geometry/holds_reference.h"

namespace epure::tests {

using namespace geometry;

namespace {

const std::array<Rational, 4> instants{0, Rational(1, 7), Rational(5, 3), 20};

std::vector<CorpusCase> vibrations(const std::string& given) {
  std::vector<CorpusCase> all;
  for (const CorpusCase& c : read_corpus(EPURE_CORPUS "/vibration.txt"))
    if (c.givens.contains(given)) all.push_back(c);
  return all;
}

std::string at(const std::string& name, std::size_t instant) { return name + "_" + std::to_string(instant); }

Angle angle_of(const CorpusCase& c) { return {c.givens.at("degrees") / 360, 0}; }

}  // namespace

TEST_CASE("an oscillator's law is the reference's, critically damped, beside that, and far from it") {
  const Arithmetic<Deep> scope(256);
  const auto cases = vibrations("zeta");
  CHECK(cases.size() == 9);
  for (const CorpusCase& c : cases) {
    const FreeOscillation motion(c.givens.at("zeta"), {0, c.givens.at("omega")}, c.givens.at("v_0"));
    for (std::size_t i = 0; i < instants.size(); ++i) {
      holds(c, at("position", i), motion.position(instants[i]));
      holds(c, at("velocity", i), motion.velocity(instants[i]));
      holds(c, at("acceleration", i), motion.acceleration(instants[i]));
    }
    holds(c, "time_of_extreme", motion.time_of_extreme());
    holds(c, "time_of_inflection", motion.time_of_inflection());
    holds(c, "extreme", motion.extreme());
    holds(c, "position_of_inflection", motion.position_of_inflection());
    holds(c, "velocity_of_inflection", motion.velocity_of_inflection());
  }
}

TEST_CASE("an oscillator's matrix and its path in the phase plane give the reference's law") {
  const Arithmetic<Deep> scope(256);
  for (const CorpusCase& c : vibrations("zeta")) {
    const Angle omega{0, c.givens.at("omega")};
    const analytic::OscillationByMatrix motion(c.givens.at("zeta"), omega);
    const Deep v_0 = from_rational<Deep>(c.givens.at("v_0")), w = radians<Deep>(omega);
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const auto [omega_x, velocity] = motion.after_push(from_rational<Deep>(instants[i]));
      holds(c, at("position", i), v_0 / w * omega_x);
      holds(c, at("velocity", i), v_0 * velocity);
    }
    holds(c, "time_of_extreme", motion.time_of_extreme());
    holds(c, "time_of_inflection", motion.time_of_inflection());
  }
}

TEST_CASE("which damping it is, is decided on the rational") {
  CHECK(damping_of(1) == Damping::critical);
  CHECK(damping_of(1 + exact_decimal("1e-30")) == Damping::over);
  CHECK(damping_of(1 - exact_decimal("1e-30")) == Damping::under);
  CHECK(damping_of(0) == Damping::under);
}

TEST_CASE("a pendulum's swing is the reference's, tiny, wide and nearly upright") {
  const Arithmetic<Deep> scope(320);
  const auto cases = vibrations("degrees");
  CHECK(cases.size() == 6);
  for (const CorpusCase& c : cases) {
    const Rational square = c.givens.at("Omega_squared");
    const PendulumSwing swing(angle_of(c), square);
    holds(c, "modulus", swing.modulus());
    holds(c, "K", swing.K());
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const SwingState state = swing.at(instants[i]);
      holds(c, at("sine_of_half", i), state.sine_of_half);
      holds(c, at("cosine_of_half", i), state.cosine_of_half);
      holds(c, at("rate", i), state.rate);
    }
    const Deep seventh = pi<Deep>() / Deep(7), k = swing.modulus();
    holds(c, "time_until_0", swing.time_until(Deep(0), k));
    holds(c, "time_until_1", swing.time_until(k * sine_of_angle(seventh), k * cosine_of_angle(seventh)));
    const Deep near = pi<Deep>() / Deep(2) - from_rational<Deep>(exact_decimal("1e-9"));
    holds(c, "time_until_2", swing.time_until(k * sine_of_angle(near), k * cosine_of_angle(near)));
  }
}

TEST_CASE("theta series and the energy's integral give the reference's swing") {
  const Arithmetic<Deep> scope(320);
  for (const CorpusCase& c : vibrations("degrees")) {
    const analytic::PendulumByTheta swing(angle_of(c), c.givens.at("Omega_squared"), 1);
    holds(c, "K", swing.K());
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const auto state = swing.at(instants[i]);
      holds(c, at("sine_of_half", i), state.sine_of_half);
      holds(c, at("cosine_of_half", i), state.cosine_of_half);
      holds(c, at("rate", i), state.rate);
    }
    holds(c, "time_until_1", swing.time_until(pi<Deep>() / Deep(7)));
  }
}

TEST_CASE("the pendulum's table is the reference's, row by row and summed up") {
  const Arithmetic<Deep> scope(256);
  for (const CorpusCase& c : vibrations("degrees")) {
    // Ω² = m g r/(I_G + m r²) in a body of its own.
    const Rational square = c.givens.at("Omega_squared"), m = 3, r = Rational(1, 4), I_G = Rational(5, 16),
                   g = square * (I_G + m * r * r) / (m * r);
    const PendulumTable table{angle_of(c), I_G, m, r, g, c.givens.at("dt")};
    const auto rows = row_by_row(table, 200);
    const SummedUp sums = summed_up(table, 200);
    for (const std::size_t i : {2, 3, 50, 200}) {
      holds(c, at("row", i), rows.at(i));
      holds(c, at("row", i), sums.theta.at(i));
    }
  }
}

}  // namespace epure::tests
