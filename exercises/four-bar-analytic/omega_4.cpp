// Sheet 5: ω₄ against the crank's angle, at the speed given and held, for both configurations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawings/chart.h"
#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/four-bar-analytic/extremes.h"
#include "exercises/kit/sheet.h"
#include "geometry/mechanisms/change_point.h"

namespace epure::four_bar_analytic {
namespace {

using drawings::Datum;
using geometry::Fast;
using Runs = std::vector<std::vector<Datum>>;

constexpr int samples_in_degree = 4;  // some two in a millimetre of paper

double degrees_within_turn(const geometry::Vector<double>& direction) {
  const double angle = std::atan2(direction.y, direction.x) * 180 / geometry::pi<Fast>();
  return angle < 0 ? angle + 360 : angle;
}

// In doubles, for the eye. None where the linkage does not close, or stands where ω₄ is not determined.
std::optional<double> omega_4_at(const FourBarInstant& at, const geometry::Vector<double>& crank) {
  const RatioByClosure closure{at.analytic_lengths(), at.analytic_branch()};
  try {
    const double omega_4 = at.omega_2<Fast>() * closure.ratio(crank);
    return std::isfinite(omega_4) ? std::optional(omega_4) : std::nullopt;
  } catch (const geometry::Impossible&) {
    return {};
  } catch (const geometry::Undecided&) {
    return {};
  }
}

// What is joined is continuous: a run ends where the linkage no longer closes, and where it folds flat (on +x or -x).
Runs runs_of(const FourBarInstant& at) {
  const std::vector<geometry::FlatPosition> flat = geometry::flat_positions(at.lengths);
  const auto is_flat = [&](const geometry::Vector<double>& crank) {
    return crank.y == 0 && std::any_of(flat.begin(), flat.end(), [&](const geometry::FlatPosition& position) {
             return (position.A0A > 0) == (crank.x > 0);
           });
  };
  Runs runs{{}};
  for (int i = 0; i <= 360 * samples_in_degree; ++i) {
    const geometry::Turn turn{Rational(i, 360 * samples_in_degree)};
    const geometry::Vector<double> crank{geometry::cosine<Fast>(turn), geometry::sine<Fast>(turn)};
    const auto omega_4 = is_flat(crank) ? std::nullopt : omega_4_at(at, crank);
    if (omega_4)
      runs.back().push_back({static_cast<double>(i) / samples_in_degree, *omega_4});
    else if (!runs.back().empty())
      runs.emplace_back();
  }
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

// All of both curves; where they leave for infinity, what most of their points need.
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
  if (!is_bounded) {
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

// What a ruler reads along the axes.
void measure(DrawnSheet& onto, const drawings::ChartMap& map, const std::vector<Special>& points) {
  const auto across = [&](const std::string& name, const Datum& to) {
    onto.measurements.push_back({name, map.at({0, to.y}), map.at(to), map.x.per_mm(), Measurement::along_x});
  };
  const auto up = [&](const std::string& name, const Datum& to) {
    onto.measurements.push_back({name, map.at({to.x, 0}), map.at(to), map.y.per_mm(), Measurement::along_y});
  };
  for (const Special& point : points) {
    if (point.quantity.empty()) continue;
    across("theta_2_at_" + point.quantity + "_deg", point.at);
    if (point.quantity.find("zero") == std::string::npos) up(point.quantity, point.at);
  }
}

drawings::Chart chart_of(const Drawn& f, const std::vector<Special>& points, const std::vector<Special>& others,
                         Language language) {
  const bool english = language == Language::english;
  const FourBarInstant &at = f.of.instant, other = on_other_branch(at);
  const bool is_bounded = why_no_extremes(at.lengths).empty();
  const std::vector<Runs> runs{runs_of(at), runs_of(other)};
  const bool is_left = at.side == geometry::Side::left;
  const auto side = [&](bool left) {
    return english ? (left ? "$B$ left of $AB_{0}$" : "$B$ right of $AB_{0}$")
                   : (left ? "$B$ a sinistra di $AB_{0}$" : "$B$ a destra di $AB_{0}$");
  };
  drawings::Chart chart;
  chart.x = {.quantity = "$θ_{2}$", .unit = "°", .low = 0, .high = 360, .steps = drawings::degree_steps};
  chart.y = speed_axis(runs, f.omega_4, is_bounded);
  chart.curves = {{.name = "omega_4", .runs = runs[0], .meaning = Meaning::velocity, .label = side(is_left)},
                  {.name = "omega_4_other_branch",
                   .runs = runs[1],
                   .meaning = Meaning::velocity,
                   .line = drawings::LineType::dashed,
                   .label = side(!is_left)}};
  for (const Special& point : points)
    chart.markers.push_back(
        {.at = point.at, .label = point.label, .shape = drawings::PointShape::dot, .meaning = Meaning::velocity});
  for (const Special& point : others)
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
  const RockerSpeed speed = rocker_speed(at);
  const std::vector<Special> points = special_points(speed, language),
                             others = special_points(rocker_speed(other), language);
  drawings::Chart chart = chart_of(f, points, others, language);
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
