// The sheets of accelerations: the polygon of a_A = a_O + a_AO^n + a_AO^t; K and the accelerations about it.
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/diagram_sheet.h"
#include "exercises/velocity-centre/exercise.h"

namespace epure::velocity_centre {
namespace {

drawings::Steps steps_at_K(Language language) {
  if (language == Language::english) {
    return {
        {"Rays through $O$ and $A$, at the angle $γ$ to $\\vec{a}_{O}$ and to $\\vec{a}_{A}$, tan $γ$ = "
         "(d$ω$/d$t$)/$ω^{2}$: they meet in $K$, where the acceleration is zero.",
         "$a_{O}$ = $KO$·√($ω^{4}$ + (d$ω$/d$t$)$^{2}$).",
         "So is $a_{A}$ with $KA$: $a_{A}$ : $a_{O}$ = $KA$ : $KO$.",
         "The same $γ$ stands at every point of the bar."}};
  }
  return {
      {"Raggi per $O$ e per $A$, all'angolo $γ$ dalla $\\vec{a}_{O}$ e dalla $\\vec{a}_{A}$, tan $γ$ = "
       "(d$ω$/d$t$)/$ω^{2}$: si incontrano in $K$, dove l'accelerazione è nulla.",
       "$a_{O}$ = $KO$·√($ω^{4}$ + (d$ω$/d$t$)$^{2}$).", "Così $a_{A}$ con $KA$: $a_{A}$ : $a_{O}$ = $KA$ : $KO$.",
       "Lo stesso $γ$ si trova in ogni punto della barra."}};
}

// Without K there is nothing to construct.
drawings::Steps steps_without_K(Language language) {
  return {{Words{"$ω$ and d$ω$/d$t$ are zero: every point has the acceleration of $O$, and $K$ is at infinity.",
                 "$ω$ e d$ω$/d$t$ sono nulle: ogni punto ha l'accelerazione di $O$, e $K$ è all'infinito."}
               .in(language)}};
}

}  // namespace

void draw_accelerations(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const Arrow2 a_A = f.A().a;
  DiagramSheet sheet{.mechanism = f.bar, .polygons = {f.accelerations}};
  sheet.results = {fmt::format("$\\vec{{a}}_{{A}}$ = ({}; {}) m/s²,  $a_{{A}}$ = {} m/s²",
                               figures(a_A.x, 4, language), figures(a_A.y, 4, language),
                               figures(magnitude(a_A), 4, language))};
  sheet.description = {"The bar on its body, and the polygon of the accelerations of A",
                       "La barra sul suo corpo, e il poligono delle accelerazioni di A"};
  sheet.values = {{"a_A", magnitude(a_A), "m/s²"}, {"a_A_x", a_A.x, "m/s²"}, {"a_A_y", a_A.y, "m/s²"}};
  const std::vector<Plot> plots = draw_diagram_sheet(onto, sheet, request);
  Plot plot = plots.front();
  plot.measures_coordinates("a_A", {a_A.x, a_A.y}, {0, 0});
  onto.sheet.column.push_back(measured_table(onto, f.accelerations, language));
}

void draw_acceleration_pole(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  draw_acceleration_pole_sheet(
      onto, f.motion, request,
      {f.motion.K ? steps_at_K(request.language) : steps_without_K(request.language),
       {"The bar on its body, its acceleration centre K, and the accelerations of O and A",
        "La barra sul suo corpo, il centro delle accelerazioni K, e le accelerazioni di O e A"}},
      [&](DrawnSheet& other, const SheetRequest& own_scale) { draw_accelerations(other, f, own_scale); });
}

}  // namespace epure::velocity_centre
