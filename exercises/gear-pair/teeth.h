// The teeth of a pair on a plot, in mesh: outlines that join around the wheel, and the bodies they bound.
#pragma once

#include <array>
#include <optional>

#include "exercises/gear-pair/pair.h"
#include "exercises/kit/panels/plot.h"
#include "geometry/gears/mesh_angles.h"
#include "geometry/gears/tooth_outline.h"

namespace epure::gear_pair {

class Teeth {
 public:
  // The driving flanks touch in the pair's shown contact. `tolerance`, in metres: how far what is drawn may lie
  // inside the true teeth.
  Teeth(const Pair& pair, double tolerance);

  // Wheel 1 or 2 has an outline. Without one it has no flanks, or its cutter is none.
  bool has(int wheel) const { return outline(wheel).has_value(); }

  // The body's tint, a darker one for wheel 1, and its outline; as far as the paper reaches. The tint of a wheel
  // reaches `depth` metres inwards of its root circle; that of a ring or rack is its rim. Nothing for a wheel without
  // an outline.
  void tint(Plot& plot, int wheel, double depth) const;
  void draw(Plot& plot, int wheel, Meaning outline_as) const;
  // The touching flank alone, of a tooth that touches at the position `xi` of the line of action.
  void draw_flank(Plot& plot, int wheel, double xi) const;

  // Of the tooth `count` on from the touching one (counter-clockwise; of a rack to the left): the middle of its tip,
  // the place on its touching side where flank and root meet. The wheel has an outline.
  Place tip_of_tooth(int wheel, double count) const;
  Place foot_of_flank(int wheel, double count) const;
  // From the centre of wheel 1 or 2, no rack, through the middle of that tooth (of a half, of the space): unit
  // vector.
  Arrow2 direction_of_tooth(int wheel, double count) const;

 private:
  const std::optional<geometry::ToothOutline>& outline(int wheel) const {
    return outlines_[static_cast<std::size_t>(wheel - 1)];
  }
  long teeth_on_paper(const Plot& plot, int wheel) const;
  Place placed(const Place& P, int wheel, double tooth, const geometry::MeshAngles& at) const;
  void append(drawings::Path& path, const Plot& plot, int wheel, const std::vector<geometry::BezierArc>& arcs,
              double tooth, const geometry::MeshAngles& at) const;
  drawings::Path edge(const Plot& plot, int wheel) const;
  const geometry::OutlinePiece& touching_flank(int wheel) const;
  bool touches_on_the_left(int wheel) const { return wheel == 1 || pair_.of.kind == geometry::PairKind::external; }

  const Pair& pair_;
  double rack_reference_ = 0;  // the height of its line
  std::optional<geometry::MeshAngles> mesh_;
  std::array<std::optional<geometry::ToothOutline>, 2> outlines_;
};

// An arc arrow about the wheel's centre that shows how it turns, by its radius in paper millimetres and the angles of
// its middle and half.
void draw_sense(Plot& plot, const Pair& pair, int wheel, double radius, double middle, double half);

}  // namespace epure::gear_pair
