// Objects of a PDF that its table promises and that are not there.
#pragma once

#include <string>

namespace epure::drawings {

// Cairo 1.16 numbers an element of structure for each link, and writes none where nothing else has a structure; in
// the table of objects these then lie where another one does, and readers that look take the file for damaged. Here
// their entries are free (ISO 32000-1, 7.5.4). Unchanged where the table is no plain text, as a later Cairo has it.
std::string without_missing_objects(std::string pdf);

}  // namespace epure::drawings
