#include "exercises/kit/linkages/four_bar_mechanism.h"

namespace epure {

Mechanism four_bar_mechanism(const Solution& solution, double sense_of_crank, const std::string& of_case) {
  using Joint = Mechanism::Joint;
  constexpr double beside_B = 0.42;  // radians of the rocker's way
  const auto at = [&](const char* name) { return solution.place(of_case + name); };
  const bool has_plate = solution.has(of_case + "C_x");
  Mechanism mechanism;
  mechanism.point("A0", at("A0"), Joint::fixed, "$A_{0}$")
      .point("A", at("A"), Joint::hinge, "$A$")
      .point("B", at("B"), Joint::hinge, "$B$")
      .point("B0", at("B0"), Joint::fixed, "$B_{0}$");
  if (has_plate) mechanism.point("C", at("C"), Joint::none, "$C$");
  mechanism.body({"A0", "A"}, 2)
      .body(has_plate ? std::vector<std::string>{"A", "B", "C"} : std::vector<std::string>{"A", "B"}, 3)
      .body({"B0", "B"}, 4)
      .axis(at("A0"), at("B0"))
      .path("A0", "A")
      .swing("B0", "B", -beside_B, beside_B)
      .turning("A0", "A", sense_of_crank, "$ω_{2}$");
  return mechanism;
}

}  // namespace epure
