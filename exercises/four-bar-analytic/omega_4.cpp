// Sheet 5: ω₄ against the crank's angle, at the speed given and held, for both configurations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/four-bar-analytic/extremes.h"
#include "exercises/kit/panels/chart_panel.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/sheet.h"
#include "geometry/mechanisms/change_point.h"

namespace epure::four_bar_analytic {
namespace {

using drawings::Datum;
using geometry::Fast;
using Runs = std::vector<std::vector<Datum>>;

constexpr int samples_in_turn = 1440;  // some two in a millimetre of paper

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
Runs runs_of(const FourBarInstant& at, std::vector<Datum> extremes) {
  const std::vector<geometry::FlatPosition> flat = geometry::flat_positions(at.lengths);
  const auto is_flat = [&](const Rational& turn) {
    return geometry::is_whole_turns({2 * turn}) &&
           std::any_of(flat.begin(), flat.end(), [&](const geometry::FlatPosition& position) {
             return (position.A0A > 0) == geometry::is_whole_turns({turn});
           });
  };
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

// All of both curves; where they leave for infinity, as at a crank's limit positions, or for an extreme beside which
// they would be a flat line, what most of their points need.
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

// What the solution knows of a configuration's curve.
std::vector<Datum> extremes_of(const Solution& s, Configuration of) {
  std::vector<Datum> found;
  for (std::size_t i = 0; s.has(stationary_omega_4(of, i).name); ++i)
    found.push_back({s[stationary_theta_2(of, i).name], s[stationary_omega_4(of, i).name]});
  return found;
}
std::vector<Datum> zeros_of(const Solution& s, Configuration of) {
  std::vector<Datum> found;
  for (const geometry::Reach reach : {geometry::Reach::extended, geometry::Reach::folded})
    if (const auto theta_2 = s.value(dead_centre_theta_2(of, reach).name)) found.push_back({*theta_2, 0});
  std::sort(found.begin(), found.end(), [](const Datum& a, const Datum& b) { return a.x < b.x; });
  return found;
}

std::vector<drawings::Marker> markers(const Solution& s, Configuration of, Language language) {
  const auto shape = of == Configuration::chosen ? drawings::PointShape::dot : drawings::PointShape::ring;
  const auto num = [&](double x) { return figures(x, 4, language); };
  std::vector<drawings::Marker> all;
  for (const Datum& at : extremes_of(s, of))
    all.push_back({.at = at,
                   .label = fmt::format("{} ({}°)", num(at.y), num(at.x)),
                   .shape = shape,
                   .meaning = Meaning::velocity});
  for (const Datum& at : zeros_of(s, of))
    all.push_back({.at = at, .label = fmt::format("{}°", num(at.x)), .shape = shape, .meaning = Meaning::velocity});
  return all;
}

// What a ruler reads along the axes.
std::vector<ChartPanel::Read> read_on_chart(const Solution& s, const Datum& now) {
  std::vector<ChartPanel::Read> read{{now, {}, "omega_4"}};
  for (const Extreme which : {Extreme::max, Extreme::min}) {
    const auto x = s.value(theta_2_at(which).name), y = s.value(omega_4_at(which).name);
    if (x && y) read.push_back({{*x, *y}, theta_2_at(which).name, omega_4_at(which).name});
  }
  for (const int number : {1, 2})
    if (const auto x = s.value(theta_2_at_zero(number).name))
      read.push_back({{*x, 0}, theta_2_at_zero(number).name, {}});
  return read;
}

Datum now_of(const Solution& s) { return {s[theta_2_within_turn().name], s["omega_4"]}; }

drawings::Chart chart_of(const Solution& s, const FourBarInstant& at, Language language) {
  const FourBarInstant other = on_other_branch(at);
  const bool is_bounded = geometry::crank_turns_fully(at.lengths);
  const std::vector<Runs> runs{runs_of(at, extremes_of(s, Configuration::chosen)),
                               runs_of(other, extremes_of(s, Configuration::other))};
  const bool is_left = at.side == geometry::Side::left;
  const auto side = [&](bool left) {
    const Words words = left ? Words{"$B$ left of $AB_{0}$", "$B$ a sinistra di $AB_{0}$"}
                             : Words{"$B$ right of $AB_{0}$", "$B$ a destra di $AB_{0}$"};
    return words.in(language);
  };
  const Datum now = now_of(s);
  drawings::Chart chart;
  chart.x = {.quantity = "$θ_{2}$", .unit = "°", .low = 0, .high = 360, .steps = drawings::degree_steps};
  chart.y = speed_axis(runs, now.y, is_bounded);
  chart.curves = {{.name = "omega_4",
                   .runs = refined(runs[0], at, chart.y),
                   .meaning = Meaning::velocity,
                   .label = side(is_left)},
                  {.name = "omega_4_other_branch",
                   .runs = refined(runs[1], other, chart.y),
                   .meaning = Meaning::velocity,
                   .line = drawings::LineType::dashed,
                   .label = side(!is_left)}};
  for (const Configuration of : {Configuration::chosen, Configuration::other})
    for (drawings::Marker& marker : markers(s, of, language)) chart.markers.push_back(std::move(marker));
  chart.markers.push_back({.at = now,
                           .label = "$ω_{4}$ = " + figures(now.y, 4, language) + " rad/s",
                           .shape = drawings::PointShape::square,
                           .meaning = Meaning::text});
  chart.horizontals = {{.at = 0}};
  chart.verticals = {{.at = now.x, .label = "$θ_{2}$"}};
  return chart;
}

// The linkage with the centres that give ω₄/ω₂.
class CentresPanel : public Panel {
 public:
  explicit CentresPanel(const Solution& s) : mechanism_(linkage(s, {})), P24_(s.point("P24")) {
    // Far off, where the coupler is nearly parallel to the frame, it says no more.
    if (P24_ && distance(mechanism_.at("A0"), *P24_) > 2 * mechanism_.reach()) P24_.reset();
  }
  double reach() const override { return mechanism_.reach(); }
  drawings::Box extent(const Scale& lengths, const Scale&) const override {
    Extent extent;
    mechanism_.include(extent, lengths);
    if (P24_) extent.include(lengths, *P24_, 9);
    return extent.box();
  }
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_.draw_given(plot); }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override {
    const Place &A0 = mechanism_.at("A0"), &A = mechanism_.at("A"), &B = mechanism_.at("B"),
                &B0 = mechanism_.at("B0");
    if (P24_) {
      constexpr double beyond = 5;  // mm
      plot.long_segment(B, *P24_, beyond, Meaning::construction);
      plot.segment(B0, *P24_, Meaning::construction);
    }
    mechanism_.draw(plot);
    plot.label("$P_{12}$", A0, B, Meaning::locus);
    plot.label("$P_{14}$", B0, A, Meaning::locus);
    if (!P24_) return {};
    plot.cross(*P24_);
    plot.label("$P_{24}$", *P24_, B, Meaning::locus);
    return {};
  }
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    std::vector<PanelStep> all;
    if (P24_)
      all.push_back({{"$P_{12}$ ≡ $A_{0}$ and $P_{14}$ ≡ $B_{0}$ are the frame's hinges; $P_{24}$, where $AB$ meets "
                      "$A_{0}B_{0}$, has one velocity as a point of crank and of rocker.",
                      "$P_{12}$ ≡ $A_{0}$ e $P_{14}$ ≡ $B_{0}$ sono le cerniere del telaio; $P_{24}$, dove $AB$ "
                      "incontra $A_{0}B_{0}$, ha una sola velocità come punto di manovella e di bilanciere."},
                     P24_});
    all.push_back({{"$ω_{4}$ = $ω_{2}$·$P_{12}P_{24}$ / $P_{14}P_{24}$. $ω_{2}$ is held constant.",
                    "$ω_{4}$ = $ω_{2}$·$P_{12}P_{24}$ / $P_{14}P_{24}$. $ω_{2}$ è costante."}});
    return all;
  }

 private:
  Mechanism mechanism_;
  std::optional<Place> P24_;
};

std::vector<Result> explained(const FourBarInstant& at, Language language) {
  const Words extremes =
      why_no_extremes(at.lengths).empty()
          ? Words{"Extreme where the line from $P_{24}$ to the meet $P_{13}$ of $A_{0}A$ and $B_{0}B$ (collineation "
                  "axis) is perpendicular to $AB$ (Freudenstein): $α_{4}$ = 0.",
                  "Estrema dove la retta da $P_{24}$ all'incontro $P_{13}$ di $A_{0}A$ e $B_{0}B$ (asse di "
                  "collineazione) è normale ad $AB$ (Freudenstein): $α_{4}$ = 0."}
      : !geometry::crank_turns_fully(at.lengths)
          ? Words{"The crank cannot turn fully: $ω_{4}$ grows beyond all bounds at its limit positions, where both "
                  "branches meet. No extremes.",
                  "La manovella non fa il giro completo: $ω_{4}$ cresce oltre ogni limite nelle posizioni limite, "
                  "dove i due rami si incontrano. Nessun estremo."}
          : Words{"The linkage folds flat within a turn: there $ω_{4}$ is not determined, and the curves end. No "
                  "extremes.",
                  "In un giro il quadrilatero si appiattisce: lì $ω_{4}$ non è determinata, e le curve finiscono. "
                  "Nessun estremo."};
  return {remark(Words{"Zero at the dead centres: crank and coupler in line.",
                       "Zero ai punti morti: manovella e biella allineate."}
                     .in(language)),
          remark(extremes.in(language))};
}

std::optional<drawings::Block> extremes_and_zeros(const Solution& s, Language language) {
  const auto num = [&](double x) { return figures(x, 5, language); };
  drawings::Table table{{"", "$θ_{2}$ (°)", "$ω_{4}$ (rad/s)"}, {}};
  const std::vector<Datum> extremes = extremes_of(s, Configuration::chosen);
  for (const Datum& at : extremes) {
    const bool is_max = std::all_of(extremes.begin(), extremes.end(), [&](const Datum&x) { return x.y <= at.y; }),
               is_min = std::all_of(extremes.begin(), extremes.end(), [&](const Datum&x) { return x.y >= at.y; });
    table.rows.push_back({is_max ? "max" : is_min ? "min" : "", num(at.x), num(at.y)});
  }
  for (const Datum& at : zeros_of(s, Configuration::chosen))
    table.rows.push_back({Words{"dead centre", "punto morto"}.in(language), num(at.x), "0"});
  if (table.rows.empty()) return {};
  return table;
}

}  // namespace

PanelSheet omega_4_sheet(const Solution& s, Language language) {
  const FourBarInstant at = problem(s.givens()).instant;
  return {.panels = panels(CentresPanel(s), ChartPanel(chart_of(s, at, language), read_on_chart(s, now_of(s)))),
          .theory = {{{"The curve", "La curva"}, explained(at, language)}},
          .results = {extremes_and_zeros, values({"omega_4"})},
          .seen = {"The angular velocity of the rocker over a full turn of the crank, for both configurations",
                   "La velocità angolare del bilanciere in un giro della manovella, per le due configurazioni"},
          .told = {"omega_4_min", "omega_4_max"},
          .without_part = {"AP_along", "AP_across"}};
}

}  // namespace epure::four_bar_analytic
