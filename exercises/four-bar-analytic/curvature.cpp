// Sheet 4: the inflection circle by A', B' and the inflection pole J, then G₃' on it and the centre of curvature of
// G₃'s path.
#include <cmath>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/panels/cut_panel.h"

namespace epure::four_bar_analytic {
namespace {

class CurvatureOfG3 : public CutPanel {
 public:
  explicit CurvatureOfG3(const Solution& s)
      : CutPanel(std::make_shared<const Mechanism>(linkage(s, {"G3"}))),
        A_(s.place("A")),
        B_(s.place("B")),
        G3_(s.place("G3")),
        P0_(s.point("P0")),
        A_prime_(P0_ ? s.point("Aprime") : std::nullopt),
        B_prime_(P0_ ? s.point("Bprime") : std::nullopt),
        G3_prime_(s.point("G3prime")),
        F_(s.point("inflection_centre")),
        J_(s.point("inflection_pole")),
        centre_(s.point("curvature_centre_G3")),
        inflection_(cycle_of(s, "inflection_centre", "inflection_diameter")) {
    if (centre_) osculating_ = circle_through(G3_, *centre_);
  }

  double reach() const override { return mechanism_->reach(); }

  std::vector<Place> lettered() const override {
    std::vector<Place> all = mechanism_->corners();
    for (const auto& P : {P0_, A_prime_, B_prime_, G3_prime_, F_, J_, centre_})
      if (P) all.push_back(*P);
    return all;
  }

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    draw_rays(plot, room, language);
    draw_perpendiculars(plot, room, language);
    constexpr int circle = 4, centre = 6;  // steps
    plot.in_step(circle);
    plot.cycle(inflection_, Meaning::locus, "inflection_circle");
    plot.in_step({});
    const Place A0 = mechanism_->corners().front();
    if (P0_) {
      draw_named(plot, P0_, "$P_{0}$", G3_);
      plot.measures_coordinates("P0", *P0_, A0);
      for (const auto& [name, X] : {std::pair{"P0A", A_}, std::pair{"P0B", B_}, std::pair{"P0G3", G3_}})
        plot.measures(name, *P0_, X);
      draw_diameter(plot, room, A0, language);
      if (G3_prime_) {
        plot.measures("G3prime_G3", *G3_prime_, G3_);
        plot.measures_coordinates("G3prime", *G3_prime_, A0);
      }
    }
    mechanism_->sketch(plot);
    plot.in_step(centre);
    draw_centre(plot, room, A0, language);
    const std::string off = left_out(plot, room, language);
    if (off.empty()) return {};
    return {drawings::Paragraph{off}};
  }

  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override {
    const auto at_end = [&](const Place& X, const std::optional<Place>& end) {
      return end ? std::optional(seen_end(plot, room, X, *end)) : std::nullopt;
    };
    if (!P0_)
      return {{{"Crank and rocker are parallel: $P_{0}$ is at infinity, the rays are parallel and there is no "
                "inflection circle.",
                "Manovella e bilanciere sono paralleli: $P_{0}$ è all'infinito, i raggi sono paralleli e non c'è "
                "circonferenza dei flessi."}},
              {{"$Ω_{G3}$ on the normal to $\\vec{v}_{G3}$, at $ρ_{G3}$ = $v^{2}_{G3}$ / $a^{n}_{G3}$.",
                "$Ω_{G3}$ sulla normale a $\\vec{v}_{G3}$, a $ρ_{G3}$ = $v^{2}_{G3}$ / $a^{n}_{G3}$."},
               at_end(G3_, centre_)}};
    return {{{"$P_{0}$, where the lines of crank and rocker meet.",
              "$P_{0}$, all'incontro delle rette di manovella e bilanciere."},
             P0_},
            {{"$A'$ on its ray: $P_{0}A^{2}$ = $A_{0}A$·$A'A$, on the side of $A_{0}$ seen from $A$.",
              "$A'$ sul suo raggio: $P_{0}A^{2}$ = $A_{0}A$·$A'A$, dalla parte di $A_{0}$ rispetto ad $A$."},
             at_end(A_, A_prime_)},
            {{"Likewise $B'$: $P_{0}B^{2}$ = $B_{0}B$·$B'B$.", "Analogamente $B'$: $P_{0}B^{2}$ = $B_{0}B$·$B'B$."},
             at_end(B_, B_prime_)},
            {{"The perpendiculars to the rays at $A'$ and $B'$ meet at $J$: the inflection circle has the diameter "
              "$P_{0}J$ and the centre $F$.",
              "Le normali ai raggi in $A'$ e $B'$ si incontrano in $J$: la circonferenza dei flessi ha il diametro "
              "$P_{0}J$ e il centro $F$."},
             at_end(*P0_, J_)},
            {{"$G'_{3}$, where the ray $P_{0}G_{3}$ meets it again.",
              "$G'_{3}$, dove il raggio $P_{0}G_{3}$ la incontra ancora."},
             at_end(G3_, G3_prime_)},
            {{"Euler-Savary: $P_{0}G^{2}_{3}$ = $Ω_{G3}G_{3}$·$G'_{3}G_{3}$ gives $Ω_{G3}$, on the side of $G'_{3}$. "
              "Thin: the osculating circle.",
              "Euler-Savary: $P_{0}G^{2}_{3}$ = $Ω_{G3}G_{3}$·$G'_{3}G_{3}$ dà $Ω_{G3}$, dalla parte di $G'_{3}$. "
              "Sottile: il cerchio osculatore."},
             at_end(G3_, centre_)}};
  }

 private:
  double far() const override { return 2; }
  drawings::Box covered(const Scale& lengths, double points, double circles) const override {
    Extent extent;
    for (const Place& P : mechanism_->corners()) extent.include(lengths, P, 9);
    for (const auto& P : {P0_, A_prime_, B_prime_, G3_prime_, centre_}) include(extent, lengths, P, points);
    for (const DrawnCycle& circle : {inflection_, osculating_}) include(extent, lengths, circle, circles);
    return extent.box();
  }

  void draw_rays(Plot& plot, const drawings::Box& room, Language language) const {
    if (!P0_) return;
    for (const auto& [X, prime, letters] : {std::tuple{A_, A_prime_, "$A'$"}, std::tuple{B_, B_prime_, "$B'$"},
                                            std::tuple{G3_, G3_prime_, "$G'_{3}$"}}) {
      plot.segment(*P0_, X, Meaning::construction);
      if (!prime) continue;
      draw_to(plot, room, X, *prime, letters, language);
      if (!is_in(room, plot, *prime)) continue;
      plot.dot(*prime, Meaning::locus);
      plot.label(letters, *prime, X, Meaning::locus);
    }
  }

  void draw_perpendiculars(Plot& plot, const drawings::Box& room, Language language) const {
    for (const std::optional<Place>& prime : {A_prime_, B_prime_}) {
      if (!prime || !J_) continue;
      draw_to(plot, room, *prime, *J_, "$J$", language);
      plot.right_angle(*prime, *P0_, *J_);
    }
  }

  void draw_diameter(Plot& plot, const drawings::Box& room, const Place& A0, Language language) const {
    if (F_) {
      draw_named(plot, F_, "$F$", *P0_);
      plot.measures_coordinates("inflection_centre", *F_, A0);
    }
    if (!J_) return;
    draw_to(plot, room, *P0_, *J_, "$J$", language, Meaning::axis);
    draw_named(plot, J_, "$J$", *P0_);
    plot.measures("inflection_diameter", *P0_, *J_);
    plot.measures_coordinates("inflection_pole", *J_, A0);
  }

  void draw_centre(Plot& plot, const drawings::Box& room, const Place& A0, Language language) const {
    if (!centre_) return;
    plot.cycle(osculating_, Meaning::construction);
    if (!is_in(room, plot, *centre_)) {
      draw_towards(plot, room, G3_, *centre_, "$Ω_{G3}$", language);
      return;
    }
    plot.segment(*centre_, G3_, Meaning::dimension, "rho_G3");
    draw_named(plot, centre_, "$Ω_{G3}$", G3_);
    plot.measures("rho_G3", *centre_, G3_);
    plot.measures_coordinates("curvature_centre_G3", *centre_, A0);
  }

  std::string left_out(const Plot& plot, const drawings::Box& room, Language language) const {
    OffSheet off(plot, room);
    for (const auto& [letters, P] :
         {std::pair{"$P_{0}$", P0_}, std::pair{"$A'$", A_prime_}, std::pair{"$B'$", B_prime_}, std::pair{"$F$", F_},
          std::pair{"$J$", J_}, std::pair{"$G'_{3}$", G3_prime_}, std::pair{"$Ω_{G3}$", centre_}})
      off.point(letters, P);
    off.circle({"part of the inflection circle", "parte della circonferenza dei flessi"}, inflection_);
    off.circle({"part of the osculating circle", "parte del cerchio osculatore"}, osculating_);
    return off.sentence(language);
  }

  Place A_, B_, G3_;
  std::optional<Place> P0_, A_prime_, B_prime_, G3_prime_, F_, J_, centre_;
  DrawnCycle inflection_, osculating_ = {};
};

}  // namespace

PanelSheet curvature_sheet(const Solution& s, Language language) {
  const auto row = [](const std::string& letters, const std::string& name) {
    return Row{"$" + letters + "$", {name + "_x", name + "_y"}};
  };
  std::vector<Row> rows{row("P_{0}", "P0")};
  if (s.has("Aprime_x")) {
    rows.push_back(row("A'", "Aprime"));
    rows.push_back(row("B'", "Bprime"));
  }
  for (const auto& [letters, name] : {std::pair{"G'_{3}", "G3prime"}, std::pair{"Ω_{G3}", "curvature_centre_G3"},
                                      std::pair{"F", "inflection_centre"}, std::pair{"J", "inflection_pole"}})
    rows.push_back(row(letters, name));
  return {
      .panels = panels(CurvatureOfG3(s)),
      .theory =
          {{{"By analysis", "Per via analitica"},
            {remark("$ρ_{G3}$ = 1/$k$,  $k$ = |$v_{\\it{x}}$$a_{\\it{y}}$ − $v_{\\it{y}}$$a_{\\it{x}}$| / $v^{3}$"),
             remark(Words{"with $\\vec{v}_{G3}$ and $\\vec{a}_{G3}$ of sheets 2 and 3.",
                          "con $\\vec{v}_{G3}$ e $\\vec{a}_{G3}$ delle tavole 2 e 3."}
                        .in(language))}}},
      .results = {table({"$X$", "$x$ (m)", "$y$ (m)"}, rows), values({"rho_G3"}), values({"inflection_diameter"})},
      .seen = {"The inflection circle of the coupler and the centre of curvature of the path of its midpoint",
               "La circonferenza dei flessi della biella e il centro di curvatura della traiettoria del punto medio"},
      .told = {"rho_G3", "curvature_centre_G3_x", "curvature_centre_G3_y"},
      .without_part = {"AP_along", "AP_across"}};
}

}  // namespace epure::four_bar_analytic
