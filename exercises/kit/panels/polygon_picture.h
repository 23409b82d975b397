// A vector equation with two unknowns, drawn as the polygon that solves it.
//
// Both sides of the equation start at the origin O and end in the same point. Either two magnitudes are unknown:
//   left side: its known vectors, then the sought one;  right side: the known ones, then the closing one.
// Or one vector is, in direction and magnitude: the only one of the left side; on the right all are known.
// What is subtracted (left = a - b) is drawn towards the polygon: its tip lies where the side before it ends, and the
// next side begins where it begins.
// A polygon of forces in equilibrium is a loop: right + left = 0, so the left side is drawn backwards and leads from
// the corner where the right one ends to the origin again.
// The polygon is drawn in steps, as with set squares: each known vector, then the line that carries the last vector
// of the right side, then the same for the left side; where the two lines meet, the polygon is closed. A vector of
// unknown direction closes it in one step.
// Vectors that would lie on one another stand beside each other (tracks.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/compare.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/plot.h"

namespace epure {

struct PolygonSide {
  std::string quantity = {};   // "a_BA_t": what the side measures on the sheet; empty: nothing that is reported
  std::string label = {};      // "$\\vec{a}^{t}_{BA}$"
  std::string direction = {};  // "⊥ $BA$"; "?" when unknown
  std::string magnitude = {};  // "$ω^{2}_{3}$·$BA$"; "?" when unknown; "0": stands in the equation only, is not drawn
  Arrow2 v = {};
  std::string tip = {};  // letter at its end, "$b'$"; empty: none
  Arrow2 along = {};     // of an unknown: the line it lies on, which its vector does not tell when it is zero
  std::optional<double> length = {};  // its value, told where the vector is too short for an arrow
  bool square = false;         // to the side before it, which a mark says: a tangential part after the normal one
  bool is_subtracted = false;  // then `tip` stands where it begins
  bool is_drawn() const { return magnitude != "0"; }
  bool is_unknown() const { return magnitude == "?"; }
  bool closes_alone() const { return is_unknown() && direction == "?"; }
};

// The image of another point of a body whose two points have their images in the polygon. Or only the sum of sides:
// from the origin, or between two corners. What has no label is not drawn, but for the third side of a triangle.
struct PolygonImage {
  PolygonSide absolute;          // from O; quantity "v_C", tip "$c'$"
  PolygonSide relative = {};     // its last part, "v_CA"
  Words explained = {};          // one step: how the point is found; none for a sum
  bool closes_triangle = false;  // `relative` is a side of a triangle that is found by its shape: a line, no vector
  bool draws_relative() const { return !closes_triangle && !relative.label.empty(); }
  bool draws_absolute() const { return !absolute.label.empty(); }
};

struct VectorPolygon {
  Meaning meaning = Meaning::velocity;
  std::string unit;    // "m/s"
  std::string origin;  // "$O_{v}$"
  std::vector<PolygonSide> left = {}, right = {};
  std::vector<PolygonImage> images = {};
  bool loop = false;
};

// As the course writes it, with direction and magnitude below each vector.
drawings::VectorEquation equation(const VectorPolygon& polygon);

// The steps in words, in the order in which they are drawn: the sides, then the images.
std::vector<std::string> steps_of(const VectorPolygon& polygon, Language language);

// Where the numbers of these steps stand, in the plane of the vectors at this scale.
std::vector<Place> places_of_steps(const VectorPolygon& polygon, const Scale& scale);

// The number of steps that draw the sides; the images follow.
int steps_of_sides(const VectorPolygon& polygon);

// Vector by vector its magnitude, and what a ruler reads on the sheet. What the sheet does not show is left out.
drawings::Table measured_table(const DrawnSheet& sheet, const VectorPolygon& polygon, Language language);

// The rows of such a table: what is too short for a ruler has none.
std::vector<Comparison> measured_rows(const Readings& readings, const VectorPolygon& polygon);

// The angle (0 to pi/2) between the two lines that close it; nothing where a single vector does.
std::vector<double> crossings_of(const VectorPolygon& polygon);

// The origin, where each side ends and where each image lies.
std::vector<Place> corners_of(const VectorPolygon& polygon);

// The longest vector.
double greatest(const VectorPolygon& polygon);

// With its lines and room for letters.
drawings::Box extent_of(const VectorPolygon& polygon, const Scale& scale);
// How much of the polygon is drawn: its first `steps` steps. When numbered, each step from `first_numbered` on has
// its number where it happens. Before it is `closed` an unknown vector is only the line it lies on. Quantities are
// measured on the whole polygon only.
struct PolygonStage {
  int steps = 1000;
  bool numbered = true;
  int first_numbered = 1;
  bool closed = true;
  Language language = Language::english;
  int numbers_after = 0;  // the steps of another polygon of the sheet, whose numbers these continue
};
void draw_polygon(Plot& plot, const VectorPolygon& polygon, const PolygonStage& stage);
inline void draw_polygon(Plot& plot, const VectorPolygon& polygon) { draw_polygon(plot, polygon, PolygonStage{}); }

}  // namespace epure
