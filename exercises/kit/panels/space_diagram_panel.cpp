#include "exercises/kit/panels/space_diagram_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

constexpr double title_above = 26;                                                // mm
constexpr double arrow_length_of_load = 14, half_support = 7, space_letters = 8;  // mm
constexpr double axis_length = 11, axes_left = 17;  // mm, of the three axes beside the clamp

}  // namespace

bool SpaceDiagramPanel::is_deep() const {
  double long_ = 0, deep = 0;
  for (const SpaceBar& bar : bars_) {
    long_ = std::max(long_, std::abs(bar.to.x - bar.from.x));
    deep = std::max(deep, std::abs(bar.to.y - bar.from.y));
  }
  return 2 * deep >= long_;
}

Place SpaceDiagramPanel::projected(const SpacePoint& P) const {
  const double oblique = std::numbers::sqrt2 / (halves_depth_ ? 4 : 2);
  return {P.x + oblique * P.y, P.z + oblique * P.y};
}

Place SpaceDiagramPanel::node(std::size_t i) const {
  return i == 0 ? projected(bars_.front().from) : projected(bars_[i - 1].to);
}

Place SpaceDiagramPanel::on_bar(const SpaceBar& bar, double part) const {
  const Place from = projected(bar.from), to = projected(bar.to);
  return from + part * (to - from);
}

Place SpaceDiagramPanel::tip(const SpaceBar& bar, std::size_t ordinate, double metres_per_unit) const {
  const double part = static_cast<double>(ordinate) / static_cast<double>(bar.moments.size() - 1);
  const double up = (positive_ == Positive::upwards ? 1 : -1) * bar.moments[ordinate].value;
  return on_bar(bar, part) + Arrow2{0, metres_per_unit * up};
}

double SpaceDiagramPanel::reach() const {
  double reach = 0;
  for (std::size_t i = 0; i <= bars_.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) reach = std::max(reach, distance(node(i), node(k)));
  return reach;
}

Panel::Vectors SpaceDiagramPanel::vectors() const {
  constexpr double longest_on_paper = 32;  // mm
  double longest = 0;
  for (const SpaceBar& bar : bars_)
    for (const DiagramOrdinate& each : bar.moments) longest = std::max(longest, std::abs(each.value));
  return {"N m", longest, longest_on_paper};
}

drawings::Box SpaceDiagramPanel::extent(const Scale& lengths, const Scale& vectors) const {
  const double units = vectors.mm_per_unit / lengths.mm_per_unit;
  Extent extent;
  for (std::size_t i = 0; i <= bars_.size(); ++i) extent.include(lengths, node(i), space_letters);
  for (const SpaceBar& bar : bars_)
    for (std::size_t k = 0; k < bar.moments.size(); ++k) extent.include(lengths, tip(bar, k, units), space_letters);
  const Place O = node(0), A = node(bars_.size());
  extent.include(lengths.mm_per_unit * O.x - axes_left - 4, lengths.mm_per_unit * O.y - 6);
  extent.include(lengths.mm_per_unit * O.x - axes_left, lengths.mm_per_unit * O.y + title_above + 5);
  extent.include(lengths.mm_per_unit * A.x, lengths.mm_per_unit * A.y - arrow_length_of_load - 4);
  return extent.box();
}

// A number at the tip, clear of the diagram; but within it where the bar before has its own diagram there.
void SpaceDiagramPanel::write_ordinate(Plot& plot, const SpaceBar& bar, std::size_t ordinate,
                                       Language language) const {
  const double mm = 1 / plot.scale().mm_per_unit, units = plot.vector_scale().mm_per_unit * mm,
               value = bar.moments[ordinate].value;
  const bool is_first = ordinate == 0 && &bar != &bars_.front();
  const double before = is_first ? (&bar - 1)->moments.back().value : 0;
  const Place end = tip(bar, ordinate, units),
              foot = on_bar(bar, static_cast<double>(ordinate) / static_cast<double>(bar.moments.size() - 1));
  const bool is_within = value > 0 ? before >= value : before <= value && is_first;
  plot.small_label(figures(value, 4, language), end,
                   is_within ? end + Arrow2{-2 * mm, end.y > foot.y ? mm : -mm} : foot, Meaning::force);
}

void SpaceDiagramPanel::draw_diagram(Plot& plot, const SpaceBar& bar, Language language) const {
  const double units = plot.vector_scale().mm_per_unit / plot.scale().mm_per_unit;
  const std::size_t last = bar.moments.size() - 1;
  if (std::all_of(bar.moments.begin(), bar.moments.end(), [](const auto& each) { return each.value == 0; })) {
    plot.small_label(moment_ + " = 0", on_bar(bar, 0.5), on_bar(bar, 0.5) + Arrow2{0, -1}, Meaning::force);
    return;
  }
  plot.area({on_bar(bar, 0), on_bar(bar, 1), tip(bar, last, units), tip(bar, 0, units)}, Meaning::force);
  plot.polygon({on_bar(bar, 0), on_bar(bar, 1), tip(bar, last, units), tip(bar, 0, units)}, Meaning::force);
  for (std::size_t k = 0; k <= last; ++k) {
    const DiagramOrdinate& each = bar.moments[k];
    const Place foot = on_bar(bar, static_cast<double>(k) / static_cast<double>(last)), end = tip(bar, k, units);
    plot.segment(foot, end, Meaning::force);
    if (each.value != 0 && !(k > 0 && each.value == bar.moments[k - 1].value)) write_ordinate(plot, bar, k, language);
    if (each.quantity.empty()) continue;
    const bool upwards = positive_ == Positive::upwards;
    plot.onto().measurements.push_back({each.quantity, plot.at(upwards ? foot : end), plot.at(upwards ? end : foot),
                                        1 / plot.vector_scale().mm_per_unit, Measurement::along_y});
  }
}

void SpaceDiagramPanel::draw_frame(Plot& plot) const {
  const double mm = 1 / plot.scale().mm_per_unit;
  for (const SpaceBar& bar : bars_) {
    plot.segment(projected(bar.from), projected(bar.to), Meaning::link);
    plot.small_label(bar.name, on_bar(bar, 0.4), on_bar(bar, 0.4) + Arrow2{-mm, mm});
  }
  const Place O = node(0), A = node(bars_.size());
  plot.mark(drawings::Ground{plot.at(O + Arrow2{0, half_support * mm}), plot.at(O + Arrow2{0, -half_support * mm})});
  plot.side("", A, A + Arrow2{0, -arrow_length_of_load * mm}, Meaning::force, "$\\it{P}$");
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    const Place inside = geometry::midpoint(node(0), node(letters_.size() / 2));
    if (i > 0) plot.dot(node(i), Meaning::link);
    plot.label("$" + letters_[i] + "$", node(i), inside);
  }
  const Place axes = O + Arrow2{-axes_left * mm, 0};
  const double oblique = std::numbers::sqrt2 / 4;
  for (const auto& [letter, along] :
       {std::pair{"$x$", Arrow2{0.6, 0}}, {"$y$", Arrow2{oblique, oblique}}, {"$z$", Arrow2{0, 1}}})
    plot.side("", axes, axes + axis_length * mm * along, Meaning::axis, letter);
}

void SpaceDiagramPanel::draw_given(Plot& plot, const drawings::Box&, Language) const { draw_frame(plot); }

std::vector<drawings::Block> SpaceDiagramPanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  for (const SpaceBar& bar : bars_) draw_diagram(plot, bar, language);
  draw_frame(plot);
  const double mm = 1 / plot.scale().mm_per_unit;
  plot.label(moment_ + " (N m)", node(0) + Arrow2{-axes_left * mm, title_above * mm}, {}, Meaning::force);
  return {};
}

std::vector<PanelStep> SpaceDiagramPanel::steps(const Plot& plot, const drawings::Box&) const {
  const double units = plot.vector_scale().mm_per_unit / plot.scale().mm_per_unit;
  std::vector<PanelStep> all;
  for (const SpaceBar& bar : bars_) {
    const std::size_t middle = bar.moments.size() / 2;
    all.push_back({bar.told, on_bar(bar, 0.6) + 0.5 * (tip(bar, middle, units) - on_bar(bar, 0.5))});
  }
  return all;
}

}  // namespace epure
