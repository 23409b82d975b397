// What language a PDF is written in.
#pragma once

#include <string>

#include "words/words.h"

namespace epure::drawings {

// The document with /Lang in its catalogue (ISO 32000-1, 14.9.2), which no version of Cairo writes, for readers that
// speak. Cairo 1.16 writes the catalogue plain and as the last object; 1.18 packs it with others, and it is written
// once more, in an update of the document (7.5.6). PDF 1.4, which knows of no packing, is no way out: it knows of no
// text to be copied for letters with indices either. Unchanged where the catalogue is found in neither place.
std::string in_language(std::string pdf, Language language);

}  // namespace epure::drawings
