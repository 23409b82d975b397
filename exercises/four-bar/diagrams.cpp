// The polar diagrams of velocity and acceleration, at the instant and at the dead centres.
#include <fmt/format.h>

#include <cmath>

#include "exercises/four-bar/figure.h"

namespace epure::four_bar {
namespace {

std::string rates_of_velocity(const Drawn& f, Language language) {
  return fmt::format("$ω_{{3}}$ = $v_{{BA}}$ / $AB$ = {} rad/s,  $ω_{{4}}$ = $v_{{B}}$ / $B_{{0}}B$ = {} rad/s",
                     figures(f.coupler.omega_3, 4, language), figures(f.omega_4, 4, language));
}
std::string rates_of_acceleration(const Drawn& f, Language language) {
  return fmt::format(
      "$α_{{3}}$ = $a^{{t}}_{{BA}}$ / $AB$ = {} rad/s²,  $α_{{4}}$ = $a^{{t}}_{{B}}$ / $B_{{0}}B$ = {} rad/s²",
      figures(f.coupler.alpha_3, 4, language), figures(f.alpha_4, 4, language));
}

drawings::Table table_of(const Drawn& f, bool velocity, Language language) {
  drawings::Table table{{"$X$", velocity ? "$v_{X}$ (m/s)" : "$a_{X}$ (m/s²)"}, {}};
  for (const CouplerPoint& X : f.coupler.points) {
    const Arrow2& v = velocity ? X.v : X.a;
    table.rows.push_back({"$" + X.letter + "$", figures(std::hypot(v.x, v.y), 4, language)});
  }
  return table;
}

void measure_components(Plot& plot, const Drawn& f, bool velocity) {
  const std::string letter = velocity ? "v_" : "a_";
  const Place O{0, 0};
  for (const CouplerPoint& X : f.coupler.points) {
    const Arrow2& v = velocity ? X.v : X.a;
    if (X.letter == "A") continue;
    plot.measures_coordinates(f.coupler.prefix + letter + X.letter, {v.x, v.y}, O);
    plot.measures(f.coupler.prefix + letter + X.letter, O, {v.x, v.y});
  }
}

}  // namespace

void draw_velocity_diagram(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const DiagramSheet shown{
      .mechanism = f.mechanism,
      .polygons = {f.velocity},
      .results = {rates_of_velocity(f, language)},
      .table = table_of(f, true, language),
      .description = {"The polygon of the velocities of the four-bar linkage, with the image of C",
                      "Il poligono delle velocità del quadrilatero articolato, con l'immagine di C"},
      .values = {{"ω₃", f.coupler.omega_3, "rad/s"}, {"ω₄", f.omega_4, "rad/s"}}};
  std::vector<Plot> plots = draw_diagram_sheet(onto, shown, request);
  measure_components(plots.front(), f, true);
}

void draw_acceleration_diagram(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const DiagramSheet shown{
      .mechanism = f.mechanism,
      .polygons = {f.acceleration},
      .results = {rates_of_acceleration(f, language)},
      .table = table_of(f, false, language),
      .description = {"The polygon of the accelerations of the four-bar linkage, with the image of C",
                      "Il poligono delle accelerazioni del quadrilatero articolato, con l'immagine di C"},
      .values = {{"α₃", f.coupler.alpha_3, "rad/s²"}, {"α₄", f.alpha_4, "rad/s²"}}};
  std::vector<Plot> plots = draw_diagram_sheet(onto, shown, request);
  measure_components(plots.front(), f, false);
}

void draw_dead_centre(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const DiagramSheet shown{
      .mechanism = f.mechanism,
      .polygons = {f.velocity, f.acceleration},
      .results = {rates_of_velocity(f, language), rates_of_acceleration(f, language)},
      .description =
          {"The four-bar linkage with its rocker at a dead centre: the polygons of velocity and acceleration",
           "Il quadrilatero articolato col bilanciere al punto morto: i poligoni di velocità e accelerazioni"},
      .values = {{"ω₃", f.coupler.omega_3, "rad/s"},
                 {"ω₄", f.omega_4, "rad/s"},
                 {"α₃", f.coupler.alpha_3, "rad/s²"},
                 {"α₄", f.alpha_4, "rad/s²"}}};
  std::vector<Plot> plots = draw_diagram_sheet(onto, shown, request);
  measure_components(plots.front(), f, true);
  measure_components(plots.back(), f, false);
}

}  // namespace epure::four_bar
