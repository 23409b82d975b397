// Mechanisms of which a test says the file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "exercises/scenes/scene.h"
#include "exercises/scenes/scene_exercise.h"
#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline std::unique_ptr<Exercise> exercise_said(const std::string& text) {
  return scenes::scene_exercise(std::make_shared<const scenes::Scene>("f", text));
}

// At its own givens, but for those that are set. (What it tells of the exercise is gone with that.)
inline CheckedExercise checked_text(const std::string& text, const Assignments& set = {}) {
  const auto exercise = exercise_said(text);
  Givens givens(exercise->about().givens);
  for (const std::string& each : set) givens.set(each);
  return check(*exercise, givens, Rung::climb);
}

// With nothing that is undecided.
inline void passes(const std::string& text) {
  const CheckedExercise result = checked_text(text);
  CAPTURE(text, complaints(result));
  CHECK(result.passed());
  CHECK(result.undecided.empty());
}

}  // namespace epure::tests
