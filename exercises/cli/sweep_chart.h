// A sweep as charts: the quantities over the given that was named first, a chart for each unit.
#pragma once

#include <string>
#include <vector>

#include "drawings/charts/chart.h"
#include "drawings/output.h"
#include "drawings/page.h"
#include "exercises/cli/sweep_row.h"

namespace epure {

// Throws WrongUsage when the name ends neither in .pdf nor in .svg.
void demand_chart_file(const std::string& file);

class SweepChart {
 public:
  // `option`: what asks for it. Throws WrongUsage when the first given has words for values, or there would be more
  // curves or units than a sheet bears.
  SweepChart(const SweepStudy& study, std::string option, Language language);

  // Rows in order. What has no value leaves a gap. Of more than a thousand values of the first given some are drawn.
  void add(const SweptRow& row);

  // As a sheet, PDF or SVG. The name is one that demand_chart_file takes.
  drawings::File drawn(const std::string& file) const;

  // Bare, one below the other, and where their numbers lie on the paper.
  struct Charts {
    drawings::Page page;
    std::vector<drawings::ChartMap> maps;
    std::vector<std::size_t> chart_of;  // of each quantity
  };
  Charts charts() const;

 private:
  struct CurveOver {
    drawings::Curve curve;
    bool is_broken = true;
  };

  drawings::Sheet sheet() const;
  std::vector<drawings::ChartMap> draw_charts(const drawings::Box& area, drawings::Figure& figure) const;
  drawings::Chart chart(const std::string& unit) const;
  drawings::Axis value_axis(const std::string& unit) const;

  const SweepStudy& study_;
  std::string option_;
  Language language_;
  std::uint64_t others_;           // combinations of the values of all givens but the first
  std::uint64_t stride_;           // of the first's values every so many is drawn, and the last
  std::vector<CurveOver> curves_;  // others_ for each quantity
};

}  // namespace epure
