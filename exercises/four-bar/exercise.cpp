#include "exercises/four-bar/exercise.h"

#include <fmt/format.h>

#include <algorithm>

#include "exercises/four-bar/linkage.h"
#include "exercises/kit/linkages/coupler_steps.h"
#include "exercises/kit/panels/circles_panel.h"
#include "exercises/kit/panels/compass.h"
#include "exercises/kit/panels/curvature_panel.h"
#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/statement/format_words.h"

namespace epure {
namespace four_bar {

std::shared_ptr<const Mechanism> linkage(const Solution& s, const std::string& rate, const std::string& of_case,
                                         bool marks_phi) {
  const Problem of = problem(s.givens());
  Mechanism mechanism = four_bar_mechanism(s, sign_of(of.instant.n), of_case);
  if (of.AC < of.instant.lengths.AB) mechanism.right_angle("C", "A", "B");
  if (of_case.empty() && marks_phi)
    mechanism.angle("A0", 0, geometry::to_double(within_one_turn(of.instant.crank)), "$φ$");
  if (rate.empty()) return std::make_shared<const Mechanism>(std::move(mechanism));
  const auto turning = [&](const char* link, const std::string& about, const std::string& P) {
    const std::string name = of_case + rate + link;
    mechanism.turning_found(about, P, s.value(name).value_or(0), s.described(name).symbol);
  };
  // At C outside of the plate: from the side that the arrow leaves.
  const Place &A = mechanism.at("A"), &B = mechanism.at("B"), &C = mechanism.at("C");
  const bool towards_B = s.value(of_case + rate + "_3").value_or(0) * cross(A - C, B - C) > 0;
  turning("_3", "C", towards_B ? "B" : "A");
  turning("_4", "B0", "B");
  return std::make_shared<const Mechanism>(std::move(mechanism));
}

namespace {

using Where = PolesStep::Where;

// P₄₂ too, by Aronhold and Kennedy: where coupler and frame meet. Far away it is left out.
class BothPolesPanel : public PolesPanel {
 public:
  BothPolesPanel(PolesPanel poles, const Solution& s, const MechanismFigure& mechanism)
      : PolesPanel(std::move(poles)), A_(s.place("A")), B_(s.place("B")), A0_(s.place("A0")), B0_(s.place("B0")) {
    const std::optional<Place> P42 = s.point("P42");
    if (P42 && distance(A0_, *P42) < 2.5 * mechanism.reach()) P42_ = P42;
  }

  drawings::Box extent_of_near(const Scale& lengths, const Scale& vectors) const override {
    const drawings::Box box = PolesPanel::extent_of_near(lengths, vectors);
    Extent extent;
    extent.include(box.low.x, box.low.y);
    extent.include(box.high.x, box.high.y);
    if (P42_) extent.include(lengths, *P42_, 9);
    return extent.box();
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    if (P42_) {
      for (const Place& P : {A_, B_, A0_, B0_}) plot.segment(P, *P42_, Meaning::construction);
      plot.cross(*P42_);
      plot.label("$P_{42}$", *P42_, A_, Meaning::locus);
    }
    return PolesPanel::draw(plot, room, language);
  }
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override {
    std::vector<PanelStep> all = PolesPanel::steps(plot, room);
    if (P42_)
      all.push_back({{"Aronhold-Kennedy: $P_{42}$ on $AB$ and on $A_{0}B_{0}$; |$ω_{4}$| / |$ω_{2}$| = $A_{0}P_{42}$ "
                      "/ $B_{0}P_{42}$.",
                      "Aronhold-Kennedy: $P_{42}$ su $AB$ e su $A_{0}B_{0}$; |$ω_{4}$| / |$ω_{2}$| = $A_{0}P_{42}$ / "
                      "$B_{0}P_{42}$."},
                     P42_});
    return all;
  }

 private:
  Place A_, B_, A0_, B0_;
  std::optional<Place> P42_ = {};
};

std::vector<PolesStep> steps_to_velocities(const Solution& s, Language language) {
  std::vector<PolesStep> steps{
      {format_words("Crank at $φ$ = {}°; $B$ by the arcs $AB$ about $A$ and $B_{{0}}B$ about $B_{{0}}$; $C$ on the "
                    "circle whose diameter is $AB$, at $AC$ from $A$: the angle $BCA$ is right.",
                    "Manovella a $φ$ = {}°; $B$ con gli archi $AB$ da $A$ e $B_{{0}}B$ da $B_{{0}}$; $C$ sulla "
                    "circonferenza di diametro $AB$, ad $AC$ da $A$: l'angolo $BCA$ è retto.",
                    short_number(s["crank_angle_phi_deg"], language)),
       Where::point, "C"},
      {{"$A$ moves perpendicularly to the crank: $P_{31}$ lies on the line $A_{0}A$.",
        "$A$ si muove normalmente alla manovella: $P_{31}$ sta sulla retta $A_{0}A$."},
       Where::ray,
       "A"}};
  if (!s.point("P31")) {
    steps.push_back({{"The rocker is parallel to the crank: $P_{31}$ is at infinity.",
                      "Il bilanciere è parallelo alla manovella: $P_{31}$ è all'infinito."},
                     Where::ray,
                     "B"});
    steps.push_back({{"The coupler translates: $ω_{3}$ = 0, $\\vec{v}_{A}$ = $\\vec{v}_{B}$ = $\\vec{v}_{C}$, "
                      "|$ω_{4}$| = $v_{B}$ / $B_{0}B$.",
                      "La biella trasla: $ω_{3}$ = 0, $\\vec{v}_{A}$ = $\\vec{v}_{B}$ = $\\vec{v}_{C}$, |$ω_{4}$| = "
                      "$v_{B}$ / $B_{0}B$."},
                     Where::tip,
                     "C"});
    return steps;
  }
  steps.push_back({{"$B$ moves perpendicularly to the rocker: $P_{31}$ lies on the line $B_{0}B$.",
                    "$B$ si muove normalmente al bilanciere: $P_{31}$ sta sulla retta $B_{0}B$."},
                   Where::ray,
                   "B"});
  const std::string rate = "$v_{A}$ = |$ω_{2}$|·$A_{0}A$, |$ω_{3}$| = $v_{A}$ / $P_{31}A$.";
  steps.push_back({{rate, rate}, Where::tip, "A"});
  steps.push_back({{"$v_{B}$ = |$ω_{3}$|·$P_{31}B$, perpendicular to $P_{31}B$; |$ω_{4}$| = $v_{B}$ / $B_{0}B$.",
                    "$v_{B}$ = |$ω_{3}$|·$P_{31}B$, normale a $P_{31}B$; |$ω_{4}$| = $v_{B}$ / $B_{0}B$."},
                   Where::tip,
                   "B"});
  steps.push_back({{"$v_{C}$ = |$ω_{3}$|·$P_{31}C$, perpendicular to $P_{31}C$.",
                    "$v_{C}$ = |$ω_{3}$|·$P_{31}C$, normale a $P_{31}C$."},
                   Where::tip,
                   "C"});
  return steps;
}

PanelSheet poles_sheet(const Solution& s, Language language) {
  const auto mechanism = linkage(s, "omega");
  PolesPanel::Kind kind = PolesPanel::of_velocity("P31");
  kind.times_smaller = 2.5;
  PolesPanel poles(s, mechanism, kind, {"A", "B", "C"}, steps_to_velocities(s, language));
  poles.on_lines({{s.place("A0"), "A"}, {s.place("B0"), "B"}}).compared_with(s["omega_3"], "|ω_{3}|");
  const Place A = s.place("A"), B = s.place("B"), C = s.place("C"), middle = A + 0.5 * (B - A);
  return {.panels = panels(FoundByArcs(BothPolesPanel(std::move(poles), s, *mechanism),
                                       {{A, B}, {s.place("B0"), B}, {A, C}, {middle, C}})),
          .results = {values({"omega_2", "omega_3", "omega_4"}),
                      by_point({"A", "B", "C"}, {{"$P_{31}X$ (m)", "P31{}"}, {"$v_{X}$ (m/s)", "v_{}"}})},
          .seen = {"The four-bar linkage with the poles P₃₁ and P₄₂ and the velocities of A, B and C",
                   "Il quadrilatero articolato con i poli P₃₁ e P₄₂ e le velocità di A, B e C"},
          .told = {"crank_angle_phi_deg", "omega_3", "omega_4", "v_A", "v_B", "v_C"},
          .without_part = without({"alpha_2"})};
}

// A side of which only the drawing shows the length, or of which no letters are wanted.
PolygonSide unmeasured(PolygonSide side) {
  side.quantity.clear();
  return side;
}
PolygonSide unlabelled(PolygonSide side) {
  side.label.clear();
  return unmeasured(std::move(side));
}
// The line it lies on is told also where it is zero.
PolygonSide across(PolygonSide side, const Place& from, const Place& to) {
  side.along = geometry::quarter_turn(to - from);
  return side;
}

// The vectors of a case, and two points of the linkage in it.
struct PolygonOf {
  const Solution& s;
  std::string prefix = {};
  std::string primes = "'";  // of the images of A, B and C

  Place at(const char* name) const { return s.place(prefix + name); }
  PolygonSide operator()(const VectorQuantity& quantity, const std::string& direction = {},
                         const std::string& magnitude = {}, const std::string& tip = {}) const {
    return epure::side(s, of_case(prefix, quantity), direction, magnitude, tip);
  }
  // c', or c'', by the vectors of C and of C relative to A and to B.
  std::vector<PolygonImage> image_of_C(VectorQuantity (*kind)(const std::string&), const Words& explained) const {
    PolygonSide c = (*this)(kind("C"));
    c.tip = "$c" + primes + "$";
    return {{.absolute = c, .relative = unmeasured((*this)(kind("CA"))), .explained = explained},
            {.absolute = unlabelled((*this)(kind("C"))), .relative = unmeasured((*this)(kind("CB")))}};
  }
};

VectorPolygon velocities(const PolygonOf& of) {
  VectorPolygon polygon =
      velocity_polygon({across(of(velocity("B"), "⊥ $B_{0}B$", "?"), of.at("B0"), of.at("B"))},
                       {of(velocity("A"), "⊥ $A_{0}A$", "|$ω_{2}$|·$A_{0}A$", "$a'$"),
                        across(of(velocity("BA"), "⊥ $AB$", "?", "$b'$"), of.at("A"), of.at("B"))});
  polygon.images = of.image_of_C(
      velocity,
      {"$c'$: perpendicular to $AC$ through $a'$, perpendicular to $BC$ through $b'$. The triangle $a'b'c'$ is the "
       "image of $ABC$.",
       "$c'$: normale ad $AC$ per $a'$, normale a $BC$ per $b'$. Il triangolo $a'b'c'$ è l'immagine di $ABC$."});
  return polygon;
}

bool crank_speeds_up(const Solution& s) { return !is_zero(s.givens().angle("alpha_2")); }

VectorPolygon accelerations(const PolygonOf& of) {
  const bool speeds_up = crank_speeds_up(of.s);
  const std::string a = "$a" + of.primes + "$", b = "$b" + of.primes + "$";
  const auto unless_zero = [](PolygonSide side) {
    if (magnitude(side.v) == 0) side.magnitude = "0";
    return side;
  };
  const PolygonSide a_B_n = unless_zero(of(normal_acceleration("B"), "∥ $BB_{0}$", "$ω^{2}_{4}$·$B_{0}B$")),
                    a_BA_n = unless_zero(of(normal_acceleration("BA"), "∥ $BA$", "$ω^{2}_{3}$·$AB$"));
  PolygonSide a_B_t = across(of(tangential_acceleration("B"), "⊥ $B_{0}B$", "?"), of.at("B0"), of.at("B")),
              a_BA_t = across(of(tangential_acceleration("BA"), "⊥ $AB$", "?", b), of.at("A"), of.at("B"));
  a_B_t.square = a_B_n.is_drawn();
  a_BA_t.square = a_BA_n.is_drawn();
  const PolygonSide a_A = speeds_up ? of(acceleration("A"), "$a^{n}_{A}$, $a^{t}_{A}$", "", a)
                                    : of(acceleration("A"), "∥ $AA_{0}$", "$ω^{2}_{2}$·$A_{0}A$", a);
  VectorPolygon polygon = acceleration_polygon({a_B_n, a_B_t}, {a_A, a_BA_n, a_BA_t});
  if (speeds_up)
    polygon.images = {
        {.absolute = unmeasured(of(normal_acceleration("A")))},
        {.absolute = unlabelled(of(acceleration("A"))), .relative = unmeasured(of(tangential_acceleration("A")))}};
  PolygonImage sums{
      .absolute = of(acceleration("B")),
      .relative = unmeasured(of(acceleration("BA"))),
      .explained = {"$\\vec{a}_{B}$ from $O_{a}$ to " + b + ", $\\vec{a}_{BA}$ from " + a + " to " + b + ".",
                    "La $\\vec{a}_{B}$ da $O_{a}$ a " + b + ", la $\\vec{a}_{BA}$ da " + a + " a " + b + "."}};
  // At a dead centre the parts of a_BA are so unlike that its letters would be lost beside the greater one; a_B has
  // one part. Where the coupler translates a_BA has one part.
  if (!a_B_n.is_drawn()) {
    sums.closes_triangle = true;
    sums.explained = {"$\\vec{a}_{B}$ = $\\vec{a}^{t}_{B}$, from $O_{a}$ to " + b + ".",
                      "$\\vec{a}_{B}$ = $\\vec{a}^{t}_{B}$, da $O_{a}$ a " + b + "."};
  } else if (!a_BA_n.is_drawn()) {
    sums.relative = {};
    sums.explained = {"$\\vec{a}_{B}$ from $O_{a}$ to " + b + ".", "La $\\vec{a}_{B}$ da $O_{a}$ a " + b + "."};
  }
  polygon.images.push_back(std::move(sums));
  auto image = of.image_of_C(
      acceleration,
      format_words("$c{0}$: the triangle $a{0}b{0}c{0}$ is similar to $ABC$, in the same sense.",
                   "$c{0}$: il triangolo $a{0}b{0}c{0}$ è simile ad $ABC$, nello stesso verso.", of.primes));
  image.back().closes_triangle = true;
  polygon.images.insert(polygon.images.end(), image.begin(), image.end());
  return polygon;
}

// The parts of a_A in an equation of their own: six terms in one line would be too wide.
PolygonPanel panel_of_accelerations(const PolygonOf& of, PolygonPanel::Table table = PolygonPanel::Table::none) {
  PolygonPanel panel(of.s, accelerations(of), table);
  if (crank_speeds_up(of.s))
    panel.with_equations({{{{"$\\vec{a}_{A}$", "", "", ""},
                            {"$\\vec{a}^{n}_{A}$", "∥ $AA_{0}$", "$ω^{2}_{2}$·$A_{0}A$", "="},
                            {"$\\vec{a}^{t}_{A}$", "⊥ $A_{0}A$", "|$α_{2}$|·$A_{0}A$", "+"}}}});
  else if (of.prefix.empty())
    panel.with_equations({{{{"$\\vec{a}_{C}$", "?", "?", ""},
                            {"$\\vec{a}_{A}$", "∥ $AA_{0}$", "$ω^{2}_{2}$·$A_{0}A$", "="},
                            {"$\\vec{a}^{n}_{CA}$", "∥ $CA$", "$ω^{2}_{3}$·$AC$", "+"},
                            {"$\\vec{a}^{t}_{CA}$", "⊥ $CA$", "|$α_{3}$|·$AC$", "+"}}}});
  return panel;
}

}  // namespace

PolygonPanel acceleration_panel(const Solution& s, const std::string& of_case, const std::string& primes) {
  return panel_of_accelerations({s, of_case, primes});
}

namespace {

Result rates_of_velocity() { return remark("|$ω_{3}$| = $v_{BA}$ / $AB$,  |$ω_{4}$| = $v_{B}$ / $B_{0}B$"); }
Result rates_of_acceleration() {
  return remark("|$α_{3}$| = $a^{t}_{BA}$ / $AB$,  |$α_{4}$| = $a^{t}_{B}$ / $B_{0}B$");
}

PanelSheet velocity_diagram_sheet(const Solution& s, Language) {
  PolygonPanel polygon(s, velocities({s}), PolygonPanel::Table::measured);
  polygon.with_equations({{{{"$\\vec{v}_{C}$", "?", "?", ""},
                            {"$\\vec{v}_{A}$", "⊥ $A_{0}A$", "|$ω_{2}$|·$A_{0}A$", "="},
                            {"$\\vec{v}_{CA}$", "⊥ $CA$", "|$ω_{3}$|·$CA$", "+"}}}});
  return {.panels = panels(MechanismPanel(linkage(s, "omega")), polygon),
          .results = {values({"omega_2", "omega_3", "omega_4"}), rates_of_velocity()},
          .seen = {"The polygon of the velocities of the four-bar linkage, with the image of C",
                   "Il poligono delle velocità del quadrilatero articolato, con l'immagine di C"},
          .told = {"omega_3", "omega_4", "v_A", "v_BA", "v_B", "v_C"},
          .without_part = without({"alpha_2"})};
}

PanelSheet acceleration_diagram_sheet(const Solution& s, Language) {
  return {
      .panels =
          panels(MechanismPanel(linkage(s, "alpha")), panel_of_accelerations({s}, PolygonPanel::Table::measured)),
      .results = {values({"omega_2", "omega_3", "omega_4"}), values({"alpha_3", "alpha_4"}), rates_of_acceleration()},
      .seen = {"The polygon of the accelerations of the four-bar linkage, with the image of C",
               "Il poligono delle accelerazioni del quadrilatero articolato, con l'immagine di C"},
      .told = {"alpha_3", "alpha_4", "a_A", "a_B", "a_C"},
      .without_part = without()};
}

PanelSheet circles_of(const Solution& s, const std::string& prefix) {
  const bool rocker_rests = s.value(prefix + "P31B") == 0;
  CirclesPanel circles(s, linkage(s, {}, prefix),
                       {.pole = "P31",
                        .driven = {"A", "A0"},
                        .other = {"B", "B0", rocker_rests},
                        .driven_speeds_up = crank_speeds_up(s),
                        .prefix = prefix});
  CirclesPanel detail = circles;
  return {
      .panels = circles.needs_detail() ? panels(circles.beside_detail(), detail.detail()) : panels(circles),
      .results = {values({prefix + "omega_3", prefix + "alpha_3"}), coordinates(CirclesPanel::points("P31", prefix)),
                  values({prefix + "inflection_diameter", prefix + "stationarity_diameter"})},
      .seen = {"Inflection and stationarity circle of the coupler, which meet in P₃₁ and K",
               "Circonferenze dei flessi e di stazionarietà della biella, che si incontrano in P₃₁ e K"},
      .told = {prefix + "P31_x", prefix + "P31_y", prefix + "inflection_pole_x", prefix + "inflection_pole_y",
               prefix + "K_x", prefix + "K_y"},
      .without_part = without()};
}

PanelSheet circles_sheet(const Solution& s, Language) { return circles_of(s, {}); }

// With the parts of a_B, of which α₄ is found.
class AccelerationsPanel : public PolesPanel {
 public:
  AccelerationsPanel(PolesPanel poles, const Solution& s)
      : PolesPanel(std::move(poles)), B_(s.place("B")), a_B_n_(s.vector("a_B_n")), a_B_t_(s.vector("a_B_t")) {}

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override {
    auto told = PolesPanel::draw(plot, room, language);
    for (const auto& [part, v] :
         {std::pair{normal_acceleration("B"), a_B_n_}, {tangential_acceleration("B"), a_B_t_}})
      if (magnitude(v) > 0) plot.vector_on(part.name, B_, v, Meaning::acceleration, part.arrow());
    return told;
  }

 private:
  Place B_;
  Arrow2 a_B_n_, a_B_t_;
};

std::vector<PolesStep> steps_to_accelerations(const Solution& s) {
  const Words to_the_rocker{
      "$γ$ does not hold for the rocker, which turns about $B_{0}$: |$α_{4}$| = $a^{t}_{B}$ / $B_{0}B$.",
      "$γ$ non vale per il bilanciere, che ruota attorno a $B_{0}$: |$α_{4}$| = $a^{t}_{B}$ / $B_{0}B$."};
  if (!s.point("K"))
    return {
        {{"$ω_{3}$ and $α_{3}$ are zero: every point of the coupler has the acceleration of $A$, and $K$ is at "
          "infinity.",
          "$ω_{3}$ e $α_{3}$ sono nulle: ogni punto della biella ha l'accelerazione di $A$, e $K$ è all'infinito."},
         Where::tip,
         "C"},
        {to_the_rocker, Where::tip, "B"}};
  std::vector<PolesStep> steps = steps_to_coupler_accelerations(4, "C", "A");
  steps.push_back({to_the_rocker, Where::tip, "B"});
  return steps;
}

PanelSheet acceleration_pole_sheet(const Solution& s, Language) {
  const std::vector<std::string> points{"A", "B", "C"};
  Mechanism mechanism = *linkage(s, "alpha", {}, false);  // γ has the place of φ
  mechanism.without_ways();                               // that of B would hide the tangential part
  PolesPanel poles(s, std::make_shared<const Mechanism>(std::move(mechanism)), PolesPanel::of_acceleration(), points,
                   steps_to_accelerations(s));
  return {.panels = panels(AccelerationsPanel(std::move(poles), s)),
          .results = {values({"omega_3", "alpha_3", "gamma_deg"}), coordinates("K"),
                      by_point(points, {{"$KX$ (m)", "K{}"}, {"$a_{X}$ (m/s²)", "a_{}"}}),
                      values({"a_B_n", "a_B_t", "alpha_4"})},
          .seen = {"Accelerations of A, B and C, proportional to their distances from the acceleration pole K",
                   "Accelerazioni di A, B e C, proporzionali alle distanze dal polo delle accelerazioni K"},
          .told = {"alpha_3", "alpha_4", "a_A", "a_B", "a_C", "K_x", "K_y"},
          .without_part = without()};
}

PanelSheet curvature_sheet(const Solution& s, Language) {
  const auto mechanism = linkage(s);
  const Curved path{.pole = "P31", .points = {"C"}, .circles_sheet = 4};
  const auto draw_path = [of = problem(s.givens())](Plot& plot, const std::string&, const drawings::Box& around) {
    const auto C = [&]<class X>(const geometry::Vector<X>& crank) {
      const geometry::FourBar<X> at = geometry::four_bar(of.instant.lengths, crank, of.instant.side);
      return geometry::projective(geometry::right_angled_corner(at.A, at.B, of.instant.lengths.AB, of.AC, of.C_side));
    };
    draw_locus(plot, C, around, Meaning::locus, "path_of_C");
  };
  return {
      .panels = curvature_panels(s, mechanism, path, draw_path),
      .results = {by_point({"C"},
                           {{"$P_{31}X$ (m)", "P31{}"}, {"$X'X$ (m)", "{0}prime_{0}"}, {"$ρ_{X}$ (m)", "rho_{}"}}),
                  coordinates({{"$J$", "inflection_pole"}, {"$Ω_{C}$", "curvature_centre_C"}})},
      .seen = {"Centre of curvature of the path of C by Euler-Savary, with its osculating circle",
               "Centro di curvatura della traiettoria di C con Euler-Savary, col cerchio osculatore"},
      .told = {"rho_C", "P31C", "Cprime_C"},
      .without_part = without({"n", "alpha_2"})};
}

const std::set<std::string> of_the_instant{"t", "phi"};

// Velocities all in one line but those of C: the room is the linkage's, whose links are close together here.
class VelocitiesAtDeadCentre : public PolygonPanel {
 public:
  using PolygonPanel::PolygonPanel;
  Vectors vectors() const override {
    constexpr double longest = 60;  // mm
    Vectors shown = PolygonPanel::vectors();
    shown.longest_on_paper = longest;
    return shown;
  }
};

PanelSheet dead_centre_sheet(const Solution& s, Language language, geometry::Reach reach) {
  const std::string prefix = dead_centre(reach).prefix;
  if (!s.value(prefix + "A_x")) return no_dead_centre(s, language);
  const auto names = [&](std::vector<std::string> all) {
    for (std::string& name : all) name.insert(0, prefix);
    return all;
  };
  return {
      .panels = panels(MechanismPanel(linkage(s, "alpha", prefix)),
                       VelocitiesAtDeadCentre(s, velocities({s, prefix})), acceleration_panel(s, prefix, "''")),
      .results = {values(names({"crank_angle_deg", "rocker_angle_deg"})),
                  values({"omega_2", prefix + "omega_3", prefix + "omega_4"}), values(names({"alpha_3", "alpha_4"})),
                  by_point({"A", "B", "C"},
                           {{"$v_{X}$ (m/s)", prefix + "v_{}"}, {"$a_{X}$ (m/s²)", prefix + "a_{}"}})},
      .seen = {"The four-bar linkage with its rocker at a dead centre: the polygons of velocity and acceleration",
               "Il quadrilatero articolato col bilanciere al punto morto: i poligoni di velocità e accelerazioni"},
      .told = names({"omega_3", "alpha_3", "alpha_4", "v_A", "a_A", "a_B"}),
      .without_part = without(of_the_instant)};
}

PanelSheet circles_at_dead_centre(const Solution& s, Language language, geometry::Reach reach) {
  const std::string prefix = dead_centre(reach).prefix;
  if (!s.value(prefix + "A_x")) return no_dead_centre(s, language);
  PanelSheet sheet = circles_of(s, prefix);
  sheet.without_part = without(of_the_instant);
  return sheet;
}

Description description() {
  return {.id = "four-bar",
          .title = {"Four-bar linkage", "Quadrilatero articolato"},
          .document = "sapienza",
          .item = "N.3",
          .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.3",
                     "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.3"},
          .question =
              {"At the given instant find the velocities and accelerations of the linkage's points by the poles and "
               "by the polar diagrams, inflection and stationarity circles and the centre of curvature of C's path; "
               "the same at both dead centres of the rocker and where crank and rocker are parallel.",
               "All'istante dato trovare velocità e accelerazioni dei punti del quadrilatero con i poli e con i "
               "diagrammi polari, le circonferenze dei flessi e di stazionarietà e il centro di curvatura della "
               "traiettoria "
               "di C; lo stesso nei due punti morti del bilanciere e dove manovella e bilanciere sono paralleli."},
          .givens = givens(),
          .printed = printed_by_the_source};
}

std::vector<SheetMaker> sheets() {
  const auto at = [](PanelSheet (*sheet)(const Solution&, Language, geometry::Reach), geometry::Reach reach) {
    return [=](const Solution& s, Language language) { return sheet(s, language, reach); };
  };
  const auto extended = geometry::Reach::extended, folded = geometry::Reach::folded;
  const auto parallel = [](geometry::Sense sense) {
    return [=](const Solution& s, Language language) { return parallel_links_sheet(s, language, sense); };
  };
  return {
      {{"poles",
        {"Velocities by the poles", "Velocità col metodo dei poli"},
        {"At the given instant find the velocities of the linkage's points by the method of poles.",
         "All'istante dato trovare le velocità dei punti del quadrilatero con il metodo dei poli."}},
       poles_sheet},
      {{"velocity-diagram",
        {"Polar diagram of velocity", "Diagramma polare delle velocità"},
        {"At the given instant find the velocities of the linkage's points by the polar diagram.",
         "All'istante dato trovare le velocità dei punti del quadrilatero con il diagramma polare."}},
       velocity_diagram_sheet},
      {{"acceleration-diagram",
        {"Polar diagram of acceleration", "Diagramma polare delle accelerazioni"},
        {"At the given instant find the accelerations of the linkage's points by the polar diagram.",
         "All'istante dato trovare le accelerazioni dei punti del quadrilatero con il diagramma polare."}},
       acceleration_diagram_sheet},
      {{"circles",
        {"Inflection and stationarity circles", "Circonferenze dei flessi e di stazionarietà"},
        {"At the given instant find the inflection and stationarity circles of the coupler and its acceleration pole "
         "K.",
         "All'istante dato trovare le circonferenze dei flessi e di stazionarietà della biella e il suo polo delle "
         "accelerazioni K."}},
       circles_sheet},
      {{"acceleration-pole",
        {"Accelerations by the pole K", "Accelerazioni col metodo dei poli"},
        {"At the given instant find the accelerations of the linkage's points by the acceleration pole K.",
         "All'istante dato trovare le accelerazioni dei punti del quadrilatero con il polo delle accelerazioni K."}},
       acceleration_pole_sheet},
      {{"curvature",
        {"Curvature of C's path (Euler-Savary)", "Curvatura della traiettoria di C"},
        {"At the given instant find the centre of curvature of the path of C by the formula of Euler-Savary.",
         "All'istante dato trovare il centro di curvatura della traiettoria di C con la formula di Euler-Savary."}},
       curvature_sheet},
      {{"dead-centres",
        {"The rocker's dead centres", "I punti morti del bilanciere"},
        {"Find both dead centres of the rocker.", "Trovare i due punti morti del bilanciere."}},
       dead_centres_sheet},
      {{"dead-centre-extended",
        {"Dead centre, extended", "Punto morto disteso"},
        {"At the dead centre of the rocker where crank and coupler are extended find velocities and accelerations by "
         "the polar diagrams.",
         "Nel punto morto del bilanciere con manovella e biella distese trovare velocità e accelerazioni con i "
         "diagrammi polari."}},
       at(dead_centre_sheet, extended)},
      {{"dead-centre-folded",
        {"Dead centre, folded", "Punto morto ripiegato"},
        {"At the dead centre of the rocker where crank and coupler are folded find velocities and accelerations by "
         "the polar diagrams.",
         "Nel punto morto del bilanciere con manovella e biella sovrapposte trovare velocità e accelerazioni con i "
         "diagrammi polari."}},
       at(dead_centre_sheet, folded)},
      {{"circles-extended",
        {"Circles, extended dead centre", "Circonferenze al punto morto disteso"},
        {"At the dead centre of the rocker where crank and coupler are extended find the inflection and stationarity "
         "circles of the coupler.",
         "Nel punto morto del bilanciere con manovella e biella distese trovare le circonferenze dei flessi e di "
         "stazionarietà della biella."}},
       at(circles_at_dead_centre, extended)},
      {{"circles-folded",
        {"Circles, folded dead centre", "Circonferenze al punto morto ripiegato"},
        {"At the dead centre of the rocker where crank and coupler are folded find the inflection and stationarity "
         "circles of the coupler.",
         "Nel punto morto del bilanciere con manovella e biella sovrapposte trovare le circonferenze dei flessi e di "
         "stazionarietà della biella."}},
       at(circles_at_dead_centre, folded)},
      {{"parallel-links",
        {"Crank and rocker parallel", "Manovella e bilanciere paralleli"},
        {"Where crank and rocker are parallel in the same sense find the velocities and accelerations of the "
         "linkage's points.",
         "Dove manovella e bilanciere sono paralleli e concordi trovare velocità e accelerazioni dei punti del "
         "quadrilatero."}},
       parallel(geometry::Sense::same)},
      {{"parallel-links-opposite",
        {"Parallel in opposite senses", "Paralleli e discordi"},
        {"Where crank and rocker are parallel in opposite senses find the velocities and accelerations of the "
         "linkage's points.",
         "Dove manovella e bilanciere sono paralleli e discordi trovare velocità e accelerazioni dei punti del "
         "quadrilatero."}},
       parallel(geometry::Sense::opposite)},
      {{"slider-crank",
        {"Circles that are lines", "Circonferenze degeneri in rette"},
        {"In a slider-crank whose crank stands square to the guide the coupler translates for the instant. Find the "
         "lines that its inflection and stationarity circles become, and its acceleration pole K.",
         "In un manovellismo di spinta con la manovella perpendicolare alla guida la biella trasla per un istante. "
         "Trovare le rette in cui degenerano le sue circonferenze dei flessi e di stazionarietà, e il suo polo delle "
         "accelerazioni K."}},
       slider_crank_sheet}};
}

}  // namespace
}  // namespace four_bar

std::unique_ptr<Exercise> make_four_bar() {
  using namespace four_bar;
  const auto solve = [](const Givens& givens, Rung rung) { return four_bar::solve(problem(givens), rung); };
  return exercise_of_panels(description(), solve, sheets());
}

}  // namespace epure
