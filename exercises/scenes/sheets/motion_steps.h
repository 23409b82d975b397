// How the velocities or accelerations of a scene are found, in words: link after link in the order of the
// construction, by what drives them, and by the polygons, which have sheets of their own.
#pragma once

#include <string>
#include <vector>

#include "exercises/scenes/scene.h"
#include "exercises/scenes/sheets/sheet_numbers.h"

namespace epure::scenes {

struct MotionStep {
  Words text;
  std::string of = {};    // a point: the step stands at its vector; empty: it is drawn on another sheet
  std::string from = {};  // another point: the vector is a sum that begins with this one's
};
std::vector<MotionStep> motion_steps(const Built& built, bool is_of_velocities, const SheetNumbers& numbers);

}  // namespace epure::scenes
