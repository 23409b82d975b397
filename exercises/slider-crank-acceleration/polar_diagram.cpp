// Sheet 1: a_B = a_A + a_BA^n + a_BA^t closed as a polygon; C and M by similarity.
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/slider-crank-acceleration/exercise.h"

namespace epure::slider_crank_acceleration {
namespace {

constexpr double mechanism_share = 0.42;  // of the room's height; the polygon needs the larger part

Place tip(const Arrow2& a) { return {a.x, a.y}; }
Place after(const Place& P, const Arrow2& a) { return {P.x + a.x, P.y + a.y}; }

void draw_sides(Plot& plot, const Drawn& f, Language language) {
  const Place O{0, 0}, a = tip(f.a_A), n = after(a, f.a_BA_n), b = tip(f.a_B), c = tip(f.a_C), m = tip(f.a_M);
  const Place inside{(a.x + b.x + n.x) / 3, (a.y + b.y + n.y) / 3};
  plot.direction_line(b, n, 12, "⊥ $AB$");
  plot.direction_line(O, b, 12, parallel_to_guide(f.instant, language));
  plot.segment(b, c, Meaning::construction);
  const bool has_tangential_part = !is_zero(f.instant.alpha_2);
  if (has_tangential_part) {
    const Place after_n = tip(f.a_A_n);
    plot.side("", O, after_n, Meaning::acceleration, "$\\vec{a}^{n}_{A}$", b);
    plot.side("", after_n, a, Meaning::acceleration, "$\\vec{a}^{t}_{A}$", b);
  }
  plot.side("a_A", O, a, Meaning::acceleration, "$\\vec{a}_{A}$", b);
  plot.side("a_BA_n", a, n, Meaning::acceleration, "$\\vec{a}^{n}_{BA}$", inside);
  plot.side("a_BA_t", n, b, Meaning::acceleration, "$\\vec{a}^{t}_{BA}$", inside);
  plot.side("a_BA", a, b, Meaning::acceleration, "$\\vec{a}_{BA}$", n);
  plot.side("a_B", O, b, Meaning::acceleration, "$\\vec{a}_{B}$", a);
  plot.side("a_CA", a, c, Meaning::acceleration, "$\\vec{a}_{CA}$", Place{2 * n.x - c.x, 2 * n.y - c.y});
  plot.side("a_C", O, c, Meaning::acceleration, "$\\vec{a}_{C}$", a);
  plot.side("a_M", O, m, Meaning::acceleration, "$\\vec{a}_{M}$", a);
  plot.measures("a_MA", a, m);
  plot.right_angle(n, a, b);
}

void draw_names(Plot& plot, const Drawn& f) {
  const Place O{0, 0}, a = tip(f.a_A), n = after(a, f.a_BA_n), b = tip(f.a_B), c = tip(f.a_C), m = tip(f.a_M);
  plot.measures_coordinates("a_B", b, O);
  plot.measures_coordinates("a_C", c, O);
  plot.measures_coordinates("a_M", m, O);
  for (const Place& X : {O, m}) plot.dot(X, Meaning::acceleration);
  plot.label("$O_{a}$", O, b, Meaning::acceleration);
  for (const auto& [name, X] :
       {std::pair{"$a'$", a}, std::pair{"$b'$", b}, std::pair{"$c'$", c}, std::pair{"$m'$", m}}) {
    plot.label(name, X, O, Meaning::acceleration);
  }
  const auto along = [](const Place& P, const Place& Q, double t) {
    return Place{P.x + t * (Q.x - P.x), P.y + t * (Q.y - P.y)};
  };
  plot.step(1, along(O, a, 0.3));
  plot.step(2, along(a, n, 0.8));
  plot.step(3, along(n, b, 0.25));
  plot.step(4, along(O, b, 0.35));
  plot.step(5, c);
  plot.step(6, m);
}

drawings::Box polygon_extent(const Drawn& f, const Scale& scale) {
  Extent extent;
  const Place a = tip(f.a_A);
  for (const Place& X : {Place{0, 0}, a, after(a, f.a_BA_n), tip(f.a_B), tip(f.a_C), tip(f.a_M), tip(f.a_A_n)}) {
    extent.include(scale, X, 11);
  }
  return extent.box();
}

drawings::VectorEquation equation_of_B(const Drawn& f, Language language) {
  const std::string tangential = is_zero(f.instant.alpha_2) ? "0" : "$α_{2}$·$A_{0}A$";
  return {{{"$\\vec{a}_{B}$", parallel_to_guide(f.instant, language), "?", ""},
           {"$\\vec{a}^{n}_{A}$", "∥ $AA_{0}$", "$ω^{2}_{2}$·$A_{0}A$", "="},
           {"$\\vec{a}^{t}_{A}$", "⊥ $A_{0}A$", tangential, "+"},
           {"$\\vec{a}^{n}_{BA}$", "∥ $BA$", "$ω^{2}_{3}$·$AB$", "+"},
           {"$\\vec{a}^{t}_{BA}$", "⊥ $BA$", "?", "+"}}};
}

drawings::Steps steps(Language language) {
  if (language == Language::english) {
    return {
        {"From $O_{a}$ the known $\\vec{a}_{A}$, from $A$ towards $A_{0}$ (and its tangential part, when $α_{2}$ is "
         "not zero).",
         "From $a'$ the normal part $ω^{2}_{3}$·$AB$, from $B$ towards $A$; $ω_{3}$ from the velocities.",
         "The line square to $AB$: it carries $\\vec{a}^{t}_{BA}$.",
         "Through $O_{a}$ the line parallel to the guide. The two meet in $b'$; $α_{3}$ = $a^{t}_{BA}$ / $AB$.",
         "$c'$: the triangle $a'b'c'$ is similar to $ABC$, in the same sense: $a_{CA}$ : $a_{BA}$ = $AC$ : $AB$, "
         "turned by the same $γ$.",
         "$m'$ halves $a'b'$, as $M$ halves $AB$."}};
  }
  return {
      {"Da $O_{a}$ la $\\vec{a}_{A}$ nota, da $A$ verso $A_{0}$ (e la parte tangenziale, se $α_{2}$ non è nulla).",
       "Da $a'$ la parte normale $ω^{2}_{3}$·$AB$, da $B$ verso $A$; $ω_{3}$ dalle velocità.",
       "La normale ad $AB$: la retta d'azione della $\\vec{a}^{t}_{BA}$.",
       "Per $O_{a}$ la parallela alla guida. Le due si incontrano in $b'$; $α_{3}$ = $a^{t}_{BA}$ / $AB$.",
       "$c'$: il triangolo $a'b'c'$ è simile ad $ABC$, nello stesso verso: $a_{CA}$ : $a_{BA}$ = $AC$ : $AB$, "
       "ruotata dello stesso $γ$.",
       "$m'$ è il punto medio di $a'b'$, come $M$ di $AB$."}};
}

drawings::Table results(const Drawn& f, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  drawings::Table table{{"$X$", "$a_{X}$ (m/s²)"}, {}};
  for (const CouplerPoint& X : f.coupler.points) {
    table.rows.push_back({"$" + X.letter + "$", num(std::hypot(X.a.x, X.a.y))});
  }
  return table;
}

}  // namespace

void draw_polar_diagram(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const drawings::Box room = room_above_scale_bars(request);
  const double divide = room.high.y - mechanism_share * room.height();
  const Scale lengths = draw_small_slider_crank(onto, f.at, f.instant, {{room.low.x, divide}, room.high}, request);
  const Fit fit = fit_vectors({room.low, {room.high.x, divide}}, "m/s²", request.language,
                              room.width() / f.coupler.greatest_acceleration(),
                              [&](const Scale& scale) { return polygon_extent(f, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_sides(plot, f, request.language);
  draw_names(plot, f);
  add_scale_bars(onto, {lengths, plot.scale()}, request);

  const Language language = request.language;
  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(equation_of_B(f, language));
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(drawings::Paragraph{fmt::format("$ω_{{3}}$ = {} rad/s,  $α_{{3}}$ = {} rad/s²",
                                                   figures(f.coupler.omega_3, 4, language),
                                                   figures(f.coupler.alpha_3, 4, language))});
  column.push_back(results(f, language));
  std::vector<Value> values{{"α₃", f.coupler.alpha_3, "rad/s²"}};
  for (const CouplerPoint& X : f.coupler.points)
    values.push_back({"a_" + X.letter, std::hypot(X.a.x, X.a.y), "m/s²"});
  onto.sheet.description =
      in_words({"The polygon of the accelerations of the slider-crank, with the images of C and M",
                "Il poligono delle accelerazioni del manovellismo, con le immagini di C e M"},
               values, language);
}

}  // namespace epure::slider_crank_acceleration
