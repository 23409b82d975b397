// A scene as an exercise: listed, checked and drawn as the others are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "exercises/kit/proof/exercise.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// Whether a name on the command line is that of a file: ID.yaml, or ID.yaml/SHEET.
bool is_scene_file(const std::string& name);

// The exercise of a file. Throws BadScene, also where the file cannot be read.
std::unique_ptr<Exercise> scene_exercise(const std::string& file);
std::unique_ptr<Exercise> scene_exercise(const std::shared_ptr<const Scene>& scene);

}  // namespace epure::scenes
