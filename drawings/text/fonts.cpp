#include "drawings/text/fonts.h"

#include <hb.h>

#include <array>
#include <stdexcept>
#include <unordered_map>

#include "drawings/paths/vectors.h"
#include "drawings/text/memory_watch.h"
#include "drawings/text/release.h"
#include "drawings/text/shipped_fonts.h"

namespace epure::drawings {
namespace {

using Letters = Held<hb_buffer_t, hb_buffer_destroy>;

// What was asked of a face once: a column that is tried in smaller and smaller letters sets the same words again.
struct Known {
  std::unordered_map<std::string, ShapedLetters> shaped;
  std::unordered_map<unsigned, Box> inks;
  std::unordered_map<char32_t, bool> has_glyph;
};
Known& known_of(Face face) {
  thread_local std::array<Known, 4> known;
  return known.at(static_cast<std::size_t>(face));
}

// A text by itself, in the one font: what that lacks comes back as glyph 0.
Letters set(Face face, std::string_view letters) {
  const ShippedFonts& fonts = shipped_fonts();
  const MemoryWatch memory;
  Letters set(hb_buffer_create());
  const auto length = static_cast<int>(letters.size());
  hb_buffer_add_utf8(set.get(), letters.data(), length, 0, length);
  hb_buffer_set_flags(set.get(), static_cast<hb_buffer_flags_t>(HB_BUFFER_FLAG_BOT | HB_BUFFER_FLAG_EOT));
  hb_buffer_set_segment_properties(set.get(), &fonts.letters());
  hb_shape_plan_execute(fonts.plan(face), fonts[face], set.get(), nullptr, 0);
  memory.demand();
  return set;
}

Box find_ink(hb_font_t* font, unsigned glyph) {
  hb_glyph_extents_t drawn{};  // y upwards, the height downwards
  const MemoryWatch memory;
  const bool has = hb_font_get_glyph_extents(font, glyph, &drawn);
  memory.demand();
  if (!has || (drawn.width == 0 && drawn.height == 0)) return nothing();
  const Point corner{static_cast<double>(drawn.x_bearing), static_cast<double>(drawn.y_bearing)};
  return {corner + Point{0, static_cast<double>(drawn.height)}, corner + Point{static_cast<double>(drawn.width), 0}};
}

ShapedLetters shape_anew(Face face, std::string_view letters) {
  const Letters set_letters = set(face, letters);
  unsigned count = 0;
  const hb_glyph_info_t* glyphs = hb_buffer_get_glyph_infos(set_letters.get(), &count);
  const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(set_letters.get(), nullptr);

  ShapedLetters result;
  for (unsigned i = 0; i < count; ++i) {
    const unsigned index = glyphs[i].codepoint, cluster = glyphs[i].cluster;
    if (index == 0)
      throw std::invalid_argument("the shipped font cannot write all of \"" + std::string(letters) + "\"");
    // Glyphs of one cluster stand for its characters together; the first of them carries the text.
    const bool first = i == 0 || cluster != glyphs[i - 1].cluster;
    unsigned next = i;
    while (next < count && glyphs[next].cluster == cluster) ++next;
    const std::size_t end = next < count ? glyphs[next].cluster : letters.size();
    result.glyphs.push_back({index,
                             {result.advance + places[i].x_offset, static_cast<double>(places[i].y_offset)},
                             ink(face, index),
                             first ? std::string(letters.substr(cluster, end - cluster)) : ""});
    result.advance += places[i].x_advance;
  }
  return result;
}

}  // namespace

bool has_glyph(Face face, char32_t character) {
  auto& known = known_of(face).has_glyph;
  if (const auto found = known.find(character); found != known.end()) return found->second;
  hb_font_t* font = shipped_fonts()[face];
  const MemoryWatch memory;
  hb_codepoint_t glyph = 0;
  const bool has = hb_font_get_nominal_glyph(font, character, &glyph) && glyph != 0;
  memory.demand();
  return known.emplace(character, has).first->second;
}

const ShapedLetters& shape(Face face, const std::string& letters) {
  auto& known = known_of(face).shaped;
  constexpr std::size_t most = 5000;  // some megabytes; a sheet has some hundred
  if (const auto found = known.find(letters); found != known.end()) return found->second;
  if (known.size() == most) known.clear();
  return known.emplace(letters, shape_anew(face, letters)).first->second;
}

Box ink(Face face, unsigned glyph) {
  auto& inks = known_of(face).inks;
  if (const auto found = inks.find(glyph); found != inks.end()) return found->second;
  return inks.emplace(glyph, find_ink(shipped_fonts()[face], glyph)).first->second;
}

}  // namespace epure::drawings
