// Quantities of one unit laid end to end, each in a row of its own, and their sum in the last row; several such sums
// one below the other, at one scale.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct Part {
  Words name;
  double value;
  std::string quantity = {};  // that a ruler reads; empty: none that is reported
};
struct Sum {
  Words name;
  std::vector<Part> parts;
  Part whole;
  std::vector<Words> steps;  // what is told of it
};

class SumPanel : public Panel {
 public:
  SumPanel(std::vector<Sum> sums, std::string unit) : sums_(std::move(sums)), unit_(std::move(unit)) {}

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box&) const override;

 private:
  void draw_sum(Plot& plot, const Sum& sum, double top, int first_step, Language language) const;
  // From the least to the greatest sum on the way.
  std::pair<double, double> ends() const;

  std::vector<Sum> sums_;
  std::string unit_;
};

}  // namespace epure
