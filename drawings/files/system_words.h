// What the system says of a call that failed.
#pragma once

#include "words/words.h"

namespace epure::drawings {

// errno in words: "No space left on device". What is rare is said in English.
Words system_words(int error);

}  // namespace epure::drawings
