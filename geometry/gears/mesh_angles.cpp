#include "geometry/gears/mesh_angles.h"

#include "geometry/gears/rack_form.h"
#include "geometry/gears/tooth_form.h"
#include "geometry/gears/tooth_thickness.h"
#include "geometry/numbers/enclosure.h"

namespace epure::geometry {

namespace {

constexpr long bits_of_contact = 128;

// The involute that is turned by β and touched at the tangent t begins where the common tangent touches the base
// circle, π/2 - α_w, turned on by t.
struct Contact {
  Deep alpha_w, tangent_w;
  RightFlank<Deep> flank;
  Deep t(const Deep& xi) const { return tangent_w + quotient(xi, flank.r_b); }
};

Contact contact(const GearPair<Deep>& pair, int wheel) {
  return {arc_tangent(pair.alpha_w.sine, pair.alpha_w.cosine), pair.alpha_w.tangent, right_flank(pair, wheel)};
}

// Of the left flank of a wheel whose base circle the common tangent leaves towards the upper left.
Deep left_flank(const Contact& at, const Deep& xi) { return at.t(xi) - at.alpha_w - at.flank.half_angle; }
// Of the right flank of a ring.
Deep ring_flank(const Contact& at, const Deep& xi) { return at.t(xi) - at.alpha_w + at.flank.half_angle; }

// The point of contact lies at (-ξ cos α, ξ sin α), on the right flank of the rack's tooth.
Deep rack_position(const PairData& of, const GearPair<Deep>& pair, const Deep& xi) {
  const Deep height = xi * pair.alpha.sine - from_rational<Deep>(of.m * of.x1);
  const Deep half = quotient(rack_tooth_thickness(pair, Deep(0)), Deep(2));
  return -xi * pair.alpha.cosine - half - height * pair.alpha.tangent;
}

}  // namespace

MeshAngles mesh_angles(const PairData& of, double position) {
  const Arithmetic<Bounded> scope;
  return doubles_first(bits_of_contact, [&]() -> MeshAngles {
    const GearPair<Deep> pair = gear_pair<Deep>(of);
    const Deep xi = Deep::from_double(position);
    const auto second = [&]() -> Deep {
      switch (of.kind) {
        case PairKind::rack:
          return rack_position(of, pair, xi);
        case PairKind::internal:
          return ring_flank(contact(pair, 2), xi);
        default:  // half a turn about P0 exchanges the wheels, approach and recess
          return pi<Deep>() + left_flank(contact(pair, 2), -xi);
      }
    };
    return {enclosure(left_flank(contact(pair, 1), xi)).value, enclosure(second()).value};
  });
}

MeshCentres mesh_centres(const PairData& of) {
  const Arithmetic<Bounded> scope;
  const Arithmetic<Deep> deep_scope(bits_of_contact);
  const GearPair<Deep> pair = gear_pair<Deep>(of);
  const Deep height = pair.O2 ? pair.O2->y : from_rational<Deep>(rack_lines(of).reference);
  return {{0, to_bounded(pair.O1.y)}, {0, to_bounded(height)}};
}

}  // namespace epure::geometry
