#include "exercises/frame-deflection/problem.h"

#include <fmt/format.h>

#include "geometry/statics/rectangle_torsion.h"

namespace epure::frame_deflection {
namespace {

Rational in_si(const Givens& givens, const std::string& symbol) { return geometry::in_si(*givens.reading(symbol)); }

}  // namespace

std::vector<GivenSpec> stated_givens() {
  return {
      {"L_1",
       {"length of the round bar 2", "lunghezza della barra tonda 2"},
       "mm",
       "1200",
       Range::positive,
       "$\\it{L}_{1}$"},
      {"L_2",
       {"length of the rectangular bars 1 and 3", "lunghezza delle barre rettangolari 1 e 3"},
       "mm",
       "800",
       Range::positive,
       "$\\it{L}_{2}$"},
      {"phi", {"diameter of bar 2", "diametro della barra 2"}, "mm", "50", Range::positive, "$φ$"},
      {"s_r", {"width of the rectangle", "larghezza del rettangolo"}, "mm", "10", Range::positive, "$s_{r}$"},
      {"H_r", {"height of the rectangle", "altezza del rettangolo"}, "mm", "50", Range::positive, "$\\it{H}_{r}$"},
      {"P", {"load in A, downwards", "carico in A, verso il basso"}, "N", "300", Range::positive, "$\\it{P}$"},
      {"E", {"Young's modulus", "modulo di Young"}, "MPa", "210000", Range::positive, "$\\it{E}$"},
      {"nu", {"Poisson's ratio", "coefficiente di Poisson"}, "1", "0.3", Range::any, "$ν$"},
  };
}

std::array<geometry::FrameBar, 3> Problem::bars() const {
  return {{{{0, 0}, {1, 0}, L_2}, {{L_2, 0}, {0, 1}, L_1}, {{L_2, L_1}, {-1, 0}, L_2}}};
}

Problem problem(const Givens& givens) {
  const Problem of{.L_1 = in_si(givens, "L_1"),
                   .L_2 = in_si(givens, "L_2"),
                   .phi = in_si(givens, "phi"),
                   .s_r = in_si(givens, "s_r"),
                   .H_r = in_si(givens, "H_r"),
                   .P = in_si(givens, "P"),
                   .E = in_si(givens, "E"),
                   .nu = givens["nu"]};
  require(of.nu > -1 && of.nu <= Rational(1, 2),
          format_words("nu = {}: Poisson's ratio of an elastic material is above -1 and at most 1/2",
                       "nu = {}: il coefficiente di Poisson di un materiale elastico supera -1 ed è al più 1/2",
                       decimal(CGAL::to_double(of.nu), 6)));
  const Rational ratio = of.H_r / of.s_r;
  const int most = geometry::slenderest_rectangle;
  require(
      ratio <= most && ratio * most >= 1,
      format_words("H_r = {} mm is {} times s_r = {} mm: a bar's rectangle has sides up to {} times each other",
                   "H_r = {} mm è {} volte s_r = {} mm: il rettangolo di una barra ha i lati in rapporto fino a {}",
                   decimal(CGAL::to_double(1000 * of.H_r), 6), decimal(CGAL::to_double(ratio), 6),
                   decimal(CGAL::to_double(1000 * of.s_r), 6), most));
  return of;
}

}  // namespace epure::frame_deflection
