#include "exercises/michell-thrust/problem.h"

#include <algorithm>
#include <numbers>

#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/given_number.h"
#include "geometry/numbers/climb.h"

namespace epure::michell_thrust {
namespace {

GivenSpec given(const std::string& symbol, const Words& meaning, const std::string& unit, const std::string& stated,
                const std::string& letters) {
  return {.symbol = symbol, .meaning = meaning, .unit = unit, .stated = stated, .letters = letters};
}

Rational si(const Givens& givens, const std::string& symbol, const std::string& from, const std::string& to) {
  return givens[symbol] * geometry::conversion(from, to);
}

void demand_ring(const Problem& of) {
  if (of.D_i >= of.D_e)
    throw BadGivens(format_words("D_i = {} m must be less than D_e = {} m: the pads have no width",
                                 "D_i = {} m dev'essere minore di D_e = {} m: i pattini non hanno larghezza",
                                 told_value(of.D_i), told_value(of.D_e)));
  if (of.pads.denominator() != 1 || of.pads < Rational(1))
    throw BadGivens(
        format_words("z = {}: must be a whole number", "z = {}: deve essere un numero intero", told_value(of.pads)));
  const auto lengths = [&]<class T>() {
    const Rational circle = Rational(2) * of.R_m(), gaps = of.pads * of.d;
    return T(geometry::from_rational<T>(circle) * geometry::pi<T>() - geometry::from_rational<T>(gaps));
  };
  if (geometry::decide(lengths).sign == geometry::Sign::positive) return;
  const Rational gaps = of.pads * of.d;
  const double circle = 2 * std::numbers::pi * nearest(of.R_m());
  const int figures = figures_that_tell_apart(nearest(gaps), circle).value_or(12);
  throw BadGivens(
      format_words("{} gaps of d = {} m take {} m, and the mean circle of R_m = {} m is only {} m: no room for pads",
                   "{} intervalli con d = {} m prendono {} m, e la circonferenza media con R_m = {} m è solo {} m: "
                   "non resta posto per i pattini",
                   told_value(of.pads), told_value(of.d), told_value(gaps, std::max(12, figures)),
                   told_value(of.R_m()), decimal(circle, figures)));
}

// As far as a flat pad can have it, and as films can be made: the same as of the bearing of N.6.
void demand_pivot(const Rational& centre) {
  if (centre <= Rational(1, 2) || centre > Rational(95, 100))
    throw BadGivens(format_words(
        "x_N_over_l = {}: must be more than 0.5 and at most 0.95: the load of a flat pad acts in its middle where "
        "its walls are parallel, and nearer to the outlet the more they narrow (at 0.95, h_1/h_2 is beyond 10^5)",
        "x_N_over_l = {}: deve essere più di 0,5 e al più 0,95: il carico di un pattino piano agisce nel mezzo "
        "quando le pareti sono parallele, e tanto più verso l'uscita quanto più si stringono (a 0,95, h_1/h_2 supera "
        "10^5)",
        told_value(centre)));
}

std::optional<RowsBeside> rows_beside(const Rational& centre) {
  const auto& rows = table_1();
  if (centre < rows.front().x_N_over_l || centre > rows.back().x_N_over_l) return {};
  const auto next =
      std::find_if(rows.begin() + 1, rows.end() - 1, [&](const TableRow& row) { return row.x_N_over_l >= centre; });
  return RowsBeside{&*(next - 1), &*next};
}

}  // namespace

const std::vector<TableRow>& table_1() {
  const auto row = [](const std::string& n, const char* A, const char* A_n_minus_1_squared, const char* x_N_over_l,
                      const char* k) {
    const auto number = [](const std::string& text) { return geometry::parse_given(text, "1"); };
    std::string name = n;
    std::replace(name.begin(), name.end(), '.', '_');
    return TableRow{
        .name = name,
        .n = number(n),
        .A = number(A),
        .x_N_over_l = number(x_N_over_l),
        .k = number(k),
        .printed = {{"A", A}, {"A_n_minus_1_squared", A_n_minus_1_squared}, {"x_N_over_l", x_N_over_l}, {"k", k}}};
  };
  static const std::vector<TableRow> rows{
      row("1.6", "0.141", "0.0508", "0.548", "2.20"), row("1.8", "0.153", "0.0982", "0.559", "2.03"),
      row("2.0", "0.159", "0.159", "0.571", "1.94"),  row("2.2", "0.160", "0.231", "0.577", "1.88"),
      row("2.4", "0.159", "0.312", "0.586", "1.85"),  row("2.6", "0.156", "0.400", "0.594", "1.83"),
      row("2.8", "0.152", "0.494", "0.601", "1.82"),  row("3.0", "0.148", "0.592", "0.608", "1.81")};
  return rows;
}

std::vector<GivenSpec> given_specs() {
  return {given("Q", {"thrust", "carico"}, "tf", "700", "$\\it{Q}$"),
          given("n_g", {"speed", "velocità di rotazione"}, "rpm", "75", "$n_{g}$"),
          given("D_e", {"outer diameter", "diametro esterno"}, "m", "2.2", "$\\it{D}_{e}$"),
          given("D_i", {"inner diameter", "diametro interno"}, "m", "1.1", "$\\it{D}_{i}$"),
          given("d", {"gap between pads", "distanza tra i pattini"}, "mm", "50", "$d$"),
          given("x_N_over_l",
                {"pivot, from the leading edge, in lengths of the pad",
                 "cerniera, dal bordo d'ingresso, in lunghezze del pattino"},
                "1", "0.565", "$x_{N}$/$l$"),
          given("mu", {"viscosity", "viscosità"}, "kgf s/m^2", "0.0035", "$μ$"),
          given("z", {"number of pads", "numero dei pattini"}, "1", "10", "$z$")};
}

Problem::Problem(const Givens& givens)
    : Q(si(givens, "Q", "tf", "N")),
      D_e(givens["D_e"]),
      D_i(givens["D_i"]),
      d(si(givens, "d", "mm", "m")),
      centre(givens["x_N_over_l"]),
      mu(si(givens, "mu", "kgf s/m^2", "Pa s")),
      mu_in_kgf(givens["mu"]),
      pads(givens["z"]),
      speed(givens.angle("n_g")),
      beside(rows_beside(centre)) {
  demand_ring(*this);
  demand_pivot(centre);
}

}  // namespace epure::michell_thrust
