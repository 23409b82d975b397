// What acts on a linkage from outside, loads and masses, as plain data, and the forces in its joints and drives. As
// linkage.h: both routes read the one and write the other, and nothing of each other (forces_by_groups.h goes from
// group to group, analytic/joint_equations.h has the equilibrium of all links at once). Newtons, metres; couples
// counter-clockwise positive.
#pragma once

#include <variant>
#include <vector>

#include "geometry/linkages/linkage.h"
#include "geometry/numbers/numbers.h"

namespace epure::geometry {

// Of a link, at this place in its own axes: the components, along the axes of the frame, turned by the angle.
struct LinkForce {
  int link;
  Own at;
  Own components;
  Angle turned = {};
};
struct LinkCouple {
  int link;
  Rational moment;
};
// Of a link, with its centre at this place in the link's own axes, and its moment of inertia about there.
struct LinkMass {
  int link;
  Own at;
  Rational mass, inertia = 0;
};
// Coulomb's, between a pin and the line it runs on, or between the two lines of a block: what holds back the sliding
// is the coefficient times what presses.
struct LineFriction {
  bool is_of_block;
  int which;                             // of the linkage's blocks or pins
  std::variant<Rational, Angle> amount;  // the coefficient, or the angle of friction

  template <class T>
  T coefficient() const {
    if (const auto* angle = std::get_if<Angle>(&amount)) return quotient(sine<T>(*angle), cosine<T>(*angle));
    return from_rational<T>(std::get<Rational>(amount));
  }
};
// In the hinges at a point: the force passes its middle by the radius of the friction circle, the pin's radius times
// the sine of the angle of friction.
struct HingeFriction {
  int point;
  Rational radius;
};
// Of what teeth press with along the common tangent of their pitch circles, so much acts along the line of centres,
// on the second wheel away from the first: a wheel's tooth is pressed towards the wheel's own middle, and a ring's
// outwards, whichever flank it is.
template <class T>
T slope_of_teeth(const MeshingLinks& gear) {
  const T slope = quotient(sine<T>(gear.pressure_angle), cosine<T>(gear.pressure_angle));
  return gear.is_inside ? -slope : slope;
}
struct Loads {
  std::vector<LinkForce> forces = {};
  std::vector<LinkCouple> couples = {};
  std::vector<LinkMass> masses = {};
  Own gravity = {0, 0};  // the weight of a unit of mass, along the axes of the frame
  std::vector<LineFriction> frictions = {};
  std::vector<HingeFriction> hinge_frictions = {};

  bool has_friction() const { return !frictions.empty() || !hinge_frictions.empty(); }

  bool has_weight() const { return !masses.empty() && (gravity.x != 0 || gravity.y != 0); }
};
// d'Alembert: what a mass exerts as it moves is minus its mass times the acceleration of its centre, and minus its
// moment of inertia times the angular acceleration.
template <class T>
struct MassInMotion {
  T a_x, a_y, alpha;
};

// Of links that have a point in common the first one carries the pin, and the forces of other pins, guides and drives
// there are its own.
template <class T>
struct JointForces {
  // Of the first link at the point on another one; the couple is of friction.
  struct Hinge {
    int point, by, on;
    T x{0}, y{0}, couple{0};
  };
  // Of the guide on the block: square to the guide, to its left, in the point that the moving line is given through,
  // and a couple; and friction, along the guide in the same point.
  struct Guide {
    T force{0}, couple{0}, friction{0};
  };

  // Of the first wheel on the second, in their pitch point: a quarter turn from the line from the first one's centre
  // to the second one's, and along that line.
  struct Tooth {
    T tangential{0}, radial{0};
  };

  explicit JointForces(const Linkage& linkage)
      : pins(linkage.pins.size(), T(0)),
        pin_frictions(linkage.pins.size(), T(0)),
        guides(linkage.blocks.size()),
        teeth(linkage.gears.size()),
        drives(linkage.drives.size(), T(0)) {
    for (int point = 0; point < linkage.count_of_points(); ++point) {
      const std::vector<int> there = linkage.links_at(point);
      for (std::size_t k = 1; k < there.size(); ++k) hinges.push_back({point, there[0], there[k]});
    }
  }

  std::vector<Hinge> hinges;     // point after point
  std::vector<T> pins;           // of the line on the pin, to the left of the line; as the linkage's pins
  std::vector<T> pin_frictions;  // of the line on the pin, along the line
  std::vector<Guide> guides;     // as its blocks
  std::vector<Tooth> teeth;      // as its gears
  // What presses, and what holds back.
  const T& normal(const LineFriction& of) const { return of.is_of_block ? guides[at(of)].force : pins[at(of)]; }
  T& friction(const LineFriction& of) { return of.is_of_block ? guides[at(of)].friction : pin_frictions[at(of)]; }
  const T& friction(const LineFriction& of) const {
    return of.is_of_block ? guides[at(of)].friction : pin_frictions[at(of)];
  }

  std::vector<T> drives;  // the couple on the link, the force on the point along the guide, of a cylinder its push

 private:
  static std::size_t at(const LineFriction& of) { return static_cast<std::size_t>(of.which); }
};

}  // namespace epure::geometry
