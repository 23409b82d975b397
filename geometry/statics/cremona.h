// Cremona's plan of forces of a plane truss: the reciprocal figure, in which each region of the plane (Bow's
// notation) is a point, and the force between two regions, of a bar or from outside, is the way from one point to the
// other.
//
// Going clockwise round a joint from region to region, the ways in the plan are the forces on that joint, one after
// the other: they close. L. Cremona, Le figure reciproche nella statica grafica (1872); R. H. Bow, Economics of
// construction (1873). Metres, newtons.
#pragma once

#include <vector>

#include "geometry/statics/free_bodies.h"
#include "geometry/statics/truss.h"

namespace epure::geometry {

template <class T>
Vector<T> direction_of(const Truss& truss, std::size_t bar) {
  const Vector<Rational> d = along(truss, bar);
  return {from_rational<T>(d.x), from_rational<T>(d.y)};
}

// What a hinge in A and a roller, whose force has a known line of action, answer to these loads. Throws Impossible
// when that line passes through A.
template <class T>
struct SupportReactions {
  Vector<T> hinge, roller;
};
template <class T>
SupportReactions<T> support_reactions(const std::vector<Line<T>>& loads, const Point<T>& A,
                                      const LineOfAction<T>& roller) {
  Line<T> sum{T(0), T(0), T(0)};
  for (const Line<T>& load : loads) sum = sum + load;
  const T arm = moment_about(projective(A), roller.unit());
  if (statics::is_zero(arm, statics::through_question))
    throw Impossible("the truss is unstable: the roller's line of action passes through the hinge",
                     "la travatura è labile: la retta d'azione del carrello passa per la cerniera");
  const Vector<T> answer = quotient(-moment_about(projective(A), sum), arm) * roller.along;
  return {-(sum.direction() + answer), answer};
}

// The regions as points, region 0 in the origin. `outside`: the forces of Truss::outside, in equilibrium.
template <class T>
std::vector<Point<T>> cremona_plan(const Truss& truss, const BowNotation& bow,
                                   const std::vector<Vector<T>>& outside) {
  std::vector<Point<T>> at{{T(0), T(0)}};
  for (std::size_t k = 0; k + 1 < bow.forces.size(); ++k) at.push_back(at.back() + outside[bow.forces[k]]);
  for (const BowNotation::Step& step : bow.steps) {
    const auto ray = [&](std::size_t bar) {
      const auto& [left, right] = bow.sides[bar];
      return line(at[left == step.region ? right : left], direction_of<T>(truss, bar));
    };
    at.push_back(finite(meet(ray(step.bars[0]), ray(step.bars[1]))));
  }
  return at;
}

// The force of the bar times its length, tension positive: the way from the region on its left to that on its right
// is its force on its first joint.
template <class T>
T force_times_length(const Truss& truss, const BowNotation& bow, const std::vector<Point<T>>& plan, std::size_t bar) {
  return dot(plan[bow.sides[bar].right] - plan[bow.sides[bar].left], direction_of<T>(truss, bar));
}

}  // namespace epure::geometry
