// What is left of the path of contact where flanks are not whole, in words.
#pragma once

#include <string>

#include "exercises/gear-pair/drawn_pair.h"

namespace epure::gear_pair {

// "AE", "F_{1}E": rich text between dollars.
std::string name_of_path(const DrawnPath& path);

// For a description in plain text: "F1".
std::string plain_name(const DrawnPath::End& end);

// Of the path that is left: "$f$ = $F_{1}E$/$p_{b}$ = 1.021".
std::string true_contact_ratio(const DrawnPair& pair, Language language);

// One sentence after `whole`, the clause that says what holds of whole flanks only: where contact begins and ends in
// truth, or only that clause when that is not known. The pair has contact, and its path is not whole.
std::string about_path(const DrawnPair& pair, const Words& whole, Language language);

}  // namespace epure::gear_pair
