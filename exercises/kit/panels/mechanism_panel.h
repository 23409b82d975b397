// The mechanism alone, from which diagrams take their directions.
#pragma once

#include <functional>
#include <memory>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/panel.h"

namespace epure {

class MechanismPanel : public Panel {
 public:
  // `shown`: the points whose coordinates, from the first corner, the sheet shows: names of quantities and places.
  explicit MechanismPanel(std::shared_ptr<const MechanismFigure> mechanism,
                          std::vector<std::pair<std::string, Place>> shown = {})
      : mechanism_(std::move(mechanism)), shown_(std::move(shown)) {}

  double reach() const override { return mechanism_->reach(); }
  drawings::Box extent(const Scale& lengths, const Scale&) const override {
    Extent extent;
    mechanism_->include(extent, lengths);
    return extent.box();
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override {
    mechanism_->draw(plot);
    for (const auto& [name, P] : shown_) plot.measures_coordinates(name, P, mechanism_->corners().front());
    return {};
  }
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_->draw_given(plot); }

 private:
  std::shared_ptr<const MechanismFigure> mechanism_;
  std::vector<std::pair<std::string, Place>> shown_;
};

}  // namespace epure
