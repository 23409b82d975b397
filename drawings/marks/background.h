// Pages for other grounds than white paper: slides and web pages that are dark.
#pragma once

#include <optional>

#include "drawings/page.h"

namespace epure::drawings {

enum class Inks { dark, light };

struct Background {
  std::optional<Colour> colour = {};  // painted behind all, opaque; none: the page of the reader shows through
  Inks inks = Inks::dark;
};

// WCAG 2.1: the contrast of two opaque colours, from 1 to 21, and what letters need at least (1.4.3).
double contrast(const Colour& a, const Colour& b);
inline constexpr double legible = 4.5;

// A dark sheet, and what light inks expect of a page that is not known.
inline constexpr Colour dark_background{0x1A / 255.0, 0x1A / 255.0, 0x1A / 255.0, 1};

// Those of which black or white stands out more.
Inks inks_for(const Colour& ground);

// The same drawing on the ground. White areas (joints, blocks, points of charts) take its colour. Light inks are made
// lighter until they are legible on it, dark ones darker until they stand out as they do on white paper, or legibly;
// those of Inks::dark with legible black, and of Inks::light with legible white, always do.
Page on_background(Page page, const Background& background);

}  // namespace epure::drawings
