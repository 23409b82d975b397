#include "exercises/slider-crank-velocity/loci.h"

#include "geometry/numbers/enclosure.h"

namespace epure::slider_crank_velocity {

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

std::vector<Position> divided_positions(const SliderCrankInstant& instant) {
  using geometry::Deep;
  return deeply([&] {
    std::vector<Position> found;
    const auto loop = loop_of<Deep>(instant);
    const auto at = instant.position<Deep>();
    const geometry::CouplerPosition<Deep> reference{at.A, at.B, at.pole()};
    const auto directions = geometry::directions_of_divided_circle<Deep>(positions);
    for (int k = 0; k < positions; ++k) {
      try {
        const auto here = geometry::coupler_position(loop, directions[static_cast<std::size_t>(k)]);
        const geometry::TransportedPosition<Deep> paper(reference, here);
        found.push_back({k, to_double(here.A), to_double(here.B), to_double(here.P0),
                         to_double(paper.P0_on_coupler()), to_double(paper.forth(at.C))});
      } catch (const geometry::Impossible&) {
        // Links of equal length touch at the square position: that division has no coupler to carry.
      } catch (const geometry::Undecided&) {
      }
    }
    return found;
  });
}

}  // namespace epure::slider_crank_velocity
