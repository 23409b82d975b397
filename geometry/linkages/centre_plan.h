// The instant centres of all pairs of links of a linkage: joints give some, and by the theorem of Aronhold and
// Kennedy each of the others is where two lines meet, P_ij on P_ik P_kj and on P_il P_lj. Which lines are crossed is
// chosen once, in doubles, so that they meet well; carried out on any number, by the construction that is drawn.
//
// A pin in a slot is a hinge and a slide with a stone between them: a body more.
#pragma once

#include <optional>
#include <vector>

#include "geometry/linkages/carried_out.h"
#include "geometry/motion/instant_centres.h"

namespace epure::geometry {

// A centre that a joint gives: the hinge `point`; or, of what slides along `line`, at infinity square to it; or where
// the wheels of a `gear` touch, or one of `rolls` its line. i < j; links first, in the order of the linkage, then
// stones.
struct PermanentCentre {
  int i, j;
  int point = nothing, line = nothing, gear = nothing, roll = nothing;

  // What joins them is no hinge and no slide.
  bool is_of_touching() const { return gear != nothing || roll != nothing; }
};
// P_ij of two links on the line of P_ik and P_kj, and on that of P_il and P_lj.
struct FoundCentre {
  int i, j, k, l;
};
struct CentrePlan {
  int bodies = 0;
  std::vector<PermanentCentre> permanent;
  std::vector<FoundCentre> found;  // in the order in which they are found

  // What a joint gives of the two bodies, in either order; none: no joint does.
  const PermanentCentre* permanent_of(int i, int j) const;
  // What P_ij is found by, and it: for who asks for no other. It must have it.
  CentrePlan leading_to(int i, int j) const;
};

// With several drives, or one at rest, joints alone do not tell how links move against each other: nothing is found.
CentrePlan centre_plan(const Linkage& linkage, const LinkagePosition<Fast>& at);

// Of row i and column j in a square table.
inline std::size_t in_square(int i, int j, int side) {
  return static_cast<std::size_t>(i) * static_cast<std::size_t>(side) + static_cast<std::size_t>(j);
}

template <class T>
class Centres {
 public:
  Centres(const CentrePlan& plan, const Linkage& linkage, const LinkagePosition<T>& at) : bodies_(plan.bodies) {
    at_.resize(in_square(bodies_, 0, bodies_));
    for (const PermanentCentre& centre : plan.permanent) put(centre.i, centre.j, of_joint(centre, linkage, at));
    for (const FoundCentre& centre : plan.found)
      put(centre.i, centre.j,
          scaled(meet(line(of(centre.i, centre.k), of(centre.k, centre.j)),
                      line(of(centre.i, centre.l), of(centre.l, centre.j)))));
  }
  // One that the plan has.
  const ProjectivePoint<T>& of(int i, int j) const { return *at_[in_square(i, j, bodies_)]; }

 private:
  void put(int i, int j, const ProjectivePoint<T>& P) {
    at_[in_square(i, j, bodies_)] = P;
    at_[in_square(j, i, bodies_)] = P;
  }
  static ProjectivePoint<T> of_joint(const PermanentCentre& centre, const Linkage& linkage,
                                     const LinkagePosition<T>& at) {
    const auto point = [&](int p) { return at.points[static_cast<std::size_t>(p)]; };
    if (centre.point != nothing) return projective(point(centre.point));
    if (centre.gear != nothing) {
      const MeshingLinks& gear = linkage.gears[static_cast<std::size_t>(centre.gear)];
      const Own on_carrier = linkage.pitch_point(gear);
      return projective(at.links[static_cast<std::size_t>(gear.carrier)].at(
          Vector<T>{from_rational<T>(on_carrier.x), from_rational<T>(on_carrier.y)}));
    }
    if (centre.roll != nothing) {
      const RollingWheel& roll = linkage.rolls[static_cast<std::size_t>(centre.roll)];
      return projective(point(roll.centre) +
                        -(from_rational<T>(roll.radius) * quarter_turn(along(roll.line, linkage, at))));
    }
    const Vector<T> n = quarter_turn(along(centre.line, linkage, at));
    return {n.x, n.y, T(0)};
  }
  static Vector<T> along(int line, const Linkage& linkage, const LinkagePosition<T>& at) {
    return at.links[static_cast<std::size_t>(linkage.link_of_line(line))].turned(
        linkages::unit_vector<T>(linkage.line(line).along));
  }
  // With w = 1 unless it is or may be at infinity: else coordinates grow to the fourth power at each step.
  static ProjectivePoint<T> scaled(const ProjectivePoint<T>& P) {
    const Sign w = sign(P.w);
    return w == Sign::positive || w == Sign::negative ? projective(finite(P)) : P;
  }

  int bodies_;
  std::vector<std::optional<ProjectivePoint<T>>> at_;
};

}  // namespace epure::geometry
