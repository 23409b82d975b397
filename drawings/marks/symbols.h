// How each mark looks: lines, vectors, and the kinematic symbols of ISO 3952.
#pragma once

#include <utility>

#include "drawings/marks/canvas.h"

namespace epure::drawings {

inline constexpr double head_length = 3;                      // mm; never more than a third of the vector
inline constexpr double head_angle = 20;                      // degrees, between the two sides
inline constexpr double hinge_radius = 1.2;                   // mm
inline constexpr double dot_radius = 0.6;                     // mm
inline constexpr double block_length = 10, block_height = 6;  // mm: a slider
inline constexpr double step_diameter = 4;                    // mm: the circle around a step's number

// The filled triangle of an arrow: tip exactly at `tip`, `length` mm long.
Path arrow_head(Point tip, Point towards, double length);

// Where the dimension line runs; its text stands beside the middle.
std::pair<Point, Point> dimension_line(const Dimension& dimension);

// Draws the mark on the canvas, whose current clip is the mark's.
void draw(Canvas& canvas, const Mark& mark);

// The circle and number of a construction step.
std::vector<Primitive> circled_number(Point centre, int number, double diameter, Colour colour);

// What is called this in error messages: "arrow 'v_B'".
std::string describe(const Mark& mark, std::size_t index);
// The same for the user, by its name where it has one: "arrow v_B".
Words in_words(const Mark& mark);

}  // namespace epure::drawings
