#include "exercises/cli/sweep_chart.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "drawings/charts/value_span.h"
#include "drawings/text/text.h"
#include "exercises/cli/sweep_words.h"
#include "exercises/kit/panels/results.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

constexpr std::uint64_t most_curves = 12, most_drawn_points = 1000;
constexpr std::size_t most_charts = 4;

std::string chart_ending(const std::string& file) {
  const std::string ending = lower_case(std::filesystem::path(file).extension().string());
  if (ending == ".pdf" || ending == ".svg") return ending;
  throw WrongUsage(format_words("--chart {}: the file's name must end in .pdf or .svg",
                                "--chart {}: il nome del file deve finire in .pdf o .svg", file));
}

std::vector<std::string> units_of(const std::vector<Quantity>& quantities) {
  std::vector<std::string> units;
  for (const Quantity& each : quantities)
    if (std::find(units.begin(), units.end(), each.unit) == units.end()) units.push_back(each.unit);
  return units;
}

// Whether another given as the axis would leave few enough curves.
Words better_order(const SweepStudy& study) {
  for (const Variation& axis : study.over)
    if (!axis.is_of_words() && study.size() / axis.size() * study.quantities.size() <= most_curves)
      return format_words("; the axis is the first --over: name {} first, as it has {} values",
                          "; l'asse è il primo --over: nominare prima {}, che ha {} valori", axis.given().symbol,
                          axis.size());
  return {};
}

// From beyond one end of the axis to beyond the other, as from +∞ to -∞, nothing is known of the way.
drawings::Curve parted_beyond(const drawings::ValueSpan& axis, const drawings::Curve& curve) {
  const auto side = [&](const drawings::Datum& each) { return each.y > axis.high ? 1 : each.y < axis.low ? -1 : 0; };
  drawings::Curve parted = curve;
  parted.runs.clear();
  for (const auto& run : curve.runs) {
    parted.runs.emplace_back();
    for (const drawings::Datum& each : run) {
      auto& last = parted.runs.back();
      if (!last.empty() && side(last.back()) * side(each) < 0)
        parted.runs.push_back({each});
      else
        last.push_back(each);
    }
  }
  return parted;
}

}  // namespace

void demand_chart_file(const std::string& file) { chart_ending(file); }

SweepChart::SweepChart(const SweepStudy& study, std::string option, Language language)
    : study_(study), option_(std::move(option)), language_(language) {
  const Variation& first = study.over.front();
  if (first.is_of_words())
    throw WrongUsage(format_words("{}: {} has words for values and makes no axis; name another --over first",
                                  "{}: {} ha parole per valori e non fa da asse; nominare prima un altro --over",
                                  option_, first.given().symbol));
  const auto [low, high] = std::minmax({first.number(0), first.number(first.size() - 1)});
  if (high - low <= drawings::narrowest_span(low, high))
    throw WrongUsage(format_words("{}: from {} to {} is too narrow an axis for its numbers",
                                  "{}: da {} a {} l'asse è troppo corto per i suoi numeri", option_, first.text(0),
                                  first.text(first.size() - 1)));
  others_ = study.size() / first.size();
  stride_ = (first.size() + most_drawn_points - 1) / most_drawn_points;
  if (others_ * study.quantities.size() > most_curves)
    throw WrongUsage(format_words("{} would draw {} curves over {}, and a sheet bears {}",
                                  "{} disegnerebbe {} curve su {}, e un foglio ne porta {}", option_,
                                  others_ * study.quantities.size(), first.given().symbol, most_curves) +
                     better_order(study));
  if (const std::size_t units = units_of(study.quantities).size(); units > most_charts)
    throw WrongUsage(format_words("{} would draw {} charts, as the quantities have so many units; a sheet bears {}",
                                  "{} disegnerebbe {} grafici, tante sono le unità delle grandezze; un foglio ne "
                                  "porta {}",
                                  option_, units, most_charts));
  for (const Quantity& quantity : study.quantities)
    for (std::uint64_t row = 0; row < others_; ++row) {
      const std::vector<std::uint64_t> places = study.places(row);
      drawings::Curve curve{.name = quantity.name, .label = quantity.symbol};
      for (std::size_t i = 1; i < places.size(); ++i)
        curve.label += ", " + letters_of_given(study.over[i].given()) + " = " +
                       value_with_unit(study.over[i], places[i], language);
      if (row > 0) curve.name += fmt::format("-{}", row + 1);
      curves_.push_back({std::move(curve)});
    }
}

void SweepChart::add(const SweptRow& row) {
  const std::uint64_t place = row.places.front();
  const bool is_drawn = place % stride_ == 0 || place + 1 == study_.over.front().size();
  for (std::size_t i = 0; i < row.quantities.size(); ++i) {
    auto& [curve, is_broken] = curves_[i * others_ + row.number % others_];
    const SweptQuantity& quantity = row.quantities[i];
    if (quantity.state != SweptQuantity::State::value) is_broken = true;
    if (quantity.state != SweptQuantity::State::value || !is_drawn) continue;
    const double value = quantity.enclosure.value;
    if (is_broken || goes_over_end_of_turn(curve.runs.back().back().y, value, study_.quantities[i]))
      curve.runs.emplace_back();
    is_broken = false;
    curve.runs.back().push_back({study_.over.front().number(place), value});
  }
}

drawings::Axis SweepChart::value_axis(const std::string& unit) const {
  drawings::Axis axis{.unit = written_unit(unit, language_)};
  std::vector<double> values;
  for (std::size_t i = 0; i < study_.quantities.size(); ++i) {
    if (study_.quantities[i].unit != unit) continue;
    axis.quantity += (axis.quantity.empty() ? "" : ", ") + study_.quantities[i].symbol;
    for (std::size_t k = 0; k < others_; ++k)
      for (const auto& run : curves_[i * others_ + k].curve.runs)
        for (const drawings::Datum& each : run) values.push_back(each.y);
  }
  const drawings::ValueSpan span = drawings::span_of(std::move(values));
  axis.low = span.low;
  axis.high = span.high;
  return axis;
}

drawings::Chart SweepChart::chart(const std::string& unit) const {
  const Variation& first = study_.over.front();
  const auto [low, high] = std::minmax({first.number(0), first.number(first.size() - 1)});
  drawings::Chart chart;
  chart.x = {.quantity = letters_of_given(first.given()),
             .unit = written_unit(first.unit(), language_),
             .low = low,
             .high = high,
             .to_ticks = false};
  if (first.unit() == "deg") chart.x.steps = drawings::degree_steps;
  chart.y = value_axis(unit);
  if (chart.y.low < 0 && chart.y.high > 0) chart.horizontals = {{.at = 0}};
  for (std::size_t i = 0; i < curves_.size(); ++i)
    if (study_.quantities[i / others_].unit == unit)
      chart.curves.push_back(parted_beyond({chart.y.low, chart.y.high}, curves_[i].curve));
  constexpr double letters_left = 18;  // mm
  chart.letters_left = letters_left;
  return chart;
}

drawings::Sheet SweepChart::sheet() const {
  Description about = study_.exercise->about();
  about.sheets = {{"sweep", {"Sweep", "Variazione"}}};
  std::set<std::string> swept;
  for (const Variation& each : study_.over) {
    swept.insert(each.given().symbol);
    if (each.given().turned) swept.insert(each.given().turned->instant);
  }
  drawings::Sheet sheet = blank_sheet(about, "sweep", study_.givens, {.language = language_}, swept).sheet;
  sheet.description = sheet.title;
  sheet.column.push_back(drawings::Heading{Words{"Swept", "Fatti variare"}.in(language_)});
  for (const Variation& each : study_.over)
    sheet.column.push_back(drawings::Paragraph{
        letters_of_given(each.given()) + format_words(" from {} to {}, {} values", " da {} a {}, {} valori",
                                                      value_with_unit(each, 0, language_),
                                                      value_with_unit(each, each.size() - 1, language_), each.size())
                                             .in(language_)});
  sheet.column.push_back(drawings::Heading{Words{"Found", "Trovate"}.in(language_)});
  for (const Quantity& each : study_.quantities)
    sheet.column.push_back(drawings::Paragraph{each.symbol + ": " + each.meaning.in(language_)});
  sheet.title_block.scales = {"–"};

  constexpr double air = 4;  // mm
  const drawings::Box area = drawings::drawing_area(sheet.paper);
  draw_charts({{area.low.x + air, area.low.y}, {area.high.x - air, area.high.y}}, sheet.figure);
  return sheet;
}

std::vector<drawings::ChartMap> SweepChart::draw_charts(const drawings::Box& area, drawings::Figure& figure) const {
  constexpr double air = 4;  // mm
  const std::vector<std::string> units = units_of(study_.quantities);
  const double height = (area.height() - air) / static_cast<double>(units.size());
  std::vector<drawings::ChartMap> maps;
  double top = area.high.y;
  for (const std::string& unit : units) {
    maps.push_back(
        drawings::draw(chart(unit), {{area.low.x, top - height}, {area.high.x, top - air}}, figure, language_));
    top -= height;
  }
  return maps;
}

SweepChart::Charts SweepChart::charts() const {
  const std::vector<std::string> units = units_of(study_.quantities);
  constexpr double width = 165, height_of_each = 75, height_of_all = 175;  // mm: on A4 beside their margins
  const drawings::Point corner = drawings::drawing_area(drawings::Paper::a4).low;
  const double height = std::min(height_of_each * static_cast<double>(units.size()), height_of_all);
  drawings::Sheet sheet;
  sheet.id = study_.exercise->about().id + "-charts";
  sheet.language = language_;
  sheet.bare = true;
  for (const Quantity& each : study_.quantities)
    sheet.title += (sheet.title.empty() ? "" : ", ") + drawings::plain(each.symbol);
  Charts charts;
  charts.maps = draw_charts({corner, {corner.x + width, corner.y + height}}, sheet.figure);
  charts.page = drawings::compose(sheet);
  for (const Quantity& each : study_.quantities)
    charts.chart_of.push_back(
        static_cast<std::size_t>(std::find(units.begin(), units.end(), each.unit) - units.begin()));
  return charts;
}

drawings::File SweepChart::drawn(const std::string& file) const {
  const drawings::Sheet drawing = sheet();
  if (chart_ending(file) == ".svg") return {file, drawings::svg(drawing)};
  return {file, drawings::pdf({drawing}, drawing.title)};
}

}  // namespace epure
