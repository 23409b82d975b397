// A mechanism with what its links and hinges alone do not show: blocks that slide along its bodies, and hinges under
// a body that goes on.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism.h"

namespace epure {

class MechanismWithBlocks : public MechanismFigure {
 public:
  explicit MechanismWithBlocks(Mechanism mechanism) : mechanism_(std::move(mechanism)) {}

  // A block on its pin slides along a body, in this direction (radians): on the body, or in a slot of it, which hides
  // what lies beneath. The letters are the pin's, which the mechanism leaves to the block, as it does its number.
  enum class Slides { on_body, in_slot };
  MechanismWithBlocks& block(const Place& pin, double direction, Slides slides, const std::string& letters,
                             int number);
  // The hinge of a link that ends at a point of a body which goes on: beside the body, towards the link's other end.
  MechanismWithBlocks& hinge_under(const Place& at, const Place& other_end);

  void draw(Plot& plot) const override;
  void draw_given(Plot& plot) const override;
  void sketch(Plot& plot) const override { mechanism_.sketch(plot); }
  void include(Extent& extent, const Scale& scale) const override;
  std::vector<Place> corners() const override { return mechanism_.corners(); }
  double reach() const override { return mechanism_.reach(); }

 private:
  struct Block {
    Place pin;
    double direction;
    Slides slides;
    std::string letters;
    int number;
  };
  struct Hinge {
    Place at, other_end;
  };
  void draw_own(Plot& plot) const;
  void draw_block(Plot& plot, const Block& block) const;

  Mechanism mechanism_;
  std::vector<Block> blocks_;
  std::vector<Hinge> hinges_;
};

}  // namespace epure
