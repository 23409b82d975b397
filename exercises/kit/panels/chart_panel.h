// A chart as a part of a sheet: curves over axes of their own, as large as the room.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "drawings/charts/chart.h"
#include "exercises/kit/panels/panel.h"

namespace epure {

class ChartPanel : public Panel {
 public:
  // A point by which a ruler reads quantities along the axes, from their zeros; empty: none.
  struct Read {
    drawings::Datum at;
    std::string along_x, along_y;
    double si_x = 1, si_y = 1;  // one of an axis' unit, in the quantity's
  };
  explicit ChartPanel(drawings::Chart chart, std::vector<Read> read = {})
      : chart_(std::move(chart)), read_(std::move(read)) {}

  bool has_scale() const override { return false; }
  drawings::Box extent(const Scale&, const Scale&) const override {
    constexpr double wide = 110, high = 80;  // mm at least
    return {{0, 0}, {wide, high}};
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;

 protected:
  // What is to be told of how it is drawn.
  virtual std::string told_of(const drawings::ChartMap&, Language) const { return {}; }
  // Marks over the curves; the map tells where the chart's numbers lie on the paper.
  virtual void mark_over(Plot&, const drawings::ChartMap&) const {}

 private:
  drawings::Chart chart_;
  std::vector<Read> read_;
};

}  // namespace epure
