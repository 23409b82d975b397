#include "geometry/gears/contact_path.h"

#include "geometry/gears/rack_form.h"
#include "geometry/gears/tooth_form.h"

namespace epure::geometry {
namespace {

// Where on the line of action the flank of a wheel has its ends.
struct FlankOnLine {
  Deep tip, root;
};

// The contact climbs by ξ sin α along the rack's flank.
FlankOnLine flank_of_rack(const GearPair<Deep>& pair) {
  const RackForm<Deep> form = rack_form<Deep>(pair.given, 0);
  const Deep reference = from_rational<Deep>(rack_lines(pair.given).reference);
  const auto at = [&](const Point<Deep>& P) { return quotient(P.y + reference, pair.alpha.sine); };
  return {at(form.flank_end), at(form.flank_start)};
}

// A point of an involute is touched as far from T as its tangent to the base circle is long: after T1, before T2, of
// a ring after T2.
FlankOnLine flank_on_line(const GearPair<Deep>& pair, int wheel) {
  const PairKind kind = pair.given.kind;
  if (wheel == 2 && kind == PairKind::rack) return flank_of_rack(pair);
  const ToothForm<Deep> form = tooth_form(pair.given, wheel, 0);
  const Deep T = pair.position(wheel == 1 ? pair.T1 : *pair.T2);
  const bool before = wheel == 2 && kind == PairKind::external;
  const auto at = [&](const Deep& t) -> Deep { return before ? T - form.flank.r_b * t : T + form.flank.r_b * t; };
  return {at(form.t_tip), at(form.t_form)};
}

bool is_after(const Deep& xi, const Deep& other) { return sign(xi - other) == Sign::positive; }

}  // namespace

// Where an end of a flank cannot be told from that of the tips, it is that of the tips: so is every tip that is not
// pointed.
ContactPath contact_path(const PairData& of) {
  using By = EndOfContact::By;
  const GearPair<Deep> pair = gear_pair<Deep>(of);
  const FlankOnLine flank1 = flank_on_line(pair, 1), flank2 = flank_on_line(pair, 2);
  ContactPath path{{By::tip, pair.position(pair.A())}, {By::tip, pair.position(pair.E())}};
  if (is_after(flank2.tip, path.begins.xi)) path.begins = {By::point, flank2.tip};
  if (is_after(flank1.root, path.begins.xi)) path.begins = {By::root, flank1.root};
  if (is_after(path.ends.xi, flank1.tip)) path.ends = {By::point, flank1.tip};
  if (is_after(path.ends.xi, flank2.root)) path.ends = {By::root, flank2.root};
  return path;
}

}  // namespace epure::geometry
