// The numerical table, and its errors over time.
#include <cmath>
#include <limits>

#include "exercises/kit/panels/sized_chart.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/point-mass/exercise.h"
#include "exercises/point-mass/motion.h"
#include "exercises/point-mass/quantities.h"

namespace epure::point_mass {
namespace {

using drawings::Datum;

constexpr ChartSize one_of_two_in_a_column{110, 74};

// Of Cavalieri-Simpson's formula the odd and the even rows are two sums.
struct Errors {
  std::string name, label;
  Meaning meaning;
  drawings::LineType line;  // in all charts the same
  std::vector<std::vector<Datum>> runs;
  std::vector<Words> of_runs;  // which rows
};

// As many as a curve needs.
constexpr std::size_t most_points = 400;

// |numerical - exact|/|exact|, where there is such a thing that is not zero.
Errors errors(const std::string& kind, const std::string& method, const std::vector<Rational>& numerical,
              const std::vector<Rational>& exact, const Rational& dt) {
  using drawings::LineType;
  const std::string initial = method == "bezout" ? "B" : "S";
  const LineType line = method == "bezout" ? (kind == "v" ? LineType::continuous : LineType::dashed)
                                           : (kind == "v" ? LineType::dotted : LineType::dash_dotted);
  Errors of{kind + "_" + method,
            "$" + kind + "_{" + initial + "}$",
            kind == "v" ? Meaning::velocity : Meaning::locus,
            line,
            {},
            {}};
  const std::size_t sums = method == "bezout" ? 1 : 2, step = sums * (numerical.size() / most_points + 1);
  for (std::size_t first = 0; first < sums; ++first) {
    std::vector<Datum> run;
    for (std::size_t i = first; i < numerical.size(); i += step) {
      if (exact[i] == 0 || numerical[i] == exact[i]) continue;
      const double error = std::abs(nearest((numerical[i] - exact[i]) / exact[i]));
      if (error > 0) run.push_back({nearest(dt * Rational(static_cast<long>(i))), error});
    }
    if (run.empty()) continue;
    of.runs.push_back(run);
    of.of_runs.push_back(sums == 1    ? Words{}
                         : first == 0 ? Words{", even rows", ", righe pari"}
                                      : Words{", odd rows", ", righe dispari"});
  }
  return of;
}

// Whole decades, of a few at least.
SizedChart chart(const std::vector<Errors>& all, const std::string& letters, double end, Language language) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Errors& each : all)
    for (const auto& run : each.runs)
      for (const Datum& point : run) {
        low = std::min(low, point.y);
        high = std::max(high, point.y);
      }
  constexpr double least = 1e-12, decade = 10;
  if (high == 0) low = high = 1;  // no errors
  low = std::min(std::max(low, least), high / decade);
  drawings::Chart chart;
  chart.x = {.quantity = "$t$", .unit = "s", .low = 0, .high = end, .to_ticks = false};
  chart.y = {.quantity = letters,
             .unit = "",
             .low = std::pow(10.0, std::floor(std::log10(low))),
             .high = std::pow(10.0, std::ceil(std::log10(high))),
             .scale = drawings::AxisScale::logarithmic};
  for (const Errors& each : all)
    for (std::size_t i = 0; i < each.runs.size(); ++i)
      chart.curves.push_back({.name = each.name,
                              .runs = {each.runs[i]},
                              .meaning = each.meaning,
                              .line = each.line,
                              .label = each.label + each.of_runs[i].in(language)});
  chart.letters_left = 15;
  return SizedChart(std::move(chart), {}, one_of_two_in_a_column);
}

// The motion itself, and by both formulas.
struct Tabulated {
  std::vector<Rational> t, F, a;
  struct Columns {
    std::string method;
    std::vector<Rational> v = {}, q = {}, E = {}, s = {};
  };
  std::vector<Columns> columns = {{""}, {"bezout"}, {"simpson"}};
};
// `motion` and `steps`: either of the two routes to both.
template <class Motion, class Steps>
Tabulated tabulated(const Problem& of, const Motion& motion, const Steps& steps) {
  Tabulated all;
  for (long i = 0; i <= of.rows(); ++i) {
    all.t.push_back(of.dt * Rational(i));
    const Instant<Rational> at = motion.at(all.t.back());
    all.F.push_back(at.F);
    all.a.push_back(at.a);
    for (Tabulated::Columns& column : all.columns) {
      const TableRow row = column.method.empty() ? TableRow{at.v, at.s} : steps.at(column.method, i);
      column.v.push_back(row.v);
      column.q.push_back(column.method.empty() ? at.q : of.m * row.v);
      column.E.push_back(column.method.empty() ? at.E : of.m * row.v * row.v / 2);
      column.s.push_back(row.s);
    }
  }
  return all;
}

std::vector<double> in_doubles(const std::vector<Rational>& values) {
  std::vector<double> all;
  for (const Rational& value : values) all.push_back(nearest(value));
  return all;
}
// In the order of the long table.
std::vector<std::vector<double>> in_columns(const Tabulated& table) {
  std::vector<std::vector<double>> all{in_doubles(table.t), in_doubles(table.F), in_doubles(table.a)};
  for (const Tabulated::Columns& each : table.columns)
    for (const auto* column : {&each.v, &each.q, &each.E, &each.s}) all.push_back(in_doubles(*column));
  return all;
}

// Which of the errors there are: the formulas are exact for polynomials of low degree.
Words of_the_formulas(const Problem& of) {
  if (of.A != 0)
    return {
        "Bezout's $v_{B}$ is off by Δ$t^{2}$/12·($a'$($t$) − $a'$(0)). Cavalieri-Simpson's formula is exact for "
        "the cubic $a$: $v_{S}$ has an error in the odd rows alone, which begin with a parabola through three "
        "points. Odd and even rows each have a curve of $s_{S}$, and one of $v_{S}$ where that is wrong in both.",
        "La $v_{B}$ di Bezout è errata di Δ$t^{2}$/12·($a'$($t$) − $a'$(0)). La formula di Cavalieri-Simpson è "
        "esatta per la cubica $a$: $v_{S}$ ha errore nelle sole righe dispari, che cominciano con una parabola per "
        "tre punti. Righe dispari e pari hanno ognuna la sua curva di $s_{S}$, e dove entrambe sono errate di "
        "$v_{S}$."};
  if (of.B != 0)
    return {
        "Bezout's $v_{B}$ is off by Δ$t^{2}$/12·($a'$($t$) − $a'$(0)). Cavalieri-Simpson's formula is exact for "
        "the parabola $a$: $v_{S}$ has no error, $s_{S}$ in the odd rows alone, which begin with a parabola "
        "through three points.",
        "La $v_{B}$ di Bezout è errata di Δ$t^{2}$/12·($a'$($t$) − $a'$(0)). La formula di Cavalieri-Simpson è "
        "esatta per la parabola $a$: $v_{S}$ non ha errore, $s_{S}$ nelle sole righe dispari, che cominciano con "
        "una parabola per tre punti."};
  if (of.C != 0)
    return {
        "$a$ is a straight line: $v_{B}$, $v_{S}$ and $s_{S}$ have no error, and no curve here. Bezout's $s_{B}$ "
        "alone is off, by Δ$t^{2}$/12·$a$($t$).",
        "$a$ è una retta: $v_{B}$, $v_{S}$ e $s_{S}$ non hanno errore, e qui nessuna curva. Solo la $s_{B}$ di "
        "Bezout è errata, di Δ$t^{2}$/12·$a$($t$)."};
  return {"$\\it{F}$ = 0: the body rests, and both formulas say so.",
          "$\\it{F}$ = 0: il corpo resta in quiete, e così dicono entrambe le formule."};
}

}  // namespace

PanelSheet errors_sheet(const Solution& s, Language language) {
  const Problem of(s.givens());
  const double end = nearest(of.end());
  const Tabulated table = tabulated(of, ByPowers(of), BySteps(of));
  std::vector<Errors> right, printed;
  for (const Tabulated::Columns& column : table.columns) {
    if (column.method.empty()) continue;
    right.push_back(errors("v", column.method, column.v, table.columns.front().v, of.dt));
    right.push_back(errors("s", column.method, column.s, table.columns.front().s, of.dt));
  }
  Panels all;
  all.push_back(std::make_unique<SizedChart>(
      chart(right, Words{"|$ε$|, correct tables", "|$ε$|, tabelle giuste"}.in(language), end, language)));
  std::vector<Section> theory{{{"The formulas", "Le formule"}, {remark(of_the_formulas(of).in(language))}}};
  if (s.givens().as_stated()) {
    for (const PrintedAgainstExact& column : printed_columns())
      printed.push_back(errors(column.kind, column.method, column.printed, column.exact, of.dt));
    all.push_back(std::make_unique<SizedChart>(chart(
        printed, Words{"|$ε$|, the source's tables", "|$ε$|, tabelle della fonte"}.in(language), end, language)));
    const Words mistakes{
        "Below, the source's own table: worse nearly everywhere, mostly by several powers of ten. Its sums leave out "
        "the first strip (Bezout), and those of the velocities stand a row too high; or the first two "
        "(Cavalieri-Simpson: its first three rows are zero). Every number of these columns follows from that.",
        "Sotto, la tabella della fonte: peggiore quasi ovunque, per lo più di varie potenze di dieci. Le sue somme "
        "tralasciano la prima striscia (Bezout), e quelle delle velocità stanno una riga troppo in alto; o le prime "
        "due (Cavalieri-Simpson: le sue prime tre righe sono nulle). Ne segue ogni numero di queste colonne."};
    theory.push_back({{"The source's table", "La tabella della fonte"}, {remark(mistakes.in(language))}});
  }
  const auto row = [](const std::string& kind, const std::string& method) {
    return Row{"$ε_{" + kind + (method == "bezout" ? "B" : "S") + "}$",
               {error_of(kind, method, "1").name, error_of(kind, method, "2").name, error_of(kind, method, "3").name},
               "–"};
  };
  return {.panels = std::move(all),
          .theory = std::move(theory),
          .results = {epure::table({"", "$t_{1}$", "$t_{2}$", "$t_{3}$"},
                                   {row("v", "bezout"), row("E", "bezout"), row("s", "bezout"), row("v", "simpson"),
                                    row("E", "simpson"), row("s", "simpson")})},
          .seen = {"Relative errors of velocity and space over time, by both formulas",
                   "Errori relativi di velocità e spazio nel tempo, con le due formule"},
          .told = {"err_v_bezout_3", "err_s_bezout_3", "err_s_simpson_3"},
          .without_part = {"strip", "cm_t", "cm_a", "cm_v", "cm_s"}};
}

LongTable long_table(const Solution& s) {
  const Problem of(s.givens());
  int decimals = 0;  // of the instants
  for (Rational step = of.dt; step.denominator() != 1 && decimals < 4; step *= 10) ++decimals;
  LongTable table;
  table.columns = {{"t", "$t$", "s", decimals, {}}, {"F", "$\\it{F}$", "N", 2, {}}, {"a", "$a$", "m/s^2", 3, {}}};
  for (const std::string method : {"", "_bezout", "_simpson"}) {
    const std::string below = method.empty() ? "" : method == "_bezout" ? "_{B}" : "_{S}";
    table.columns.push_back({"v" + method, "$v" + below + "$", "m/s", 3, {}});
    table.columns.push_back({"q" + method, "$q" + below + "$", "kg*m/s", 2, {}});
    table.columns.push_back({"E" + method, "$\\it{E}" + below + "$", "J", 1, {}});
    table.columns.push_back({"s" + method, "$s" + below + "$", "m", 3, {}});
  }
  const auto values = in_columns(tabulated(of, ByPowers(of), BySteps(of)));
  for (std::size_t i = 0; i < values.size(); ++i) table.columns[i].values = values[i];
  table.by_another_route = [of] { return in_columns(tabulated(of, ByQuadrature{of}, InClosedForm(of))); };
  return table;
}

PanelSheet table_sheet(const Solution&, Language language) {
  const Words columns{
      "First the motion itself, then $v_{B}$ and $s_{B}$ by Bezout's formula, $v_{S}$ and $s_{S}$ by "
      "Cavalieri-Simpson's; $q$ = $mv$ and $\\it{E}$ = $mv^{2}$/2 of each velocity.",
      "Prima il moto esatto, poi $v_{B}$ e $s_{B}$ con la formula di Bezout, $v_{S}$ e $s_{S}$ con quella di "
      "Cavalieri-Simpson; $q$ = $mv$ ed $\\it{E}$ = $mv^{2}$/2 di ogni velocità."};
  return {.theory = {{{"The columns", "Le colonne"}, {remark(columns.in(language))}}},
          .seen = {"The motion step by step: exact, by Bezout's and by Cavalieri-Simpson's formula",
                   "Il moto passo per passo: esatto, con la formula di Bezout e con quella di Cavalieri-Simpson"},
          .without_part = {"t_1", "t_2", "strip", "cm_t", "cm_a", "cm_v", "cm_s"}};
}

}  // namespace epure::point_mass
