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

// `path` from its end to its start.
drawings::Path reversed(const drawings::Path& path) {
  if (path.pieces.empty()) return path;
  drawings::Path back{path.pieces.back().end, {}, path.closed};
  for (std::size_t i = path.pieces.size(); i-- > 0;) {
    const drawings::Piece& piece = path.pieces[i];
    back.pieces.push_back(
        {piece.straight, piece.second_control, piece.first_control, i == 0 ? path.start : path.pieces[i - 1].end});
  }
  return back;
}

void line_to(drawings::Path& path, drawings::Point p) { path.pieces.push_back({true, {}, {}, p}); }

// A straight line to where `other` starts, then all of it.
void join(drawings::Path& path, const drawings::Path& other) {
  line_to(path, other.start);
  path.pieces.insert(path.pieces.end(), other.pieces.begin(), other.pieces.end());
}

}  // namespace

Teeth::Teeth(const DrawnPair& pair, double xi, double mm_per_metre) : pair_(pair) {
  const double tolerance = drawings::file_resolution / mm_per_metre;
  for (const int wheel : {1, 2})
    outlines_[static_cast<std::size_t>(wheel - 1)] =
        if_there([&] { return geometry::tooth_outline(pair.of, wheel, tolerance); });
  mesh_ = if_there([&] { return geometry::mesh_angles(pair.of, xi); });
  if (!mesh_) outlines_ = {};
}

double Teeth::rim() const { return 2.5 * CGAL::to_double(pair_.of.m); }

long Teeth::teeth_on_paper(const Plot& plot, int wheel) const {
  const auto count = static_cast<long>(std::ceil(reach / (pair_.pitch * plot.scale().mm_per_unit)));
  if (wheel == 2 && pair_.is_rack()) return count;
  return std::min(count, (wheel == 1 ? pair_.of.z1 : pair_.of.z2) / 2);
}

Place Teeth::placed(const Place& P, int wheel, double tooth, const geometry::MeshAngles& at) const {
  if (wheel == 2 && pair_.is_rack())
    return {P.x + at.wheel2 - tooth * pair_.pitch, P.y + CGAL::to_double(geometry::rack_lines(pair_.of).reference)};
  const double turn = (wheel == 1 ? at.wheel1 : at.wheel2) +
                      2 * std::numbers::pi * tooth / static_cast<double>(wheel == 1 ? pair_.of.z1 : pair_.of.z2);
  const double c = std::cos(turn), s = std::sin(turn);
  const Place& O = wheel == 1 ? pair_.O1 : *pair_.O2;
  return {O.x + c * P.x - s * P.y, O.y + s * P.x + c * P.y};
}

void Teeth::append(drawings::Path& path, const Plot& plot, int wheel, double tooth) const {
  const auto at = [&](const Place& P) { return plot.at(placed(P, wheel, tooth, *mesh_)); };
  for (const OutlinePiece& piece : outline(wheel)->pieces)
    for (const BezierArc& arc : piece.arcs) {
      if (path.pieces.empty()) path.start = at(arc.start);
      path.pieces.push_back({false, at(arc.first_control), at(arc.second_control), at(arc.end)});
    }
}

// The edge, and back along the other side of the rim: where the edge goes all around, a seam joins the two circles.
drawings::Path Teeth::body(const Plot& plot, int wheel, const drawings::Path& edge, double depth) const {
  drawings::Path around = edge;
  around.closed = true;
  const drawings::Point end = edge.pieces.back().end;
  if (wheel == 2 && pair_.is_rack()) {
    const double top = plot.at({0, CGAL::to_double(geometry::rack_lines(pair_.of).root) + rim()}).y;
    line_to(around, {end.x, top});
    line_to(around, {edge.start.x, top});
    return around;
  }
  const Place& centre = wheel == 1 ? pair_.O1 : *pair_.O2;
  const double r_root = (wheel == 1 ? pair_.wheel1 : *pair_.wheel2).circles.r_root;
  const double back = wheel == 2 && pair_.is_ring() ? r_root + rim() : r_root - depth;
  const drawings::Point O = plot.at(centre);
  if (back <= 0) {
    if (!edge.closed) line_to(around, O);
    return around;
  }
  const double from = drawings::angle_of(edge.start - O);
  double to = edge.closed ? from : drawings::angle_of(end - O);
  if (to <= from) to += 2 * std::numbers::pi;
  join(around, reversed(drawings::arc(O, back * plot.scale().mm_per_unit, from, to)));
  return around;
}

void Teeth::draw(Plot& plot, int wheel, Meaning outline_as, double depth) const {
  if (!has(wheel)) return;
  const bool rack = wheel == 2 && pair_.is_rack();
  const long z = wheel == 1 ? pair_.of.z1 : pair_.of.z2, half = teeth_on_paper(plot, wheel);
  const bool whole = !rack && half == z / 2;
  drawings::Path edge;
  for (long k = -half; k < (whole ? z - half : half + 1); ++k) append(edge, plot, wheel, static_cast<double>(k));
  edge.closed = whole;
  plot.mark(drawings::Area{body(plot, wheel, edge, depth), Meaning::plate, {}});
  plot.mark(drawings::Line{edge, outline_as, wheel == 1 ? "wheel_1" : "wheel_2"});
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
  const geometry::MeshAngles at = geometry::mesh_angles(pair_.of, xi);
  const std::vector<BezierArc>& arcs = touching_flank(wheel).arcs;
  const auto on_paper = [&](const Place& P) { return plot.at(placed(P, wheel, 0, at)); };
  drawings::Path path{on_paper(arcs.front().start), {}, false};
  for (const BezierArc& arc : arcs)
    path.pieces.push_back({false, on_paper(arc.first_control), on_paper(arc.second_control), on_paper(arc.end)});
  plot.mark(drawings::Line{path, Meaning::alternative, {}});
}

Place Teeth::foot_of_flank(int wheel, double count) const {
  const std::vector<BezierArc>& arcs = touching_flank(wheel).arcs;
  return placed(touches_on_the_left(wheel) ? arcs.back().end : arcs.front().start, wheel, count, *mesh_);
}

Place Teeth::tip_of_tooth(int wheel, double count) const {
  const std::vector<BezierArc>& arcs = touching_flank(wheel).arcs;
  const Place corner = touches_on_the_left(wheel) ? arcs.front().start : arcs.back().end;
  return placed({0, wheel == 2 && pair_.is_rack() ? corner.y : std::hypot(corner.x, corner.y)}, wheel, count, *mesh_);
}

Arrow2 Teeth::direction_of_tooth(int wheel, double count) const {
  const Place& O = wheel == 1 ? pair_.O1 : *pair_.O2;
  const Place there = placed({0, 1}, wheel, count, *mesh_);
  return {there.x - O.x, there.y - O.y};
}

void draw_arc(Plot& plot, const Place& centre, double radius, double from, double to, Meaning meaning,
              const std::string& name) {
  if (!(to > from)) return;
  plot.mark(
      drawings::Line{drawings::arc(plot.at(centre), radius * plot.scale().mm_per_unit, from, to), meaning, name});
}

}  // namespace epure::gear_pair
