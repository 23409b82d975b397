// The contact of a pair in words: its ratio, and where it begins and ends when flanks are not whole.
#pragma once

#include "exercises/gear-pair/pair.h"

namespace epure::gear_pair {

// "Contact ratio f = e/p = 1.557 > 1: ... the motion is continuous." Of whole flanks.
Words about_ratio(const Pair& pair);

// That of the table of results, and where flanks are not whole what is left of it.
Words both_contact_ratios(const Pair& pair);

// One sentence after `whole`, the clause that says what holds of whole flanks only: where contact begins and ends in
// truth, or only that clause when that is not known. The pair has contact, and its path is not whole.
Words about_path(const Pair& pair, const Words& whole);

}  // namespace epure::gear_pair
