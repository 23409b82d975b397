// What language a PDF is written in.
#pragma once

#include <string>

#include "words/words.h"

namespace epure::drawings {

// The document with /Lang in its catalogue (ISO 32000-1, 14.9.2), which no version of Cairo writes, for readers that
// speak. Unchanged where its catalogue is not plain text and its last object, as Cairo 1.16 has it: a later Cairo may
// pack it among others, and PDF 1.4, which knows of no packing, knows of no text to be copied for letters with
// indices either.
std::string in_language(std::string pdf, Language language);

}  // namespace epure::drawings
