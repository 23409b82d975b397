// Sheets 3 and 4: velocities and accelerations of the links' midpoints, drawn where they act.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/four-bar-constraints/exercise.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::four_bar_constraints {
namespace {

struct Vectors {
  std::string letter, unit;  // "v", "m/s"
  Meaning meaning;
  std::vector<Arrow2> of;  // G₂, G₃, G₄
  std::vector<std::string> formulas;
  Words description;
};

double greatest(const Vectors& all) {
  double size = 0;
  for (const Arrow2& v : all.of) size = std::max(size, magnitude(v));
  return size;
}

drawings::Box extent(const Drawn& f, const Vectors& all, const Scale& scale, const Scale& of_vectors) {
  Extent extent;
  f.figure.include(extent, scale);
  for (std::size_t i = 0; i < all.of.size(); ++i) {
    const double units = of_vectors.mm_per_unit / scale.mm_per_unit;
    const Place G = f.figure.points.at(i).at;
    extent.include(scale, {G.x + units * all.of[i].x, G.y + units * all.of[i].y}, 9);
  }
  return extent.box();
}

void draw(DrawnSheet& onto, const Drawn& f, const Vectors& all, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  constexpr double longest = 60;  // mm, of a vector
  const Scale of_vectors = largest_vector_scale(longest / greatest(all), all.unit, language);
  const Fit fit = fit_lengths(room_above_scale_bars(request), request, 1000 / f.figure.reach(),
                              [&](const Scale& scale) { return extent(f, all, scale, of_vectors); });
  Plot plot(onto, fit.origin, fit.scale);
  plot.vectors_at(of_vectors);
  f.figure.draw(plot);
  const std::vector<std::string> names{"G2", "G3", "G4"};
  for (std::size_t i = 0; i < all.of.size(); ++i)
    plot.vector_on(all.letter + "_" + names[i], f.figure.points.at(i).at, all.of[i], all.meaning,
                   "$\\vec{" + all.letter + "}_{" + names[i] + "}$");
  add_scale_bars(onto, {plot.scale(), of_vectors}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Differentiated constraints" : "Vincoli derivati"});
  for (const std::string& line : all.formulas) column.push_back(drawings::Paragraph{line});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  const auto num = [&](double x) { return figures(x, 6, language); };
  drawings::Table table{{"", "x", "y", "$" + all.letter + "$ (" + all.unit + ")"}, {}};
  std::vector<Value> values;
  for (std::size_t i = 0; i < all.of.size(); ++i) {
    const double size = magnitude(all.of[i]);
    table.rows.push_back({f.figure.points.at(i).letter, num(all.of[i].x), num(all.of[i].y), num(size)});
    values.push_back({all.letter + "_" + names[i], size, all.unit});
  }
  column.push_back(table);
  onto.sheet.description = in_words(all.description, values, language);
}

std::string value_line(const char* first, double first_value, const char* second, double second_value,
                       const char* unit, Language language) {
  return fmt::format("{} = {} {},  {} = {} {}", first, figures(first_value, 6, language), unit, second,
                     figures(second_value, 6, language), unit);
}

}  // namespace

void draw_velocities(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  draw(onto, f,
       {.letter = "v",
        .unit = "m/s",
        .meaning = Meaning::velocity,
        .of = {f.motion.v_G2, f.motion.v_G3, f.motion.v_G4},
        .formulas = {"($ω_{3}$, $ω_{4}$) = − $ψ^{−1}_{y}$ $ψ_{x}$ $ω_{2}$,  $ψ_{x}$ = ∂$ψ$/∂$θ_{2}$",
                     value_line("$ω_{3}$", f.compared.at(2).by_constraints, "$ω_{4}$",
                                f.compared.at(3).by_constraints, "rad/s", request.language)},
        .description = {"Velocities of the midpoints of the links", "Velocità delle mezzerie delle aste"}},
       request);
}

void draw_accelerations(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  draw(onto, f,
       {.letter = "a",
        .unit = "m/s²",
        .meaning = Meaning::acceleration,
        .of = {f.motion.a_G2, f.motion.a_G3, f.motion.a_G4},
        .formulas = {"($α_{3}$, $α_{4}$) = − $ψ^{−1}_{y}$ ($ψ_{x}$ $α_{2}$ + $(ψ_{y} y')_{y} y'$ + "
                     "$(ψ_{x} ω_{2})_{x} ω_{2}$)",
                     value_line("$α_{3}$", f.compared.at(4).by_constraints, "$α_{4}$",
                                f.compared.at(5).by_constraints, "rad/s²", request.language)},
        .description = {"Accelerations of the midpoints of the links", "Accelerazioni delle mezzerie delle aste"}},
       request);
}

}  // namespace epure::four_bar_constraints
