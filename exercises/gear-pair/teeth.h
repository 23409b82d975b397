// The teeth of a pair on a plot, in mesh: outlines that join around the wheel, and the bodies they bound.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "exercises/gear-pair/drawn_pair.h"
#include "geometry/gears/mesh_angles.h"
#include "geometry/gears/tooth_outline.h"

namespace epure::gear_pair {

// The driving flank of wheel 1 and the driven one of wheel 2.
class Teeth {
 public:
  // The driving flanks touch at the position `xi` of the line of action. `mm_per_metre` is the plot's scale: teeth
  // are drawn as truly as the file can hold them.
  Teeth(const DrawnPair& pair, double xi, double mm_per_metre);

  // Wheel 1 or 2 has an outline. Without one it has no flanks, or its cutter is none.
  bool has(int wheel) const { return outline(wheel).has_value(); }

  // The body's tint, then its outline; as far as the paper reaches. The tint of a wheel reaches `depth` metres
  // inwards of its root circle; that of a ring or rack is its rim. Nothing for a wheel without an outline.
  void draw(Plot& plot, int wheel, Meaning outline_as, double depth) const;
  // The touching flank alone, of a tooth that touches at another position.
  void draw_flank(Plot& plot, int wheel, double xi) const;

  // Of the tooth `count` on from the touching one (counter-clockwise; of a rack to the left): the middle of its tip,
  // the place on its touching side where flank and root meet. The wheel has an outline.
  Place tip_of_tooth(int wheel, double count) const;
  Place foot_of_flank(int wheel, double count) const;
  // From the centre of wheel 1 or 2, no rack, through the middle of that tooth (of a half, of the space): unit
  // vector.
  Arrow2 direction_of_tooth(int wheel, double count) const;

  // How thick the rim of a ring or rack is drawn, beyond its root.
  double rim() const;

 private:
  const std::optional<geometry::ToothOutline>& outline(int wheel) const {
    return outlines_[static_cast<std::size_t>(wheel - 1)];
  }
  long teeth_on_paper(const Plot& plot, int wheel) const;
  Place placed(const Place& P, int wheel, double tooth, const geometry::MeshAngles& at) const;
  void append(drawings::Path& path, const Plot& plot, int wheel, double tooth) const;
  drawings::Path body(const Plot& plot, int wheel, const drawings::Path& edge, double depth) const;
  const geometry::OutlinePiece& touching_flank(int wheel) const;
  bool touches_on_the_left(int wheel) const { return wheel == 1 || pair_.of.kind == geometry::PairKind::external; }

  const DrawnPair& pair_;
  std::optional<geometry::MeshAngles> mesh_;
  std::array<std::optional<geometry::ToothOutline>, 2> outlines_;
};

// A circle's arc from the angle `from` to `to` (radians, to > from), in the plane of the plot.
void draw_arc(Plot& plot, const Place& centre, double radius, double from, double to, Meaning meaning,
              const std::string& name = {});

}  // namespace epure::gear_pair
