// A scene as an exercise: listed, checked and drawn as the others are.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "exercises/kit/proof/exercise.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// A name on the command line that is one of a file: ID.yaml, or ID.yaml/SHEET; of standard input: -, or
// /dev/stdin/SHEET; of a shipped file: its id, or ID/SHEET. None: it is that of an exercise.
struct SceneName {
  std::string file, sheet;  // "/SHEET", or empty
};
std::optional<SceneName> scene_name(const std::string& name);

std::unique_ptr<Exercise> scene_exercise(const std::shared_ptr<const Scene>& scene);

}  // namespace epure::scenes
