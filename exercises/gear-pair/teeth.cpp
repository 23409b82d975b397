#include "exercises/gear-pair/teeth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawings/paths/vectors.h"

namespace epure::gear_pair {
namespace {

using geometry::BezierArc;
using geometry::OutlinePiece;

constexpr double reach = 1200;  // mm along a pitch line: more than any way across the paper

// What `find` returns; none for what does not exist, or cannot be told.
template <class Find>
auto if_there(const Find& find) -> std::optional<decltype(find())> {
  try {
    return find();
  } catch (const geometry::Impossible&) {
    return {};
  } catch (const geometry::Undecided&) {
    return {};
  }
}

void line_to(drawings::Path& path, drawings::Point p) { path.pieces.push_back({true, {}, {}, p}); }

// A straight line to the end of `other`, and back along it to its start.
void join_reversed(drawings::Path& path, const drawings::Path& other) {
  line_to(path, other.pieces.back().end);
  for (std::size_t i = other.pieces.size(); i-- > 0;) {
    const drawings::Piece& piece = other.pieces[i];
    path.pieces.push_back(
        {piece.straight, piece.second_control, piece.first_control, i == 0 ? other.start : other.pieces[i - 1].end});
  }
}

}  // namespace

Teeth::Teeth(const Pair& pair, double tolerance)
    : pair_(pair), mesh_(if_there([&] { return geometry::mesh_angles(pair.of, pair.shown_contact()); })) {
  if (pair.is_rack(2)) rack_reference_ = CGAL::to_double(geometry::rack_lines(pair.of).reference);
  if (!mesh_) return;
  for (const int wheel : {1, 2})
    outlines_[static_cast<std::size_t>(wheel - 1)] =
        if_there([&] { return geometry::tooth_outline(pair.of, wheel, tolerance); });
}

long Teeth::teeth_on_paper(const Plot& plot, int wheel) const {
  const auto count = static_cast<long>(std::ceil(reach / (pair_.pitch * plot.scale().mm_per_unit)));
  return pair_.is_rack(wheel) ? count : std::min(count, teeth_of(pair_.of, wheel) / 2);
}

Place Teeth::placed(const Place& P, int wheel, double tooth, const geometry::MeshAngles& at) const {
  if (pair_.is_rack(wheel)) return {P.x + at.wheel2 - tooth * pair_.pitch, P.y + rack_reference_};
  const double turn = (wheel == 1 ? at.wheel1 : at.wheel2) +
                      2 * std::numbers::pi * tooth / static_cast<double>(teeth_of(pair_.of, wheel));
  const double c = std::cos(turn), s = std::sin(turn);
  return pair_.O(wheel) + Arrow2{c * P.x - s * P.y, s * P.x + c * P.y};
}

void Teeth::append(drawings::Path& path, const Plot& plot, int wheel, const std::vector<BezierArc>& arcs,
                   double tooth, const geometry::MeshAngles& mesh) const {
  const auto at = [&](const Place& P) { return plot.at(placed(P, wheel, tooth, mesh)); };
  for (const BezierArc& arc : arcs) {
    if (path.pieces.empty()) path.start = at(arc.start);
    path.pieces.push_back({false, at(arc.first_control), at(arc.second_control), at(arc.end)});
  }
}

drawings::Path Teeth::edge(const Plot& plot, int wheel) const {
  const long z = teeth_of(pair_.of, wheel), half = teeth_on_paper(plot, wheel);
  const bool whole = !pair_.is_rack(wheel) && half == z / 2;
  drawings::Path edge;
  for (long k = -half; k < (whole ? z - half : half + 1); ++k)
    for (const OutlinePiece& piece : outline(wheel)->pieces)
      append(edge, plot, wheel, piece.arcs, static_cast<double>(k), *mesh_);
  edge.closed = whole;
  return edge;
}

// The edge, and back along the other side of the rim: where the edge goes all around, a seam joins the two circles.
void Teeth::tint(Plot& plot, int wheel, double depth) const {
  if (!has(wheel)) return;
  const drawings::Path edge = this->edge(plot, wheel);
  drawings::Path around = edge;
  around.closed = true;
  const drawings::Point end = edge.pieces.back().end;
  if (pair_.is_rack(wheel)) {
    const double top = plot.at({0, pair_.root_at_mesh(wheel).y + pair_.rim()}).y;
    line_to(around, {end.x, top});
    line_to(around, {edge.start.x, top});
  } else {
    const double r_root = pair_("r_root_", wheel),
                 back = pair_.is_ring(wheel) ? r_root + pair_.rim() : r_root - depth;
    const drawings::Point O = plot.at(pair_.O(wheel));
    if (back > 0) {
      const double from = drawings::angle_of(edge.start - O);
      double to = edge.closed ? from : drawings::angle_of(end - O);
      if (to <= from) to += 2 * std::numbers::pi;
      join_reversed(around, drawings::arc(O, back * plot.scale().mm_per_unit, from, to));
    } else if (!edge.closed) {
      line_to(around, O);
    }
  }
  plot.mark(drawings::Area{around, wheel == 1 ? Meaning::link : Meaning::plate, {}});
}

void Teeth::draw(Plot& plot, int wheel, Meaning outline_as) const {
  if (has(wheel)) plot.mark(drawings::Line{edge(plot, wheel), outline_as, on("wheel_", wheel)});
}

// The outline runs from right to left: external wheels touch with their left flanks, ring and rack with the right.
const OutlinePiece& Teeth::touching_flank(int wheel) const {
  const auto is_flank = [](const OutlinePiece& piece) { return piece.kind == OutlinePiece::Kind::flank; };
  const auto& pieces = outline(wheel)->pieces;
  return touches_on_the_left(wheel) ? *std::find_if(pieces.rbegin(), pieces.rend(), is_flank)
                                    : *std::find_if(pieces.begin(), pieces.end(), is_flank);
}

void Teeth::draw_flank(Plot& plot, int wheel, double xi) const {
  if (!has(wheel)) return;
  drawings::Path path;
  append(path, plot, wheel, touching_flank(wheel).arcs, 0, geometry::mesh_angles(pair_.of, xi));
  plot.mark(drawings::Line{path, Meaning::alternative, {}});
}

Place Teeth::foot_of_flank(int wheel, double count) const {
  const std::vector<BezierArc>& arcs = touching_flank(wheel).arcs;
  return placed(touches_on_the_left(wheel) ? arcs.back().end : arcs.front().start, wheel, count, *mesh_);
}

Place Teeth::tip_of_tooth(int wheel, double count) const {
  const std::vector<BezierArc>& arcs = touching_flank(wheel).arcs;
  const Place corner = touches_on_the_left(wheel) ? arcs.front().start : arcs.back().end;
  return placed({0, pair_.is_rack(wheel) ? corner.y : std::hypot(corner.x, corner.y)}, wheel, count, *mesh_);
}

Arrow2 Teeth::direction_of_tooth(int wheel, double count) const {
  return placed({0, 1}, wheel, count, *mesh_) - pair_.O(wheel);
}

void draw_sense(Plot& plot, const Pair& pair, int wheel, double radius, double middle, double half) {
  const double way = pair.s[on("omega_", wheel)] > 0 ? 1 : -1, named = middle + 0.4 * half;
  const drawings::Point O = plot.at(pair.O(wheel));
  plot.mark(drawings::Rotation{O, radius, middle - way * half, middle + way * half});
  plot.label(on("$ω_{", wheel) + "}$",
             plot.from_paper({O.x + radius * std::cos(named), O.y + radius * std::sin(named)}), pair.O(wheel));
}

}  // namespace epure::gear_pair
