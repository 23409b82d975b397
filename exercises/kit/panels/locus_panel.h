// The path of a point of a mechanism by the transport method: the body that carries it, in numbered positions, and
// the curve through the points.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/panel.h"

namespace epure {

class LocusPanel : public Panel {
 public:
  // Of the body: a segment or a plate. Its number stands at every point that is numbered, away from another. What has
  // several numbers, where a point comes by again, has those of one series together.
  struct Numbered {
    std::string label;
    Place at, away_from;
    Meaning ink = Meaning::construction;
    int series = 0;
  };
  struct Position {
    std::vector<Place> body;
    std::vector<Numbered> points;
    std::vector<std::vector<Place>> others = {};  // bodies too, of a point that is their joint
  };
  // Traces and draws within a box of the paper.
  using DrawCurve = std::function<geometry::Trace(Plot&, const drawings::Box& room)>;

  // The point is one of the mechanism.
  LocusPanel(std::shared_ptr<const Mechanism> mechanism, std::string point, std::vector<Position> positions,
             DrawCurve draw_curve, std::vector<PanelStep> steps);
  // The path takes so much less room than the mechanism that a picture of its own, larger, is better.
  bool needs_close_up() const;
  // That picture, of the path with its points and the circle that osculates it; beside it the whole is constructed.
  LocusPanel& close_up();
  LocusPanel& beside_close_up();
  // The circle that osculates the path now, about this centre: named by its letters.
  LocusPanel& osculated(const std::optional<Place>& centre, const std::string& quantity, const std::string& letters);

  double reach() const override;
  bool is_cut() const override { return true; }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box&, Language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;

 private:
  static bool is_on_path(const Numbered& point) { return point.ink == Meaning::locus; }
  // The point of now and in the positions.
  void include_path(Extent& extent, const Scale& scale, double letters) const;
  double size_of_path() const;  // metres
  bool shows_centre() const { return shows_ != Shows::whole; }
  bool is_centre(const PanelStep& step) const;
  void draw_positions(Plot& plot) const;
  void draw_point(Plot& plot) const;
  std::vector<drawings::Block> draw_osculating(Plot& plot, const drawings::Box& room, Language language) const;

  enum class Shows { all, whole, close_up } shows_ = Shows::all;
  std::shared_ptr<const Mechanism> mechanism_;
  std::string point_;
  std::vector<Position> positions_;
  DrawCurve draw_curve_;
  std::vector<PanelStep> steps_;
  std::optional<Place> centre_ = {};
  std::string centre_quantity_ = {}, centre_letters_ = {};
};

}  // namespace epure
