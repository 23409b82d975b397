// The slotted lever with every number: its laws agree, provably where the number can prove, and its analytic
// counterpart is the same mechanism.
#include "geometry/analytic/slotted_lever_formulas.h"
#include "geometry/statics/slotted_lever_forces.h"
#include "tests/geometry/every_number.h"
#include "tests/support/catch.h"

using namespace epure::tests;

namespace {

const SlottedLeverMasses masses{30, 20, 1, Rational(981, 100)};
// 30°: Q(√3); sides 3, 4, 5: Q; upright.
const std::vector<SlottedLeverLengths> levers{{Rational(1, 5), Rational(2, 5), Rational(3, 10)},
                                              {Rational(3, 10), Rational(1, 2), Rational(7, 10)},
                                              {Rational(1, 5), Rational(1, 5), Rational(3, 10)}};

}  // namespace

TEMPLATE_TEST_CASE("the pin keeps its level and the slot its pin", "[slotted-lever]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  for (const SlottedLeverLengths& of : levers) {
    const auto at = slotted_lever<T>(of);
    const auto motion = slotted_lever_motion(at, number<T>(-3, 2), number<T>(2, 5));
    CHECK(is(at.B.y, from_rational<T>(of.R)));
    CHECK(is(length_squared(at.B - at.O), from_rational<T>(of.OB * of.OB)));
    CHECK(is(cross(at.A - at.O, at.B - at.O), T(0)));
    // The disc's lowest point stands still, and the pin is in the slot: the difference of the velocities is along it.
    CHECK(is(motion.disc.velocity(at.D), Vector<T>{T(0), T(0)}));
    CHECK(is(cross(motion.disc.velocity(at.B) - motion.lever.velocity(at.B), at.slot), T(0)));
    CHECK(is(motion.disc.omega, disc_speed_by_poles(at, number<T>(-3, 2)), 100));
  }
}

TEMPLATE_TEST_CASE("bodies are in equilibrium and the couple is that of the powers", "[slotted-lever]", Fast, Bounded,
                   Deep, Exact, Calcium) {
  using T = TestType;
  const Scope<T> scope;
  constexpr double newtons = 1e4;
  for (const SlottedLeverLengths& of : levers) {
    const auto at = slotted_lever<T>(of);
    const auto motion = slotted_lever_motion(at, number<T>(-3, 2), number<T>(2, 5));
    const auto disc = disc_forces(at, motion.disc, masses);
    const auto lever = lever_forces(at, motion.lever, disc.slot, masses);
    const Vector<T> none{T(0), T(0)};
    CHECK(is(disc.weight.f + disc.inertia.f + disc.friction.f + disc.slot.f + disc.ground.f, none, newtons));
    CHECK(is(lever.pin.f + lever.weight.f + lever.inertia.f + lever.pivot.f, none, newtons));
    CHECK(is(dot(disc.slot.f, at.slot), T(0), newtons));
    CHECK(is(moment(disc.friction, at.B), from_rational<T>(masses.J2) * motion.disc.alpha, newtons));
    CHECK(is(lever.couple, power_balance(at, motion, masses).couple(), newtons));
  }
}

TEMPLATE_TEST_CASE("the analytic slotted lever is the constructed one", "[slotted-lever]", Fast, Bounded, Deep, Exact,
                   Calcium) {
  using T = TestType;
  const Scope<T> scope;
  constexpr double newtons = 1e4;
  for (const SlottedLeverLengths& of : levers) {
    const T omega = number<T>(3, 2), omega_dot = number<T>(-2, 5);
    const auto at = slotted_lever<T>(of);
    const auto motion = slotted_lever_motion<T>(at, -omega, -omega_dot);
    const auto disc = disc_forces(at, motion.disc, masses);
    const auto lever = lever_forces(at, motion.lever, disc.slot, masses);
    const analytic::SlottedLever same{of.R, of.OB, of.AO, masses.M1, masses.M2, masses.J2, masses.g};
    const auto angle = analytic::angle<T>(same);
    const auto m = analytic::motion(same, angle, omega, omega_dot);
    const auto force = analytic::reactions(same, angle, m, omega, omega_dot);
    const auto balance = analytic::balance(same, angle, omega, omega_dot);
    CHECK(is(at.slot, Vector<T>{angle.cosine, angle.sine}));
    CHECK(is(motion.velocity.first_rate, m.b_dot));
    CHECK(is(motion.acceleration.first_rate, m.b_ddot, 100));
    CHECK(is(motion.disc.a_A, Vector<T>{m.a_B, T(0)}, 100));
    CHECK(is(motion.disc.alpha, m.alpha_disc, 100));
    CHECK(is(disc.on_slot_normal, force.slot, newtons));
    CHECK(is(disc.normal, force.normal, newtons));
    CHECK(is(disc.friction.f.x, force.friction, newtons));
    CHECK(is(lever.pivot.f, Vector<T>{force.at_O.re, force.at_O.im}, newtons));
    CHECK(is(lever.couple, balance.couple, newtons));
    CHECK(is(kinetic_energy(at, motion, masses), balance.kinetic_energy, newtons));
  }
}

TEST_CASE("a lever shorter than its pin is high does not exist", "[slotted-lever]") {
  const Arithmetic<Exact> scope;
  CHECK_THROWS_AS(slotted_lever<Exact>({Rational(1, 5), Rational(1, 6), Rational(1)}), Impossible);
}
