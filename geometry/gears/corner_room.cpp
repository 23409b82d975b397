#include "geometry/gears/corner_room.h"

#include "geometry/gears/tooth_form.h"

#include <optional>

namespace epure::geometry {
namespace {

// The path of the corner in the frame of the tooth it has touched last, whose middle lies on +y, and at which angle
// to the right of +y it is as far from the centre as a given point.
//
// When the flanks touch in P0, the line of centres lies half_angle - inv α_w to the right of the tooth's middle, and
// the corner inv α_corner - inv α_w to the right of the line of centres, seen from the mate's centre. From there the
// wheels roll: while the corner comes to stand at the angle β from the line of centres, that line turns about the
// wheel by z_mate/z times what is missing from β.
class CornerPath {
 public:
  CornerPath(const GearPair<Deep>& pair, int wheel, const ToothForm<Deep>& form, const ToothForm<Deep>& mate)
      : a_(pair.centre_distance),
        r_(mate.flank.r_b * root(Deep(1) + square(mate.t_tip))),
        ratio_(
            from_rational<Deep>(Rational(teeth_of(pair.given, 3 - wheel)) / Rational(teeth_of(pair.given, wheel)))) {
    const Deep inv_w = involute(pair.alpha_w.tangent);
    middle_ = form.flank.half_angle - inv_w + ratio_ * (involute(mate.t_tip) - inv_w);
  }

  // Of the two passages, going in and coming out, the one nearer to the tooth. Nothing where the corner is never so
  // near to the centre.
  std::optional<Deep> angle_at(const Deep& distance) const {
    const Deep cosine = quotient(square(a_) + square(r_) - square(distance), Deep(2) * a_ * r_);
    const Deep squared = Deep(1) - square(cosine);
    if (sign(squared) != Sign::positive) return {};
    const Deep sine = root(squared), beta = arc_tangent(sine, cosine);
    const Deep seen_from_centre = arc_tangent(r_ * sine, a_ - r_ * cosine);
    const Deep aside = seen_from_centre - ratio_ * beta;
    return sign(aside) == Sign::negative ? middle_ + aside : middle_ - aside;
  }

 private:
  Deep a_, r_, ratio_, middle_;
};

}  // namespace

Deep corner_room(const PairData& of, int wheel) {
  const GearPair<Deep> pair = gear_pair<Deep>(of);
  const ToothForm<Deep> form = tooth_form(of, wheel, 0);
  const auto& cut = std::get<GeneratedRoot<Deep>>(form.root);
  const CornerPath corner(pair, wheel, form, tooth_form(of, 3 - wheel, 0));
  const auto room_at = [&](double p) -> std::optional<Deep> {
    const Point<Deep> Q = cut.curve(Deep::from_double(p));
    const Deep distance = length(Vector<Deep>{Q.x, Q.y});
    const auto angle = corner.angle_at(distance);
    if (!angle) return {};
    return distance * (*angle - arc_tangent(Q.x, Q.y));
  };
  std::optional<Deep> least;
  constexpr int places = 32;
  const double from = 1, to = to_bounded(cut.end).inf();
  for (int i = 0; i <= places; ++i) {
    const auto room = room_at(from + (to - from) * i / places);
    if (room && (!least || sign(*room - *least) == Sign::negative)) least = room;
  }
  if (!least)
    throw Impossible("no corner comes as near to the centre as the root curve",
                     "nessuno spigolo arriva vicino al centro quanto la curva di piede");
  return *least;
}

}  // namespace epure::geometry
