// What the source printed, and why it is off where it is.
//
// Reading errors. Acceleration polygon: 4 cm for a_A, so 71.06 m/s² a cm; half a millimetre for each length read and
// 0.05/4 of each for a_A laid off; ω₃ = 13 ± 0.47 comes in from exercise N.1 through a_BA^n = ω₃² AB. Method of
// poles: half a millimetre at 1 : 10 for each of the two lengths of a ratio; 5 mm for a length by itself.
#include "exercises/slider-crank-acceleration/printed.h"

#include <cmath>

#include "exercises/kit/proof/solution.h"
#include "exercises/slider-crank-acceleration/routes.h"

namespace epure::slider_crank_acceleration {
namespace {

// The lengths the source read off its figure with the circles all come out of one factor on the true ones, anything
// from 0.7930 to 0.7964: a figure reduced to about four fifths and read as if it were not.
constexpr double shrunk = 0.795;

const Solution& source_figure() {
  static const Solution solution = [] {
    const Givens stated(slider_crank_givens(true));
    return Solution(stated, settle(AccelerationRoutes{slider_crank_instant(stated)}, Rung::drawing));
  }();
  return solution;
}

Explanation reduced_figure(const std::string& length) {
  return {{"read off a figure reduced to about 0.795 of its scale, as are all lengths of this exercise: 0.795 times "
           "the true length",
           "letta su una figura ridotta a circa 0,795 della sua scala, come tutte le lunghezze di questa "
           "esercitazione: 0,795 volte la lunghezza vera"},
          [length] { return shrunk * source_figure()[length]; }};
}

// X'X on the inflection circle through P₀, B and the K that the source's own polygon gives: KA = AB a_A/a_BA and
// KB = AB a_B/a_BA with its numbers, K on the right of AB.
double on_the_circle_of_the_printed_K(const Place& X) {
  const Solution& s = source_figure();
  const Place A = s.place("A"), B = s.place("B"), P0 = s.place("P0");
  const double AB = 0.50, KA = AB * 284.26 / 153.36, KB = AB * 305.30 / 153.36;
  const double along = (KA * KA + AB * AB - KB * KB) / (2 * AB), across = -std::sqrt(KA * KA - along * along);
  const Arrow2 u = 1 / AB * (B - A);
  const auto circle = geometry::cycle_through(P0, B, A + along * u + across * geometry::quarter_turn(u));
  const Place centre{-circle.l / (2 * circle.k), -circle.m / (2 * circle.k)};
  const double PX = distance(P0, X);
  return std::abs(2 * geometry::dot(centre - P0, 1 / PX * (X - P0)) - PX);
}

Explanation circle_of_the_printed_K(const std::string& X) {
  return {{"the same figure at 0.795, its inflection circle through P₀, B and the K of the printed polygon (KA = "
           "AB·284.26/153.36, KB = AB·305.30/153.36)",
           "la stessa figura a 0,795, con la circonferenza dei flessi per P₀, B e il K del poligono stampato (KA = "
           "AB·284,26/153,36, KB = AB·305,30/153,36)"},
          [X] { return shrunk * on_the_circle_of_the_printed_K(source_figure().place(X)); }};
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  constexpr double ruler = 0.005;  // m: half a millimetre at 1 : 10
  return {
      {"a_A", "284.26", "analytic", 0,
       Explanation{{"ω₂ rounded to 37.7 rad/s before it is squared: 37.7²·0.20",
                    "ω₂ arrotondata a 37,7 rad/s prima del quadrato: 37,7²·0,20"},
                   [] { return 37.7 * 37.7 * 0.20; }}},
      {"a_BA_n", "84.50", "polar diagram", 6.31},
      {"a_BA_t", "127.80", "polar diagram", 6.42},
      {"alpha_3", "255.60", "polar diagram", 12.85},
      {"a_BA", "153.36", "polar diagram", 8.88},
      {"a_CA", "92", "polar diagram", 5.33},
      {"a_MA", "76.68", "polar diagram", 4.44},
      {"a_B", "305.30", "polar diagram", 13.84},
      {"a_C", "355", "polar diagram", 13.35},
      {"a_M", "284", "polar diagram", 11.57},
      {"a_B", "307.62", "poles", 4.05},
      {"a_C", "358.25", "poles", 4.39},
      {"a_M", "284.26", "poles", 3.90},
      {"KA", "0.73", "poles", ruler, reduced_figure("KA")},
      {"KB", "0.79", "poles", ruler, reduced_figure("KB")},
      {"KC", "0.92", "poles", ruler, reduced_figure("KC")},
      {"KM", "0.73", "poles", ruler, reduced_figure("KM")},
      {"P0C", "0.22", "poles", ruler, reduced_figure("P0C")},
      {"P0M", "0.33", "poles", ruler, reduced_figure("P0M")},
      {"Cprime_C", "1.65", "poles", ruler, circle_of_the_printed_K("C")},
      {"Mprime_M", "1.02", "poles", ruler, circle_of_the_printed_K("M")},
      {"rho_C", "0.03", "poles", 0,
       Explanation{{"P₀C²/C'C with the two lengths of the reduced figure: 0.22²/1.65",
                    "P₀C²/C'C con le due lunghezze della figura ridotta: 0,22²/1,65"},
                   [] { return 0.22 * 0.22 / 1.65; }}},
      {"rho_M", "0.11", "poles", 0,
       Explanation{{"P₀M²/M'M with the two lengths of the reduced figure: 0.33²/1.02",
                    "P₀M²/M'M con le due lunghezze della figura ridotta: 0,33²/1,02"},
                   [] { return 0.33 * 0.33 / 1.02; }}},
  };
}

}  // namespace epure::slider_crank_acceleration
