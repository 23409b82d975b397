#include "geometry/linkages/every_place.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace epure::geometry {
namespace {

template <class X>
std::function<ProjectivePoint<X>(const Vector<X>&)> path_over(const EveryPlace& places, const Linkage& linkage,
                                                              const std::vector<Step>& steps, std::size_t point) {
  const auto carried_out = std::make_shared<const CarriedOut<X>>(linkage, steps);
  return [carried_out, &places, point](const Vector<X>& direction) {
    return projective(carried_out->position(places.drive(direction)).points[point]);
  };
}

// A point that goes with a link, where it is when the link is elsewhere.
template <class X>
ProjectivePoint<X> carried(const ProjectivePoint<X>& P, const PlacedLink<X>& from, const PlacedLink<double>& to) {
  const Vector<X> v{P.x - P.w * from.O.x, P.y - P.w * from.O.y};
  const Vector<X> own{dot(v, from.x), cross(from.x, v)};
  const Vector<X> x{X(Bounded(to.x.x)), X(Bounded(to.x.y))}, turned = own.x * x + own.y * quarter_turn(x);
  return {turned.x + P.w * X(Bounded(to.O.x)), turned.y + P.w * X(Bounded(to.O.y)), P.w};
}

// Of a slid point that is so many sizes of the linkage from where it is now: a wheel that rolls along has turned as
// often as it likes, and its moving polode, which stays about it, would be traced without end.
template <class X>
bool is_far(const Linkage& linkage, const Vector<X>& direction) {
  constexpr int sizes = 4;
  if (!std::holds_alternative<SlidPoint>(linkage.drives.front())) return false;
  const X t = quotient(direction.y, X(1) + direction.x);
  return sign(t * t - X(sizes * sizes)) == Sign::positive;
}

template <class X>
std::function<ProjectivePoint<X>(const Vector<X>&)> polode_over(const EveryPlace& places, const Linkage& linkage,
                                                                const std::vector<Step>& steps,
                                                                const CentrePlan& plan, int link,
                                                                const std::optional<PlacedLink<double>>& drawn) {
  const auto carried_out = std::make_shared<const CarriedOut<X>>(linkage, steps);
  return [carried_out, &places, &linkage, plan = plan.leading_to(0, link), link, drawn](const Vector<X>& direction) {
    if (drawn && is_far(linkage, direction)) return ProjectivePoint<X>{X(1), X(0), X(0)};
    const LinkagePosition<X> at = carried_out->position(places.drive(direction));
    const ProjectivePoint<X> P = Centres<X>(plan, linkage, at).of(0, link);
    return drawn ? carried(P, at.links[static_cast<std::size_t>(link)], *drawn) : P;
  };
}

// To find a linkage is a hundred times as dear as the loci that the usual number is for, and the more so the more
// links it has.
int looks_of(const Linkage& linkage) {
  constexpr int links_of_most = 8;
  const int links = static_cast<int>(linkage.links.size());
  return (usual_looks >> 3) * links_of_most / std::max(links_of_most, links);
}

}  // namespace

EveryPlace::EveryPlace(const Linkage& linkage, const std::vector<Step>& steps) : linkage_(linkage), steps_(steps) {
  assert(linkage.drives.size() == 1);
  for (const Link& link : linkage.links)
    for (const LinkPoint& p : link.points)
      size_ = std::max({size_, Rational(CGAL::abs(p.at.x)), Rational(CGAL::abs(p.at.y))});
  if (size_ == 0) size_ = 1;
  for (const Step& step : steps)
    if (const auto* wheel = std::get_if<GearedWheel>(&step)) {
      const Rational part = turns_ * wheel->turn.times.front();
      const double more = CGAL::to_double(Rational(part.denominator()));
      if (turns_ * more > most_turns)
        throw Impossible("the gears come back to where they were after more than 12 turns of the drive only",
                         "gli ingranaggi tornano dov'erano solo dopo più di 12 giri del movente");
      turns_ *= static_cast<int>(more);
    }
  for (const Step& step : steps)
    if (const auto* wheel = std::get_if<GearedWheel>(&step))
      if (turns_ * std::abs(CGAL::to_double(wheel->turn.times.front())) > most_turns_of_a_wheel)
        throw Impossible("a wheel turns more than 100 times before the gears come back to where they were",
                         "una ruota fa più di 100 giri prima che gli ingranaggi tornino dov'erano");
}

Trace EveryPlace::path(int point, const Frame& frame, double tolerance) const {
  const Arithmetic<Bounded> scope;
  const auto p = static_cast<std::size_t>(point);
  return trace(TracedLocus{path_over<BoundedSeries>(*this, linkage_, steps_, p),
                           path_over<BoundedTangent>(*this, linkage_, steps_, p)},
               frame, tolerance, looks_of(linkage_));
}

Trace EveryPlace::polode(const CentrePlan& plan, int link, const std::optional<PlacedLink<double>>& drawn,
                         const Frame& frame, double tolerance) const {
  const Arithmetic<Bounded> scope;
  return trace(TracedLocus{polode_over<BoundedSeries>(*this, linkage_, steps_, plan, link, drawn),
                           polode_over<BoundedTangent>(*this, linkage_, steps_, plan, link, drawn)},
               frame, tolerance, looks_of(linkage_));
}

}  // namespace epure::geometry
