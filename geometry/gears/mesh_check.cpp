#include "geometry/gears/mesh_check.h"

#include "geometry/gears/arc_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace epure::geometry {

namespace {

using Kind = OutlinePiece::Kind;

// Right and left as seen in the outline's own frame; the outline runs from right to left.
std::vector<BezierArc> chosen(const ToothOutline& outline, Flanks flanks, bool left_drives) {
  std::vector<BezierArc> arcs;
  const bool left = (flanks == Flanks::driving) == left_drives;
  int flanks_seen = 0;
  for (const OutlinePiece& piece : outline.pieces) {
    const bool is_left_flank = piece.kind == Kind::flank && flanks_seen++ == 1;
    if (flanks == Flanks::all || (piece.kind == Kind::flank && is_left_flank == left))
      arcs.insert(arcs.end(), piece.arcs.begin(), piece.arcs.end());
  }
  return arcs;
}

// From an outline's own frame into that of the pair.
struct Placement {
  Bounded cosine, sine;
  Point<Bounded> origin;
  Point<Bounded> operator()(const Point<double>& P) const {
    const Bounded x(P.x), y(P.y);
    return {origin.x + cosine * x - sine * y, origin.y + sine * x + cosine * y};
  }
};

// The room a tooth takes in its outline's frame, by its control points; rounded outwards.
struct Extent {
  Point<double> centre = {0, 0};            // on the tooth's middle line
  double radius = 0;                        // everything lies within it about the centre
  double nearest = INFINITY, farthest = 0;  // of the control points, from the origin
  double lowest = INFINITY, highest = -INFINITY;
};

template <class Take>
void for_each_point(const ToothOutline& outline, const Take& take) {
  for (const OutlinePiece& piece : outline.pieces)
    for (const BezierArc& arc : piece.arcs)
      for (const Point<double>& P : {arc.start, arc.first_control, arc.second_control, arc.end}) take(P);
}

Extent extent(const ToothOutline& outline) {
  Extent all;
  const auto from = [](const Point<double>& C, const Point<double>& P) {
    return distance(Point<Bounded>{Bounded(C.x), Bounded(C.y)}, Point<Bounded>{Bounded(P.x), Bounded(P.y)});
  };
  for_each_point(outline, [&](const Point<double>& P) {
    const Bounded r = from({0, 0}, P);
    all.nearest = std::min(all.nearest, r.inf());
    all.farthest = std::max(all.farthest, r.sup());
    all.lowest = std::min(all.lowest, P.y);
    all.highest = std::max(all.highest, P.y);
  });
  all.centre.y = all.lowest / 2 + all.highest / 2;
  for_each_point(outline,
                 [&](const Point<double>& P) { all.radius = std::max(all.radius, from(all.centre, P).sup()); });
  return all;
}

// What the teeth of one wheel may touch of the other.
struct Other {
  enum class Body { wheel, ring, rack } body;
  Point<Bounded> centre;
  Extent tooth;
  // Whether something within `radius` of P may be nearer than `horizon` to the other body.
  bool is_near(const Point<Bounded>& P, double radius, double horizon) const {
    const double reach = radius + horizon;
    switch (body) {
      case Body::wheel:
        return !((distance(P, centre) - Bounded(reach)).inf() > tooth.farthest);
      case Body::ring:  // an arc may come nearer to the centre than its control points, but not by its own length
        return !((distance(P, centre) + Bounded(reach) + Bounded(2 * tooth.radius)).sup() < tooth.nearest);
      default:
        return !((P.y - centre.y + Bounded(reach)).sup() < tooth.lowest);
    }
  }
};

// One wheel's teeth in the frame of the pair.
struct Teeth {
  long z = 0;     // 0: a rack
  Bounded pitch;  // of a rack
  Point<Bounded> centre;
  double turned;   // or moved along x
  double to_mesh;  // the angle by which a tooth on +y is turned away from the other wheel

  Placement place(long k) const {
    if (z == 0)
      return {
          Bounded(1), Bounded(0), {centre.x + Bounded(turned) + Bounded(static_cast<double>(k)) * pitch, centre.y}};
    const Bounded angle =
        Bounded(turned) + Bounded(static_cast<double>(2 * k)) * pi<Bounded>() / Bounded(static_cast<double>(z));
    return {cosine_of_angle(angle), sine_of_angle(angle), centre};
  }
  // The tooth nearest to the pitch point, or one beside it.
  long first() const {
    const double share =
        z == 0 ? -turned / pitch.inf() : (to_mesh - turned) * static_cast<double>(z) / (2 * pi<Fast>());
    return std::lround(share);
  }
};

// The teeth that may be near the other body. Away from the line of centres the distance only grows, so the first
// tooth that is too far on either side ends the search there.
std::vector<EnclosedArc> near_teeth(const Teeth& teeth, const std::vector<BezierArc>& arcs, const Extent& tooth,
                                    const Other& other, double horizon) {
  std::vector<EnclosedArc> placed;
  const auto take = [&](long k) {
    const Placement place = teeth.place(k);
    if (!other.is_near(place(tooth.centre), tooth.radius, horizon)) return false;
    for (const BezierArc& arc : arcs)
      placed.push_back({place(arc.start), place(arc.first_control), place(arc.second_control), place(arc.end)});
    return true;
  };
  const long first = teeth.first(), most = teeth.z == 0 ? std::numeric_limits<long>::max() : teeth.z - 1;
  long ahead = 0, behind = 0;
  take(first);
  while (ahead + behind < most && take(first + ahead + 1)) ++ahead;
  while (ahead + behind < most && take(first - behind - 1)) ++behind;
  return placed;
}

}  // namespace

ArcGap mesh_gap(const PairData& of, const ToothOutline& wheel1, const ToothOutline& wheel2, const MeshAngles& angles,
                Flanks flanks, double accuracy, double horizon) {
  const Arithmetic<Bounded> scope;
  const MeshCentres centres = mesh_centres(of);
  const Bounded pitch = pi<Bounded>() * from_rational<Bounded>(of.m);
  const bool is_rack = of.kind == PairKind::rack, is_external = of.kind == PairKind::external;
  const Extent extent1 = extent(wheel1), extent2 = extent(wheel2);
  const Teeth first{of.z1, pitch, centres.wheel1, angles.wheel1, 0};
  const Teeth second{is_rack ? 0 : of.z2, pitch, centres.wheel2, angles.wheel2, is_external ? pi<Fast>() : 0};
  const Other::Body body2 = is_rack ? Other::Body::rack : is_external ? Other::Body::wheel : Other::Body::ring;
  const auto of_first =
      near_teeth(first, chosen(wheel1, flanks, true), extent1, {body2, centres.wheel2, extent2}, horizon);
  const auto of_second = near_teeth(second, chosen(wheel2, flanks, is_external), extent2,
                                    {Other::Body::wheel, centres.wheel1, extent1}, horizon);
  return arc_gap(of_first, of_second, accuracy, horizon);
}

}  // namespace epure::geometry
