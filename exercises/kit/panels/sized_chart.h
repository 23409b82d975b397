// A chart that shares its sheet with others: as wide and high, at least, as it says.
#pragma once

#include "exercises/kit/panels/chart_panel.h"

namespace epure {

struct ChartSize {
  double wide, high;  // mm
};
inline constexpr ChartSize one_of_three_in_a_column{110, 46}, one_of_three_in_a_row{55, 100};

class SizedChart : public ChartPanel {
 public:
  SizedChart(drawings::Chart chart, std::vector<Read> read, ChartSize size)
      : ChartPanel(std::move(chart), std::move(read)), size_(size) {}
  drawings::Box extent(const Scale&, const Scale&) const override { return {{0, 0}, {size_.wide, size_.high}}; }

 private:
  ChartSize size_;
};

// A curve as the points at equal steps from `from` to `to`.
template <class Function>
std::vector<std::vector<drawings::Datum>> run_of(double from, double to, const Function& y) {
  constexpr int steps = 300;
  std::vector<drawings::Datum> points;
  for (int i = 0; i <= steps; ++i) {
    const double x = from + (to - from) * i / steps;
    points.push_back({x, y(x)});
  }
  return {points};
}

}  // namespace epure
