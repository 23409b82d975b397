// Directions as indeterminates: their cosines and sines in a tower of roots over the rational functions of tan θ/2.
#pragma once

#include "geometry/numbers/angle.h"
#include "geometry/numbers/tower.h"

#include <optional>
#include <vector>

namespace epure::geometry {

class OpenDirections {
 public:
  using Element = Surd<RationalFunction>;

  OpenDirections();

  Tower<RationalFunction>& tower() { return tower_; }

  // An angle that may be asked for. Of those that are known when the first is asked for, the finest is left open
  // first, so that the others are its multiples.
  void expect(const Angle& angle) { expected_.push_back(angle); }

  // Throw Undecided when there are more directions than indeterminates.
  Element cosine(const Angle& angle) { return direction(angle).x; }
  Element pi();

  // √x, positive where the directions are as they are; x is proved positive there. Throws Undecided when the tower
  // grows too high, or when the sign of a root that is found cannot be told.
  Element root(const Element& x);

 private:
  struct Unit {
    Element x, y;
  };
  struct Known {
    Angle angle;
    Unit unit;
  };

  void lay_out_expected();
  Unit direction(const Angle& angle);
  Unit found(const Angle& angle);
  Unit of_fifteens(int fifteens);
  Unit turned(const Unit& a, const Unit& b) const;
  Unit power(const Unit& a, int n) const;
  Unit adjoin(const Angle& angle);
  RationalFunction next_indeterminate(std::optional<Angle> of);
  Deep ball_around(const Element& x) const;

  Tower<RationalFunction> tower_;
  std::vector<Angle> expected_;
  std::vector<Known> independent_, seen_;
  std::vector<std::optional<Angle>> indeterminates_;  // what each stands for: tan of half the angle, or π
  std::optional<Element> pi_;
};

}  // namespace epure::geometry
