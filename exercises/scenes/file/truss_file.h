// A truss from a file: joints, bars, supports and loads of the user's own. docs/trusses.md teaches the format.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "exercises/kit/proof/exercise.h"

namespace epure::scenes {

// None where the file is one of a mechanism. Throws BadScene.
std::unique_ptr<Exercise> truss_of_text(const std::string& file, std::string_view bytes);

}  // namespace epure::scenes
