// Rich text (see Label in picture.h), measured in the shipped fonts.
#pragma once

#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

struct TextSize {
  double width = 0, ascent = 0, descent = 0;  // mm: advance width; ink above and below the baseline
};
// Throws std::invalid_argument, like everything here, for text that is not well formed or holds a character that
// the shipped fonts cannot write.
TextSize measure(const std::string& rich_text, double size, Weight weight = Weight::regular);

// Whether the shipped fonts have all letters of a plain text.
bool can_write(const std::string& plain_text);

// Broken at spaces and line breaks (never inside $...$) so that no line is wider than `width` mm where possible; a
// formula, words with =, + and the like between them, only where no line has room for all of it.
std::vector<std::string> wrap(const std::string& rich_text, double size, double width,
                              Weight weight = Weight::regular);
// In no more lines, of nearly one length: for titles, whose last line would else be a single letter.
std::vector<std::string> wrap_evenly(const std::string& rich_text, double size, double width, Weight weight);

// The text without markup, for search, <desc> and reading aloud: "$\vec{v}_{BA}$" becomes "v_BA", "$a^{n}_{BA}$"
// "a_BA^n".
std::string plain(const std::string& rich_text);

// Plain text as rich text that shows it: a dollar sign opens no mathematics.
std::string escaped(const std::string& plain_text);

}  // namespace epure::drawings
