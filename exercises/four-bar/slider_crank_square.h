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

// Sub-exercise 2, for crank and crank speed 1: the crank on +y, the guide along +x through A₀.
struct SliderCrankSquare {
  const Problem& of;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("polar diagram");
    ledger.begin_case("slider_crank_ratio_3.");
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
    ledger.put("B_x_over_r", B.x);
    ledger.put("coupler_angle", [&] { return angle_of(B - A); });
    ledger.put("omega_3_over_omega_2", motion.omega);
    ledger.put("alpha_3_over_omega_2_squared", motion.alpha);
    ledger.put("v_B_over_omega_2_r", [&] { return size(v.v_X); });
    ledger.put("a_B_over_omega_2_squared_r", [&] { return size(a.a_X); });
    const auto K = finite(motion.acceleration_pole());
    ledger.put("K_x_over_r", K.x);
    ledger.put("K_y_over_r", K.y);
    // The circles have become lines: k = 0 in both.
    const auto inflection = motion.inflection_circle().straight(),
               stationarity = motion.stationarity_circle().straight();
    ledger.put("inflection_line_x_over_r", [&] { return geometry::quotient(-inflection.c, inflection.a); });
    ledger.put("stationarity_line_y_over_r", [&] { return geometry::quotient(-stationarity.c, stationarity.b); });
    by_closed_form(ledger);
    return ledger;
  }

 private:
  // sin ϑ₃ = -1/λ; ω₃ = 0 there, α₃ = 1/(λ cos ϑ₃), and the lines by the vanishing of v x a and v . a.
  template <class T>
  void by_closed_form(Ledger<T>& ledger) const {
    ledger.route("analytic");
    const T reach = geometry::root(from_rational<T>(of.lambda * of.lambda - 1));  // λ cos ϑ₃
    const T alpha = geometry::quotient(T(1), reach);
    const analytic::PlaneMotion<T> coupler{{T(0), T(1)}, {T(-1), T(0)}, {T(0), T(-1)}, T(0), alpha};
    const analytic::Complex<T> B{reach, T(0)};
    ledger.put("B_x_over_r", reach);
    ledger.put("coupler_angle", [&] { return angle_of(Vector<T>{reach, T(-1)}); });
    ledger.put("omega_3_over_omega_2", coupler.omega);
    ledger.put("alpha_3_over_omega_2_squared", alpha);
    put_length<T>(ledger, "v_B_over_omega_2_r", [&] { return coupler.velocity(B); });
    put_length<T>(ledger, "a_B_over_omega_2_squared_r", [&] { return coupler.acceleration(B); });
    const auto K = [&] { return present(coupler.acceleration_pole(), no_acceleration_pole); };
    ledger.put("K_x_over_r", [&] { return K().re; });
    ledger.put("K_y_over_r", [&] { return K().im; });
    const auto inflection = [&] { return present(coupler.inflection_line(), no_inflection_line); };
    const auto stationarity = [&] { return present(coupler.stationarity_line(), no_stationarity_line); };
    ledger.put("inflection_line_x_over_r",
               [&] { return geometry::quotient(-inflection().offset, inflection().normal.re); });
    ledger.put("stationarity_line_y_over_r",
               [&] { return geometry::quotient(-stationarity().offset, stationarity().normal.im); });
  }
};

}  // namespace epure::four_bar
