// A frame in oblique axonometry with a diagram of moments on its bars, drawn upright: lengths along x and z are true,
// those along y go off at 45° and are halved.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct SpacePoint {
  double x = 0, y = 0, z = 0;
};

// A moment of a diagram, and the quantity that a ruler reads there (empty: none).
struct DiagramOrdinate {
  double value;
  std::string quantity = {};
};

struct SpaceBar {
  SpacePoint from, to;
  std::string name;                      // "1"
  std::vector<DiagramOrdinate> moments;  // evenly spaced from one end to the other
  Words told;                            // a step
};

class SpaceDiagramPanel : public Panel {
 public:
  // Which way a positive moment is laid off.
  enum class Positive { upwards, downwards };
  // A chain of bars, clamped where the first begins and loaded downwards where the last ends. `letters`: of its
  // nodes.
  SpaceDiagramPanel(std::vector<SpaceBar> bars, std::vector<std::string> letters, std::string moment,
                    Positive positive)
      : bars_(std::move(bars)),
        letters_(std::move(letters)),
        moment_(std::move(moment)),
        positive_(positive),
        halves_depth_(is_deep()) {}

  // Lengths along y are drawn at 45°, halved; but whole where the chain is long for its depth.
  bool halves_depth() const { return halves_depth_; }

  double reach() const override;
  std::string scale_group() const override { return "frame"; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  bool is_deep() const;
  Place projected(const SpacePoint& P) const;
  Place node(std::size_t i) const;
  // At this part of the bar; and the tip of the ordinate there.
  Place on_bar(const SpaceBar& bar, double part) const;
  Place tip(const SpaceBar& bar, std::size_t ordinate, double metres_per_unit) const;
  void write_ordinate(Plot& plot, const SpaceBar& bar, std::size_t ordinate, Language language) const;
  void draw_diagram(Plot& plot, const SpaceBar& bar, Language language) const;
  void draw_frame(Plot& plot) const;

  std::vector<SpaceBar> bars_;
  std::vector<std::string> letters_;
  std::string moment_;
  Positive positive_;
  bool halves_depth_;
};

}  // namespace epure
