// Cutting marks to the part of the paper they belong to, so that far geometry costs nothing and no writer ever
// sees a coordinate far outside the sheet.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "drawings/picture.h"

namespace epure::drawings {

// The part of the segment inside the box, end points in the same order; none when they do not meet.
std::optional<std::pair<Point, Point>> clip_segment(Point from, Point to, Box box);

// What shows of the path, in order, cut at the border: curves to within a quarter of a step of the file, inside.
std::vector<Path> clip_path(const Path& path, Box box);

// The area of a closed polygon inside the box (Sutherland and Hodgman); fewer than three corners: nothing.
std::vector<Point> clip_polygon(std::vector<Point> corners, Box box);

}  // namespace epure::drawings
