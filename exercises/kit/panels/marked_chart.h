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
      : SizedChart(std::move(chart), std::move(read), size), marks_(std::move(marks)) {}

 protected:
  void mark_over(Plot& plot, const drawings::ChartMap& map) const override { marks_(plot, map); }

 private:
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
