// Sizes on paper of what a mechanism is drawn with, and what its pictures, letters and arrows are placed by.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "exercises/kit/panels/mechanism.h"

namespace epure::mechanism_on_paper {

constexpr double guide_behind = 14, guide_ahead = 10, guide_ahead_of_axis = 26;  // mm of it beside the block
constexpr double axis_ahead = 28;                        // mm of the guide's axis, with its name
constexpr double half_block = 5, block_top = 3;          // mm from the hinge
constexpr double angle_radius = 19, from_x_radius = 13;  // mm
constexpr double surface_beyond = 9;                     // mm of the frame on either side of a disc
constexpr double axis_beyond = 8;                        // mm
constexpr double support_height = 7;                     // mm

// From p, `along` mm in a direction and `across` mm to its left.
inline drawings::Point beside(drawings::Point p, double direction, double along, double across) {
  const double c = std::cos(direction), s = std::sin(direction);
  return {p.x + along * c - across * s, p.y + along * s + across * c};
}

inline Arrow2 unit_at(double direction) { return {std::cos(direction), std::sin(direction)}; }

inline double distance_to_segment(const Place& X, const Place& P, const Place& Q) {
  const Arrow2 along = Q - P;
  const double length_squared = dot(along, along);
  const double t = length_squared > 0 ? std::clamp(dot(X - P, along) / length_squared, 0.0, 1.0) : 0;
  return distance(X, P + t * along);
}

constexpr double one_direction = 0.02;  // radians
inline bool has_direction(const std::vector<double>& lines, double direction) {
  return std::any_of(lines.begin(), lines.end(), [&](double line) {
    return std::abs(std::remainder(line - direction, 2 * std::numbers::pi)) < one_direction;
  });
}

}  // namespace epure::mechanism_on_paper
