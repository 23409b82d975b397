#include "exercises/friction-efficiency/both_motions.h"

#include <cmath>
#include <numbers>

namespace epure::friction_efficiency {
namespace {

// What the sign of the effort in the retrograde motion says: it holds the load back, or the load alone does not drive
// the mechanism back.
Result what_its_sign_says(const Case& of, const std::string& effort, Language language) {
  const auto retrograde_effort = of.s.value(of.name(effort + retrograde)), ideal = of.s.value(of.name(effort + "_i"));
  if (!retrograde_effort || !ideal || *ideal <= 0) return remark("");
  const std::string letter = "$\\it{" + effort + "}$", primed = "$\\it{" + effort + "}'$";
  const Words holds =
                  format_words(" > 0: like {} it holds the load back.", " > 0: come {} trattiene il carico.", letter),
              at_limit{" = 0: exactly at the limit of self-locking.",
                       " = 0: esattamente al limite dell'arresto spontaneo."},
              pushes = format_words(
                  " < 0: self-locking. The load alone does not drive it back: {} must push the other way.",
                  " < 0: arresto spontaneo. Il carico da solo non lo fa tornare indietro: {} deve spingere nel verso "
                  "opposto.",
                  primed);
  const Words& says = *retrograde_effort > 0 ? holds : *retrograde_effort == 0 ? at_limit : pushes;
  return remark(primed + says.in(language));
}

}  // namespace

VectorQuantity moving(const VectorQuantity& quantity, const std::string& suffix) {
  return in(motion_of(suffix), quantity);
}
Motion motion_of(const std::string& suffix) { return suffix == direct ? Motion::direct : Motion::retrograde; }
VectorQuantity P_of(const std::string& suffix) { return moving(applied_force("P", {}), suffix); }
PolygonSide passed_on(const PolygonSide& force, const VectorQuantity& known, int i, int j, const std::string& suffix,
                      const std::string& tip) {
  PolygonSide side = reaction(force, moving(force_between(i, j), suffix).arrow(), known.length().symbol);
  side.tip = tip;
  return side;
}

std::string turned_from(const std::string& normal, Language language) {
  return "$φ$ " + Words{"from ", "da "}.in(language) + normal;
}

void press(FreeBodyPanel& panel, const Case& of, const PolygonSide& R, const Place& X, double normal, const Arrow2& v,
           const std::string& ji, const std::string& letters_of_normal) {
  panel.force(R, X, Arrow::ends);
  if (is_zero(of.s.givens().angle("phi")) || magnitude(R.v) == 0) return;
  const double force = std::atan2(-R.v.y, -R.v.x);
  panel.turned(X, force - std::remainder(force - normal, std::numbers::pi), force, "$φ$", letters_of_normal);
  panel.sliding(X, v, -R.v, "$\\vec{v}_{" + ji + "}$");
}

Words other_lines(const std::string& english, const std::string& italian) {
  return {"Retrograde motion: forces turned the other way, dashed: " + english + ".",
          "Moto retrogrado: forze volte all'opposto, a tratti: " + italian + "."};
}
std::string prime(const std::string& suffix) { return suffix == retrograde ? "'" : ""; }
std::string below_prime(const std::string& index, const std::string& suffix) {
  return "_{" + index + "}" + (suffix == retrograde ? "^{'}" : "");
}

std::string origin(const std::string& body, const std::string& suffix) {
  return "$O" + below_prime(body, suffix) + "$";
}

std::vector<Arrow2> laid_end_to_end(const std::vector<Arrow2>& vectors) {
  std::vector<Arrow2> corners{{0, 0}};
  for (const Arrow2& v : vectors) corners.push_back(corners.back() + v);
  return corners;
}

Sides sides(const Case& of, const Chain& chain, const std::string& suffix) {
  const PolygonSide contact = of.sought(moving(chain.contact, suffix), chain.along_contact, "$b$");
  return {of.load("Q", chain.along_Q, "$a$"),
          contact,
          of.sought(moving(chain.on_loaded, suffix), chain.along_loaded),
          passed_on(contact, chain.contact, chain.passed_by, std::stoi(chain.driven), suffix, "$a$"),
          of.sought(P_of(suffix), chain.along_P, "$c$"),
          of.sought(moving(chain.on_driven, suffix), chain.along_driven)};
}
ChainedPolygonsPanel polygons(const Case& of, const Chain& chain, const std::string& suffix) {
  const Sides on = sides(of, chain, suffix);
  const PolygonSide& Q = on.Q;
  VectorPolygon first = on.first(chain);
  first.origin = origin(chain.loaded, suffix);
  ChainedPolygonsPanel panel(std::move(first));
  panel.then(on.second(chain), Q.v + on.contact.v).captioned(name_of(motion_of(suffix)));
  const Arrow2 ideal_contact = of.vector(chain.contact.name + "_ideal"), b = Q.v + ideal_contact;
  panel.over(laid_end_to_end({Q.v, ideal_contact, of.vector(chain.on_loaded.name + "_ideal")}));
  panel.over({b, b - ideal_contact, b - ideal_contact + of.vector("P_ideal"), b});
  if (suffix == retrograde) panel.likewise(chain.other_way, Q.v);
  return panel;
}

std::vector<Result> efficiencies(const Case& of, const std::string& effort, Language language) {
  return {of.results({effort + "_i"}), of.results({effort + direct, effort + retrograde}),
          remark("$η_{D}$ = $\\it{" + effort + "}_{i}$/$\\it{" + effort + "}$, $η_{R}$ = $\\it{" + effort +
                 "}'$/$\\it{" + effort + "}_{i}$"),
          of.results({"eta_direct", "eta_retrograde"}), what_its_sign_says(of, effort, language)};
}

}  // namespace epure::friction_efficiency
