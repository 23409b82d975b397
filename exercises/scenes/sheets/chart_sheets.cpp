#include "exercises/scenes/sheets/chart_sheets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "drawings/charts/value_span.h"
#include "drawings/text/text.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/proof/agreement.h"
#include "exercises/kit/proof/asked.h"
#include "exercises/kit/proof/measured.h"
#include "exercises/scenes/drive_way.h"
#include "exercises/scenes/extremes.h"
#include "exercises/scenes/found_by_search.h"
#include "exercises/scenes/kept_by_givens.h"
#include "exercises/scenes/range_of_drive.h"
#include "exercises/scenes/scene_routes.h"
#include "exercises/scenes/sheets/scene_figure.h"
#include "geometry/linkages/every_place.h"

namespace epure::scenes {
namespace {

using geometry::Enclosure;
using geometry::SlidPoint;
using geometry::Stretched;
using geometry::TurnedLink;

constexpr int places_in_a_turn = 360, places_along_a_way = 240, most_places = 1440;

// The scene's mechanism wherever its drive can bring it: quantities there, by the first route that knows them.
class OverDrive {
 public:
  OverDrive(Built built, std::vector<std::string> names)
      : built_(std::move(built)), plan_(route_plan(built_)), names_(std::move(names)) {
    const geometry::Arithmetic<geometry::Fast> scope;
    if (const auto* turned = std::get_if<TurnedLink>(&drive())) {
      turns_ = geometry::EveryPlace(built_.linkage, built_.steps).turns();
      const geometry::Angle angle =
          geometry::within_one_turn({turned->angle.turns / turns_, turned->angle.radians / turns_});
      high_ = turns_;
      now_ = geometry::degrees(angle) / 360 * turns_;
      return;
    }
    const DriveWay way(built_);
    low_ = way.low();
    high_ = way.high();
    now_ = way.now();
  }

  // Of a turned link in turns, else in metres.
  double low() const { return low_; }
  double high() const { return high_; }
  double now() const { return now_; }
  bool turns() const { return std::holds_alternative<TurnedLink>(drive()); }
  int count() const { return turns() ? std::min(turns_ * places_in_a_turn, most_places) : places_along_a_way; }
  geometry::Rational place(int i) const {
    const geometry::Rational low(low_), high(high_);
    return low + (high - low) * geometry::Rational(i, count());
  }

  // Each quantity's, where it has a value.
  std::map<std::string, Enclosure> values_at(const geometry::Rational& place) const {
    if (std::holds_alternative<Stretched>(drive()) && place <= 0)
      return {};  // a cylinder without length points nowhere
    auto there = std::make_shared<Built>(built_);
    put(there->linkage.drives.front(), place);
    const Asked asked(names_);
    const FirstRouteOnly first(true);
    std::map<std::string, std::vector<RouteValue>> routes;
    try {
      for (RouteValue& value : by_both_routes(there, plan_, Rung::bounded)) routes[value.quantity].push_back(value);
    } catch (const geometry::Impossible&) {
    } catch (const geometry::Undecided&) {
      // At a limit of the motion, or beyond.
    }
    std::map<std::string, Enclosure> values;
    for (const std::string& name : names_) {
      if (routes[name].empty()) continue;
      const geometry::Settled& known = best_known(routes[name]);
      if (known.kind == geometry::Settled::Kind::certain || known.kind == geometry::Settled::Kind::enclosed)
        values[name] = known.enclosure;
    }
    return values;
  }

 private:
  const geometry::Drive& drive() const { return built_.linkage.drives.front(); }
  Built built_;
  std::shared_ptr<const RoutePlan> plan_;
  std::vector<std::string> names_;
  int turns_ = 1;
  double low_ = 0, high_ = 1, now_ = 0;
};

struct Sample {
  geometry::Rational at;
  std::map<std::string, Enclosure> values;
};

using Samples = std::vector<Sample>;
using KeptSamples = KeptByGivens<Samples>;

// At equal steps, and closer where a quantity begins or ends to have a value.
Samples samples_of(const OverDrive& over) {
  Samples samples;
  for (int i = 0; i <= over.count(); ++i) {
    const geometry::Rational at = over.place(i);
    Sample next{at, over.values_at(at)};
    if (!samples.empty() && samples.back().values.size() != next.values.size()) {
      constexpr int halvings = 10;
      Sample low = samples.back(), high = next;
      for (int k = 0; k < halvings; ++k) {
        const geometry::Rational middle = (low.at + high.at) / 2;
        Sample between{middle, over.values_at(middle)};
        (between.values.size() == low.values.size() ? low : high) = std::move(between);
      }
      samples.push_back(std::move(low));
      samples.push_back(std::move(high));
    }
    samples.push_back(std::move(next));
  }
  return samples;
}

class ChartOfScene {
 public:
  // `kept`: of all charts of the scene, which look at the same places.
  ChartOfScene(const Scene& scene, const Built& built, const Solution& s, const std::vector<std::string>& names,
               KeptSamples& kept)
      : s_(s),
        names_(names),
        asked_(scene.extremes()),
        drive_(driven_coordinates(built).front()),
        over_(built, all_of(scene.charts())),
        samples_(kept.of(s.givens(), [this] { return samples_of(over_); })) {
    std::vector<double> values;
    for (const Sample& sample : *samples_)
      for (const std::string& name : names_)
        if (const auto found = sample.values.find(name); found != sample.values.end())
          values.push_back(found->second.value);
    span_ = drawings::span_of(std::move(values));
  }

  bool is_broken() const {
    return anywhere([](const Enclosure* value) { return !value; });
  }

  // Where a curve runs on beyond all that the others need.
  bool is_cut() const {
    return anywhere(
        [&](const Enclosure* value) { return value && (value->value < span_.low || value->value > span_.high); });
  }

  drawings::Chart chart(const Built& built, Language language) const {
    const double unit = over_.turns() ? 360 : 1;
    drawings::Chart chart;
    chart.x = {.quantity = drive_in_words(built).in(language),
               .unit = over_.turns() ? "°" : "m",
               .low = unit * over_.low(),
               .high = unit * over_.high(),
               .to_ticks = false};
    if (over_.turns()) chart.x.steps = drawings::degree_steps;
    const std::string& unit_of_all = s_.described(names_.front()).unit;
    chart.y = {.unit = written_unit(unit_of_all, language), .low = span_.low, .high = span_.high};
    for (const std::string& name : names_) {
      const std::string& symbol = s_.described(name).symbol;
      chart.y.quantity += (chart.y.quantity.empty() ? "" : ", ") + symbol;
      drawings::Curve curve{.name = name, .label = names_.size() > 1 ? symbol : ""};
      if (const auto now = s_.value(name)) curve.points = {{unit * over_.now(), *now}};
      for (const Extreme& extreme : extremes_of(name))
        chart.markers.push_back({.at = {extreme.place, extreme.value},
                                 .label = symbol_of_extreme(symbol, extreme.is_greatest),
                                 .meaning = Meaning::locus});
      bool is_open = false;
      for (const Sample& sample : *samples_) {
        const auto found = sample.values.find(name);
        const bool is_drawn = found != sample.values.end() && is_fine(found->second);
        if (is_drawn &&
            (!is_open || goes_over_end_of_turn(curve.runs.back().back().y, found->second.value, s_.described(name))))
          curve.runs.emplace_back();
        if (is_drawn) curve.runs.back().push_back({unit * CGAL::to_double(sample.at), found->second.value});
        is_open = is_drawn;
      }
      chart.curves.push_back(std::move(curve));
    }
    if (chart.y.low < 0 && chart.y.high > 0) chart.horizontals = {{.at = 0}};
    chart.verticals = {{.at = unit * over_.now()}};
    for (const bool is_greatest : {true, false})
      if (const auto end = value_of(extreme_name(drive_.name, is_greatest)))
        chart.verticals.push_back({.at = over_.turns() ? within_turns(*end) : *end,
                                   .label = symbol_of_extreme(drive_.symbol, is_greatest)});
    return chart;
  }

  std::vector<ChartPanel::Read> read() const {
    std::vector<ChartPanel::Read> all;
    for (const std::string& name : names_)
      if (const auto now = s_.value(name)) all.push_back({{(over_.turns() ? 360 : 1) * over_.now(), *now}, {}, name});
    for (const std::string& name : names_)
      for (const Extreme& extreme : extremes_of(name))
        all.push_back({{extreme.place, extreme.value},
                       place_of_extreme(name, extreme.is_greatest),
                       extreme_name(name, extreme.is_greatest)});
    return all;
  }

  // The greatest and the least, and where: what is asked for and known of them.
  struct Extreme {
    bool is_greatest;
    double value, place;  // degrees of the drive
  };
  std::vector<Extreme> extremes_of(const std::string& name) const {
    std::vector<Extreme> all;
    if (std::find(asked_.begin(), asked_.end(), name) == asked_.end()) return all;
    for (const bool is_greatest : {true, false}) {
      const auto value = s_.value(extreme_name(name, is_greatest)),
                 place = s_.value(place_of_extreme(name, is_greatest));
      if (value && place) all.push_back({is_greatest, *value, *place});
    }
    return all;
  }

 private:
  // Of the values of all curves at all places; null where there is none.
  template <class Is>
  bool anywhere(const Is& is) const {
    return std::any_of(samples_->begin(), samples_->end(), [&](const Sample& sample) {
      return std::any_of(names_.begin(), names_.end(), [&](const std::string& name) {
        const auto found = sample.values.find(name);
        return is(found == sample.values.end() ? nullptr : &found->second);
      });
    });
  }
  static std::vector<std::string> all_of(const std::vector<std::vector<std::string>>& charts) {
    std::vector<std::string> all;
    for (const auto& names : charts)
      for (const std::string& name : names)
        if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
    return all;
  }
  // None where it is not asked for.
  std::optional<double> value_of(const std::string& name) const {
    return s_.has(name) ? s_.value(name) : std::nullopt;
  }
  double within_turns(double degrees) const {
    const double all = 360 * over_.high();
    return degrees - all * std::floor(degrees / all);
  }

  // Known to less than a pen's width.
  bool is_fine(const Enclosure& known) const {
    constexpr double pens = 500;
    return known.upper - known.lower <= (span_.high - span_.low) / pens;
  }

  static Words drive_in_words(const Built& built) {
    const geometry::Drive& drive = built.linkage.drives.front();
    if (const auto* turned = std::get_if<TurnedLink>(&drive))
      return format_words("direction of link {}", "direzione del membro {}",
                          built.letters.links[index(turned->link)]);
    const auto written = [&](int p) { return "$" + point_letters(built.letters.points[index(p)]) + "$"; };
    if (const auto* slid = std::get_if<SlidPoint>(&drive))
      return format_words("way of {}", "corsa di {}", written(slid->point));
    const auto& cylinder = std::get<Stretched>(drive);
    return format_words("length {}{}", "lunghezza {}{}", written(cylinder.from), written(cylinder.to));
  }

  const Solution& s_;
  const std::vector<std::string>&names_, &asked_;
  Quantity drive_;
  OverDrive over_;
  std::shared_ptr<const Samples> samples_;
  drawings::ValueSpan span_{};
};

// In outline where the quantity of the chart is greatest, and where it is least.
void add_position(Mechanism& mechanism, const Built& built, const std::string& name, double degrees) {
  const geometry::Arithmetic<geometry::Fast> scope;
  const geometry::EveryPlace places(built.linkage, built.steps);
  const double angle = degrees / 180 * std::numbers::pi / places.turns();
  const geometry::LinkagePosition<geometry::Fast> at =
      geometry::CarriedOut<geometry::Fast>(built.linkage, built.steps)
          .position(geometry::DriveAt<geometry::Fast>{0, {std::cos(angle), std::sin(angle)}, 0, places.turns()});
  add_in_outline(mechanism, built, name, at.points);
}

PanelSheet chart_sheet(const Scene& scene, const Solution& s, std::size_t which, Language language,
                       KeptSamples& kept) {
  const Built built = scene.built(s.givens());
  const std::vector<std::string>& names = scene.charts().at(which);
  const ChartOfScene chart(scene, built, s, names, kept);
  PanelSheet sheet;
  Mechanism mechanism = figure_of(built, s);
  sheet.results = {remark(Words{"On the thin line a dot: the position drawn.",
                                "Sulla linea sottile un punto: la posizione disegnata."}
                              .in(language)),
                   values(names)};
  bool has_extremes = false, has_outlines = false;
  for (const std::string& name : names)
    for (const ChartOfScene::Extreme& extreme : chart.extremes_of(name)) {
      const std::string found = extreme_name(name, extreme.is_greatest);
      sheet.results.push_back(values({found, place_of_extreme(name, extreme.is_greatest)}));
      has_extremes = true;
      if (is_rate(built, name)) continue;
      has_outlines = true;
      add_position(mechanism, built, found, extreme.place);
    }
  if (has_extremes)
    sheet.results.push_back(remark(Words{"The other dots: the greatest and the least in a turn.",
                                         "Gli altri punti: il massimo e il minimo in un giro."}
                                       .in(language)));
  if (has_outlines)
    sheet.results.push_back(
        remark(Words{"In outline: the mechanism there.", "Tratteggiato: il meccanismo in quei punti."}.in(language)));
  sheet.panels = panels(MechanismPanel(std::make_shared<const Mechanism>(std::move(mechanism))),
                        ChartPanel(chart.chart(built, language), chart.read()));
  if (chart.is_cut())
    sheet.results.push_back(remark(Words{"Where a curve leaves the chart, it goes on beyond its axis.",
                                         "Dove una curva esce dal grafico, prosegue oltre il suo asse."}
                                       .in(language)));
  if (chart.is_broken())
    sheet.results.push_back(
        remark(Words{"Where there is no curve the mechanism does not close, or there is no value.",
                     "Dove non c'è curva il meccanismo non si chiude, o non c'è valore."}
                   .in(language)));
  std::string letters;
  for (const std::string& name : names)
    letters += (letters.empty() ? "" : ", ") + drawings::plain(s.described(name).symbol);
  sheet.seen = format_words("The mechanism, and {} over all places of its drive",
                            "Il meccanismo, e {} in tutte le posizioni del movente", letters);
  sheet.told = names;
  return sheet;
}

}  // namespace

std::vector<SheetMaker> chart_sheets(const std::shared_ptr<const Scene>& scene, const std::vector<Quantity>& known) {
  scene->demand_charts(known);
  std::vector<SheetMaker> sheets;
  const auto kept = std::make_shared<KeptSamples>();
  for (std::size_t i = 0; i < scene->charts().size(); ++i) {
    std::string name = "chart", letters;
    for (const std::string& asked : scene->charts()[i]) {
      const auto found =
          std::find_if(known.begin(), known.end(), [&](const Quantity& each) { return each.name == asked; });
      name += "-" + asked;
      letters += (letters.empty() ? "" : ", ") + found->symbol;
    }
    sheets.push_back({{name, format_words("Chart of {}", "Grafico di {}", letters)},
                      [scene, i, kept](const Solution& s, Language language) {
                        return chart_sheet(*scene, s, i, language, *kept);
                      }});
  }
  return sheets;
}

}  // namespace epure::scenes
