// The four-bar as exercises N.10 and N.11 state it: its frame on the x axis, the crank's angle given, and the
// midpoints of the moving links followed. θ₃ is the direction of AB, θ₄ that from B to B₀, as the closure
// r₂ + r₃ + r₄ - r₁ = 0 has it.
#pragma once

#include "exercises/kit/linkages/four_bar_instant.h"
#include "exercises/kit/linkages/half_turned.h"

namespace epure {

// A0B0, A0A, AB, B0B in metres, n in rpm, phi (θ₂) in degrees, alpha_2 in rad/s².
std::vector<GivenSpec> four_bar_on_x_givens();

// On the given side; nothing is required of it yet.
FourBarInstant four_bar_on_x(const Givens& givens, geometry::Side side);

// θ₃ and θ₄.
Quantity coupler_angle();
Quantity rocker_angle();
// The linkage as it stands, and as the same crank would have it with B on the other side of A -> B₀.
enum class Configuration { chosen, other };
Quantity in(Configuration of, const Quantity& quantity);

// G₂, G₃, G₄ halve A₀A, AB, B₀B.
template <class T>
struct Midpoints {
  geometry::Point<T> G2, G3, G4;
};
template <class T>
Midpoints<T> midpoints(const geometry::FourBar<T>& at) {
  return {midpoint(at.A0, at.A), midpoint(at.A, at.B), midpoint(at.B, at.B0)};
}

// How they move.
template <class T>
struct MidpointMotion {
  geometry::Vector<T> v_G2, v_G3, v_G4, a_G2, a_G3, a_G4;
};

// As images on the polar diagrams: they halve Oa', a'b' and Ob'.
template <class T>
MidpointMotion<T> midpoint_images(const geometry::Vector<T>& v_A, const geometry::Vector<T>& v_B,
                                  const geometry::Vector<T>& a_A, const geometry::Vector<T>& a_B) {
  const T half = geometry::from_rational<T>(Rational(1, 2));
  return {half * v_A, half * (v_A + v_B), half * v_B, half * a_A, half * (a_A + a_B), half * a_B};
}

// Each as a point of its link, whose motion is known.
template <class T>
MidpointMotion<T> midpoints_on_links(const Midpoints<T>& G, const geometry::PlaneMotion<T>& crank,
                                     const geometry::PlaneMotion<T>& coupler,
                                     const geometry::PlaneMotion<T>& rocker) {
  return {crank.velocity(G.G2),     coupler.velocity(G.G3),     rocker.velocity(G.G4),
          crank.acceleration(G.G2), coupler.acceleration(G.G3), rocker.acceleration(G.G4)};
}

template <class T>
void write_midpoint_motion(Ledger<T>& ledger, const MidpointMotion<T>& m) {
  ledger.put(velocity("G2"), m.v_G2);
  ledger.put(velocity("G3"), m.v_G3);
  ledger.put(velocity("G4"), m.v_G4);
  ledger.put(acceleration("G2"), m.a_G2);
  ledger.put(acceleration("G3"), m.a_G3);
  ledger.put(acceleration("G4"), m.a_G4);
}
template <class T>
struct LinkRates {
  T omega_3, omega_4, alpha_3, alpha_4;
};
template <class T>
void write_link_rates(Ledger<T>& ledger, const LinkRates<T>& rates, Configuration of = Configuration::chosen) {
  ledger.put(in(of, angular_velocity(3)), rates.omega_3);
  ledger.put(in(of, angular_velocity(4)), rates.omega_4);
  ledger.put(in(of, angular_acceleration(3)), rates.alpha_3);
  ledger.put(in(of, angular_acceleration(4)), rates.alpha_4);
}

// Coupler A -> B, and B -> B₀.
template <class T>
LinkDirections<T> link_directions(const geometry::FourBar<T>& at) {
  return {at.B - at.A, at.B0 - at.B};
}

template <class T>
void write_link_angles(Ledger<T>& ledger, const LinkDirections<T>& links, const HalfTurned& back,
                       Configuration of = Configuration::chosen) {
  ledger.put(in(of, coupler_angle()), [&] { return angle_or_half_turn(links.coupler, back.coupler); });
  ledger.put(in(of, rocker_angle()), [&] { return angle_or_half_turn(links.rocker, back.rocker); });
}

// Of a calculated number that the source cut off where it should have rounded.
Explanation cut_off(std::function<double()> value, int decimals);

}  // namespace epure
