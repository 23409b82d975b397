// Sheet 6: the path of the coupler point P, its circuit traced within a stated distance, with the circle that
// osculates it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/panels/locus_panel.h"
#include "exercises/kit/panels/rounded.h"
#include "geometry/curves/four_bar_loci.h"
#include "geometry/mechanisms/change_point.h"
#include "geometry/mechanisms/grashof.h"

namespace epure::four_bar_analytic {
namespace {

using geometry::Deep;

constexpr int crank_positions = 12;

bool is_on_AB(const Problem& of) {
  return of.AP_across == 0 && of.AP_along >= 0 && of.AP_along <= of.instant.lengths.AB;
}

// The crank's circle divided; a division in which the linkage does not close is left out. The bar AB in each; of a
// plate only AP, for twelve triangles hide what they show.
std::vector<LocusPanel::Position> divided_positions(const Problem& of) {
  return deeply([&] {
    std::vector<LocusPanel::Position> found;
    for (int k = 0; k < crank_positions; ++k) {
      FourBarInstant there = of.instant;
      there.crank = Angle{Rational(k, crank_positions)};
      try {
        const auto at = there.position<Deep>();
        const Place A0{0, 0}, A = to_double(at.A), B = to_double(at.B), P = to_double(coupler_point(of, at));
        const Place outside = B + (B - Place{to_double(at.B0).x, to_double(at.B0).y});  // of B's way, where AB are
        const std::string number = std::to_string(k);
        found.push_back(
            {{A, is_on_AB(of) ? B : P},
             {{number, A, A0, Meaning::construction},
              {number + "'", B, outside, Meaning::construction},
              {number, P, {(A.x + B.x) / 2 + (A.x - P.x) / 2, (A.y + B.y) / 2 + (A.y - P.y) / 2}, Meaning::locus}}});
      } catch (const geometry::Impossible&) {
      } catch (const geometry::Undecided&) {
        // Flat, or at a limit position.
      }
    }
    return found;
  });
}

// Past a limit position, where the crank turns back, B goes on to the other side: one circuit of two parts.
LocusPanel::DrawCurve path_of(const Problem& of) {
  return [of](Plot& plot, const drawings::Box& room) {
    const auto draw = [&](geometry::Side side, Meaning ink, const char* name) {
      const geometry::FourBarCouplerCurve curve{of.instant.lengths, side, of.AP_along, of.AP_across};
      return draw_locus(plot, curve, room, ink, name);
    };
    const geometry::Side side = of.instant.side;
    const geometry::Trace path = draw(side, Meaning::locus, "path_of_P");
    if (!geometry::crank_turns_fully(of.instant.lengths))
      draw(geometry::opposite(side), Meaning::second_locus, "path_of_P_other_side");
    return path;
  };
}

Words where_the_centre_is(const Solution& s) {
  if (s.point("curvature_centre_P"))
    return {"$Ω_{P}$, by Euler-Savary as for $G_{3}$; thin: the circle that osculates the path now.",
            "$Ω_{P}$, con Euler-Savary come per $G_{3}$; sottile: il cerchio osculatore."};
  if (s["v_P"] == 0)
    return {
        "Now $P$ is the pole $P_{0}$ and at rest: the path has a cusp or goes back on itself; no ray leads to "
        "$Ω_{P}$.",
        "Ora $P$ è il polo $P_{0}$, fermo: la traiettoria ha una cuspide o torna su sé stessa; nessun raggio porta a "
        "$Ω_{P}$."};
  return {"Now the path is straight: $Ω_{P}$ is at infinity.",
          "Ora la traiettoria è diritta: $Ω_{P}$ è all'infinito."};
}

std::vector<PanelStep> steps_to_curve(const Solution& s, const std::vector<LocusPanel::Position>& all) {
  const auto place = [&](std::size_t share, std::size_t point) -> std::optional<Place> {
    if (all.empty()) return {};
    return all[all.size() * share / crank_positions].points[point].at;
  };
  return {{format_words("The crank's circle in {} parts from +$x$: positions of $A$.",
                        "La circonferenza di manovella in {} parti da +$x$: le posizioni di $A$.", crank_positions),
           place(7, 0)},
          {{"$B$ about $A$ and $B_{0}$ (primed); on tracing paper $P$ goes with $AB$ and marks a point.",
            "$B$ da $A$ e $B_{0}$ (con l'apice); su carta da lucido $P$ va con $AB$ e segna un punto."},
           place(2, 2)},
          {{"The curve through the points: the path of $P$.", "La curva per i punti: la traiettoria di $P$."},
           place(5, 2)},
          {where_the_centre_is(s), s.point("curvature_centre_P")}};
}

// The rocker's way reaches all positions of B.
Mechanism with_P(const Solution& s, const Problem& of, const std::vector<LocusPanel::Position>& positions) {
  Mechanism mechanism = linkage(s, {"P"}, false);
  mechanism.unnumbered();
  if (!is_on_AB(of)) mechanism.body({"A", "B", "P"});
  const Place &B0 = mechanism.at("B0"), &B = mechanism.at("B");
  for (const LocusPanel::Position& position : positions) {
    const double turned =
        std::remainder(direction(B0, position.points[1].at) - direction(B0, B), 2 * std::numbers::pi);
    mechanism.swing("B0", "B", std::min(0.0, turned), std::max(0.0, turned));
  }
  return mechanism;
}

}  // namespace

PanelSheet coupler_curve_sheet(const Solution& s, Language language) {
  const Problem of = problem(s.givens());
  const std::vector<LocusPanel::Position> positions = divided_positions(of);
  LocusPanel panel(std::make_shared<const Mechanism>(with_P(s, of, positions)), "P", positions, path_of(of),
                   steps_to_curve(s, positions));
  panel.osculated(s.point("curvature_centre_P"), "curvature_centre_P", "$Ω_{P}$");
  LocusPanel whole = panel;
  const Words past_limit = geometry::crank_turns_fully(of.instant.lengths)
                               ? Words{}
                               : Words{
                                     "The crank cannot turn fully: at its limit positions the path goes on with $B$ "
                                     "on the other side of $AB_{0}$ (second line type).",
                                     "La manovella non fa il giro completo: alle posizioni limite la traiettoria "
                                     "continua con $B$ dall'altro lato di $AB_{0}$ (secondo tipo di linea)."};
  const Words flat = geometry::flat_positions(of.instant.lengths).empty()
                         ? Words{}
                         : Words{
                               "With all hinges in one line the linkage is at a change point: the path has a corner "
                               "there, and no number.",
                               "Con tutte le cerniere allineate il meccanismo è in un punto di cambiamento: lì la "
                               "traiettoria ha uno spigolo, senza numero."};
  const std::string none = s["v_P"] == 0 ? "–" : "∞";
  return {.panels = panel.needs_close_up() ? panels(whole.beside_close_up(), panel.close_up()) : panels(panel),
          .legend = {remark(Words{"$P$: at $P_{∥}$ from $A$ along $AB$, and at $P_{⊥}$ to the left of it.",
                                  "$P$: a $P_{∥}$ da $A$ lungo $AB$, e a $P_{⊥}$ alla sua sinistra."}
                                .in(language))},
          .results = {remark(past_limit.in(language)), remark(flat.in(language)),
                      table({"", "$x$", "$y$"},
                            {{"$P$ (m)", {"P_x", "P_y"}},
                             {"$v_{P}$ (m/s)", {"v_P_x", "v_P_y"}},
                             {"$a_{P}$ (m/s²)", {"a_P_x", "a_P_y"}},
                             {"$Ω_{P}$ (m)", {"curvature_centre_P_x", "curvature_centre_P_y"}, none}}),
                      values({"rho_P"})},
          .seen = {"The path of the coupler point P, in twelve positions of the crank; P now",
                   "La traiettoria del punto di biella P, in dodici posizioni della manovella; P ora"},
          .told = {"P_x", "P_y"}};
}

}  // namespace epure::four_bar_analytic
