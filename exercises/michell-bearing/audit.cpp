// The source's two tables, row by row: films, gradients and pressures, and the velocities at the three sections.
#include "exercises/kit/statement/table_audit.h"
#include "exercises/michell-bearing/exercise.h"

namespace epure::michell_bearing {
namespace {

#include "exercises/michell-bearing/printed_tables.inc"

// Of the source, in SI units, exactly.
const Rational slider_length(4, 10), runner_speed(24, 10), viscosity(4, 100), at_inlet(4, 10000),
    at_outlet(16, 100000), grid_step(1, 100);
const Rational rounded_film(22857, 100000000), film_of_greatest = Rational(2) * at_inlet * at_outlet /
                                                                  (at_inlet + at_outlet);

Rational film_at(const Rational& x) { return at_inlet - (at_inlet - at_outlet) * x / slider_length; }
Rational gradient_with(const Rational& h_bar, const Rational& x) {
  const Rational h = film_at(x);
  return Rational(6) * viscosity * runner_speed * (h - h_bar) / (h * h * h);
}
Rational right_gradient(const Rational& x) { return gradient_with(film_of_greatest, x); }
Rational rounded_gradient(const Rational& x) { return gradient_with(rounded_film, x); }
Rational speed_at(const Rational& x, const Rational& z) {
  const Rational h = film_at(x);
  return runner_speed * z / h - right_gradient(x) * (h - z) * z / (Rational(2) * viscosity);
}

// Bezout's sums of a gradient, row after row.
std::vector<Rational> sums(std::size_t rows, const Rational& of_strip,
                           const std::function<Rational(const Rational&)>& gradient) {
  std::vector<Rational> all{0};
  while (all.size() < rows) {
    const Rational x = grid_step * Rational(static_cast<int>(all.size()));
    all.push_back(all.back() + of_strip * (gradient(x - grid_step) + gradient(x)) / 2);
  }
  return all;
}

std::vector<Rational> down(std::size_t rows, const Rational& apart,
                           const std::function<Rational(const Rational&)>& value) {
  std::vector<Rational> all;
  for (std::size_t i = 0; i < rows; ++i) all.push_back(value(apart * Rational(static_cast<int>(i))));
  return all;
}

TableAudit audit_of_pressures() {
  const auto table = read_printed_table(of_pressures);
  const std::size_t rows = table.size();
  const Words rounded{"h_bar was rounded to 0.22857 mm", "h_bar è stato arrotondato a 0,22857 mm"};
  const Words short_step{
      "the step was taken as 0.001 m instead of 0.01 m, and h_bar rounded as for the gradients",
      "il passo è stato preso di 0,001 m anziché 0,01 m, con h_bar arrotondato come nei gradienti"};
  return audit({"table of h, p' and p", "tabella di h, p' e p"}, column_of(table, 0),
               {{.name = "h", .printed = column_of(table, 1), .right = down(rows, grid_step, film_at)},
                {.name = "dp_dx",
                 .printed = column_of(table, 2),
                 .right = down(rows, grid_step, right_gradient),
                 .mistakes = {{rounded, down(rows, grid_step, rounded_gradient)}}},
                {.name = "p_bezout",
                 .printed = column_of(table, 3),
                 .right = sums(rows, grid_step, right_gradient),
                 .mistakes = {{short_step, sums(rows, grid_step / 10, rounded_gradient)}}}});
}

// Of one section: `straight` is a film such that V z/h gives the whole column, at x_1 and x_3 found by trying.
PrintedColumn velocities(const std::vector<std::vector<std::string>>& table, std::size_t place, const Rational& x,
                         const Rational& straight) {
  const Rational depth(1, 100000);
  PrintedColumn column{.name = "u_x_" + std::to_string(place),
                       .printed = {},
                       .right = down(table.size(), depth, [&](const Rational& z) { return speed_at(x, z); })};
  for (const auto& row : table) column.printed.push_back(place < row.size() ? row[place] : "");
  const Words film = decimal(1000 * CGAL::to_double(straight), 5);
  column.mistakes = {{Words{"the part of the pressure is left out: V·z/h, with h = ",
                            "manca la parte dovuta alla pressione: V·z/h, con h = "} +
                          film +
                          (place == 2 ? Words{" mm, the film at x = 0.23 m", " mm, il meato in x = 0,23 m"}
                                      : Words{" mm (fitted to the column)", " mm (adattato alla colonna)"}),
                      down(table.size(), depth, [&](const Rational& z) { return runner_speed * z / straight; })}};
  return column;
}

}  // namespace

std::vector<TableAudit> audits() {
  const auto table = read_printed_table(of_velocities);
  return {audit_of_pressures(), audit({"table of u", "tabella di u"}, column_of(table, 0),
                                      {velocities(table, 1, Rational(15, 100), Rational(31066, 100000000)),
                                       velocities(table, 2, Rational(236, 1000), Rational(262, 1000000)),
                                       velocities(table, 3, Rational(35, 100), Rational(18995, 100000000))})};
}

}  // namespace epure::michell_bearing
