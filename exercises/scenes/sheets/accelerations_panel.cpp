#include "exercises/scenes/sheets/accelerations_panel.h"

#include "exercises/kit/panels/edge.h"

namespace epure::scenes {

drawings::Box AccelerationsPanel::extent(const Scale& lengths, const Scale& vectors) const {
  constexpr double beside = 1, letters = 9;  // reaches of the mechanism; mm
  const drawings::Box covered = VectorsPanel::extent(lengths, vectors);
  Extent extent;
  extent.include(covered.low.x, covered.low.y);
  extent.include(covered.high.x, covered.high.y);
  for (const Centre& K : centres_)
    if (distance(mechanism_->corners().front(), K.at) < beside * mechanism_->reach())
      extent.include(lengths, K.at, letters);
  return extent.box();
}

std::vector<drawings::Block> AccelerationsPanel::draw(Plot& plot, const drawings::Box& room,
                                                      Language language) const {
  std::vector<drawings::Block> told = VectorsPanel::draw(plot, room, language);
  for (const Centre& K : centres_) {
    if (!is_in(room, plot, K.at)) continue;
    plot.cross(K.at);
    plot.label(K.letters, K.at, mechanism_->corners().front(), Meaning::locus);
    plot.measures_coordinates(K.quantity, K.at, {0, 0});
  }
  return told;
}

}  // namespace epure::scenes
