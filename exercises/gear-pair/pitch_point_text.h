// What stands in the column beside the mesh.
#pragma once

#include "exercises/gear-pair/teeth.h"

namespace epure::gear_pair {

// "α = 22°"; of shifted wheels the working one, α_w.
std::string pressure_angle(const DrawnPair& pair, Language language);

// T1 and T2 are shown when what lies between A and E beside them can still be seen.
bool is_near(const DrawnPair& pair, double xi);

// Faults, the steps of the construction, results, and the description for a reader who does not see the sheet.
void add_text(DrawnSheet& onto, const DrawnPair& pair, const Teeth& teeth, Language language);

}  // namespace epure::gear_pair
