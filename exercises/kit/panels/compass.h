// What a pair of compasses leaves of the points that it found.
#pragma once

#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

// A short arc about `centre` through P, so many mm to both sides.
void compass_arc(Plot& plot, const Place& centre, const Place& P, double half_mm = 7);

// A panel with arcs, each about a centre through the point it finds.
template <class Drawn>
class FoundByArcs : public Drawn {
 public:
  using Arcs = std::vector<std::pair<Place, Place>>;
  FoundByArcs(Drawn panel, Arcs arcs) : Drawn(std::move(panel)), arcs_(std::move(arcs)) {}

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    for (const auto& [centre, P] : arcs_) compass_arc(plot, centre, P);
    return Drawn::draw(plot, room, language);
  }

 private:
  Arcs arcs_;
};

}  // namespace epure
