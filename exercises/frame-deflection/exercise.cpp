// A frame loaded at right angles to its plane: bending and torsion, and how far its end sinks.
#include "exercises/frame-deflection/routes.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/sum_panel.h"

namespace epure {
namespace frame_deflection {
namespace {

// With the polar moment of area for the torsion constant, which it is for circles alone.
double deflection_with_polar_moment() {
  const double L_1 = 1.2, L_2 = 0.8, phi = 0.05, s = 0.01, H = 0.05, P = 300, E = 210e9, G = E / 2.6;
  const double J_x1 = s * H * H * H / 12, J_y1 = H * s * s * s / 12, J_p1 = J_x1 + J_y1;
  const double J_x2 = 3.14159265358979323846 * phi * phi * phi * phi / 64, J_p2 = 2 * J_x2;
  return P * (2 * L_2 * L_2 * L_2 / (3 * E * J_x1) + L_1 * L_1 * L_2 / (G * J_p1) + L_1 * L_1 * L_1 / (3 * E * J_x2) +
              L_2 * L_2 * L_1 / (G * J_p2));
}

std::vector<Printed> printed_by_the_source() {
  const Words why{
      "the source takes J_p1 = J_x1 + J_y1, the polar moment of area, for the torsion constant of the rectangle; "
      "only of "
      "a circle are the two one",
      "la fonte prende J_p1 = J_x1 + J_y1, il momento polare, per la costante di torsione del rettangolo; le due "
      "coincidono soltanto per il cerchio"};
  return {{"G", "8.077×10^4 MPa", "analytic"},
          {"J_x1", "1.042×10^5 mm^4", "analytic"},
          {"J_x2", "3.068×10^5 mm^4", "analytic"},
          {"J_p2", "6.136×10^5 mm^4", "analytic"},
          {"M_z_bar_2", "240 N·m", "analytic"},
          {"U", "7.726 J", "virtual work", 0, Explanation{why, [] { return 150 * deflection_with_polar_moment(); }}},
          {"delta_A", "51.509 mm", "virtual work", 0, Explanation{why, deflection_with_polar_moment}}};
}

PanelSheet shares_sheet(const Solution& s, Language) {
  const auto part = [&](const std::string& name) { return Part{decimal(s.described(name).symbol), s[name], name}; };
  return {
      .panels = panels(SumPanel({{.name = {"Deflection of A", "Abbassamento di A"},
                                  .parts = {part("delta_bending_1"), part("delta_torsion_1"), part("delta_bending_2"),
                                            part("delta_torsion_2"), part("delta_bending_3")},
                                  .whole = part("delta_A"),
                                  .steps = {}}},
                                "m")),
      .results = {values({"delta_A"})},
      .seen = {"The five shares of the deflection of A", "Le cinque parti dell'abbassamento di A"},
      .told = {"delta_A", "U"}};
}

}  // namespace
}  // namespace frame_deflection

std::unique_ptr<Exercise> make_frame_deflection() {
  using namespace frame_deflection;
  Description about{.id = "frame-deflection",
                    .title = {"A frame loaded across its plane", "Un telaio caricato fuori del piano"},
                    .document = "pisa",
                    .item = "Quesito 1",
                    .source = {"Pisa, mid-term test of 14 June 2006, question 1",
                               "Pisa, verifica intermedia del 14/6/2006, quesito 1"},
                    .givens = stated_givens(),
                    .printed = printed_by_the_source()};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{problem(givens)}, rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"shares", {"Five shares of the deflection", "Cinque parti dell'abbassamento"}}, shares_sheet}});
}

}  // namespace epure
