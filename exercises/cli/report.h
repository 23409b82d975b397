// Checked exercises as text for people and as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/checked.h"

namespace epure {

// Tables, remarks, and last the line "ID: N quantities, M routes, passed".
std::string text_report(const CheckedExercise& checked);

// Schema epure.check/1.
std::string json_report(const std::vector<CheckedExercise>& all);

// "within reading" or "beyond reading".
std::string verdict(const Measured& measured);

}  // namespace epure
