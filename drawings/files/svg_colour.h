// A colour as SVG and style sheets write it: "#0072b2", or "#000" for #000000; eight bits a channel, as a screen has
// them. Its opacity is written apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "drawings/page.h"

namespace epure::drawings {

inline void add_colour(std::string& to, const Colour& colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto level_of = [](double part) { return static_cast<unsigned>(std::floor(part * 255 + 0.5)); };
  const std::array levels{level_of(colour.red), level_of(colour.green), level_of(colour.blue)};
  const bool is_short = std::all_of(levels.begin(), levels.end(), [](unsigned level) { return level % 17 == 0; });
  to += '#';
  for (const unsigned level : levels) {
    if (!is_short) to += digits[level / 16];
    to += digits[level % 16];
  }
}

inline std::string in_css(const Colour& colour) {
  std::string text;
  add_colour(text, colour);
  return text;
}

}  // namespace epure::drawings
