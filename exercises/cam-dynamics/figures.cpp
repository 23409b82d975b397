#include "exercises/cam-dynamics/figures.h"

#include <numbers>

namespace epure::cam_dynamics {
namespace {

using Joint = Mechanism::Joint;

const Words along_guide{"∥ guide", "∥ guida"};

}  // namespace

double given(const Solution& s, const std::string& symbol) { return CGAL::to_double(s.givens()[symbol]); }

Place centre_of_follower(const Solution& s, const std::string& prefix) {
  return s.place(prefix + "B_at") + Arrow2{0, 0.9 * (given(s, "r") + given(s, "r_r")) / 2};
}

Mechanism cam_figure(const Solution& s, const std::string& prefix, Shown shown) {
  const Place A0 = s.place(prefix + "A0"), A = s.place(prefix + "A_at"), B = s.place(prefix + "B_at"),
              C = s.place(prefix + "contact_at"), G3 = centre_of_follower(s, prefix);
  const bool has_roller = s.givens()["r_r"] != 0;
  Mechanism drawn;
  if (shown != Shown::follower)
    drawn.point("A0", A0, shown == Shown::all ? Joint::fixed : Joint::hinge, "$A_{0}$")
        .point("A", A, Joint::mass, "$A$");
  if (shown != Shown::cam) drawn.point("B", B, Joint::hinge, "$B$").point("G3", G3, Joint::mass, "$G_{3}$");
  drawn.point("C", C, has_roller ? Joint::none : Joint::corner, "");
  if (shown != Shown::follower) drawn.disc("A", "C", false, 2).body({"A0", "A"});
  if (shown == Shown::cam) return drawn;
  drawn.point("T", G3 + (G3 - B), shown == Shown::all ? Joint::block : Joint::corner, "");
  if (has_roller) drawn.disc("B", "C", false);
  drawn.body({"B", "T"}, 3);
  if (shown == Shown::all) drawn.guide("T", std::numbers::pi / 2).axis(A, B);
  return drawn;
}

std::shared_ptr<const Mechanism> whole(const Solution& s, const std::string& prefix, Dimensioned dimensioned) {
  Mechanism drawn = cam_figure(s, prefix);
  if (dimensioned == Dimensioned::yes) {
    const Place A0 = s.place(prefix + "A0"), level{A0.x, drawn.at("T").y};
    drawn.axis(A0, level)
        .offset("T", level, std::numbers::pi / 2, given(s, "r_r"), "$e$")
        .angle_from_x("A0", "A", "$φ$");
  }
  drawn.turning("A0", "A", sign_of(s.givens().angle(prefix.empty() ? "n" : "n_lift")), "$ω_{2}$");
  return std::make_shared<const Mechanism>(std::move(drawn));
}

PolygonSide of_case(const Solution& s, const std::string& prefix, const VectorQuantity& quantity,
                    const std::string& direction, const std::string& magnitude, const std::string& tip) {
  VectorQuantity named = quantity;
  named.name = prefix + quantity.name;
  PolygonSide side = epure::side(s, named, direction, magnitude, tip);
  if (!s.is_reported(named.name)) side.quantity.clear();
  return side;
}

VectorPolygon velocities(const Solution& s, const std::string& prefix, Language language) {
  PolygonSide sought = of_case(s, prefix, moving("v_B3"), along_guide.in(language), "?");
  sought.along = {0, 1};
  return velocity_polygon({sought}, {of_case(s, prefix, moving("v_B2"), "⊥ $A_{0}B$", "$ω_{2}$·$A_{0}B$", "$b_{2}$"),
                                     of_case(s, prefix, moving("v_B32"), "⊥ $AB$", "?", "$b_{3}$")});
}

VectorPolygon accelerations(const Solution& s, const std::string& prefix, Language language) {
  PolygonSide sought = of_case(s, prefix, moving("a_B3"), along_guide.in(language), "?");
  sought.along = {0, 1};
  PolygonSide closing = of_case(s, prefix, moving("a_B32_t"), "⊥ $AB$", "?", "$b_{3}$");
  closing.along = geometry::quarter_turn(s.place(prefix + "B_at") - s.place(prefix + "A_at"));
  return acceleration_polygon({sought},
                              {of_case(s, prefix, moving("a_B2"), "∥ $BA_{0}$", "$ω^{2}_{2}$·$A_{0}B$", "$b_{2}$"),
                               of_case(s, prefix, moving("a_B32_n"), "∥ $BA$", "$v^{2}_{B32}$/$AB$"),
                               of_case(s, prefix, moving("a_coriolis"), "∥ $AB$", "2$ω_{2}v_{B32}$"), closing});
}

}  // namespace epure::cam_dynamics
