#include "exercises/kit/panels/chart_panel.h"

namespace epure {
namespace {

bool is_on_chart(const drawings::ChartMap& map, const drawings::Datum& at) {
  return at.x >= map.x.low && at.x <= map.x.high && at.y >= map.y.low && at.y <= map.y.high;
}

// The special points beyond the axis, where the curve leaves the chart and comes back.
std::string off_chart(const drawings::Chart& chart, const drawings::ChartMap& map, Language language) {
  std::string text;
  for (const drawings::Marker& marker : chart.markers)
    if (!is_on_chart(map, marker.at)) text += (text.empty() ? "" : ", ") + marker.label;
  return text.empty() ? "" : Words{"Off the chart: ", "Fuori del grafico: "}.in(language) + text + ".";
}

}  // namespace

void ChartPanel::draw_given(Plot& plot, const drawings::Box& room, Language language) const {
  drawings::draw_axes(chart_, room, plot.onto().sheet.figure, language);
}

std::vector<drawings::Block> ChartPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  DrawnSheet& onto = plot.onto();
  const drawings::ChartMap map = drawings::draw(chart_, room, onto.sheet.figure, language);
  const auto measure = [&](const std::string& name, const drawings::Datum& from, const drawings::Datum& to,
                           double per_mm, Measurement::Kind kind) {
    if (!name.empty()) onto.measurements.push_back({name, map.at(from), map.at(to), per_mm, kind});
  };
  for (const Read& each : read_) {
    if (!is_on_chart(map, each.at)) continue;
    measure(each.along_x, {0, each.at.y}, each.at, each.si_x * map.x.per_mm(), Measurement::along_x);
    measure(each.along_y, {each.at.x, 0}, each.at, each.si_y * map.y.per_mm(), Measurement::along_y);
  }
  mark_over(plot, map);
  std::vector<drawings::Block> told;
  for (const std::string& text : {off_chart(chart_, map, language), told_of(map, language)})
    if (!text.empty()) told.push_back(drawings::Paragraph{text});
  return told;
}

}  // namespace epure
