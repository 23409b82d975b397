// A double T with diagrams of stress along its depth beside it, each at a scale of its own.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct StressDiagram {
  struct Read {  // a stress that a ruler reads off, along the abscissa from the diagram's axis
    std::string quantity, label;
    Place at;
  };
  std::string name;
  // The border, from the axis and back to it: stress and height above the centroid. Where it bends, every point.
  std::vector<Place> border;
  std::vector<Read> reads = {};
};

class SectionPanel : public Panel {
 public:
  // Depth, width and walls in metres, stresses in `unit`, which is worth `si`.
  SectionPanel(double depth, double width, double wall, std::string unit, double si, Language language)
      : depth_(depth), width_(width), wall_(wall), unit_(std::move(unit)), si_(si), language_(language) {}

  SectionPanel& diagram(StressDiagram added);
  SectionPanel& step(std::size_t diagram, const Place& at, const Words& text) {
    steps_.push_back({diagram, at, text});
    return *this;
  }
  // Letters of depth, width and wall.
  SectionPanel& dimensioned(std::string depth, std::string width, std::string wall) {
    dimensions_ = {std::move(depth), std::move(width), std::move(wall)};
    return *this;
  }
  // Letters at a height of the section: "$\\it{G}$".
  SectionPanel& level(double height, const std::string& letters) {
    levels_.push_back({height, letters});
    return *this;
  }

  double reach() const override { return depth_; }
  bool is_in_millimetres() const override { return true; }
  std::vector<Scale> own_scales() const override;
  drawings::Box extent(const Scale& lengths, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override;

 private:
  struct Step {
    std::size_t diagram;
    Place at;
    Words text;
  };
  struct Placed {
    StressDiagram diagram;
    Scale scale;
    double left, right;  // mm from its axis
  };
  // From the section's axis to that of the diagram, mm.
  double axis(std::size_t diagram, const Scale& lengths) const;
  Place place(const Plot& plot, std::size_t diagram, const Place& at) const;
  void draw_section(Plot& plot) const;
  void draw_diagram(Plot& plot, std::size_t i) const;

  double depth_, width_, wall_;
  std::array<std::string, 3> dimensions_ = {};
  std::string unit_;
  double si_;
  Language language_;
  std::vector<Placed> diagrams_ = {};
  std::vector<Step> steps_ = {};
  std::vector<std::pair<double, std::string>> levels_ = {};
};

}  // namespace epure
