// A linkage in every place that its drive can bring it to, by a direction that turns once round: paths of its points.
//
// Of a turned link the direction is that of its x axis; where gears make a part of its turns, that of the greatest
// part of its angle of which all wheels make whole ones: once round is so many turns of the link. Of a slid point or
// a cylinder the way along is that of the half angle's tangent, t = y / (1 + x), from -∞ to ∞: so far ahead as a size
// of the linkage for each unit of it from where the point is now, as long as now for each unit of a cylinder, which
// has no length below zero. (1, 0) is where a slid point is now, (0, 1) how long a cylinder is.
#pragma once

#include "geometry/curves/trace.h"
#include "geometry/linkages/carried_out.h"
#include "geometry/linkages/centre_plan.h"

namespace epure::geometry {

namespace linkages {
template <class T, std::size_t N>
struct Constant<Taylor<T, N>> {
  static Vector<Taylor<T, N>> direction(const Angle& angle) {
    return {Taylor<T, N>(cosine<T>(angle)), Taylor<T, N>(sine<T>(angle))};
  }
};
}  // namespace linkages

class EveryPlace {
 public:
  // Of a linkage with one drive; both must outlive it. Throws Impossible where gears are where they were after more
  // than `most_turns` of it only, or of one of them after more than `most_turns_of_a_wheel`: a path would be too
  // long.
  static constexpr int most_turns = 12, most_turns_of_a_wheel = 100;
  EveryPlace(const Linkage& linkage, const std::vector<Step>& steps);

  // Of the turned link, until all wheels are where they were.
  int turns() const { return turns_; }
  // The drive at a direction. Throws Impossible where there is none such, Undecided when that cannot be told.
  template <class T>
  DriveAt<T> drive(const Vector<T>& direction) const;

  // The path of a point, within the frame, not farther from the true one than the tolerance (trace.h).
  Trace path(int point, const Frame& frame, double tolerance) const;

  // The path of a link's instant centre on the frame, which the plan must have: in the plane (the fixed polode); or
  // carried with the link onto where it is `drawn` (the moving one, of a slid point within four sizes of the linkage
  // from where it is). Where the plan's lines lie in each other there is a gap.
  Trace polode(const CentrePlan& plan, int link, const std::optional<PlacedLink<double>>& drawn, const Frame& frame,
               double tolerance) const;

 private:
  const Linkage& linkage_;
  const std::vector<Step>& steps_;
  Rational size_ = 0;
  int turns_ = 1;
};

template <class T>
DriveAt<T> EveryPlace::drive(const Vector<T>& direction) const {
  const Drive& drive = linkage_.drives.front();
  if (std::holds_alternative<TurnedLink>(drive)) return {0, direction, T(0), turns_};
  const T t = quotient(direction.y, T(1) + direction.x);
  if (const auto* slid = std::get_if<SlidPoint>(&drive))
    return {0, direction, from_rational<T>(slid->at) + from_rational<T>(size_) * t};
  const Sign decided = sign(t);
  if (decided == Sign::undecided)
    throw Undecided("whether a cylinder has a length", "se un cilindro abbia una lunghezza");
  if (decided != Sign::positive)
    throw Impossible("a cylinder has no length below zero", "un cilindro non ha lunghezza negativa");
  return {0, direction, from_rational<T>(std::get<Stretched>(drive).length) * t};
}

}  // namespace epure::geometry
