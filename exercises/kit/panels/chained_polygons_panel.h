// Polygons of forces of several bodies in one figure: each starts in a corner of one before, so that what one body
// does to the next is a side of both.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"
#include "exercises/kit/panels/polygon_picture.h"

namespace epure {

class ChainedPolygonsPanel : public Panel {
 public:
  // The first polygon; its origin is the plane's.
  explicit ChainedPolygonsPanel(VectorPolygon first) { links_.push_back({std::move(first), {0, 0}}); }
  // Another, which starts `from` the origin: in the corner of that letter, which is its own origin's.
  ChainedPolygonsPanel& then(VectorPolygon polygon, const Arrow2& from);
  // Other polygons under these, dashed and without letters, through these corners: to compare with.
  ChainedPolygonsPanel& over(std::vector<Arrow2> corners);
  // Words beneath.
  ChainedPolygonsPanel& captioned(const Words& caption);
  // An angle at a corner from one direction to another (radians), with its letters and a line in the first.
  ChainedPolygonsPanel& angle(const Arrow2& at, double from, double to, const std::string& letters);
  // Made as the figure before it, whose steps and equations tell how: one step tells so, where the other way begins.
  ChainedPolygonsPanel& likewise(const Words& text, const Arrow2& at);
  // What the figure shows beside: told, and where.
  ChainedPolygonsPanel& step(const Words& text, const Arrow2& at);

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<Place> lettered() const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override;
  std::vector<drawings::VectorEquation> equations() const override;
  std::vector<double> crossings() const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  struct Angle;
  static void draw_angle(Plot& plot, const Angle& angle);

  struct Link {
    VectorPolygon polygon;
    Arrow2 from;
  };
  struct Angle {
    Arrow2 at;
    double from, to;
    std::string letters;
  };
  std::vector<Link> links_;
  std::vector<Angle> angles_;
  std::vector<std::vector<Arrow2>> under_;
  Words caption_;
  bool is_told_ = true;
  std::vector<PanelStep> steps_;
};

}  // namespace epure
