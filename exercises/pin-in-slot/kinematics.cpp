// Sheet 1: v_B = v_B* + v_rel as a polygon, the disc about its pole D, and the same by the relative pole P₂₃.
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/compare.h"
#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/pin-in-slot/figure.h"

namespace epure::pin_in_slot {
namespace {

constexpr double poles_share = 0.56;  // of the room's height

VectorPolygon velocity_polygon(const Drawn& f, Language language) {
  const Words guide{"∥ guide", "∥ guida"};
  return {.meaning = Meaning::velocity,
          .unit = "m/s",
          .origin = "$O_{v}$",
          .left = {{.quantity = "v_B",
                    .label = "$\\vec{v}_{B}$",
                    .direction = guide.in(language),
                    .magnitude = "?",
                    .v = f.v_B,
                    .along = {1, 0}}},
          .right = {{.quantity = "v_Bstar",
                     .label = "$\\vec{v}_{B*}$",
                     .direction = "⊥ $OB$",
                     .magnitude = f.omega == 0 ? "0" : "$ω$·$OB$",
                     .v = f.v_Bstar,
                     .tip = "$b*$"},
                    {.quantity = "b_dot",
                     .label = "$\\vec{v}_{rel}$",
                     .direction = "∥ $OB$",
                     .magnitude = "?",
                     .v = f.v_rel,
                     .tip = "$b'$",
                     .along = f.slot}}};
}

// P₂₃ no farther than the figure is long: farther off it is told, not drawn.
bool has_relative_pole(const Plot& plot, const Drawn& f) { return f.P23 && plot.shows(*f.P23); }

void draw_poles(Plot& plot, const Drawn& f, int first_step) {
  plot.measures_abscissa("B_x", f.D, f.O);
  if (!has_relative_pole(plot, f)) return;
  const Place P = *f.P23;
  plot.long_segment(f.B, P, 4, Meaning::construction);
  plot.long_segment(f.D, P, 4, Meaning::axis);
  plot.right_angle(f.B, P, {f.B.x + f.slot.x, f.B.y + f.slot.y});
  plot.cross(P);
  plot.label("$P_{23}$", P, f.B, Meaning::locus);
  plot.measures_abscissa("P23_x", P, f.O);
  plot.step(first_step, {(f.B.x + P.x) / 2, (f.B.y + P.y) / 2});
}

std::vector<std::string> pole_steps(const Plot& plot, const Drawn& f, Language language) {
  const bool english = language == Language::english;
  const std::string last = english ? "The disc rolls: its pole is $D$, $ω_{d}$ = −$v_{B}$ / $R$ (counter-clockwise "
                                     "positive)."
                                   : "Il disco rotola: il suo polo è $D$, $ω_{d}$ = −$v_{B}$ / $R$ (positiva se "
                                     "antioraria).";
  if (!has_relative_pole(plot, f)) {
    return {last, english
                      ? "The normal to the slot in $B$ meets the guide too far off to be drawn: lever and disc have "
                        "their relative pole $P_{23}$ there."
                      : "La normale al glifo in $B$ incontra la guida troppo lontano per il disegno: lì glifo e "
                        "disco hanno il polo relativo $P_{23}$."};
  }
  return {english
              ? "The normal to the slot in $B$ meets the guide $OD$ in $P_{23}$, the pole of the disc relative to "
                "the lever: $ω_{d}$·$DP_{23}$ = −$ω$·$OP_{23}$."
              : "La normale al glifo in $B$ incontra la guida $OD$ in $P_{23}$, polo del moto relativo di glifo "
                "e disco: $ω_{d}$·$DP_{23}$ = −$ω$·$OP_{23}$.",
          last};
}

// ω_d as measured on the polygon, and on the figure with the poles.
std::vector<Comparison> comparisons(const DrawnSheet& drawn, const Drawn& f) {
  const Readings read(drawn);
  if (!read.has("P23_x") || !read.is_unit("v_B")) return {};
  const double DP23 = read["P23_x"] - read["B_x"], by_polygon = read["v_B"] / f.B.y;
  if (!read.is_unit(DP23, "P23_x")) return {};
  return {{"|$ω_{d}$| (rad/s)", by_polygon, std::abs(f.omega) * read["P23_x"] / DP23}};
}

}  // namespace

void draw_kinematics(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const drawings::Box room = room_above_scale_bars(request);
  const double divide = room.high.y - poles_share * room.height();
  const VectorPolygon polygon = velocity_polygon(f, language);
  const Fit above = fit_mechanism(f, {{room.low.x, divide}, room.high}, request);
  Plot mechanism(onto, above.origin, above.scale);
  draw_mechanism(mechanism, f);
  const int pole_step = steps_of_sides(polygon) + 1;
  draw_poles(mechanism, f, pole_step);
  const Fit below = fit_polygon(polygon, {room.low, {room.high.x, divide}}, language);
  Plot plot(onto, below.origin, below.scale);
  draw_polygon(plot, polygon);
  add_scale_bars(onto, {above.scale, below.scale}, request);

  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(equation(polygon));
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  std::vector<std::string> lines = steps_of(polygon, language);
  for (const std::string& line : pole_steps(mechanism, f, language)) lines.push_back(line);
  column.push_back(drawings::Steps{lines});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  const auto num = [&](double x) { return figures(x, 4, language); };
  column.push_back(drawings::Paragraph{fmt::format("$v_{{B}}$ = {} m/s,  $v_{{rel}}$ = {} m/s,  $ω_{{d}}$ = {} rad/s",
                                                   num(f.v_B.x), num(f.b_dot), num(f.omega_disc))});
  if (const auto rows = comparisons(onto, f); !rows.empty()) {
    column.push_back(comparison_table(rows, {"polygon", "poligono"}, {"poles", "poli"}, language));
  }
  onto.sheet.description =
      in_words({"The slotted lever with the disc it rolls, and the polygon of the velocities of the pin B",
                "Il glifo con il disco che fa rotolare, e il poligono delle velocità del piolo B"},
               {{"v_B", f.v_B.x, "m/s"}, {"v_rel", f.b_dot, "m/s"}, {"ω_d", f.omega_disc, "rad/s"}}, language);
}

}  // namespace epure::pin_in_slot
