// Sub-exercise 2: the slider-crank with its crank square to the guide. The coupler translates for the instant, and
// both circles have become lines. Crank and crank speed are 1: lengths are multiples of r.
#include "exercises/four-bar/linkage.h"
#include "exercises/four-bar/slider_crank_square.h"
#include "exercises/kit/panels/polygon_panel.h"

namespace epure::four_bar {
namespace {

std::string named(const std::string& name) { return slider_crank_case + name; }

Mechanism slider_crank(const Solution& s) {
  using Joint = Mechanism::Joint;
  Mechanism mechanism;
  mechanism.point("A0", s.place(named("A0")), Joint::fixed, "$A_{0}$")
      .point("A", s.place(named("A")), Joint::hinge, "$A$")
      .point("B", s.place(named("B")), Joint::block, "$B$")
      .body({"A0", "A"}, 2)
      .body({"A", "B"}, 3)
      .guide("B", 0)
      .axis(mechanism.at("A0"), mechanism.at("B"))
      .path("A0", "A")
      .turning("A0", "A", 1, "$ω_{2}$")
      .turning_found("A", "B", s[named("alpha_3_over_omega_2_squared")], "$α_{3}$");
  return mechanism;
}

// Of lengths in r, at the scale of which ω₂r is as long as r.
class LinesPanel : public Panel {
 public:
  explicit LinesPanel(const Solution& s)
      : mechanism_(slider_crank(s)),
        K_(s.place(named("K"))),
        v_A_(s.vector(named("v_A"))),
        v_B_(s.vector(named("v_B"))) {}

  bool is_of_vectors() const override { return true; }
  std::optional<Place> start() const override { return {}; }
  Vectors vectors() const override {
    return {.unit = "$r$", .longest = mechanism_.reach(), .longest_on_paper = 1000};
  }
  drawings::Box extent(const Scale&, const Scale& scale) const override {
    Extent extent;
    mechanism_.include(extent, scale);
    extent.include(scale, K_ + Arrow2{beyond, beyond}, 6);
    return extent.box();
  }

  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_.draw_given(plot); }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override {
    const Place &A0 = mechanism_.at("A0"), &A = mechanism_.at("A"), &B = mechanism_.at("B");
    const Place end_of_f{K_.x, K_.y + beyond}, end_of_s{K_.x + beyond, K_.y};
    plot.mark(drawings::Line{drawings::segment(plot.at({B.x, -beyond}), plot.at(end_of_f)), Meaning::locus,
                             "inflection_line"});
    plot.mark(drawings::Line{drawings::segment(plot.at({-1.1, A.y}), plot.at(end_of_s)), Meaning::second_locus,
                             "stationarity_line"});
    plot.label("$f$", end_of_f, B, Meaning::locus);
    plot.label("$s$", end_of_s, A, Meaning::second_locus);
    mechanism_.draw(plot);
    plot.cross(K_, Meaning::acceleration);
    plot.label("$K$", K_, A0, Meaning::acceleration);
    plot.right_angle(K_, B, A);
    plot.vector_on("", A, v_A_, Meaning::velocity, velocity("A").arrow());
    plot.vector_on(named("v_B_over_omega_2_r"), B, v_B_, Meaning::velocity, velocity("B").arrow());
    plot.measures_abscissa(named("B_x_over_r"), B, A0);
    plot.measures_abscissa(named("K_x_over_r"), K_, A0);
    return {};
  }

  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    return {{{"The crank is perpendicular to the guide, $P_{31}$ at infinity: $ω_{3}$ = 0 and $\\vec{v}_{A}$ = "
              "$\\vec{v}_{B}$ (drawn as long as $r$). The inflection circle passes through $B$, whose path is "
              "straight: it has become the line $f$ through $B$ perpendicular to the guide.",
              "La manovella è normale alla guida, $P_{31}$ all'infinito: $ω_{3}$ = 0 e $\\vec{v}_{A}$ = "
              "$\\vec{v}_{B}$ (disegnate lunghe $r$). La circonferenza dei flessi passa per $B$, la cui traiettoria "
              "è retta: è diventata la retta $f$ per $B$ normale alla guida."},
             Place{K_.x, K_.y + 0.6 * beyond}},
            {{"The stationarity circle passes through $A$, whose acceleration is all normal: it has become the line "
              "$s$ through $A$ parallel to the guide.",
              "La circonferenza di stazionarietà passa per $A$, la cui accelerazione è tutta normale: è diventata la "
              "retta $s$ per $A$ parallela alla guida."},
             Place{K_.x / 2, K_.y}},
            {{"They meet at $K$, the acceleration pole. With $ω_{3}$ = 0 every acceleration is perpendicular to its "
              "ray: $a_{X}$ = $α_{3}$·$KX$, hence $α_{3}$ = $a_{A}$ / $KA$ and $a_{B}$ = $α_{3}$·$KB$.",
              "Si incontrano in $K$, il polo delle accelerazioni. Con $ω_{3}$ = 0 ogni accelerazione è normale al "
              "suo raggio: $a_{X}$ = $α_{3}$·$KX$, perciò $α_{3}$ = $a_{A}$ / $KA$ e $a_{B}$ = $α_{3}$·$KB$."},
             K_}};
  }

 private:
  static constexpr double beyond = 0.5;  // of r: how far the lines run on past K

  Mechanism mechanism_;
  Place K_;
  Arrow2 v_A_, v_B_;
};

// Checks K: the same a_B.
VectorPolygon accelerations(const Solution& s, Language language) {
  const auto side = [&](const std::string& of, const std::string& direction, const std::string& magnitude,
                        const std::string& tip) {
    const VectorQuantity quantity = of == "BA" ? tangential_acceleration(of) : acceleration(of);
    return PolygonSide{.label = quantity.arrow(),
                       .direction = direction,
                       .magnitude = magnitude,
                       .v = s.vector(named("a_" + of)),
                       .tip = tip};
  };
  VectorPolygon polygon =
      acceleration_polygon({side("B", Words{"∥ guide", "∥ guida"}.in(language), "?", "")},
                           {side("A", "∥ $AA_{0}$", "$ω^{2}_{2}r$", "$a'$"), side("BA", "⊥ $AB$", "?", "$b'$")});
  polygon.left.front().quantity = named("a_B_over_omega_2_squared_r");
  polygon.unit = "$ω^{2}_{2}r$";
  return polygon;
}

}  // namespace

PanelSheet slider_crank_sheet(const Solution& s, Language language) {
  return {.panels = panels(LinesPanel(s), PolygonPanel(s, accelerations(s, language))),
          .first = {{{"Letters", "Simboli"},
                     {remark(Words{"$r$ = $A_{0}A$, $λ$ = $AB$ / $r$, $ω_{2}$ constant. Lengths are told in $r$, "
                                   "velocities in $ω_{2}r$, accelerations in $ω^{2}_{2}r$.",
                                   "$r$ = $A_{0}A$, $λ$ = $AB$ / $r$, $ω_{2}$ costante. Le lunghezze sono in $r$, le "
                                   "velocità in $ω_{2}r$, le accelerazioni in $ω^{2}_{2}r$."}
                                 .in(language))}}},
          .results = {values({named("B_x_over_r"), named("K_x_over_r"), named("K_y_over_r")}),
                      values({named("alpha_3_over_omega_2_squared")}),
                      values({named("v_B_over_omega_2_r"), named("a_B_over_omega_2_squared_r")})},
          .seen = {"Slider-crank with the crank perpendicular to the guide: inflection and stationarity circle are "
                   "lines that meet at K",
                   "Manovellismo con la manovella normale alla guida: le circonferenze dei flessi e di stazionarietà "
                   "sono rette che si incontrano in K"},
          .told = {named("B_x_over_r"), named("alpha_3_over_omega_2_squared")},
          .without_part = {"A0A", "AB", "B0B", "x_B0", "y_B0", "branch", "AC", "C_side", "n", "t", "phi", "alpha_2"}};
}

}  // namespace epure::four_bar
