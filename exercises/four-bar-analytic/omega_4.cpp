// Sheet 5: ω₄ against the crank's angle, at the speed given and held, for both configurations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawings/charts/chart.h"
#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/four-bar-analytic/extremes.h"
#include "exercises/kit/panels/sheet.h"
#include "geometry/mechanisms/change_point.h"

namespace epure::four_bar_analytic {
namespace {

using drawings::Datum;
using geometry::Fast;
using Runs = std::vector<std::vector<Datum>>;

constexpr int samples_in_turn = 1440;  // some two in a millimetre of paper

double degrees_within_turn(const geometry::Vector<double>& direction) {
  const double angle = std::atan2(direction.y, direction.x) * 180 / geometry::pi<Fast>();
  return angle < 0 ? angle + 360 : angle;
}

// ω₄ with the crank at a part of a turn.
template <class T>
T omega_4(const FourBarInstant& at, const Rational& turn) {
  const RatioByClosure closure{at.analytic_lengths(), at.analytic_branch()};
  const geometry::Turn theta{turn};
  return at.omega_2<T>() * closure.ratio(geometry::Vector<T>{geometry::cosine<T>(theta), geometry::sine<T>(theta)});
}

// For the eye; beside a fold, where doubles lose all their digits, by balls. None where the linkage does not close,
// or stands where ω₄ is not determined.
std::optional<double> omega_4_at(const FourBarInstant& at, const Rational& turn) {
  constexpr double seen = 1e-6;  // of the value
  try {
    const geometry::Arithmetic<geometry::Bounded> scope;
    const geometry::Enclosure known = geometry::enclosure(omega_4<geometry::Bounded>(at, turn));
    if (known.upper - known.lower <= seen * std::abs(known.value)) return known.value;
  } catch (const geometry::Impossible&) {
    return {};
  } catch (const geometry::Undecided&) {
  }
  try {
    return deeply([&] { return to_double(omega_4<geometry::Deep>(at, turn)); });
  } catch (const geometry::Impossible&) {
    return {};
  } catch (const geometry::Undecided&) {
    return {};
  }
}

Datum datum(const Rational& turn, double omega_4) { return {geometry::from_rational<double>(360 * turn), omega_4}; }

// What is joined is continuous: a run ends where the linkage no longer closes, and where it folds flat (on +x or -x).
// Every extreme is a point of it, however narrow.
Runs runs_of(const FourBarInstant& at, const RockerSpeed& speed) {
  const std::vector<geometry::FlatPosition> flat = geometry::flat_positions(at.lengths);
  const auto is_flat = [&](const Rational& turn) {
    return geometry::is_whole_turns({2 * turn}) &&
           std::any_of(flat.begin(), flat.end(), [&](const geometry::FlatPosition& position) {
             return (position.A0A > 0) == geometry::is_whole_turns({turn});
           });
  };
  std::vector<Datum> extremes;
  for (const RockerSpeed::Extreme& extreme : speed.extremes)
    extremes.push_back({degrees_within_turn(extreme.crank), extreme.omega_4});
  std::sort(extremes.begin(), extremes.end(), [](const Datum& a, const Datum& b) { return a.x < b.x; });
  auto next = extremes.begin();
  Runs runs{{}};
  for (int i = 0; i <= samples_in_turn; ++i) {
    const Rational turn(i, samples_in_turn);
    const auto omega_4 = is_flat(turn) ? std::nullopt : omega_4_at(at, turn);
    for (; next != extremes.end() && next->x < datum(turn, 0).x; ++next) runs.back().push_back(*next);
    if (omega_4)
      runs.back().push_back(datum(turn, *omega_4));
    else if (!runs.back().empty())
      runs.emplace_back();
  }
  for (; next != extremes.end(); ++next) runs.back().push_back(*next);  // just short of a whole turn
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

// Points between two, until the chart cannot tell the curve from straight lines through them.
class Refined {
 public:
  Refined(const FourBarInstant& at, const drawings::Axis& axis)
      : at_(at), axis_(axis), seen_((axis.high - axis.low) / 4000) {}

  std::vector<Datum> operator()(const std::vector<Datum>& run) {
    points_.clear();
    for (std::size_t i = 0; i < run.size(); ++i) {
      points_.push_back(run[i]);
      if (i + 1 < run.size() && (bends(run, i) || bends(run, i + 1))) between(run[i], run[i + 1]);
    }
    return points_;
  }

 private:
  double on_chart(double omega_4) const { return std::clamp(omega_4, axis_.low, axis_.high); }
  double off_chord(const Datum& a, const Datum& b, const Datum& c) const {
    const double share = c.x > a.x ? (b.x - a.x) / (c.x - a.x) : 0;
    return std::abs(on_chart(b.y) - on_chart(a.y) - share * (on_chart(c.y) - on_chart(a.y)));
  }
  bool bends(const std::vector<Datum>& run, std::size_t i) const {
    return i > 0 && i + 1 < run.size() && off_chord(run[i - 1], run[i], run[i + 1]) > 4 * seen_;
  }
  void between(const Datum& a, const Datum& b) {
    constexpr double finest = 0.01;  // degrees: a fiftieth of a millimetre
    if (b.x - a.x < finest) return;
    const Rational turn = Rational(a.x + (b.x - a.x) / 2) / 360;
    const auto omega_4 = omega_4_at(at_, turn);
    if (!omega_4) return;
    const Datum middle = datum(turn, *omega_4);
    if (off_chord(a, middle, b) <= seen_) return;
    between(a, middle);
    points_.push_back(middle);
    between(middle, b);
  }

  const FourBarInstant& at_;
  const drawings::Axis& axis_;
  double seen_;
  std::vector<Datum> points_ = {};
};

Runs refined(const Runs& runs, const FourBarInstant& at, const drawings::Axis& axis) {
  Runs all;
  for (const auto& run : runs) all.push_back(Refined(at, axis)(run));
  return all;
}

// All of both curves; where they leave for infinity, or for an extreme beside which they would be a flat line, what
// most of their points need.
drawings::Axis speed_axis(const std::vector<Runs>& all, double now, bool is_bounded) {
  std::vector<double> sizes{std::abs(now)};
  double low = std::min(0.0, now), high = std::max(0.0, now);
  for (const Runs& runs : all)
    for (const auto& run : runs)
      for (const Datum& point : run) {
        sizes.push_back(std::abs(point.y));
        low = std::min(low, point.y);
        high = std::max(high, point.y);
      }
  constexpr double share_shown = 0.8;
  std::sort(sizes.begin(), sizes.end());
  const double shown =
      1.5 *
      std::max(std::abs(now), sizes[static_cast<std::size_t>(share_shown * static_cast<double>(sizes.size() - 1))]);
  constexpr double steep = 20;
  if (!is_bounded || std::max(high, -low) > steep * shown) {
    low = std::max(low, -shown);
    high = std::min(high, shown);
  }
  const double air = 0.08 * (high - low);
  return {.quantity = "$ω_{4}$", .unit = "rad/s", .low = low - air, .high = high + air};
}

struct Special {
  Datum at;
  std::string label;
  std::string quantity;  // its name in a measurement, none for the other branch
};

std::vector<Special> special_points(const RockerSpeed& of, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  std::vector<Special> points;
  for (const RockerSpeed::Extreme& extreme : of.extremes) {
    const Datum here{degrees_within_turn(extreme.crank), extreme.omega_4};
    points.push_back({here, fmt::format("{} ({}°)", num(here.y), num(here.x)), {}});
  }
  const auto by_speed = [](const Special& a, const Special& b) { return a.at.y < b.at.y; };
  if (!points.empty()) {
    std::min_element(points.begin(), points.end(), by_speed)->quantity = "omega_4_min";
    std::max_element(points.begin(), points.end(), by_speed)->quantity = "omega_4_max";
  }
  std::vector<Special> zeros;
  for (const auto& crank : of.zeros) {
    const double x = degrees_within_turn(crank);
    zeros.push_back({{x, 0}, fmt::format("{}°", num(x)), {}});
  }
  std::sort(zeros.begin(), zeros.end(), [](const Special& a, const Special& b) { return a.at.x < b.at.x; });
  for (std::size_t i = 0; i < zeros.size(); ++i) zeros[i].quantity = fmt::format("omega_4_zero_{}", i + 1);
  points.insert(points.end(), zeros.begin(), zeros.end());
  return points;
}

bool is_on_chart(const drawings::ChartMap& map, const Datum& at) { return at.y >= map.y.low && at.y <= map.y.high; }

// What a ruler reads along the axes.
void measure(DrawnSheet& onto, const drawings::ChartMap& map, const std::vector<Special>& points) {
  const auto across = [&](const std::string& name, const Datum& to) {
    onto.measurements.push_back({name, map.at({0, to.y}), map.at(to), map.x.per_mm(), Measurement::along_x});
  };
  const auto up = [&](const std::string& name, const Datum& to) {
    onto.measurements.push_back({name, map.at({to.x, 0}), map.at(to), map.y.per_mm(), Measurement::along_y});
  };
  for (const Special& point : points) {
    if (point.quantity.empty() || !is_on_chart(map, point.at)) continue;
    across("theta_2_at_" + point.quantity + "_deg", point.at);
    if (point.quantity.find("zero") == std::string::npos) up(point.quantity, point.at);
  }
}

// Of both branches, that of the sheet first.
struct Curves {
  RockerSpeed speed, other_speed;
  std::vector<Special> points, others;
};

drawings::Chart chart_of(const Drawn& f, const Curves& of, Language language) {
  const bool english = language == Language::english;
  const FourBarInstant &at = f.of.instant, other = on_other_branch(at);
  const bool is_bounded = why_no_extremes(at.lengths).empty();
  const std::vector<Runs> runs{runs_of(at, of.speed), runs_of(other, of.other_speed)};
  const bool is_left = at.side == geometry::Side::left;
  const auto side = [&](bool left) {
    return english ? (left ? "$B$ left of $AB_{0}$" : "$B$ right of $AB_{0}$")
                   : (left ? "$B$ a sinistra di $AB_{0}$" : "$B$ a destra di $AB_{0}$");
  };
  drawings::Chart chart;
  chart.x = {.quantity = "$θ_{2}$", .unit = "°", .low = 0, .high = 360, .steps = drawings::degree_steps};
  chart.y = speed_axis(runs, f.omega_4, is_bounded);
  chart.curves = {{.name = "omega_4",
                   .runs = refined(runs[0], at, chart.y),
                   .meaning = Meaning::velocity,
                   .label = side(is_left)},
                  {.name = "omega_4_other_branch",
                   .runs = refined(runs[1], other, chart.y),
                   .meaning = Meaning::velocity,
                   .line = drawings::LineType::dashed,
                   .label = side(!is_left)}};
  for (const Special& point : of.points)
    chart.markers.push_back(
        {.at = point.at, .label = point.label, .shape = drawings::PointShape::dot, .meaning = Meaning::velocity});
  for (const Special& point : of.others)
    chart.markers.push_back(
        {.at = point.at, .label = point.label, .shape = drawings::PointShape::ring, .meaning = Meaning::velocity});
  chart.horizontals = {{.at = 0}};
  return chart;
}

std::vector<std::string> explained(const FourBarInstant& at, const RockerSpeed& speed, Language language) {
  const bool english = language == Language::english;
  std::vector<std::string> lines{
      english
          ? "$ω_{4}$ = $ω_{2}$·$P_{12}P_{24}$ / $P_{14}P_{24}$, with $P_{24}$ where $AB$ and the frame meet. $ω_{2}$ "
            "held constant."
          : "$ω_{4}$ = $ω_{2}$·$P_{12}P_{24}$ / $P_{14}P_{24}$, con $P_{24}$ all'incontro di $AB$ col telaio. "
            "$ω_{2}$ "
            "costante.",
      english ? "Zero at the dead centres: crank and coupler in line."
              : "Zero ai punti morti: manovella e biella allineate."};
  if (speed.why_no_extremes.empty()) {
    lines.emplace_back(
        english ? "Extreme where the collineation axis $P_{13}P_{24}$ is square to $AB$ (Freudenstein): $α_{4}$ "
                  "= 0."
                : "Estrema dove l'asse di collineazione $P_{13}P_{24}$ è normale ad $AB$ (Freudenstein): $α_{4}$ "
                  "= 0.");
  } else if (!geometry::crank_turns_fully(at.lengths)) {
    lines.emplace_back(english
                           ? "The crank cannot turn fully: $ω_{4}$ grows beyond all bounds at its limit positions, "
                             "where both branches meet. No extremes."
                           : "La manovella non fa il giro completo: $ω_{4}$ cresce oltre ogni limite nelle posizioni "
                             "limite, dove i due rami si incontrano. Nessun estremo.");
  } else {
    lines.emplace_back(english ? "The linkage folds flat within a turn: there $ω_{4}$ is not determined, and the "
                                 "curves end. No extremes."
                               : "In un giro il quadrilatero si appiattisce: lì $ω_{4}$ non è determinata, e le "
                                 "curve finiscono. Nessun estremo.");
  }
  return lines;
}

// The extremes beyond the axis, where the curve leaves the chart and comes back.
std::string off_chart(const drawings::Chart& chart, const drawings::ChartMap& map, Language language) {
  std::string text;
  for (const drawings::Marker& marker : chart.markers)
    if (!is_on_chart(map, marker.at)) text += (text.empty() ? "" : ", ") + marker.label;
  return text.empty() ? "" : Words{"Off the chart: ", "Fuori del grafico: "}.in(language) + text + ".";
}

drawings::Table results(const std::vector<Special>& points, Language language) {
  const auto num = [&](double x) { return figures(x, 5, language); };
  drawings::Table table{{"", "$θ_{2}$ (°)", "$ω_{4}$ (rad/s)"}, {}};
  for (const Special& point : points) {
    const bool is_zero = point.quantity.find("zero") != std::string::npos;
    table.rows.push_back({is_zero                           ? "0"
                          : point.quantity == "omega_4_max" ? "max"
                          : point.quantity == "omega_4_min" ? "min"
                                                            : "",
                          num(point.at.x), is_zero ? "0" : num(point.at.y)});
  }
  return table;
}

}  // namespace

void draw_omega_4(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const FourBarInstant &at = f.of.instant, other = on_other_branch(at);
  const RockerSpeed speed = rocker_speed(at), other_speed = rocker_speed(other);
  const std::vector<Special> points = special_points(speed, language), others = special_points(other_speed, language);
  drawings::Chart chart = chart_of(f, {speed, other_speed, points, others}, language);
  const Datum now{degrees_within_turn({f.figure.A.x, f.figure.A.y}), f.omega_4};
  chart.markers.push_back({.at = now,
                           .label = "$ω_{4}$ = " + figures(now.y, 4, language),
                           .shape = drawings::PointShape::square,
                           .meaning = Meaning::text});
  chart.verticals = {{.at = now.x, .label = "$θ_{2}$"}};
  drawings::Box room = drawings::drawing_area(request.paper);
  constexpr double air = 4;  // mm
  room = {{room.low.x + air, room.low.y + air}, {room.high.x - air, room.high.y - air}};
  const drawings::ChartMap map = draw(chart, room, onto.sheet.figure, language);
  measure(onto, map, points);
  onto.measurements.push_back({"omega_4", map.at({now.x, 0}), map.at(now), map.y.per_mm(), Measurement::along_y});

  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "The curve" : "La curva"});
  for (const std::string& line : explained(at, speed, language)) column.push_back(drawings::Paragraph{line});
  if (const std::string beyond = off_chart(chart, map, language); !beyond.empty())
    column.push_back(drawings::Paragraph{beyond});
  if (!points.empty()) {
    column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
    column.push_back(results(points, language));
  }
  std::vector<Value> values;
  for (const Special& point : points)
    if (point.quantity == "omega_4_max" || point.quantity == "omega_4_min")
      values.push_back({point.quantity, point.at.y, "rad/s"});
  onto.sheet.description =
      in_words({"The angular velocity of the rocker over a full turn of the crank, for both configurations",
                "La velocità angolare del bilanciere in un giro della manovella, per le due configurazioni"},
               values, language);
}

}  // namespace epure::four_bar_analytic
