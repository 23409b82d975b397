// Pressures by graphical integration of the gradients: the table's column by Bezout's formula.
#include <cmath>
#include <functional>

#include "exercises/kit/panels/integration_panel.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/michell-bearing/along_film.h"
#include "exercises/michell-bearing/exercise.h"
#include "geometry/constructions/graphical_integral.h"

namespace epure::michell_bearing {
namespace {

// So many strips can be told apart; of a finer grid several are drawn as one, with the mean of their gradients.
constexpr long most_drawn = 40;
constexpr double pascals = 1e6;

std::vector<double> in_mega(std::vector<double> values) {
  for (double& value : values) value /= pascals;
  return values;
}
std::function<double(double)> in_mega(const std::function<double(double)>& of) {
  return [of](double x) { return of(x) / pascals; };
}

struct Strips {
  std::vector<double> ends, means, pressures;
  std::vector<long> corners;  // the stations of the grid that are ends
};

// With many bits: where the walls are nearly parallel doubles lose what the gradient is made of.
Strips integrated(const Film& film) {
  return deeply([&] {
    using geometry::Deep;
    const auto wedge = film.wedge<Deep>();
    std::vector<Deep> stations, gradients;
    for (long i = 0; i <= film.strips; ++i) {
      stations.push_back(geometry::from_rational<Deep>(film.dx * Rational(i)));
      gradients.push_back(wedge.gradient(stations.back()));
    }
    const auto all = geometry::graphical_integral<Deep>(stations, geometry::means_of_ends(gradients), Deep(1));
    Strips drawn;
    const long together = (film.strips + most_drawn - 1) / most_drawn;
    for (long i = 0; i <= film.strips; ++i) {
      if (i % together != 0 && i != film.strips) continue;
      drawn.corners.push_back(i);
      drawn.ends.push_back(to_double(stations[static_cast<std::size_t>(i)]));
      drawn.pressures.push_back(to_double(all.corners[static_cast<std::size_t>(i)].y));
    }
    for (std::size_t i = 1; i < drawn.ends.size(); ++i)
      drawn.means.push_back((drawn.pressures[i] - drawn.pressures[i - 1]) / (drawn.ends[i] - drawn.ends[i - 1]));
    return drawn;
  });
}

// The pressures of the table's stations, where the polygon has corners there.
std::vector<IntegrationRow::Read> read(const Solution& s, const Film& film, const Strips& strips) {
  std::vector<IntegrationRow::Read> all;
  for (const Station& at : stations())
    for (const long corner : strips.corners) {
      const std::string quantity = of_film(at_station("p_bezout", at.name).name);
      if (corner == 0 || film.dx * Rational(corner) != at.x || !s.has(quantity)) continue;
      if (const auto value = s.value(quantity))
        all.push_back({quantity, "", CGAL::to_double(at.x), *value / pascals, pascals});
    }
  return all;
}

// How well the polygon comes back to zero at the outlet, where the true pressure is zero.
Words closure(const Strips& strips, double p_max) {
  constexpr double coarse = 0.05;
  if (std::abs(strips.pressures.back()) <= coarse * p_max)
    return {"The polygon does not quite close: Bezout's formula takes each arc for its chord.",
            "Il poligono non si chiude del tutto: la formula di Bezout prende ogni arco per la sua corda."};
  return {
      "The grid is too coarse for this film: at the outlet the polygon misses zero by more than a twentieth of "
      "$p_{max}$. Its pressures and its load say nothing of the film.",
      "La griglia è troppo rada per questo meato: all'uscita il poligono manca lo zero di più di un ventesimo di "
      "$p_{max}$. Le sue pressioni e la sua portanza non dicono nulla del meato."};
}

}  // namespace

PanelSheet integration_sheet(const Solution& s, Language language) {
  const Film film = Problem(s.givens()).film;
  const Strips strips = integrated(film);
  const Words mean{"the mean of the gradients at both ends of each strip",
                   "la media dei gradienti ai due estremi di ogni striscia"};
  return {.panels = panels(IntegrationPanel({.letters = "$x$", .unit = "m", .ends = strips.ends},
                                            {{.letters = "$p'$",
                                              .unit = "MPa/m",
                                              .meaning = Meaning::locus,
                                              .curve = in_mega(along(film, &DeepWedge::gradient)),
                                              .carried = in_mega(strips.means)},
                                             {.letters = "$p$",
                                              .unit = "MPa",
                                              .meaning = Meaning::force,
                                              .id = "p-polygon",
                                              .curve = in_mega(along(film, &DeepWedge::pressure)),
                                              .corners = in_mega(strips.pressures),
                                              .read = read(s, film, strips)}},
                                            mean)),
          .results = {values({of_film("p_max_bezout"), of_film("p_max")}),
                      values({of_film("N_bezout"), of_film("x_N_bezout")}), values({of_film("N"), of_film("x_N")}),
                      told(closure(strips, s[of_film("p_max")]), language)},
          .seen = {"The gradients in strips with pole and rays, and below them the polygon of the pressures",
                   "I gradienti in strisce con polo e raggi, e sotto il poligono delle pressioni"},
          .told = {of_film("p_max_bezout"), of_film("p_max"), of_film("N_bezout"), of_film("x_N_bezout")},
          .without_part = {"P", "speed", "pads", "r_m", "l_pad", "b", "x_N", "mu_pad", "h_ref", "x_1", "x_3"}};
}

}  // namespace epure::michell_bearing
