// What language a PDF is written in.
#pragma once

#include <string>

#include "words/words.h"

namespace epure::drawings {

// The document with /Lang in its catalogue (ISO 32000-1, 14.9.2), which no version of Cairo writes, for readers that
// speak. Where the catalogue is plain text and its last object, as Cairo 1.16 has it, it stands in there; where it is
// packed among others, as Cairo 1.18 has it, a catalogue behind the end of the document stands for it (7.5.6).
// Unchanged where it is neither.
std::string in_language(std::string pdf, Language language);

}  // namespace epure::drawings
