// Sheet 2: the vector equation v_B = v_A + v_BA closed as a polygon, the images of C and M, and the two methods
// compared.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/compare.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/slider-crank-velocity/exercise.h"

namespace epure::slider_crank_velocity {
namespace {

constexpr double mechanism_share = 0.43;  // of the room's height; the polygon needs the larger part

Place tip(const Arrow2& v) { return {v.x, v.y}; }

void draw_polygon(Plot& plot, const Drawn& f, Language language) {
  const Place O{0, 0}, a = tip(f.v_A), b = tip(f.v_B), c = tip(f.v_C), m = tip(f.v_M);
  const Place inside{(a.x + b.x) / 2, (a.y + b.y) / 2};
  plot.direction_line(O, b, 12, parallel_to_guide(f.instant, language));
  plot.direction_line(a, b, 12, "⊥ $AB$");
  plot.direction_line(b, c, 6, "⊥ $BC$");
  plot.direction_line(a, c, 6, "⊥ $AC$");
  plot.side("v_A", O, a, Meaning::velocity, "$\\vec{v}_{A}$", inside);
  plot.side("v_BA", a, b, Meaning::velocity, "$\\vec{v}_{BA}$", O);
  plot.side("v_B", O, b, Meaning::velocity, "$\\vec{v}_{B}$", a);
  plot.side("v_CA", a, c, Meaning::velocity, "$\\vec{v}_{CA}$", inside);
  plot.side("v_C", O, c, Meaning::velocity, "$\\vec{v}_{C}$", inside);
  plot.side("v_M", O, m, Meaning::velocity, "$\\vec{v}_{M}$", c);
  plot.measures("v_MA", a, m);
  plot.measures_coordinates("v_B", b, O);
  plot.measures_coordinates("v_C", c, O);
  plot.measures_coordinates("v_M", m, O);
  for (const Place& X : {O, m}) plot.dot(X, Meaning::velocity);
  plot.label("$O_{v}$", O, inside, Meaning::velocity);
  for (const auto& [name, X] :
       {std::pair{"$a'$", a}, std::pair{"$b'$", b}, std::pair{"$c'$", c}, std::pair{"$m'$", m}}) {
    plot.label(name, X, O, Meaning::velocity);
  }
  plot.step(1, {a.x * 0.6, a.y * 0.6});
  plot.step(2, {a.x + 0.3 * (b.x - a.x), a.y + 0.3 * (b.y - a.y)});
  plot.step(3, {b.x * 0.6, b.y * 0.6});
  plot.step(4, c);
  plot.step(5, m);
}

drawings::Box polygon_extent(const Drawn& f, const Scale& scale) {
  Extent extent;
  for (const Place& X : {Place{0, 0}, tip(f.v_A), tip(f.v_B), tip(f.v_C), tip(f.v_M)}) extent.include(scale, X, 11);
  return extent.box();
}

drawings::VectorEquation equation_of_B(const Drawn& f, Language language) {
  return {{{"$\\vec{v}_{B}$", parallel_to_guide(f.instant, language), "?", ""},
           {"$\\vec{v}_{A}$", "⊥ $A_{0}A$", "$ω_{2}$·$A_{0}A$", "="},
           {"$\\vec{v}_{BA}$", "⊥ $BA$", "?", "+"}}};
}

drawings::VectorEquation equation_of_C() {
  return {{{"$\\vec{v}_{C}$", "?", "?", ""},
           {"$\\vec{v}_{A}$", "⊥ $A_{0}A$", "$ω_{2}$·$A_{0}A$", "="},
           {"$\\vec{v}_{CA}$", "⊥ $CA$", "$ω_{3}$·$CA$", "+"}}};
}

drawings::Steps steps(Language language) {
  if (language == Language::english) {
    return {{"From $O_{v}$ the known $\\vec{v}_{A}$, square to the crank.",
             "Through $a'$ the line square to $AB$: it carries $\\vec{v}_{BA}$.",
             "Through $O_{v}$ the line parallel to the guide. The two meet in $b'$; $ω_{3}$ = $v_{BA}$ / $AB$.",
             "$c'$: square to $AC$ through $a'$, square to $BC$ through $b'$. The triangle $a'b'c'$ is the image of "
             "$ABC$.",
             "$m'$ halves $a'b'$, as $M$ halves $AB$."}};
  }
  return {{"Da $O_{v}$ la $\\vec{v}_{A}$ nota, normale alla manovella.",
           "Per $a'$ la normale ad $AB$: la retta d'azione della $\\vec{v}_{BA}$.",
           "Per $O_{v}$ la parallela alla guida. Le due si incontrano in $b'$; $ω_{3}$ = $v_{BA}$ / $AB$.",
           "$c'$: normale ad $AC$ per $a'$, normale a $BC$ per $b'$. Il triangolo $a'b'c'$ è l'immagine di $ABC$.",
           "$m'$ è il punto medio di $a'b'$, come $M$ di $AB$."}};
}

// Both methods as read from their own drawings; ω₃ from the lengths read.
std::vector<Comparison> comparisons(const DrawnSheet& polar, const Drawn& f, const SheetRequest& request) {
  const Readings diagram(polar);
  DrawnSheet other;
  other.sheet.paper = request.paper;
  draw_poles(other, f, request);
  const Readings poles(other);
  const double AB = CGAL::to_double(f.instant.lengths.l);
  std::vector<Comparison> rows;
  const double v_A = magnitude(f.v_A);
  if (!poles.is_unit("P0A")) return rows;
  const double omega_3 = v_A / poles["P0A"];
  for (const char* X : {"B", "C", "M"}) {
    rows.push_back({fmt::format("$v_{{{}}}$ (m/s)", X), omega_3 * poles[fmt::format("P0{}", X)],
                    diagram[fmt::format("v_{}", X)]});
  }
  rows.push_back({"|$ω_{3}$| (rad/s)", omega_3, diagram["v_BA"] / AB});
  return rows;
}

}  // namespace

void draw_polar_diagram(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const drawings::Box room = room_above_scale_bars(request);
  const double divide = room.high.y - mechanism_share * room.height();
  const Scale lengths = draw_small_slider_crank(onto, f.at, f.instant, {{room.low.x, divide}, room.high}, request);
  double greatest = 0;
  for (const Arrow2& v : {f.v_A, f.v_B, f.v_C, f.v_M}) greatest = std::max(greatest, magnitude(v));
  const Fit fit = fit_vectors({room.low, {room.high.x, divide}}, "m/s", request.language, room.width() / greatest,
                              [&](const Scale& scale) { return polygon_extent(f, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_polygon(plot, f, request.language);
  add_scale_bars(onto, {lengths, plot.scale()}, request);

  const bool english = request.language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(equation_of_B(f, request.language));
  column.push_back(equation_of_C());
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(request.language));
  if (const auto rows = comparisons(onto, f, request); !rows.empty()) {
    column.push_back(drawings::Heading{english ? "The two methods, as measured" : "I due metodi, come misurati"});
    column.push_back(comparison_table(rows, {"poles", "poli"}, {"diagram", "diagramma"}, request.language));
  }
  onto.sheet.description = in_words({"The polygon of the velocities of the slider-crank, with the images of C and M",
                                     "Il poligono delle velocità del manovellismo, con le immagini di C e M"},
                                    {{"v_A", magnitude(f.v_A), "m/s"},
                                     {"v_BA", magnitude(f.v_BA), "m/s"},
                                     {"v_B", magnitude(f.v_B), "m/s"},
                                     {"v_C", magnitude(f.v_C), "m/s"},
                                     {"v_M", magnitude(f.v_M), "m/s"}},
                                    request.language);
}

}  // namespace epure::slider_crank_velocity
