// How mechanisms in equilibrium, and their bodies, are drawn.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "exercises/kit/linkages/case_of_mechanism.h"
#include "exercises/kit/linkages/loaded_mechanisms.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/mechanism_with_blocks.h"

namespace epure::loaded {

// Where it is drawn: the wedge's height and width are free, the rod ends somewhat above the collar.
struct WedgeFigure {
  double w, lower, upper, top, floor, line_of_P, sine, cosine;
  Place left, right;  // corners of the wedge's face
  double back;        // where P pushes on the wedge

  // `phi`: by how much friction turns the face's force towards x (radians), which carries the meeting point with P
  // farther to the left.
  explicit WedgeFigure(const Case& of, double phi = 0)
      : w(of.given("w")),
        lower(of.given("y_lower")),
        upper(of.given("y_upper")),
        floor(CGAL::to_double(floor_of_wedge())),
        line_of_P(CGAL::to_double(epure::line_of_P())),
        sine(std::sin(of.radians("theta"))),
        cosine(std::cos(of.radians("theta"))) {
    constexpr double above = 0.02, shortest = 0.03, longest = 0.08, down_the_face = 0.05, beside_H = 0.012;  // m
    constexpr double widest = 0.45;                                                                          // m
    top = std::max(upper, 0.0) + above;
    // To the left it reaches beyond the meeting point of its forces, or the floor could not press below it: by its
    // face, or by a level top where that would be too high.
    const double steep = of.radians("theta") + phi;
    const double beyond_H = std::cos(steep) > 0 ? beside_H - line_of_P * std::tan(steep) : 0;
    const double up_the_face = std::clamp(beyond_H / cosine, shortest, longest);
    const double down = std::min(down_the_face, -floor / sine);
    left = {-up_the_face * cosine, up_the_face * sine};
    back = std::min(left.x, -std::min(beyond_H, widest));
    right = {down * cosine, -down * sine};
  }
};

inline void add_wedge(Mechanism& drawn, const WedgeFigure& at) {
  drawn.point("L", at.left, Mechanism::Joint::corner, "").point("R", at.right, Mechanism::Joint::corner, "");
  drawn.point("Rf", {at.right.x, at.floor}, Mechanism::Joint::corner, "")
      .point("Lf", {at.back, at.floor}, Mechanism::Joint::corner, "");
  if (at.back == at.left.x)
    drawn.body({"L", "R", "Rf", "Lf"}, 2);
  else
    drawn.point("T", {at.back, at.left.y}, Mechanism::Joint::corner, "").body({"T", "L", "R", "Rf", "Lf"}, 2);
}
inline void add_rod(Mechanism& drawn, const WedgeFigure& at) {
  const double slope = at.sine / at.cosine, half = at.w / 2;
  drawn.point("l", {-half, half * slope}, Mechanism::Joint::corner, "")
      .point("r", {half, -half * slope}, Mechanism::Joint::corner, "");
  drawn.point("rt", {half, at.top}, Mechanism::Joint::corner, "")
      .point("lt", {-half, at.top}, Mechanism::Joint::corner, "");
  drawn.body({"l", "r", "rt", "lt"}, 3);
}

// The width of the rod, and from O how high the collar's ends stand, at its right, where the wedge's face falls.
inline void dimension_wedge(Mechanism& drawn, const WedgeFigure& at) {
  const double half = at.w / 2, upwards = std::numbers::pi / 2, farther_out = 0.035;  // m
  drawn.point("cl", {half, at.lower}, Mechanism::Joint::corner, "")
      .point("cu", {half, at.upper}, Mechanism::Joint::corner, "")
      .offset("rt", {-half, at.top}, upwards, 0, "$w$")
      .offset("cl", {half, 0}, 0, 0, "$y_{l}$")
      .offset("cu", {half, 0}, 0, farther_out, "$y_{u}$");
}

// With load and effort, by their directions.
enum class Dimensioned { no, yes };
inline FreeBodyPanel whole(const WedgeFigure& at, const Case& of, const PolygonSide& effort, double at_most,
                           Dimensioned dimensioned) {
  Mechanism drawn;
  drawn.point("O", {0, 0}, Mechanism::Joint::none, "$O$");
  add_wedge(drawn, at);
  add_rod(drawn, at);
  const double half = at.w / 2, beyond = 0.012;
  drawn.surface({-half, at.upper}, {-half, at.lower})
      .surface({half, at.lower}, {half, at.upper})
      .surface({at.back - beyond, at.floor}, {at.right.x + beyond, at.floor})
      .axis({0, at.floor}, {0, at.top + beyond}, "$r_{1}$")
      .angle("R", std::numbers::pi - of.radians("theta"), std::numbers::pi, "$θ$");
  if (dimensioned == Dimensioned::yes) dimension_wedge(drawn, at);
  FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(drawn)));
  panel.at_most(at_most).load(of.load("Q", "", ""), {0, at.top}, FreeBodyPanel::Arrow::ends);
  panel.effort(effort, {at.back, at.line_of_P}, FreeBodyPanel::Arrow::ends);
  return panel;
}

// A link between two sliders. The origin, where their ways cross, is shown where something is measured from there.
enum class Origin { none, shown };
inline std::shared_ptr<const Mechanism> double_slider_figure(const Case& of, Origin origin) {
  Mechanism drawn;
  if (origin == Origin::shown) drawn.point("O", {0, 0}, Mechanism::Joint::none, "$O$");
  drawn.point("A", of.place("A"), Mechanism::Joint::block, "$A$")
      .point("B", of.place("B"), Mechanism::Joint::block, "$B$")
      .body({"B", "A"}, 3)
      .guide("A", std::numbers::pi / 2)
      .guide("B", 0)
      .angle("B", 0, of.radians("theta"), "$θ$");
  return std::make_shared<const Mechanism>(std::move(drawn));
}

// One of its sliders, A on the upright guide or B on the level one.
inline FreeBodyPanel slider_cut_free(const Case& of, const std::string& name) {
  const Place P = of.place(name);
  const double half = of.given("l") / 20, x = name == "A" ? half : 2 * half, y = name == "A" ? 2 * half : half;
  Mechanism block;
  block.point(name, P, Mechanism::Joint::hinge, "$" + name + "$")
      .point("1", {P.x - x, P.y - y}, Mechanism::Joint::corner, "")
      .point("2", {P.x + x, P.y - y}, Mechanism::Joint::corner, "")
      .point("3", {P.x + x, P.y + y}, Mechanism::Joint::corner, "")
      .point("4", {P.x - x, P.y + y}, Mechanism::Joint::corner, "")
      .body({"1", "2", "3", "4"}, name == "A" ? 2 : 4);
  FreeBodyPanel panel(std::make_shared<const Mechanism>(std::move(block)));
  panel.to_scale().at_most(500);
  return panel;
}

// Which lever Q loads, and what follows of it.
struct LeverFigure {
  Case of;
  int loaded, driven;
  Place A0, B0, C, A, B, foot, on_Q;
  Arrow2 p;

  LeverFigure(const Solution& s, const std::string& name, int loaded_lever)
      : of(s, name),
        loaded(loaded_lever),
        driven(5 - loaded_lever),
        A0(of.place("A0")),
        B0(of.place("B0")),
        C(of.place("C")),
        A(of.place("A")),
        B(of.place("B")) {
    const double direction = of.radians("direction_P"), arm = of.given("arm_P"), q = of.radians("direction_Q");
    p = {std::cos(direction), std::sin(direction)};
    foot = hinge(driven) + arm * Arrow2{p.y, -p.x};
    // Where Q is drawn: the foot of the perpendicular from the hinge.
    const Arrow2 along{std::cos(q), std::sin(q)};
    const Place X{of.given("x_Q"), 0};
    on_Q = X + dot(hinge(loaded) - X, along) * along;
  }
  const Place& hinge(int lever) const { return lever == 2 ? A0 : B0; }
  double radius(int lever) const { return of.given(lever == 2 ? "r_2" : "r_3"); }
  const Place& centre(int lever) const { return lever == 2 ? A : B; }
  std::string letters(int lever) const { return lever == 2 ? "$A_{0}$" : "$B_{0}$"; }
  // The direction of load or effort, given as its angle.
  static std::string along(const std::string& force, Language language) {
    return Words{"at ", "a "}.in(language) + "$δ_{" + force + "}$";
  }
  Place attacked(int lever) const { return lever == loaded ? on_Q : foot; }
  // The angle from x of load, effort or normal, where there is one.
  void directed(FreeBodyPanel& panel, const std::string& of_what) const {
    const bool is_normal = of_what == "n";
    const double angle = of.radians(is_normal ? "nu" : "direction_" + of_what);
    if (angle == 0) return;
    panel.turned(is_normal        ? C
                 : of_what == "Q" ? on_Q
                                  : foot,
                 0, angle, is_normal ? "$ν$" : "$δ_{" + of_what + "}$", "$x$", false);
  }

  // The lever's plate between its hinge, the contact and where its force acts; the profile's arc about C.
  void add(Mechanism& drawn, int lever, Mechanism::Joint joint) const {
    const std::string i = std::to_string(lever);
    constexpr double half = 0.7;  // radians
    const double towards_C = direction(centre(lever), C);
    drawn.point("hinge" + i, hinge(lever), joint, letters(lever))
        .point("C" + i, C, Mechanism::Joint::corner, "")
        .point("force" + i, attacked(lever), Mechanism::Joint::corner, "")
        .body({"hinge" + i, "C" + i, "force" + i}, joint == Mechanism::Joint::hinge ? 0 : lever)
        .profile(centre(lever), radius(lever), towards_C - half, towards_C + half);
    if (joint != Mechanism::Joint::hinge) return;
    // Cut free it has dimensions beside hinge and contact: its number stands clear of them.
    const Place P = attacked(lever);
    drawn.point("number" + i, P + 0.3 * ((hinge(lever) - P) + (C - P)), Mechanism::Joint::corner, i);
  }

  // Both levers on the frame.
  Mechanism whole() const {
    Mechanism drawn;
    add(drawn, 2, Mechanism::Joint::fixed);
    add(drawn, 3, Mechanism::Joint::fixed);
    drawn.point("C", C, Mechanism::Joint::none, "$C$").axis(A, B, "$n$");
    return drawn;
  }
  // With where they touch, and where the load's line meets that of the hinges.
  Mechanism dimensioned() const {
    Mechanism drawn = whole();
    constexpr double upwards = std::numbers::pi / 2, clear = 0.03;  // m
    const Place on_hinges{of.given("x_Q"), 0};
    drawn.point("Q", on_hinges, Mechanism::Joint::corner, "").axis(A0, B0);
    drawn.offset("C", {0, C.y}, upwards, clear, "$x_{C}$")
        .offset("C", {C.x, 0}, std::numbers::pi, C.x + clear, "$y_{C}$")
        .offset("Q", A0, upwards, C.y + 2.5 * clear, "$x_{Q}$");
    return drawn;
  }
};

// The levers with the lines of load and effort, of which direction and arm are given, and the direction of the
// normal.
inline FreeBodyPanel levers_with_givens(const LeverFigure& at, const PolygonSide& load, const PolygonSide& effort) {
  FreeBodyPanel panel(std::make_shared<const Mechanism>(at.dimensioned()));
  panel.load(load, at.on_Q).effort(effort, at.foot);
  panel.arm(at.hinge(at.driven), at.foot, at.p, "$b_{P}$", "");
  for (const char* const of : {"Q", "P", "n"}) at.directed(panel, of);
  return panel;
}

// The lever from C is drawn as far as this: to D, or to B where that lies farther out.
inline Place end_of_lever(const Case& of) {
  const Place B = of.place("B"), C = of.place("C"), D = of.place("D");
  return distance(C, B) > distance(C, D) ? B : D;
}

// The ram reaches from D so far.
inline Place end_of_ram(const Case& of) { return of.place("D") + of.given("AB") * Arrow2{1, 0}; }

// Of the forces on the lever but its hinge's.
inline const Words meet_in_H{
    "$\\vec{\\it{R}}_{54}$ and $\\vec{\\it{R}}_{34}$ meet in $H$; $\\vec{\\it{R}}_{14}$ runs along $CH$.",
    "La $\\vec{\\it{R}}_{54}$ e la $\\vec{\\it{R}}_{34}$ si incontrano in $H$; la $\\vec{\\it{R}}_{14}$ passa per "
    "$C$ e $H$."};

inline FreeBodyPanel lever_cut_free(const Case& of) {
  Mechanism drawn;
  drawn.point("C", of.place("C"), Mechanism::Joint::hinge, "$C$")
      .point("B", of.place("B"), Mechanism::Joint::none, "$B$")
      .point("D", of.place("D"), Mechanism::Joint::hinge, "$D$")
      .point("end", end_of_lever(of), Mechanism::Joint::corner, "")
      .body({"C", "end"}, 4);
  return FreeBodyPanel(std::make_shared<const Mechanism>(std::move(drawn)));
}

inline FreeBodyPanel crank_cut_free(const Case& of) {
  Mechanism drawn;
  drawn.point("A", of.place("A"), Mechanism::Joint::hinge, "$A$")
      .point("B", of.place("B"), Mechanism::Joint::hinge, "$B$")
      .body({"A", "B"}, 2);
  return FreeBodyPanel(std::make_shared<const Mechanism>(std::move(drawn)));
}

// The ram cut free, with its slot upright: what acts on it passes through D.
inline FreeBodyPanel ram_cut_free(const Case& of) {
  const Place D = of.place("D");
  const Arrow2 half_slot{0, 0.6 * of.given("AB")};
  Mechanism drawn;
  drawn.point("D", D, Mechanism::Joint::none, "$D$")
      .point("ram", end_of_ram(of), Mechanism::Joint::corner, "")
      .point("low", D + -1.0 * half_slot, Mechanism::Joint::corner, "")
      .point("high", D + half_slot, Mechanism::Joint::corner, "")
      .body({"D", "ram"}, 6)
      .body({"low", "high"});
  return FreeBodyPanel(std::make_shared<const Mechanism>(std::move(drawn)));
}

// With the block 3 on the lever, the ram 6 in its guide and the block 5 in the ram's upright slot. `drawn`: crank and
// lever.
inline std::shared_ptr<const MechanismFigure> with_ram(Mechanism drawn, const Case& of) {
  const Place B = of.place("B"), D = of.place("D");
  const double AB = of.given("AB");
  drawn.point("D", D, Mechanism::Joint::corner, "")
      .point("ram", end_of_ram(of), Mechanism::Joint::corner, "")
      .body({"D", "ram"}, 6);
  // Above, where with friction it presses; below there is room for the load.
  drawn.surface(D + AB * Arrow2{0.9, 0.06}, D + AB * Arrow2{0.5, 0.06});
  MechanismWithBlocks whole(std::move(drawn));
  whole.block(B, std::numbers::pi / 2 - of.radians("theta"), MechanismWithBlocks::Slides::on_body, "$B$", 3)
      .block(D, std::numbers::pi / 2, MechanismWithBlocks::Slides::in_slot, "$D$", 5);
  return std::make_shared<const MechanismWithBlocks>(std::move(whole));
}

inline std::shared_ptr<const MechanismFigure> fairbairn_figure(const Case& of) {
  const Place A = of.place("A"), B = of.place("B"), C = of.place("C");
  Mechanism drawn;
  drawn.point("A", A, Mechanism::Joint::fixed, "$A$")
      .point("B", B, Mechanism::Joint::corner, "")
      .point("C", C, Mechanism::Joint::fixed, "$C$")
      .point("end", end_of_lever(of), Mechanism::Joint::corner, "")
      .body({"A", "B"}, 2)
      .body({"C", "end"}, 4)
      .axis(C, A)
      .angle("C", std::numbers::pi / 2 - of.radians("theta"), std::numbers::pi / 2, "$θ$");
  return with_ram(std::move(drawn), of);
}

}  // namespace epure::loaded
