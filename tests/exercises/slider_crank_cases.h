// The two exercises on the slider-crank, checked as the command line checks them, and givens to try them with.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/checked.h"

namespace epure::tests {

inline const std::string of_velocity = "slider-crank-velocity", of_acceleration = "slider-crank-acceleration";

inline const Exercise& exercise(const std::string& id) { return find_exercise(catalogue(), id); }

// The assignments that apply to the exercise: alpha_2 is no given of the first.
inline Givens givens_of(const std::string& id, const std::vector<std::string>& assignments) {
  Givens givens(exercise(id).about().givens);
  for (const std::string& assignment : assignments)
    if (id == of_acceleration || !assignment.starts_with("alpha_2")) givens.set(assignment);
  return givens;
}

inline CheckedExercise checked(const std::string& id, const std::vector<std::string>& assignments) {
  return check(exercise(id), givens_of(id, assignments), Rung::climb);
}

inline const CheckedQuantity* find(const CheckedExercise& checked, const std::string& name) {
  for (const CheckedQuantity& quantity : checked.quantities)
    if (quantity.spec.name == name) return &quantity;
  return nullptr;
}

// What a reader may set: all of it can be solved and drawn.
struct Try {
  std::string why;
  std::vector<std::string> assignments;
};
inline const std::vector<Try>& tries() {
  static const std::vector<Try> all{
      {"as stated", {}},
      {"other lengths and speed", {"r=0.25", "n=400rpm", "t1=1/60s"}},
      {"speeding up", {"alpha_2=100rad/s^2"}},
      {"braking", {"alpha_2=-250"}},
      {"outer dead centre", {"t1=0"}},
      {"inner dead centre", {"t1=1/12s"}},
      {"braking at a dead centre", {"t1=0", "alpha_2=-250"}},
      {"crank upright, pole at infinity", {"t1=1/24s"}},
      {"crank downwards, pole at infinity", {"t1=1/8s"}},
      {"upright and speeding up", {"t1=1/24", "alpha_2=100"}},
      {"nearly upright: the pole 3 km away", {"t1=0.041665"}},
      {"just past a dead centre", {"t1=1e-7"}},
      {"short coupler that closes", {"r=0.4", "l=0.2", "AC=0.15", "BC=0.1", "t1=1/108"}},
      {"short coupler on the left", {"r=0.4", "l=0.2", "AC=0.15", "BC=0.1", "t1=17/216"}},
      {"equal links", {"l=0.2", "AC=0.15", "BC=0.1", "t1=1/42"}},
      {"equal links, folded: B stays on A0", {"l=0.2", "AC=0.15", "BC=0.1", "t1=1/18"}},
      {"20 degrees", {"t1=1/108"}},
      {"a seventh of a turn", {"t1=1/42"}},
      {"a turn of large denominator", {"t1=0.0415"}},
      {"clockwise", {"n=-360"}},
      {"a flat plate", {"AC=0.2", "BC=0.3"}},
      {"a plate beyond B", {"AC=0.7", "BC=0.2"}},
      {"micrometres", {"r=2e-6", "l=5e-6", "AC=3e-6", "BC=4e-6"}},
      {"kilometres", {"r=2000", "l=5000", "AC=3000", "BC=4000"}},
      {"offset", {"e=0.05"}},
      {"offset below", {"e=-0.1"}},
      {"offset, inclined", {"e=0.08", "delta=20"}},
      {"guide downwards to the right", {"e=0.05", "delta=-45"}},
      {"guide at 30 degrees", {"delta=30"}},
      {"guide upwards, offset to its right", {"delta=90", "e=-0.1"}},
      {"guide to the left", {"delta=200", "e=0.05"}},
      {"guide along the crank: a dead centre", {"delta=30", "alpha_2=100"}},
      {"guide square to the crank, offset", {"delta=110", "t1=1/108", "e=0.08"}},
      {"offset dead centre", {"r=0.1", "e=0.3"}},
      {"offset dead centre, folded and inclined", {"e=-0.15", "t1=17/216", "delta=20"}},
      {"offset, the crank just turns fully", {"l=0.3", "AC=0.25", "BC=0.2", "e=0.1", "t1=5/108"}},
      {"offset, neither link turns fully", {"l=0.25", "AC=0.2", "BC=0.15", "e=-0.15", "t1=1/360", "delta=70"}},
      {"offset, the coupler turns fully", {"r=0.4", "l=0.2", "AC=0.15", "BC=0.1", "e=0.1", "t1=17/216"}},
      {"offset, equal links", {"l=0.2", "AC=0.15", "BC=0.1", "e=0.05", "t1=1/42"}},
      {"a ten-thousandth of an offset", {"e=1e-4", "delta=1e-4"}},
  };
  return all;
}

}  // namespace epure::tests
