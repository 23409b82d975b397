#include "exercises/slider-crank-velocity/loci.h"

namespace epure::slider_crank_velocity {

std::vector<Position> divided_positions(const SliderCrankInstant& instant) {
  using geometry::Deep;
  return deeply([&] {
    std::vector<Position> found;
    const auto loop = loop_of<Deep>(instant);
    const auto reference = reference_of<Deep>(instant);
    const geometry::Point<Deep> C = instant.position<Deep>().C;
    const auto directions = geometry::directions_of_divided_circle<Deep>(positions);
    for (int k = 0; k < positions; ++k) {
      try {
        const auto here = geometry::coupler_position(loop, directions[static_cast<std::size_t>(k)]);
        const geometry::TransportedPosition<Deep> paper(reference, here);
        found.push_back({k, to_double(here.A), to_double(here.B), to_double(here.P0),
                         to_double(paper.P0_on_coupler()), to_double(paper.forth(C))});
      } catch (const geometry::Impossible&) {
        // Links of equal length touch at the square position: that division has no coupler to carry.
      } catch (const geometry::Undecided&) {
      }
    }
    return found;
  });
}

}  // namespace epure::slider_crank_velocity
