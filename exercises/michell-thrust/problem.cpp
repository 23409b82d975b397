#include "exercises/michell-thrust/problem.h"
#include "exercises/kit/statement/given_number.h"

#include <algorithm>

#include "exercises/kit/statement/decimal.h"
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
  if (geometry::decide(lengths).sign != geometry::Sign::positive)
    throw BadGivens(
        format_words("{} gaps of d = {} m are longer than the mean circle of R_m = {} m: no room for pads",
                     "{} intervalli con d = {} m sono più lunghi della circonferenza media con R_m = {} m: "
                     "non resta posto per i pattini",
                     told_value(of.pads), told_value(of.d), told_value(of.R_m())));
}

// As far as a flat pad can have it, and as films can be made: the same as of the bearing of N.6.
void demand_pivot(const Rational& centre) {
  if (centre <= Rational(1, 2) || centre > Rational(95, 100))
    throw BadGivens(format_words(
        "x_N_over_l = {}: must be more than 0.5 and at most 0.95: the load of a flat pad acts in its middle where "
        "its "
        "walls are parallel, and nearer to the outlet the more they narrow (at 0.95, h_1/h_2 is beyond 10^5)",
        "x_N_over_l = {}: deve essere più di 0,5 e al più 0,95: il carico di un pattino piano agisce nel mezzo "
        "quando "
        "le pareti sono parallele, e tanto più verso l'uscita quanto più si stringono (a 0,95, h_1/h_2 supera 10^5)",
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
  const auto thousandth = [](int number) { return Rational(number, 1000); };
  static const std::vector<TableRow> rows{
      {"1_6", Rational(16, 10), thousandth(141), Rational(508, 10000), thousandth(548), Rational(220, 100)},
      {"1_8", Rational(18, 10), thousandth(153), Rational(982, 10000), thousandth(559), Rational(203, 100)},
      {"2_0", Rational(20, 10), thousandth(159), thousandth(159), thousandth(571), Rational(194, 100)},
      {"2_2", Rational(22, 10), thousandth(160), thousandth(231), thousandth(577), Rational(188, 100)},
      {"2_4", Rational(24, 10), thousandth(159), thousandth(312), thousandth(586), Rational(185, 100)},
      {"2_6", Rational(26, 10), thousandth(156), thousandth(400), thousandth(594), Rational(183, 100)},
      {"2_8", Rational(28, 10), thousandth(152), thousandth(494), thousandth(601), Rational(182, 100)},
      {"3_0", Rational(30, 10), thousandth(148), thousandth(592), thousandth(608), Rational(181, 100)}};
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
