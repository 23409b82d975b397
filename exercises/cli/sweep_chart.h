// A sweep as charts: the quantities over the given that was named first, a chart for each unit.
#pragma once

#include <string>
#include <vector>

#include "drawings/charts/chart.h"
#include "drawings/output.h"
#include "exercises/cli/sweep_row.h"

namespace epure {

class SweepChart {
 public:
  // Throws WrongUsage when the file is neither PDF nor SVG, the first given has words for values, or there would be
  // more curves or units than a sheet bears.
  SweepChart(const SweepStudy& study, std::string file, Language language);

  // Rows in order. What has no value leaves a gap. Of more than a thousand values of the first given some are drawn.
  void add(const SweptRow& row);

  drawings::File drawn() const;

 private:
  struct CurveOver {
    drawings::Curve curve;
    bool is_broken = true;
  };

  drawings::Sheet sheet() const;
  drawings::Chart chart(const std::string& unit) const;
  drawings::Axis value_axis(const std::string& unit) const;

  const SweepStudy& study_;
  std::string file_;
  Language language_;
  std::uint64_t others_;           // combinations of the values of all givens but the first
  std::uint64_t stride_;           // of the first's values every so many is drawn, and the last
  std::vector<CurveOver> curves_;  // others_ for each quantity
};

}  // namespace epure
