#include "exercises/oscillator-pendulum/tables.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "exercises/kit/proof/zero_for_drawing.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/oscillator-pendulum/routes.h"

namespace epure::oscillator_pendulum {
namespace {

// Most tables need no more than a few; what they leave open, or would take for zero, is asked of many.
constexpr long few_bits = 128, many_bits = 512;

// The double nearest to it, or one of the two beside a value midway.
double in_double(const Deep& x) {
  const geometry::Enclosure ends = geometry::enclosure(x);
  const long bits = geometry::Arithmetic<Deep>::bits();
  if (bits == many_bits && is_zero_for_drawing(ends, bits)) return 0;
  if (!certain_double(x) && std::nextafter(ends.lower, ends.upper) != ends.upper && std::isfinite(ends.value))
    throw geometry::Undecided("a number of the table: on the way to it the recursion loses more than 512 bits",
                              "un numero della tabella: fin lì la ricorrenza perde più di 512 bit");
  static_assert(many_bits == 512);
  return ends.value;
}

// Takes from a route what it finds at every instant of a table, and nothing else.
class RowWriter {
 public:
  using Columns = std::map<std::string, std::vector<double>>;
  RowWriter(const std::vector<Rational>& rows, Columns& wanted) : rows_(rows), columns_(wanted) {}

  template <class Find>
  void of(const std::string&, const Find&) const {}
  template <class Find>
  void ball(const std::string&, const Find&) const {}
  template <class Find>
  void at_instants(const std::string& what, const Find& find) const {
    if (const auto column = columns_.find(what); column != columns_.end())
      for (const Rational& t : rows_) column->second.push_back(in_double(find(t)));
  }
  struct Route {
    void route(const char*) const {}
  } ledger = {};

 private:
  const std::vector<Rational>& rows_;
  Columns& columns_;
};

struct Spec {
  std::string name, letters, unit;
  int decimals;
};

std::vector<Rational> instants_of_rows(const Rational& dt, int end) {
  std::vector<Rational> all;
  for (Rational t = 0; t <= end; t += dt) all.push_back(t);
  return all;
}

// In the order of the specs. `take` has a route write into what it is given.
template <class Take>
std::vector<std::vector<double>> columns_with(long bits, const std::vector<Spec>& specs,
                                              const std::vector<Rational>& rows, const Take& take) {
  const geometry::Arithmetic<Deep> scope(bits);
  RowWriter::Columns found;
  for (const Spec& spec : specs) found[spec.name];
  take(RowWriter(rows, found));
  std::vector<std::vector<double>> all;
  for (const Spec& spec : specs) all.push_back(found.at(spec.name));
  return all;
}

template <class Take>
std::vector<std::vector<double>> columns_of(const std::vector<Spec>& specs, const std::vector<Rational>& rows,
                                            const Take& take) {
  try {
    return columns_with(few_bits, specs, rows, take);
  } catch (const geometry::Undecided&) {
    return columns_with(many_bits, specs, rows, take);
  }
}

std::size_t rows_within_doubles(const std::vector<std::vector<double>>& columns) {
  constexpr double most = 1e300;
  std::size_t rows = columns.front().size();
  for (const auto& column : columns)
    rows = std::min(rows, static_cast<std::size_t>(std::find_if(column.begin(), column.end(),
                                                                [](double x) { return std::abs(x) > most; }) -
                                                   column.begin()));
  return rows;
}

// `dt`: its step, to `end` seconds.
template <class Routes>
LongTable table_of(const Routes& routes, const std::vector<Spec>& specs, const Rational& dt, int end) {
  std::vector<Rational> rows = instants_of_rows(dt, end);
  const auto first = columns_of(specs, rows, [&](const RowWriter& write) { routes.one_route(write); });
  rows.resize(rows_within_doubles(first));
  std::vector<double> instants;
  for (const Rational& t : rows) instants.push_back(nearest(t));
  int decimals = 0;
  for (Rational step = dt; step.denominator() != 1 && decimals < 4; step *= 10) ++decimals;
  LongTable table;
  table.columns = {{"t", "$t$", "s", decimals, instants}};
  for (std::size_t i = 0; i < specs.size(); ++i)
    table.columns.push_back({specs[i].name,
                             specs[i].letters,
                             specs[i].unit,
                             specs[i].decimals,
                             {first[i].begin(), first[i].begin() + static_cast<std::ptrdiff_t>(rows.size())}});
  table.by_another_route = [=, &specs] {
    auto columns = columns_of(specs, rows, [&](const RowWriter& write) { routes.other_route(write); });
    columns.insert(columns.begin(), instants);
    return columns;
  };
  return table;
}

}  // namespace

LongTable oscillator_table(const Solution& s) {
  static const std::vector<Spec> specs{{"x", "$x$", "m", 5},
                                       {"x_dot", "$x'$", "m/s", 5},
                                       {"x_ddot", "$x''$", "m/s^2", 6},
                                       {"x_euler", "$x_{E}$", "m", 5},
                                       {"x_dot_euler", "$x'_{E}$", "m/s", 5},
                                       {"x_ddot_euler", "$x''_{E}$", "m/s^2", 6}};
  const Oscillator of = Problem(s.givens()).oscillator;
  return table_of(OscillatorRoutes{of}, specs, of.dt, 20);
}

LongTable pendulum_table(const Solution& s) {
  static const std::vector<Spec> specs{{"theta", "$θ$", "rad", 4},
                                       {"theta_dot", "$θ'$", "rad/s", 3},
                                       {"theta_ddot", "$θ''$", "rad/s^2", 3},
                                       {"R_12_x", "$\\it{R}_{12x}$", "N", 2},
                                       {"R_12_y", "$\\it{R}_{12y}$", "N", 2},
                                       {"theta_numeric", "$θ_{n}$", "rad", 4},
                                       {"theta_dot_numeric", "$θ'_{n}$", "rad/s", 3},
                                       {"theta_ddot_numeric", "$θ''_{n}$", "rad/s^2", 3},
                                       {"R_12_x_numeric", "$\\it{R}_{12x,n}$", "N", 2},
                                       {"R_12_y_numeric", "$\\it{R}_{12y,n}$", "N", 2}};
  const Pendulum of = Problem(s.givens()).pendulum;
  return table_of(PendulumRoutes{of}, specs, of.dt, 1);
}

PanelSheet oscillator_table_sheet(const Solution&, Language language) {
  const Words columns{
      "First the motion itself, then Euler's method: $x_{i+1}$ = $x_{i}$ + $x'_{i}$Δ$t$, $x'_{i+1}$ = $x'_{i}$ + "
      "$x''_{i}$Δ$t$, $x''_{i}$ = −2$ζω_{n}x'_{i}$ − $ω_{n}^{2}x_{i}$.",
      "Prima il moto esatto, poi il metodo di Eulero: $x_{i+1}$ = $x_{i}$ + $x'_{i}$Δ$t$, $x'_{i+1}$ = $x'_{i}$ + "
      "$x''_{i}$Δ$t$, $x''_{i}$ = −2$ζω_{n}x'_{i}$ − $ω_{n}^{2}x_{i}$."};
  return {.theory = {{{"The columns", "Le colonne"}, {remark(columns.in(language))}}},
          .seen = {"The motion of the oscillator step by step: exact, and by Euler's method",
                   "Il moto dell'oscillatore passo per passo: esatto e con il metodo di Eulero"},
          .without_part = givens_of_pendulum};
}

PanelSheet pendulum_table_sheet(const Solution&, Language language) {
  const Words columns{
      "First the motion itself, then the recursion $θ_{i+2}$ = 2$θ_{i+1}$ − $θ_{i}$ − $Ω^{2}$Δ$t_{p}^{2}$sin "
      "$θ_{i}$, $θ_{1}$ = $θ_{0}$, with its difference quotients $θ'_{i}$ = ($θ_{i+1}$ − $θ_{i}$)/Δ$t_{p}$, "
      "$θ''_{i}$ = ($θ_{i+2}$ − 2$θ_{i+1}$ + $θ_{i}$)/Δ$t_{p}^{2}$.",
      "Prima il moto esatto, poi la formula ricorsiva $θ_{i+2}$ = 2$θ_{i+1}$ − $θ_{i}$ − $Ω^{2}$Δ$t_{p}^{2}$sen "
      "$θ_{i}$, $θ_{1}$ = $θ_{0}$, con i rapporti incrementali $θ'_{i}$ = ($θ_{i+1}$ − $θ_{i}$)/Δ$t_{p}$, $θ''_{i}$ "
      "= ($θ_{i+2}$ − 2$θ_{i+1}$ + $θ_{i}$)/Δ$t_{p}^{2}$."};
  return {.theory = {{{"The columns", "Le colonne"}, {remark(columns.in(language))}}},
          .seen = {"The motion of the pendulum step by step: exact, and by the recursion",
                   "Il moto del pendolo passo per passo: esatto e con la formula ricorsiva"},
          .without_part = givens_of_oscillator};
}

}  // namespace epure::oscillator_pendulum
