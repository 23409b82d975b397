// What the forces and couples of force_groups.h are called: the quantities that are reported, and their letters.
#pragma once

#include <string>

#include "exercises/kit/statement/forces.h"
#include "exercises/scenes/forces/force_groups.h"

namespace epure::scenes {

// Whether a force on its link is the opposite of what is reported under its name.
bool is_reversed(const Built& built, const ActingForce& force);
// Where it is the force of a line, and there is friction.
const geometry::LineFriction* friction_of(const Built& built, const ActingForce& force);
// What is reported of a force: its name, and its letters for the link it acts on; with an arrow; as a number.
std::string name_of_force(const Built& built, const ActingForce& force);
std::string arrow_of_force(const Built& built, const ActingForce& force, ForcePart part = ForcePart::whole);
std::string letters_of_force(const Built& built, const ActingForce& force, ForcePart part = ForcePart::whole);
// R_23_t and R_23_n.
VectorQuantity part_of_force(const Built& built, const ActingForce& force, ForcePart part);
// R_34, of a hinge or of teeth.
VectorQuantity force_of_two(const Built& built, const ActingForce& force);
// R_A.
VectorQuantity held_force(const Built& built, int point);
// A link that its drive turns, and whose turning does not grow: its inertia is a force alone, away from its hinge.
bool turns_steadily(const Built& built, int link);
// W_3 and F_3, and the couple C_3, of a mass.
VectorQuantity mass_force(const Built& built, const ActingForce& force);
// Letters of its centre, "G" or "G_{3}" within mathematics, and of how that is accelerated, rich text.
std::string letters_of_centre(const Built& built, std::size_t mass);
std::string acceleration_of_centre(const Built& built, std::size_t mass);
Quantity inertia_couple(const Built& built, std::size_t mass);
// The force of a load that is no plain given.
VectorQuantity load_force(const Built& built, std::size_t load);

}  // namespace epure::scenes
