// The scene of sub-exercise 2: a slider-crank with its crank square to the guide.
#pragma once

#include "exercises/four-bar/exercise.h"
#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/coupler_routes.h"
#include "geometry/mechanisms/dyad.h"

namespace epure::four_bar {

namespace analytic = geometry::analytic;
using geometry::from_rational;
using geometry::Vector;

inline constexpr Phrase no_inflection_line{"the inflection circle has not become a line",
                                           "la circonferenza dei flessi non è diventata una retta"};
inline constexpr Phrase no_stationarity_line{"the stationarity circle has not become a line",
                                             "la circonferenza di stazionarietà non è diventata una retta"};

inline const std::string slider_crank_case = "slider_crank_ratio_3.";

inline Quantity pure(const std::string& name, const std::string& letters, const Words& meaning) {
  return {name, "$" + letters + "$", "1", meaning};
}
// A coordinate of B or K.
inline Quantity over_r(const std::string& point, const std::string& axis) {
  return pure(point + "_" + axis + "_over_r", axis + "_{" + point + "}/r",
              (axis == "x" ? Words{"abscissa of ", "ascissa di "} : Words{"ordinate of ", "ordinata di "}) + point);
}
inline Quantity slider_coupler_angle() {
  return {"coupler_angle", "$θ_{3}$", "rad", {"direction from A to B", "direzione da A a B"}};
}
inline Quantity omega_3_over_omega_2() {
  return pure("omega_3_over_omega_2", "ω_{3}/ω_{2}",
              {"angular velocity of the coupler", "velocità angolare della biella"});
}
inline Quantity alpha_3_over_omega_2_squared() {
  return pure("alpha_3_over_omega_2_squared", "α_{3}/ω^{2}_{2}",
              {"angular acceleration of the coupler", "accelerazione angolare della biella"});
}
inline Quantity v_B_over_omega_2_r() {
  return pure("v_B_over_omega_2_r", "v_{B}/ω_{2}r", {"velocity of B", "velocità di B"});
}
inline Quantity a_B_over_omega_2_squared_r() {
  return pure("a_B_over_omega_2_squared_r", "a_{B}/ω^{2}_{2}r", {"acceleration of B", "accelerazione di B"});
}
inline Quantity inflection_line() {
  return pure("inflection_line_x_over_r", "x_{f}/r",
              {"abscissa of the line that the inflection circle has become",
               "ascissa della retta in cui degenera la circonferenza dei flessi"});
}
inline Quantity stationarity_line() {
  return pure("stationarity_line_y_over_r", "y_{s}/r",
              {"ordinate of the line that the stationarity circle has become",
               "ordinata della retta in cui degenera la circonferenza di stazionarietà"});
}

// Sub-exercise 2, for crank and crank speed 1: the crank on +y, the guide along +x through A₀.
struct SliderCrankSquare {
  const Problem& of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("polar diagram");
    ledger.begin_case(slider_crank_case);
    const T none(0), one(1);
    const Vector<T> along{one, none};
    const geometry::Point<T> A0{none, none}, A{none, one};
    const auto guide = geometry::line(A0, along);
    const auto B = geometry::joint_on_guide(A, from_rational<T>(of.lambda), guide, geometry::Along::ahead);
    const auto crank = geometry::turning_about(A0, one, none);
    const geometry::Bar<T> coupler{pin_on(crank, A)};
    const geometry::Slide<T> slider{geometry::turning_about(A0, none, none), along};
    const auto v = dyad_velocity(coupler, slider, B);
    const auto a = dyad_acceleration(coupler, slider, B, v);
    const auto motion = coupler.motion(v.first_rate, a.first_rate);
    const std::pair<const char*, geometry::Point<T>> points[]{{"A0", A0}, {"A", A}, {"B", B}};
    for (const auto& [name, P] : points) ledger.draws_point(name, P);
    ledger.draws_vector("v_A", motion.velocity(A));
    ledger.draws_vector("v_B", v.v_X);
    ledger.draws_vector("a_A", motion.acceleration(A));
    ledger.draws_vector("a_B", a.a_X);
    ledger.draws_vector("a_BA", a.first.closing);
    ledger.put(over_r("B", "x"), B.x);
    ledger.put(slider_coupler_angle(), [&] { return angle_of(B - A); });
    ledger.put(omega_3_over_omega_2(), motion.omega);
    ledger.put(alpha_3_over_omega_2_squared(), motion.alpha);
    ledger.put(v_B_over_omega_2_r(), [&] { return size(v.v_X); });
    ledger.put(a_B_over_omega_2_squared_r(), [&] { return size(a.a_X); });
    const auto K = finite(motion.acceleration_pole());
    ledger.draws_point("K", K);
    ledger.put(over_r("K", "x"), K.x);
    ledger.put(over_r("K", "y"), K.y);
    // The circles have become lines: k = 0 in both.
    const auto inflection = motion.inflection_circle().straight(),
               stationarity = motion.stationarity_circle().straight();
    ledger.put(inflection_line(), [&] { return geometry::quotient(-inflection.c, inflection.a); });
    ledger.put(stationarity_line(), [&] { return geometry::quotient(-stationarity.c, stationarity.b); });
    by_closed_form(ledger);
    return ledger;
  }

 private:
  // sin θ₃ = -1/λ; ω₃ = 0 there, α₃ = 1/(λ cos θ₃), and the lines by the vanishing of v x a and v . a.
  template <class T>
  void by_closed_form(Ledger<T>& ledger) const {
    ledger.route("analytic");
    const T reach = geometry::root(from_rational<T>(of.lambda * of.lambda - 1));  // λ cos θ₃
    const T alpha = geometry::quotient(T(1), reach);
    const analytic::PlaneMotion<T> coupler{{T(0), T(1)}, {T(-1), T(0)}, {T(0), T(-1)}, T(0), alpha};
    const analytic::Complex<T> B{reach, T(0)};
    ledger.put(over_r("B", "x"), reach);
    ledger.put(slider_coupler_angle(), [&] { return angle_of(Vector<T>{reach, T(-1)}); });
    ledger.put(omega_3_over_omega_2(), coupler.omega);
    ledger.put(alpha_3_over_omega_2_squared(), alpha);
    put_length<T>(ledger, v_B_over_omega_2_r(), [&] { return coupler.velocity(B); });
    put_length<T>(ledger, a_B_over_omega_2_squared_r(), [&] { return coupler.acceleration(B); });
    const auto K = [&] { return present(coupler.acceleration_pole(), no_acceleration_pole); };
    ledger.put(over_r("K", "x"), [&] { return K().re; });
    ledger.put(over_r("K", "y"), [&] { return K().im; });
    const auto inflection = [&] { return present(coupler.inflection_line(), no_inflection_line); };
    const auto stationarity = [&] { return present(coupler.stationarity_line(), no_stationarity_line); };
    ledger.put(inflection_line(), [&] { return geometry::quotient(-inflection().offset, inflection().normal.re); });
    ledger.put(stationarity_line(),
               [&] { return geometry::quotient(-stationarity().offset, stationarity().normal.im); });
  }
};

}  // namespace epure::four_bar
