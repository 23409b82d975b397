// The position of the slider-crank and its pole as its two routes find them: by construction and by analysis.
#pragma once

#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/kit/linkages/driving_crank.h"
#include "exercises/kit/linkages/slider_crank_instant.h"
#include "geometry/analytic/slider_crank_formulas.h"

namespace epure {

inline constexpr Phrase pole_at_infinity{"the pole P₀ is at infinity: the crank is square to the guide",
                                         "il polo P₀ è all'infinito: la manovella è perpendicolare alla guida"};

template <class T>
struct AnalyticSliderCrank {
  geometry::analytic::SliderCrankPosition<T> position;
  geometry::analytic::SliderCrankMotion<T> motion;
};

template <class T>
AnalyticSliderCrank<T> analytic_slider_crank(const SliderCrankInstant& instant) {
  namespace analytic = geometry::analytic;
  const auto& [r, l, AC, BC, e] = instant.lengths;
  const analytic::SliderCrank g{r, l, AC, BC, e, instant.guide};
  const auto crank =
      analytic::guided_crank<T>(g, instant.crank, instant.omega_2<T>(), geometry::radians<T>(instant.alpha_2));
  const auto position = analytic::position(g, crank);
  return {position, analytic::motion(g, crank, position)};
}

// The construction is carried out with the guide level: what it finds is turned back before it is written down.
template <class T>
void construct_level(Ledger<T>& ledger, const SliderCrankInstant& instant) {
  if (instant.is_inclined()) ledger.axes_along(instant.direction<T>(instant.guide));
}

// The crank angle at the beginning or the end of a range in which the linkage closes.
inline Quantity crank_limit(std::size_t number) {
  return {"crank_limit_" + std::to_string(number + 1),
          "$φ_{l" + std::to_string(number + 1) + "}$",
          "deg",
          {"crank angle where the linkage begins or ceases to close",
           "angolo di manovella dal quale o fino al quale il meccanismo si chiude"}};
}
template <class T>
void tell_crank_limits(Ledger<T>& ledger, const SliderCrankInstant& instant) {
  if constexpr (std::is_same_v<T, geometry::Deep>) {
    const std::vector<T> limits = crank_limits(instant);
    for (std::size_t i = 0; i < limits.size(); ++i) ledger.tells(crank_limit(i), [&] { return limits[i]; });
  }
}

}  // namespace epure
