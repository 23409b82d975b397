// A chart with marks of its own over its curves: arrows, hatching, tangents, where its numbers lie on the paper.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "exercises/kit/panels/sized_chart.h"

namespace epure {

class MarkedChart : public SizedChart {
 public:
  using Marks = std::function<void(Plot&, const drawings::ChartMap&)>;
  MarkedChart(drawings::Chart chart, std::vector<Read> read, ChartSize size, Marks marks)
      : SizedChart(chart, std::move(read), size), axes_(std::move(chart)), marks_(std::move(marks)) {}

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    std::vector<drawings::Block> told = SizedChart::draw(plot, room, language);
    drawings::Figure frame;  // only to learn where it stands
    marks_(plot, drawings::draw_axes(axes_, room, frame, language));
    return told;
  }

 private:
  drawings::Chart axes_;
  Marks marks_;
};

// Letters beside a point of the paper.
inline void write_beside(Plot& plot, const std::string& letters, drawings::Point at, drawings::Point away_from,
                         Meaning ink) {
  plot.onto().sheet.figure.labels.push_back({letters, at, {}, ink, away_from});
}

// A force that acts at x, upwards from the axis, of no scale: as high as this, with its letters.
inline MarkedChart::Marks force_at(double x, double high, const std::string& letters, const std::string& name) {
  return [=](Plot& plot, const drawings::ChartMap& map) {
    const drawings::Point foot = map.at({x, 0}), tip = map.at({x, high});
    plot.mark(drawings::Arrow{foot, tip, Meaning::force, name});
    plot.onto().sheet.figure.labels.push_back({letters, foot, tip, Meaning::force});
  };
}

}  // namespace epure
