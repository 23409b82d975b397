// Sheet 1: B where the circles of coupler and rocker meet: both configurations, with the angles of the closure.
#include <fmt/format.h>

#include <cmath>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/panels/compass.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::four_bar_analytic {
namespace {

class ConfigurationsPanel : public Panel {
 public:
  explicit ConfigurationsPanel(const Solution& s)
      : mechanism_(linkage(s, {"G2", "G3", "G4"})), other_B_(s.place("other_B")) {
    mechanism_.angle_from_x("A0", "A", "$θ_{2}$")
        .angle_from_x("A", "B", "$θ_{3}$")
        .angle_from_x("B", "B0", "$θ_{4}$");
  }

  double reach() const override { return mechanism_.reach(); }
  drawings::Box extent(const Scale& scale, const Scale&) const override {
    Extent extent;
    mechanism_.include(extent, scale);
    extent.include(scale, other_B_, 9);
    return extent.box();
  }
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_.draw_given(plot); }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override {
    constexpr int first = 2, other = 3;  // the steps that find B and B'
    const Place &A = mechanism_.at("A"), &B = mechanism_.at("B"), &B0 = mechanism_.at("B0");
    for (const Place& centre : {A, B0}) {
      plot.in_step(first);
      compass_arc(plot, centre, B);
      plot.in_step(other);
      plot.segment(centre, other_B_, Meaning::alternative);
      compass_arc(plot, centre, other_B_);
    }
    plot.in_step({});
    mechanism_.draw(plot);
    plot.in_step(other);
    plot.hinge(other_B_);
    plot.label("$B'$", other_B_, B);
    plot.in_step({});
    for (const char* X : {"A", "B", "G2", "G3", "G4"})
      plot.measures_coordinates(X, mechanism_.at(X), mechanism_.at("A0"));
    return {};
  }
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override {
    return {
        {{"$A$ at $θ_{2}$ on the crank's circle.", "$A$ all'anomalia $θ_{2}$ sulla circonferenza di manovella."},
         mechanism_.at("A")},
        {{"Arcs about $A$ with $AB$ and about $B_{0}$ with $B_{0}B$ meet at $B$, on the given side of $A$ → $B_{0}$.",
          "Gli archi intorno ad $A$ con $AB$ e a $B_{0}$ con $B_{0}B$ si incontrano in $B$, dal lato dato di $A$ → "
          "$B_{0}$."},
         mechanism_.at("B")},
        {{"They meet again at $B'$, its mirror image in $AB_{0}$: the other configuration.",
          "Si incontrano ancora in $B'$, simmetrico rispetto ad $AB_{0}$: l'altra configurazione."},
         other_B_}};
  }

 private:
  Mechanism mechanism_;
  Place other_B_;
};

// "{0}" is the sine, "{1}" the tangent.
Result formula(const std::string& text, Language language) {
  return remark(fmt::format(fmt::runtime(text), Words{"sin", "sen"}.in(language), Words{"tan", "tg"}.in(language)));
}

}  // namespace

PanelSheet configurations_sheet(const Solution& s, Language language) {
  const auto row = [&](const std::string& name) {
    const Quantity& quantity = s.described(name);
    return Row{quantity.symbol + " (" + written_unit(quantity.unit, language) + ")", {name, name + "_other_branch"}};
  };
  const auto of = [&](const char* text) { return formula(text, language); };
  return {
      .panels = panels(ConfigurationsPanel(s)),
      .theory =
          {{{"Closure", "Chiusura"},
            {remark("$\\vec{r}_{2}$ + $\\vec{r}_{3}$ + $\\vec{r}_{4}$ − $\\vec{r}_{1}$ = 0"),
             remark("$r_{1}$ = $A_{0}B_{0}$, $r_{2}$ = $A_{0}A$, $r_{3}$ = $AB$, $r_{4}$ = $BB_{0}$"),
             of("$k_{{1}}$ cos $θ_{{4}}$ + $k_{{2}}$ {0} $θ_{{4}}$ + $k_{{3}}$ = 0;  $t$ = {1}($θ_{{4}}$/2):"),
             of("($k_{{3}}$ − $k_{{1}}$)$t^{{2}}$ + 2$k_{{2}}$$t$ + $k_{{3}}$ + $k_{{1}}$ = 0"),
             of("$k_{{1}}$ = −2$r_{{4}}$($r_{{1}}$ − $r_{{2}}$ cos $θ_{{2}}$),  $k_{{2}}$ = 2$r_{{2}}$$r_{{4}}$ {0} "
                "$θ_{{2}}$"),
             of("$k_{{3}}$ = $r^{{2}}_{{1}}$ + $r^{{2}}_{{2}}$ + $r^{{2}}_{{4}}$ − $r^{{2}}_{{3}}$ − "
                "2$r_{{1}}$$r_{{2}}$ cos $θ_{{2}}$"),
             values({"closure_k1", "closure_k2"}), values({"closure_k3"})}},
           {{"Rates", "Derivate"},
            {of("$s_{{\\it{{ij}}}}$ = {0}($θ_{{\\it{{i}}}}$ − $θ_{{\\it{{j}}}}$),  $c_{{\\it{{ij}}}}$ = "
                "cos($θ_{{\\it{{i}}}}$ − $θ_{{\\it{{j}}}}$)"),
             value_as("$p$ = $r_{2}α_{2}$,  $q_{\\it{i}}$ = $r_{\\it{i}}ω^{2}_{\\it{i}}$,  $ω_{2}$", "omega_2"),
             remark(
                 "$ω_{3}$ = −$r_{2}ω_{2}s_{24}$ / ($r_{3}s_{34}$),  $ω_{4}$ = −$r_{2}ω_{2}s_{23}$ / ($r_{4}s_{43}$)"),
             remark("$α_{3}$ = −($ps_{24}$ + $q_{2}c_{24}$ + $q_{3}c_{34}$ + $q_{4}$) / ($r_{3}s_{34}$)"),
             remark("$α_{4}$ = −($ps_{23}$ + $q_{2}c_{23}$ + $q_{3}$ + $q_{4}c_{43}$) / ($r_{4}s_{43}$)"),
             remark("$\\vec{r}_{G2}$ = ½$\\vec{r}_{2}$,  $\\vec{r}_{G3}$ = $\\vec{r}_{2}$ + ½$\\vec{r}_{3}$,  "
                    "$\\vec{r}_{G4}$ = $\\vec{r}_{1}$ − ½$\\vec{r}_{4}$"),
             remark("d$\\vec{r}_{\\it{i}}$/d$t$ = $\\vec{ω}_{\\it{i}}$ × $\\vec{r}_{\\it{i}}$,  "
                    "d$^{2}\\vec{r}_{\\it{i}}$/d$t^{2}$ = "
                    "$\\vec{α}_{\\it{i}}$ × $\\vec{r}_{\\it{i}}$ − $ω^{2}_{\\it{i}}\\vec{r}_{\\it{i}}$")}}},
      .results = {table(
          {"", "$B$", "$B'$"},
          {row("theta_3"), row("theta_4"), row("omega_3"), row("omega_4"), row("alpha_3"), row("alpha_4")}, 4)},
      .seen = {"Both configurations of the four-bar linkage, with the angles of its closure equations",
               "Le due configurazioni del quadrilatero articolato, con le anomalie delle equazioni di chiusura"},
      .told = {"theta_3", "theta_4", "omega_3", "omega_4"},
      .without_part = {"AP_along", "AP_across"}};
}

}  // namespace epure::four_bar_analytic
