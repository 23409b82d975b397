#include "exercises/kit/panels/sum_panel.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/results.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

constexpr double bar_row = 7, between_sums = 6;      // mm
constexpr double names_width = 36, number_room = 9;  // mm, beside the bars
constexpr double letters_size = 2.9;                 // mm

// Its name, the parts and the whole.
double height(const Sum& sum) { return static_cast<double>(sum.parts.size() + 2) * bar_row; }

}  // namespace

std::pair<double, double> SumPanel::ends() const {
  double least = 0, greatest = 0;
  for (const Sum& sum : sums_) {
    double reached = 0;
    for (const Part& part : sum.parts) {
      reached += part.value;
      least = std::min(least, reached);
      greatest = std::max(greatest, reached);
    }
  }
  return {least, greatest};
}

Panel::Vectors SumPanel::vectors() const {
  const auto [least, greatest] = ends();
  return {unit_, greatest - least};
}

// The first sum begins at the plane's origin and the rows go down from there.
drawings::Box SumPanel::extent(const Scale&, const Scale& vectors) const {
  const auto [least, greatest] = ends();
  double rows = -between_sums;
  for (const Sum& sum : sums_) rows += height(sum) + between_sums;
  return {{vectors.mm_per_unit * least - number_room - names_width, -rows},
          {vectors.mm_per_unit * greatest + number_room, 0}};
}

// Where it ends a ruler reads the whole, so the parts must come to it.
void SumPanel::draw_sum(Plot& plot, const Sum& sum, double top, int first_step, Language language) const {
  const double mm = plot.scale().mm_per_unit, indent = 3;  // mm
  const double names_at = plot.at({ends().first, 0}).x - number_room - names_width;
  const auto at = [&](double value, double y) { return Place{value, y / mm}; };
  const auto write = [&](const Words& text, double from, double y) {
    const double middle = plot.at({0, y / mm}).y;
    plot.mark(drawings::Writing{text.in(language), {names_at + from, middle - letters_size / 3}, letters_size});
  };
  const auto bar = [&](const Part& part, double from, double to, double y) {
    write(part.name, indent, y);
    plot.side("", at(from, y), at(to, y), Meaning::force,
              figures(part.value, 4, language) + unit_after_number(unit_, language));
    if (!part.quantity.empty()) plot.measures_abscissa(part.quantity, at(to, y), at(from, y));
  };
  write(sum.name, 0, top - bar_row / 2);
  double y = top - 1.5 * bar_row, reached = 0;
  plot.in_step(first_step);
  plot.segment(at(0, y + bar_row / 2), at(0, top - height(sum)), Meaning::axis);
  for (const Part& part : sum.parts) {
    bar(part, reached, reached + part.value, y);
    reached += part.value;
    plot.segment(at(reached, y), at(reached, y - bar_row), Meaning::construction);
    y -= bar_row;
  }
  plot.in_step(first_step + std::max(static_cast<int>(sum.steps.size()) - 1, 0));
  bar(sum.whole, 0, reached, y);
}

std::vector<drawings::Block> SumPanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  double top = 0;
  int step = 1;
  for (const Sum& sum : sums_) {
    draw_sum(plot, sum, top, step, language);
    top -= height(sum) + between_sums;
    step += static_cast<int>(sum.steps.size());
  }
  return {};
}

// Beside the rows, from the last upwards: what leads to the sum, then the sum.
std::vector<PanelStep> SumPanel::steps(const Plot& plot, const drawings::Box&) const {
  std::vector<PanelStep> all;
  double top = 0;
  for (const Sum& sum : sums_) {
    double row = height(sum) - static_cast<double>(sum.steps.size()) * bar_row + bar_row / 2;
    for (const Words& text : sum.steps) {
      all.push_back({text, Place{0, (top - row) / plot.scale().mm_per_unit}});
      row += bar_row;
    }
    top -= height(sum) + between_sums;
  }
  return all;
}

}  // namespace epure
