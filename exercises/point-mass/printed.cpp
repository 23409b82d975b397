// What the source printed: its table, its errors, and how they came about.
#include "exercises/kit/statement/decimal.h"
#include "exercises/point-mass/exercise.h"
#include "exercises/point-mass/motion.h"
#include "exercises/point-mass/quantities.h"

namespace epure::point_mass {
namespace {

constexpr const char* table_text =
#include "exercises/point-mass/printed_table.inc"
    ;
const std::vector<std::vector<std::string>>& table() {
  static const auto all = read_printed_table(table_text);
  return all;
}

using Numbers = std::vector<Rational>;

// The columns of a velocity and of its space.
struct Columns {
  Numbers v, s;
};

// Row by row, with the source's givens.
struct Computed {
  Numbers F, a, q, E;
  Columns exact, bezout, simpson, mistaken_bezout, mistaken_simpson;
};

Numbers times(const Rational& factor, Numbers of) {
  for (Rational& each : of) each *= factor;
  return of;
}
Numbers energies(const Rational& m, Numbers of) {
  for (Rational& each : of) each = m / 2 * each * each;
  return of;
}

// Without the first strip, and each sum a row too high; what follows the table counts as zero.
Numbers shifted_trapezoids(Numbers y, const Rational& dt) {
  y.push_back(0);
  Numbers Y{0};
  for (std::size_t i = 1; i + 1 < y.size(); ++i) Y.push_back(Y.back() + dt * (y[i] + y[i + 1]) / 2);
  return Y;
}
Numbers trapezoids_without_first(const Numbers& y, const Rational& dt) {
  Numbers Y{0, 0};
  for (std::size_t i = 2; i < y.size(); ++i) Y.push_back(Y.back() + dt * (y[i - 1] + y[i]) / 2);
  return Y;
}
// The first three rows are zero, and the formula begins with the fourth.
Numbers simpson_from_fourth(const Numbers& y, const Rational& dt) {
  Numbers Y{0, 0, 0};
  for (std::size_t i = 3; i < y.size(); ++i) Y.push_back(Y[i - 2] + 2 * dt * (y[i - 2] + 4 * y[i - 1] + y[i]) / 6);
  return Y;
}

const Problem& stated() {
  static const Problem of{Givens(given_specs())};
  return of;
}

const Computed& computed() {
  static const Computed all = [] {
    const Problem& of = stated();
    const ByPowers motion(of);
    Computed found;
    for (long i = 0; i <= of.rows(); ++i) {
      const Instant<Rational> at = motion.at<Rational>(of.dt * Rational(i));
      found.F.push_back(at.F);
      found.a.push_back(at.a);
      found.exact.v.push_back(at.v);
      found.exact.s.push_back(at.s);
    }
    found.bezout.v = by_bezout(found.a, of.dt);
    found.bezout.s = by_bezout(found.bezout.v, of.dt);
    found.simpson.v = by_simpson(found.a, of.dt);
    found.simpson.s = by_simpson(found.simpson.v, of.dt);
    found.mistaken_bezout.v = shifted_trapezoids(found.a, of.dt);
    found.mistaken_bezout.s = trapezoids_without_first(found.mistaken_bezout.v, of.dt);
    found.mistaken_simpson.v = simpson_from_fourth(found.a, of.dt);
    found.mistaken_simpson.s = simpson_from_fourth(found.mistaken_simpson.v, of.dt);
    return found;
  }();
  return all;
}

const Words bezout_of_a{
    "the first strip is missing and each sum stands a row too high, as if it were Y_{i+1} = Y_i + Δx·(y_{i+1} + "
    "y_{i+2})/2; past the last row the acceleration is an empty cell",
    "manca la prima striscia e ogni somma sta una riga troppo in alto, come se fosse Y_{i+1} = Y_i + Δx·(y_{i+1} + "
    "y_{i+2})/2; oltre l'ultima riga l'accelerazione è una casella vuota"};
const Words bezout_of_v{
    "the first strip is missing: the sum begins with the second row, of velocities that are already wrong",
    "manca la prima striscia: la somma comincia dalla seconda riga, con velocità già sbagliate"};
const Words simpson_of_both{
    "the first three rows are zero, where the formula begins with the third: the first two strips are missing",
    "le prime tre righe sono nulle, mentre la formula comincia dalla terza: mancano le prime due strisce"};

// A column of the table: its place there, and what it should be and is.
struct Column {
  std::string kind, method;
  Numbers right, mistaken;
  Words mistake;
};
std::vector<Column> columns() {
  const Computed& of = computed();
  const Rational& m = stated().m;
  std::vector<Column> all{{"F", "", of.F, {}, {}}, {"a", "", of.a, {}, {}}};
  const auto add = [&](const std::string& method, const Columns& right, const Columns& mistaken, const Words& in_v,
                       const Words& in_s) {
    all.push_back({"v", method, right.v, mistaken.v, in_v});
    all.push_back({"q", method, times(m, right.v), times(m, mistaken.v), in_v});
    all.push_back({"E", method, energies(m, right.v), energies(m, mistaken.v), in_v});
    all.push_back({"s", method, right.s, mistaken.s, in_s});
  };
  add("", of.exact, {}, {}, {});
  add("bezout", of.bezout, of.mistaken_bezout, bezout_of_a, bezout_of_v);
  add("simpson", of.simpson, of.mistaken_simpson, simpson_of_both, simpson_of_both);
  return all;
}

std::string text_at(std::size_t row, std::size_t column) { return table().at(row).at(column + 1); }

Printed of_table(const std::string& quantity, const Column& column, std::size_t place, std::size_t row) {
  Printed printed{quantity, text_at(row, place), column.method.empty() ? "closed form" : "sums"};
  if (!column.mistaken.empty()) {
    const double value = nearest(column.mistaken[row]);
    printed.explanation = Explanation{column.mistake, [value] { return value; }};
  }
  return printed;
}

// Of one error the exact velocity was taken with all its digits, of the others as the table prints it.
Explanation unrounded_velocity(std::size_t row, std::size_t numerical) {
  const double exact = nearest(computed().exact.v[row]),
               found = nearest(read_decimal(text_at(row, numerical), "1").value);
  return {
      {"the exact velocity was taken with all its digits, the numerical one as the table prints it, wrong",
       "la velocità esatta è stata presa con tutte le cifre, quella numerica come la stampa la tabella, sbagliata"},
      [=] { return (exact - found) / exact; }};
}

// The errors were taken from the numbers of the table as it prints them.
Printed of_error(const std::string& kind, const std::string& method, const std::string& instant, std::size_t row,
                 const std::string& text) {
  const std::vector<Column> all = columns();
  const auto printed = [&](const std::string& of_method) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].kind == kind && all[i].method == of_method) return read_decimal(text_at(row, i), "1").value;
    return Rational(0);
  };
  const Rational exact = printed(""), numerical = printed(method);
  const double error = std::abs(nearest((numerical - exact) / exact));
  const std::string name = error_of(kind, method, instant).name;
  constexpr std::size_t v_simpson = 10;
  if (name == "err_v_simpson_2") return {name, text + "%", "sums", 0, unrounded_velocity(row, v_simpson)};
  return {name, text + "%", "sums", 0,
          Explanation{{"it is the difference of the table's rounded numbers, and the numerical one is wrong there",
                       "è la differenza dei numeri arrotondati della tabella, e quello numerico vi è sbagliato"},
                      [error] { return error; }}};
}

}  // namespace

std::vector<PrintedAgainstExact> printed_columns() {
  std::vector<PrintedAgainstExact> all;
  const Computed& of = computed();
  for (const auto& [method, columns] :
       {std::pair<const char*, const Columns*>{"bezout", &of.mistaken_bezout}, {"simpson", &of.mistaken_simpson}}) {
    all.push_back({"v", method, columns->v, of.exact.v});
    all.push_back({"s", method, columns->s, of.exact.s});
  }
  return all;
}

std::vector<Printed> printed_by_the_source() {
  const std::vector<Column> all = columns();
  const std::array<std::size_t, 3> rows{50, 140, 200};  // of the instants
  std::vector<Printed> printed;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < all.size(); ++k)
      printed.push_back(
          of_table(of_motion(all[k].kind, all[k].method, std::to_string(i + 1)).name, all[k], k, rows[i]));
  for (std::size_t second = 1; second < 20; ++second)
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool is_reported = all[k].kind == "v" || all[k].kind == "s" || all[k].kind == "F";
      if (!is_reported || second == 5 || second == 14) continue;
      const std::string at = "at_" + std::to_string(second);
      printed.push_back(of_table("table." + of_motion(all[k].kind, all[k].method, at).name, all[k], k, 10 * second));
    }
  const std::array<std::array<const char*, 8>, 3> errors{
      {{"2,84", "2,84", "5,77", "5,15", "0,24", "0,26", "0,51", "0,34"},
       {"0,32", "0,33", "0,66", "1,12", "0,12", "0,11", "0,22", "0,09"},
       {"0,05", "0,04", "0,08", "0,51", "0,14", "0,15", "0,29", "0,08"}}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 8; ++k)
      printed.push_back(of_error(std::string(1, "vqEs"[k % 4]), k < 4 ? "bezout" : "simpson", std::to_string(i + 1),
                                 rows[i], errors[i][k]));
  for (const auto& [name, text] :
       std::initializer_list<std::pair<const char*, const char*>>{{"F_max", "180,00"},
                                                                  {"F_min", "-74,07"},
                                                                  {"t_v_max", "12,5"},
                                                                  {"v_max", "28,65"},
                                                                  {"q_max", "1432,29"},
                                                                  {"E_max", "20514,59"},
                                                                  {"s_at_v_max", "195,31"}})
    printed.push_back({name, text, "closed form"});
  return printed;
}

std::vector<TableAudit> audit_of_the_table() {
  std::vector<PrintedColumn> audited;
  const std::vector<Column> all = columns();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = all[i].kind + (all[i].method.empty() ? "" : "_" + all[i].method);
    PrintedColumn column{.name = name, .printed = column_of(table(), i + 1), .right = all[i].right};
    if (!all[i].mistaken.empty()) column.mistakes = {{all[i].mistake, all[i].mistaken}};
    audited.push_back(std::move(column));
  }
  return {audit({"table of F, a, v, q, E and s", "tabella di F, a, v, q, E e s"}, column_of(table(), 0), audited)};
}

}  // namespace epure::point_mass
