#include "exercises/kit/panels/mechanism_with_blocks.h"

#include <cmath>

namespace epure {
namespace {

constexpr double half_slot = 11, block_corner = 6.5;  // mm: of a slot to either side; as far as a block reaches

drawings::Point away(drawings::Point p, double direction, double mm) {
  return {p.x + mm * std::cos(direction), p.y + mm * std::sin(direction)};
}

}  // namespace

MechanismWithBlocks& MechanismWithBlocks::block(const Place& pin, double direction, Slides slides,
                                                const std::string& letters) {
  blocks_.push_back({pin, direction, slides, letters});
  return *this;
}

MechanismWithBlocks& MechanismWithBlocks::hinge_under(const Place& at, const Place& other_end) {
  hinges_.push_back({at, other_end});
  return *this;
}

void MechanismWithBlocks::draw_own(Plot& plot) const {
  constexpr double touching = 1.5;  // mm from the body's line to the middle of the ring
  for (const Block& block : blocks_) {
    const drawings::Point p = plot.at(block.pin);
    if (block.slides == Slides::in_slot)
      plot.mark(drawings::Slot{away(p, block.direction, -half_slot), away(p, block.direction, half_slot)});
    plot.mark(drawings::Slider{p, block.direction});
    plot.hinge(block.pin);
    // Its letters at a corner: inside the block they would be lost.
    plot.label(block.letters, plot.from_paper(away(p, block.direction - std::atan2(3, 5), block_corner)), block.pin);
  }
  for (const Hinge& hinge : hinges_)
    plot.hinge(plot.from_paper(away(plot.at(hinge.at), direction(hinge.at, hinge.other_end), touching)));
}

void MechanismWithBlocks::draw(Plot& plot) const {
  mechanism_.draw(plot);
  draw_own(plot);
}

void MechanismWithBlocks::draw_given(Plot& plot) const {
  mechanism_.draw_given(plot);
  draw_own(plot);
}

void MechanismWithBlocks::include(Extent& extent, const Scale& scale) const {
  constexpr double letters = 4;  // mm
  mechanism_.include(extent, scale);
  for (const Block& block : blocks_)
    extent.include(scale, block.pin, (block.slides == Slides::in_slot ? half_slot : block_corner) + letters);
}

}  // namespace epure
