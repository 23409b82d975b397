#include "drawings/text/fonts.h"

#include <hb.h>

#include <map>
#include <stdexcept>
#include <utility>

#include "drawings/paths/vectors.h"
#include "drawings/text/memory_watch.h"
#include "drawings/text/release.h"
#include "drawings/text/shipped_fonts.h"

namespace epure::drawings {
namespace {

using Letters = Held<hb_buffer_t, hb_buffer_destroy>;

// A text by itself, in the one font: what that lacks comes back as glyph 0.
Letters set(hb_font_t* font, std::string_view letters) {
  const MemoryWatch memory;
  Letters set(hb_buffer_create());
  const auto length = static_cast<int>(letters.size());
  hb_buffer_add_utf8(set.get(), letters.data(), length, 0, length);
  hb_buffer_set_flags(set.get(), static_cast<hb_buffer_flags_t>(HB_BUFFER_FLAG_BOT | HB_BUFFER_FLAG_EOT));
  hb_buffer_set_direction(set.get(), HB_DIRECTION_LTR);
  hb_buffer_set_script(set.get(), HB_SCRIPT_LATIN);
  hb_buffer_set_language(set.get(), hb_language_from_string("en", -1));  // it would be the machine's
  hb_shape(font, set.get(), nullptr, 0);
  memory.demand();
  return set;
}

ShapedLetters shape_anew(Face face, std::string_view letters) {
  const Letters set_letters = set(shipped_fonts()[face], letters);
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
                             first ? std::string(letters.substr(cluster, end - cluster)) : ""});
    result.advance += places[i].x_advance;
  }
  return result;
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

}  // namespace

bool has_glyph(Face face, char32_t character) {
  hb_font_t* font = shipped_fonts()[face];
  const MemoryWatch memory;
  hb_codepoint_t glyph = 0;
  const bool has = hb_font_get_nominal_glyph(font, character, &glyph) && glyph != 0;
  memory.demand();
  return has;
}

ShapedLetters shape(Face face, const std::string& letters) {
  // A column that is tried in smaller and smaller letters sets the same words again.
  thread_local std::map<std::pair<Face, std::string>, ShapedLetters> known;
  constexpr std::size_t most = 5000;  // some megabytes; a sheet has some hundred
  const auto found = known.find({face, letters});
  if (found != known.end()) return found->second;
  if (known.size() == most) known.clear();
  return known.emplace(std::pair{face, letters}, shape_anew(face, letters)).first->second;
}

Box ink(Face face, unsigned glyph) {
  thread_local std::map<std::pair<Face, unsigned>, Box> found;
  const auto [entry, is_new] = found.try_emplace({face, glyph}, nothing());
  if (is_new) entry->second = find_ink(shipped_fonts()[face], glyph);
  return entry->second;
}

}  // namespace epure::drawings
