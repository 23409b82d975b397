#include "exercises/kit/linkages/slider_crank_loops.h"

#include "exercises/kit/panels/rounded.h"
#include "geometry/numbers/enclosure.h"

namespace epure {

Reference reference_of(const SliderCrankInstant& instant) {
  return deeply([&]() -> Reference {
    const auto at = instant.position<geometry::Deep>();
    const auto P0 = at.pole();
    const auto enclosed = [](const geometry::Point<geometry::Deep>& P) -> geometry::Point<geometry::Bounded> {
      return {geometry::to_bounded(P.x), geometry::to_bounded(P.y)};
    };
    return {{enclosed(at.A),
             enclosed(at.B),
             {geometry::to_bounded(P0.x), geometry::to_bounded(P0.y), geometry::to_bounded(P0.w)}},
            enclosed(at.C)};
  });
}

}  // namespace epure
