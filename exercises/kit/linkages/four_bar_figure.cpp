#include "exercises/kit/linkages/four_bar_figure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/rounded.h"

namespace epure {
namespace {

using geometry::Deep;

// The way of B about B₀, a little to both sides, and as far as its other positions.
void draw_rocker_arc(Plot& plot, const Place& B0, const Place& B, const std::vector<Place>& other_B) {
  double back = -0.42, forth = 0.42;  // radians
  const double now = direction(B0, B), radius = distance(B0, B) * plot.scale().mm_per_unit;
  for (const Place& X : other_B) {
    const double turned = std::remainder(direction(B0, X) - now, 2 * std::numbers::pi);
    back = std::min(back, turned);
    forth = std::max(forth, turned);
  }
  plot.mark(drawings::Line{drawings::arc(plot.at(B0), radius, now + back, now + forth), Meaning::axis, {}});
}

}  // namespace

Place FourBarFigure::middle() const { return {(A0.x + A.x + B.x + B0.x) / 4, (A0.y + A.y + B.y + B0.y) / 4}; }

void FourBarFigure::draw_links(Plot& plot) const {
  if (C) {
    plot.area({A, B, *C}, Meaning::plate);
    plot.segment(A, *C, Meaning::link);
    plot.segment(B, *C, Meaning::link);
  }
  plot.segment(A0, A, Meaning::link);
  plot.segment(A, B, Meaning::link);
  plot.segment(B0, B, Meaning::link);
}

void FourBarFigure::draw_letters(Plot& plot, const std::vector<Lettered<Place>>& letters) const {
  for (const auto& X : letters) plot.label(X.letter, X.at, middle());
  for (const auto& X : points) {
    plot.dot(X.at, Meaning::link);
    plot.label(X.letter, X.at, C ? C : middle());
  }
}

void FourBarFigure::draw(Plot& plot) const {
  plot.circle(A0, distance(A0, A), Meaning::axis);
  draw_rocker_arc(plot, B0, B, other_B);
  plot.long_segment(A0, B0, 8, Meaning::axis);
  draw_links(plot);
  plot.mark(drawings::FixedHinge{plot.at(A0), direction_of_support(A0, A)});
  plot.mark(drawings::FixedHinge{plot.at(B0), direction_of_support(B0, B)});
  plot.hinge(A);
  plot.hinge(B);
  if (C) plot.dot(*C, Meaning::link);

  draw_sense_of_crank(plot, A0, A, sense);

  std::vector<Lettered<Place>> letters{{"$A_{0}$", A0}, {"$A$", A}, {"$B$", B}, {"$B_{0}$", B0}};
  if (C) letters.push_back({"$C$", *C});
  draw_letters(plot, letters);
}

void FourBarFigure::sketch(Plot& plot) const {
  draw_links(plot);
  std::vector<Lettered<Place>> letters{{"$A_{0}$", A0}, {"$A$", A}, {"$B$", B}, {"$B_{0}$", B0}};
  if (C) letters.push_back({"$C$", *C});
  for (const auto& X : letters) plot.dot(X.at, Meaning::link);
  draw_letters(plot, letters);
}

void FourBarFigure::include(Extent& extent, const Scale& scale) const {
  const double r = distance(A0, A);
  extent.include(scale, {A0.x - r, A0.y - r}, 2);
  extent.include(scale, {A0.x + r, A0.y + r}, 2);
  for (const Place& hinge : {A0, B0}) extent.include(scale, hinge, 11);  // its support
  extent.include(scale, B, 8);
  if (C) extent.include(scale, *C, 8);
  for (const auto& X : points) extent.include(scale, X.at, 8);
}

std::vector<Place> FourBarFigure::corners() const {
  std::vector<Place> all{A0, A, B, B0};
  if (C) all.push_back(*C);
  return all;
}

double FourBarFigure::reach() const {
  const double r = distance(A0, A);
  double farthest = std::max(distance(A0, B0), distance(A0, B));
  if (C) farthest = std::max(farthest, distance(A0, *C));
  return r + farthest;
}

FourBarFigure drawn_four_bar(const geometry::FourBar<Deep>& at, double sense) {
  FourBarFigure figure;
  figure.A = to_double(at.A);
  figure.B = to_double(at.B);
  figure.B0 = to_double(at.B0);
  figure.sense = sense;
  return figure;
}

VectorPolygon velocity_polygon(const geometry::FourBar<Deep>& at, const geometry::FourBarMotion<Deep>& motion,
                               const std::string& prefix) {
  const auto& v = motion.velocity;
  const Arrow2 square_to_AB = to_double(geometry::quarter_turn(at.B - at.A));
  const Arrow2 square_to_B0B = to_double(geometry::quarter_turn(at.B - at.B0));
  return {.meaning = Meaning::velocity,
          .unit = "m/s",
          .origin = "$O_{v}$",
          .left = {{.quantity = prefix + "v_B",
                    .label = "$\\vec{v}_{B}$",
                    .direction = "⊥ $B_{0}B$",
                    .magnitude = "?",
                    .v = to_double(v.v_X),
                    .along = square_to_B0B}},
          .right = {{.quantity = prefix + "v_A",
                     .label = "$\\vec{v}_{A}$",
                     .direction = "⊥ $A_{0}A$",
                     .magnitude = "$ω_{2}$·$A_{0}A$",
                     .v = to_double(v.first.known),
                     .tip = "$a'$"},
                    {.quantity = prefix + "v_BA",
                     .label = "$\\vec{v}_{BA}$",
                     .direction = "⊥ $AB$",
                     .magnitude = "?",
                     .v = to_double(v.first.closing),
                     .tip = "$b'$",
                     .along = square_to_AB}}};
}

VectorPolygon acceleration_polygon(const geometry::FourBar<Deep>& at, const geometry::FourBarMotion<Deep>& motion,
                                   const std::string& prefix) {
  const auto& a = motion.acceleration;
  const PolygonSide crank_normal{.label = "$\\vec{a}^{n}_{A}$",
                                 .direction = "∥ $AA_{0}$",
                                 .magnitude = "$ω^{2}_{2}$·$A_{0}A$",
                                 .v = to_double(-(square(motion.crank.omega) * (at.A - at.A0)))};
  const PolygonSide crank_tangential{.label = "$\\vec{a}^{t}_{A}$",
                                     .direction = "⊥ $A_{0}A$",
                                     .magnitude = "$α_{2}$·$A_{0}A$",
                                     .v = to_double(motion.crank.alpha * quarter_turn(at.A - at.A0)),
                                     .tip = "$a'$"};
  const PolygonSide coupler_normal{.quantity = prefix + "a_BA_n",
                                   .label = "$\\vec{a}^{n}_{BA}$",
                                   .direction = "∥ $BA$",
                                   .magnitude = "$ω^{2}_{3}$·$AB$",
                                   .v = to_double(a.first.normal)};
  const PolygonSide coupler_tangential{.quantity = prefix + "a_BA_t",
                                       .label = "$\\vec{a}^{t}_{BA}$",
                                       .direction = "⊥ $AB$",
                                       .magnitude = "?",
                                       .v = to_double(a.first.closing),
                                       .tip = "$b'$",
                                       .along = to_double(geometry::quarter_turn(at.B - at.A))};
  const PolygonSide rocker_normal{.quantity = prefix + "a_B_n",
                                  .label = "$\\vec{a}^{n}_{B}$",
                                  .direction = "∥ $BB_{0}$",
                                  .magnitude = "$ω^{2}_{4}$·$B_{0}B$",
                                  .v = to_double(a.second.normal)};
  const PolygonSide rocker_tangential{.quantity = prefix + "a_B_t",
                                      .label = "$\\vec{a}^{t}_{B}$",
                                      .direction = "⊥ $B_{0}B$",
                                      .magnitude = "?",
                                      .v = to_double(a.second.closing),
                                      .along = to_double(geometry::quarter_turn(at.B - at.B0))};
  const auto unless_zero = [](PolygonSide side) {
    if (side.v.x == 0 && side.v.y == 0) side.magnitude = "0";
    return side;
  };
  VectorPolygon polygon{.meaning = Meaning::acceleration, .unit = "m/s²", .origin = "$O_{a}$"};
  polygon.left = {unless_zero(rocker_normal), rocker_tangential};
  if (geometry::sign(motion.crank.alpha) == geometry::Sign::zero) {
    PolygonSide whole = crank_normal;
    whole.quantity = prefix + "a_A";
    whole.label = "$\\vec{a}_{A}$";
    whole.tip = "$a'$";
    polygon.right = {whole, unless_zero(coupler_normal), coupler_tangential};
  } else {
    polygon.right = {crank_normal, crank_tangential, unless_zero(coupler_normal), coupler_tangential};
  }
  return polygon;
}

}  // namespace epure
