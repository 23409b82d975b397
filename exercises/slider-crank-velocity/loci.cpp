#include "exercises/slider-crank-velocity/loci.h"

#include <fmt/format.h>

#include <algorithm>

#include "exercises/kit/panels/rounded.h"

namespace epure::slider_crank_velocity {

std::vector<Position> divided_positions(const SliderCrankInstant& instant) {
  using geometry::Deep;
  return deeply([&] {
    std::vector<Position> found;
    const auto at = instant.position<Deep>();
    const geometry::CouplerPosition<Deep> reference{at.A, at.B, at.pole()};
    const auto directions = geometry::directions_of_divided_circle<Deep>(positions, instant.guide);
    int first = 0;
    for (const auto& loop : loops_of<Deep>(instant)) {
      for (int k = 0; k < positions; ++k) {
        try {
          const auto here = geometry::coupler_position(loop, directions[static_cast<std::size_t>(k)]);
          const geometry::TransportedPosition<Deep> paper(reference, here);
          found.push_back({first + k, std::to_string(k) + (first > 0 ? "′" : ""), to_double(here.A),
                           to_double(here.B), to_double(here.P0), to_double(paper.P0_on_coupler()),
                           to_double(paper.forth(at.C))});
        } catch (const geometry::Impossible&) {
          // Beyond the crank's range the linkage does not close.
        } catch (const geometry::Undecided&) {
          // Links of equal length touch at the square position: that division has no coupler to carry.
        }
      }
      first += positions;
    }
    return found;
  });
}

bool shares_A(const Position& at, const std::vector<Position>& all) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Position& other) { return other.number == at.number - positions; });
}

std::string division_in_words(const SliderCrankInstant& instant, Language language) {
  const bool usual = !instant.is_offset() && !instant.is_inclined();
  const Words from =
      usual ? Words{"the outer dead centre", "dal punto morto esterno"} : Words{"the $x$ axis", "dall'asse $x$"};
  const char* circle = language == Language::english
                           ? "The crank's circle in {} parts, numbered from {}: positions of $A$."
                           : "La circonferenza di manovella in {} parti, numerate {}: le posizioni di $A$.";
  const char* both =
      language == Language::english
          ? "The crank's circle in {} parts, numbered from {}; $A$ where the linkage closes. Primed: $B$ behind $A$."
          : "La circonferenza di manovella in {} parti, numerate {}; $A$ dove il manovellismo si chiude. Con apice: "
            "$B$ dietro $A$.";
  const char* coupler = language == Language::english
                            ? "The coupler turns fully: its direction in {} parts, numbered from {}. $A$ on its "
                              "circle, with $AB$ in that direction."
                            : "La biella compie il giro: la sua direzione in {} parti, numerate {}. $A$ sulla sua "
                              "circonferenza, con $AB$ in quella direzione.";
  const Circuit circuit = circuit_of(instant);
  const char* text = circuit == Circuit::crank ? circle : circuit == Circuit::both ? both : coupler;
  const Words x_axis{"the $x$ axis", "dall'asse $x$"};
  return fmt::format(fmt::runtime(text), positions, (circuit == Circuit::crank ? from : x_axis).in(language));
}

std::vector<std::pair<Place, std::string>> numbered_together(
    const Plot& plot, const std::vector<std::pair<Place, std::string>>& points) {
  constexpr double one_point = 0.5;  // mm
  std::vector<std::pair<Place, std::string>> together;
  for (const auto& each : points) {
    const auto known = std::find_if(together.begin(), together.end(), [&](const auto& one) {
      return distance(one.first, each.first) * plot.scale().mm_per_unit < one_point;
    });
    if (known == together.end())
      together.push_back(each);
    else
      known->second += ", " + each.second;
  }
  return together;
}

}  // namespace epure::slider_crank_velocity
