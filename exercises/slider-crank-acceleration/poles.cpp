// Sheet 3: accelerations by the method of poles: proportional to the distance from K, at the angle γ to the ray.
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/compare.h"
#include "exercises/kit/fit.h"
#include "exercises/kit/sheet.h"
#include "exercises/slider-crank-acceleration/exercise.h"

namespace epure::slider_crank_acceleration {
namespace {

// K is drawn when it lies no farther away than the figure can bear.
bool shows_K(const Drawn& f) { return f.K && std::hypot(f.K->x - f.at.A.x, f.K->y - f.at.A.y) < 4 * reach(f.at); }

drawings::Box extent(const Drawn& f, const Scale& lengths, const Scale& accelerations) {
  Extent extent;
  include_slider_crank(extent, lengths, f.at);
  if (shows_K(f)) extent.include(lengths, *f.K, 10);
  for (const Followed& X : followed(f)) {
    const double x = lengths.mm_per_unit * X.at.x + accelerations.mm_per_unit * X.a.x;
    const double y = lengths.mm_per_unit * X.at.y + accelerations.mm_per_unit * X.a.y;
    extent.include(x - 7, y - 7);
    extent.include(x + 7, y + 7);
  }
  return extent.box();
}

void draw_rays(Plot& plot, const Drawn& f) {
  for (const Followed& X : followed(f)) {
    plot.segment(*f.K, X.at, Meaning::construction);
    plot.measures(X.distance_from_K, *f.K, X.at);
  }
  plot.cross(*f.K, Meaning::acceleration);
  plot.label("$K$", *f.K, f.at.M, Meaning::acceleration);
  plot.measures_coordinates("K", *f.K, f.at.A0);
}

// γ at C: from the ray CK to the acceleration.
void mark_gamma(Plot& plot, const Drawn& f) {
  const drawings::Point c = plot.at(f.at.C), k = plot.at(*f.K), tip = plot.at(plot.tip(f.at.C, f.a_C));
  const double ray = std::atan2(k.y - c.y, k.x - c.x), vector = std::atan2(tip.y - c.y, tip.x - c.x);
  const double turn = std::remainder(vector - ray, 2 * M_PI);
  constexpr double radius = 13, shortest_arc = 2;      // mm
  if (std::abs(turn) * radius < shortest_arc) return;  // no arc to see: at a dead centre γ = 0
  plot.mark(
      drawings::AngleMark{c, radius, turn > 0 ? ray : ray + turn, turn > 0 ? ray + turn : ray, Meaning::dimension});
  const double middle = ray + turn / 2;
  plot.label("$γ$", plot.from_paper({c.x + radius * std::cos(middle), c.y + radius * std::sin(middle)}), f.at.C);
}

drawings::Steps steps(Language language) {
  if (language == Language::english) {
    return {{"$K$ from the two circles (sheet 2). At $K$ the acceleration is zero.",
             "$a_{A}$ = $KA$·√($α^{2}_{3}$ + $ω^{4}_{3}$), known: the factor is $a_{A}$ / $KA$.",
             "$a_{X}$ = ($KX$ / $KA$)·$a_{A}$ for every point $X$ of the coupler.",
             "All are inclined to their rays $XK$ by the same $γ$, tan $γ$ = $α_{3}$ / $ω^{2}_{3}$."}};
  }
  return {{"$K$ dalle due circonferenze (foglio 2). In $K$ l'accelerazione è nulla.",
           "$a_{A}$ = $KA$·√($α^{2}_{3}$ + $ω^{4}_{3}$), nota: il fattore è $a_{A}$ / $KA$.",
           "$a_{X}$ = ($KX$ / $KA$)·$a_{A}$ per ogni punto $X$ della biella.",
           "Tutte sono inclinate dello stesso $γ$ sui raggi $XK$, tan $γ$ = $α_{3}$ / $ω^{2}_{3}$."}};
}

drawings::Table results(const Drawn& f, Language language) {
  drawings::Table table{{"$X$", "$KX$ (m)", "$a_{X}$ (m/s²)"}, {}};
  for (const Followed& X : followed(f)) {
    const double KX = f.K ? std::hypot(f.K->x - X.at.x, f.K->y - X.at.y) : 0;
    table.rows.push_back(
        {"$" + X.symbol + "$", f.K ? figures(KX, 4, language) : "∞", figures(std::hypot(X.a.x, X.a.y), 4, language)});
  }
  return table;
}

// By poles from the rays measured here; by the polar diagram as measured there.
std::vector<Comparison> comparisons(const DrawnSheet& here, const Drawn& f, const SheetRequest& request) {
  DrawnSheet other;
  other.sheet.paper = request.paper;
  SheetRequest own_scale = request;
  own_scale.scale.reset();
  draw_polar_diagram(other, f, own_scale);
  const Readings poles(here), diagram(other);
  std::vector<Comparison> rows;
  if (!poles.is_unit("KA")) return rows;
  const double a_A = std::hypot(f.a_A.x, f.a_A.y);
  for (const char* X : {"B", "C", "M"}) {
    rows.push_back({fmt::format("$a_{{{}}}$ (m/s²)", X), poles[fmt::format("K{}", X)] / poles["KA"] * a_A,
                    diagram[fmt::format("a_{}", X)]});
  }
  return rows;
}

}  // namespace

void draw_poles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  constexpr double longest_vector = 45;  // mm
  const Language language = request.language;
  const bool english = language == Language::english;
  const Scale accelerations = largest_vector_scale(longest_vector / greatest_acceleration(f), "m/s²", language);
  const Fit fit = fit_lengths(room_above_scale_bars(request), request, 1000 / reach(f.at),
                              [&](const Scale& lengths) { return extent(f, lengths, accelerations); });
  Plot plot(onto, fit.origin, fit.scale);
  plot.vectors_at(accelerations);
  if (shows_K(f)) draw_rays(plot, f);
  draw_slider_crank(plot, f.at, f.omega_2);
  for (const Followed& X : followed(f)) {
    plot.vector_on(X.acceleration, X.at, X.a, Meaning::acceleration, fmt::format("$\\vec{{a}}_{{{}}}$", X.symbol));
  }
  if (shows_K(f)) {
    mark_gamma(plot, f);
    plot.step(1, *f.K);
    plot.step(2, {(f.K->x + f.at.A.x) / 2, (f.K->y + f.at.A.y) / 2});
    plot.step(3, plot.tip(f.at.C, f.a_C));
    plot.step(4, f.at.C);
  }
  add_scale_bars(onto, {plot.scale(), accelerations}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(results(f, language));
  if (const auto rows = comparisons(onto, f, request); !rows.empty()) {
    column.push_back(drawings::Heading{english ? "The two methods, as measured" : "I due metodi, come misurati"});
    column.push_back(comparison_table(rows, {"poles", "poli"}, {"diagram", "diagramma"}, language));
  }
  std::vector<Value> values;
  for (const Followed& X : followed(f)) values.push_back({X.acceleration, std::hypot(X.a.x, X.a.y), "m/s²"});
  onto.sheet.description =
      in_words({"Accelerations of A, B, C and M, proportional to their distances from the acceleration pole K",
                "Accelerazioni di A, B, C e M, proporzionali alle distanze dal polo delle accelerazioni K"},
               values, language);
}

}  // namespace epure::slider_crank_acceleration
