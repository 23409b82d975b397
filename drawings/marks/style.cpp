#include "drawings/marks/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace epure::drawings {

namespace {

// Okabe and Ito's colours, told apart by colour-blind readers too; the purple of forces darkened for thin lines.
constexpr Colour blue{0x00 / 255.0, 0x72 / 255.0, 0xB2 / 255.0, 1};
constexpr Colour vermilion{0xD5 / 255.0, 0x5E / 255.0, 0x00 / 255.0, 1};
constexpr Colour purple{0xA6 / 255.0, 0x4D / 255.0, 0x82 / 255.0, 1};
constexpr Colour green{0x00 / 255.0, 0x9E / 255.0, 0x73 / 255.0, 1};
constexpr Colour dark_green{0x00 / 255.0, 0x66 / 255.0, 0x4C / 255.0, 1};

constexpr Colour of_bytes(int red, int green_part, int blue_part) {
  return {red / 255.0, green_part / 255.0, blue_part / 255.0, 1};
}
// The same hues, light enough to be read on any ground as dark as #333 (a contrast of 4.5, tested). The first and the
// second locus keep their distance, which is turned round.
const std::array<std::pair<Colour, Colour>, 7> inks_on_dark{{{black, of_bytes(0xF2, 0xF2, 0xF2)},
                                                             {grey, of_bytes(0xB4, 0xB4, 0xB4)},
                                                             {blue, of_bytes(0x56, 0xB4, 0xE9)},
                                                             {vermilion, of_bytes(0xFF, 0x9D, 0x5C)},
                                                             {purple, of_bytes(0xE7, 0x9F, 0xCB)},
                                                             {green, of_bytes(0x35, 0xC9, 0x9B)},
                                                             {dark_green, of_bytes(0xA6, 0xEB, 0xD0)}}};

// ISO 128: long dash 24 d, gap 3 d, dot 0.5 d; dashes 12 d. Drawn at half the length, as on small sheets.
std::vector<double> long_dash_dot(double d) { return {20 * d, 3 * d, 1 * d, 3 * d}; }
std::vector<double> dashed(double d) { return {7 * d, 3 * d}; }

}  // namespace

LineStyle line_style(Meaning meaning) {
  switch (meaning) {
    case Meaning::link:
      return {wide, {}, black};
    case Meaning::ground:
      return {wide, {}, black};
    case Meaning::plate:
      return {narrow, {}, black};
    case Meaning::axis:
      return {fine, long_dash_dot(narrow), black};
    case Meaning::construction:
      return {fine, {}, grey};
    case Meaning::alternative:
      return {narrow, dashed(narrow), grey};
    case Meaning::locus:
      return {medium, {}, green};
    case Meaning::second_locus:
      return {medium, dashed(medium), dark_green};
    case Meaning::velocity:
      return {medium, {}, blue};
    case Meaning::acceleration:
      return {medium, {}, vermilion};
    case Meaning::force:
      return {medium, {}, purple};
    case Meaning::dimension:
      return {fine, {}, black};
    case Meaning::text:
      return {narrow, {}, black};
  }
  return {};
}

LineStyle line_style(Meaning meaning, LineType type) {
  LineStyle style = line_style(meaning);
  const double d = style.width;
  switch (type) {
    case LineType::of_its_meaning:
      return style;
    case LineType::continuous:
      style.dashes = {};
      return style;
    case LineType::dashed:
      style.dashes = dashed(d);
      return style;
    case LineType::dash_dotted:  // curves bend: shorter dashes than an axis has
      style.dashes = {12 * d, 3 * d, 1 * d, 3 * d};
      return style;
    case LineType::dotted:
      style.dashes = {1.5 * d, 2.5 * d};
      return style;
  }
  return style;
}

Colour ink(Meaning meaning) { return line_style(meaning).colour; }

Colour tint(Meaning meaning) {
  Colour colour = ink(meaning);
  colour.opacity = meaning == Meaning::plate ? 0.07 : 0.12;
  return colour;
}

Colour light_ink(const Colour& ink) {
  const Colour opaque{ink.red, ink.green, ink.blue, 1};
  for (const auto& [on_white, on_dark] : inks_on_dark)
    if (opaque == on_white) return {on_dark.red, on_dark.green, on_dark.blue, ink.opacity};
  return ink;
}

std::vector<double> fitted_dashes(const std::vector<double>& pattern, double length, bool closed) {
  if (pattern.empty()) return {};
  double period = 0;
  for (const double part : pattern) period += part;
  const double last = closed ? 0 : pattern.front();
  const double count = std::round((length - last) / period);
  if (count < 1) return {};
  std::vector<double> fitted = pattern;
  for (double& part : fitted) part *= length / (count * period + last);
  return fitted;
}

}  // namespace epure::drawings
