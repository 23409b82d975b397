#include "geometry/curves/asymptotes.h"

#include "geometry/curves/zeros.h"
#include "geometry/numbers/enclosure.h"

namespace epure::geometry {

namespace {

// A simple zero takes some dozen; what doubles cannot settle is not worth more.
constexpr int most_looks_at_w = 1024;

// P x P' with w = 0, which it is at the zero enclosed; to a unit normal.
Line<Bounded> tangent_at_infinity(const ProjectivePoint<BoundedTangent>& P) {
  const Bounded x = P.x.c[0], y = P.y.c[0], w_rate = P.w.c[1];
  const Line<Bounded> l{y * w_rate, -(x * w_rate), x * P.y.c[1] - y * P.x.c[1]};
  const Bounded size = root(square(l.a) + square(l.b));
  return {quotient(l.a, size), quotient(l.b, size), quotient(l.c, size)};
}

}  // namespace

Asymptotes asymptotes(const TracedLocus& locus) {
  const Arithmetic<Bounded> scope;
  const auto w = [&](int arc, const Bounded& t) {
    return locus.at(direction_on_turn(arc, BoundedTangent::parameter(t))).w;
  };
  const Zeros at_infinity = search_zeros(w, most_looks_at_w);
  Asymptotes all{{}, at_infinity.open};
  for (const Zero& zero : at_infinity.found) {
    const auto P = locus.at(direction_on_turn(zero.arc, BoundedTangent::parameter(zero.t)));
    const Line<Bounded> tangent = tangent_at_infinity(P);
    all.lines.push_back({tangent,
                         {enclosure(tangent.a).value, enclosure(tangent.b).value, enclosure(tangent.c).value},
                         zero.direction()});
  }
  return all;
}

}  // namespace epure::geometry
