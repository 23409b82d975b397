#include "exercises/kit/panels/mechanism_with_blocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epure {
namespace {

constexpr double half_slot = 11, shortest_half_slot = 6, block_corner = 6.5;  // mm: to either side of the pin

drawings::Point away(drawings::Point p, double direction, double mm) {
  return {p.x + mm * std::cos(direction), p.y + mm * std::sin(direction)};
}

}  // namespace

MechanismWithBlocks& MechanismWithBlocks::block(const Place& pin, double direction, Slides slides,
                                                const std::string& letters, int number) {
  blocks_.push_back({pin, direction, slides, letters, number});
  return *this;
}

MechanismWithBlocks& MechanismWithBlocks::hinge_under(const Place& at, const Place& other_end) {
  hinges_.push_back({at, other_end});
  return *this;
}

// Its number and its letters at two corners, as inside the block they would be lost: the number ahead on the left,
// the letters on the right, away from other blocks. A slot leaves the next block free.
void MechanismWithBlocks::draw_block(Plot& plot, const Block& block) const {
  const drawings::Point p = plot.at(block.pin);
  const double to_corner = std::atan2(3, 5);
  double slot = half_slot, letters = -to_corner;
  for (const Block& other : blocks_) {
    const Arrow2 there = other.pin - block.pin;
    if (&other == &block) continue;
    slot = std::clamp(plot.scale().mm_per_unit * magnitude(there) - 1.5 * block_corner, shortest_half_slot, slot);
    if (std::cos(block.direction) * there.x + std::sin(block.direction) * there.y > 0)
      letters = to_corner - std::numbers::pi;
  }
  if (block.slides == Slides::in_slot)
    plot.mark(drawings::Slot{away(p, block.direction, -slot), away(p, block.direction, slot)});
  plot.mark(drawings::Slider{p, block.direction});
  plot.hinge(block.pin);
  const auto corner = [&](double turned) { return plot.from_paper(away(p, block.direction + turned, block_corner)); };
  plot.label(block.letters, corner(letters), block.pin);
  plot.label(std::to_string(block.number), corner(to_corner), block.pin);
}

void MechanismWithBlocks::draw_own(Plot& plot) const {
  constexpr double touching = 1.5;  // mm from the body's line to the middle of the ring
  for (const Block& block : blocks_) draw_block(plot, block);
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
