// Rich text set in the shipped fonts: which glyph stands where. Measuring and both writers use this one result, so
// what was measured is what is drawn.
#pragma once

#include <string>
#include <vector>

#include "drawings/page.h"
#include "drawings/text/fonts.h"
#include "drawings/text/text.h"

namespace epure::drawings {

struct SetGlyph {
  unsigned index = 0;
  Point at;          // mm from the left end of the baseline
  std::string text;  // what it adds to the plain text; lowered and raised parts begin with "_" and "^"
};
struct GlyphRun {
  Face face = Face::regular;
  double size = 0;  // mm
  std::vector<SetGlyph> glyphs;
  std::string letters;  // as they were given to be shaped
  Point start;          // of the first, mm from the left end of the baseline
};
struct SetText {
  std::vector<GlyphRun> runs;  // their texts one after the other are the plain text
  std::vector<Path> arrows;    // to be filled
  TextSize extent;
};
// What was set before is not set again, so measuring a label makes drawing it cheap. Good until this thread's next
// call.
const SetText& typeset(const std::string& rich_text, double size, Weight weight);

}  // namespace epure::drawings
