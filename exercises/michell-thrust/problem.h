// What is given of the thrust bearing, in SI units, and the table of coefficients that its source prints.
#pragma once

#include <optional>
#include <vector>

#include "exercises/kit/statement/givens.h"
#include "geometry/analytic/reynolds.h"
#include "geometry/lubrication/flat_slider.h"

namespace epure::michell_thrust {

std::vector<GivenSpec> given_specs();

struct TableRow {
  struct Column {
    const char* name;  // of the quantity
    std::string text;  // as printed, with a decimal point
  };

  std::string name;  // "1_6"
  Rational n, A, x_N_over_l, k;
  std::vector<Column> printed;  // but for n
};
const std::vector<TableRow>& table_1();

struct RowsBeside {
  const TableRow *before, *after;
};

struct Problem {
  Rational Q, D_e, D_i, d, centre, mu, mu_in_kgf, pads;
  Angle speed;
  // The rows of the table on both sides of the pivot; none where it is off the table.
  std::optional<RowsBeside> beside;

  Rational R_m() const { return (D_e + D_i) / 4; }
  Rational b() const { return (D_e - D_i) / 2; }
  // Throws BadGivens: a ring without width, pads that overlap, a pivot where no flat pad can have it.
  explicit Problem(const Givens& givens);
};

}  // namespace epure::michell_thrust
