// Where symbols are drawn: collects primitives in drawing order, cuts them to the part of the paper their mark
// belongs to, checks every number, and remembers what labels must keep clear of.
#pragma once

#include <string>
#include <vector>

#include "drawings/labels/obstacles.h"
#include "drawings/marks/style.h"
#include "drawings/page.h"

namespace epure::drawings {

class Canvas {
 public:
  explicit Canvas(Box area);

  // Where the marks drawn from now on may show.
  void clip_to(Box clip) { clip_ = clip; }
  Box clip() const { return clip_; }
  // The step that draws them.
  void in_step(int step) { step_ = step; }

  // All throw as demand_drawable (output.h) does; compose() adds the mark's name.
  void stroke(const Path& path, const LineStyle& style, const std::string& name = {});
  // Solid areas (arrow heads, points, blocks) keep labels away; light ones (plates) do not.
  void fill(const Path& path, Colour colour, const std::string& name = {});
  void tint(const Path& path, Colour colour, const std::string& name = {});
  // Labels keep clear of it, though nothing shows.
  void keep_clear(const Path& path) { remember(path, 0); }
  // Letters whose place their mark decides (scale bars). Labels keep away from them too.
  void text(const PlacedText& text);

  // From now on on top of everything drawn before `lower` is called: hinges and points.
  void raise() { raised_ = true; }
  void lower() { raised_ = false; }

  // Call when all marks are drawn: which of those letters a line or symbol runs through.
  std::vector<std::string> crossed_texts() const;
  // What labels must keep clear of.
  Obstacles obstacles() const;
  std::vector<Primitive> take();

 private:
  void put(Primitive primitive);
  void remember(const Path& path, double width);
  // Curves become chords within `tolerance` (mm) where the area must be cut.
  void area(const Path& path, Colour colour, const std::string& name, double tolerance);

  Box clip_;
  int step_ = 0;
  bool raised_ = false;
  Obstacles drawn_;
  std::vector<std::pair<std::string, Box>> texts_;
  std::vector<Primitive> below_, above_;
};

}  // namespace epure::drawings
