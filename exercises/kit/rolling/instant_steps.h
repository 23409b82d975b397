// What is done to find velocity, acceleration and curvature at an instant of a rolling motion, step by step.
#pragma once

#include <vector>

#include "exercises/kit/rolling/rolled.h"

namespace epure {

struct InstantStep {
  enum class At { contact, inflection_pole, tip_of_velocity, foot, acceleration, centre_of_curvature };
  Words text;
  At at;
};

// Inflection pole, velocity, foot on the ray, acceleration, curvature; fewer at a cusp and on a straight path.
std::vector<InstantStep> instant_steps(const Rolled& f);

}  // namespace epure
