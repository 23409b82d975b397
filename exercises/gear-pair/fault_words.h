// A fault of the pair in words.
#pragma once

#include <string>

#include "exercises/gear-pair/drawn_pair.h"

namespace epure::gear_pair {

// "wheel 1", "the ring".
std::string name_of(int wheel, const DrawnPair& pair, Language language);

// One sentence that names the wheel, the numbers and what follows from it.
std::string sentence(const geometry::Fault& fault, const DrawnPair& pair, Language language);

// What stands beside the place in the figure: "undercut".
std::string mark_of(geometry::Fault::Kind kind, Language language);

// A heading and a sentence for every fault; nothing for a pair without one.
void add_faults(DrawnSheet& onto, const DrawnPair& pair, Language language);

}  // namespace epure::gear_pair
