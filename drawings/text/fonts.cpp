#include "drawings/text/fonts.h"

#include <pango/pango.h>

#include <map>
#include <stdexcept>
#include <utility>

#include "drawings/paths/vectors.h"
#include "drawings/text/memory_watch.h"
#include "drawings/text/pango_fonts.h"
#include "drawings/text/release.h"

namespace epure::drawings {
namespace {

double to_units(int pango_units) { return static_cast<double>(pango_units) / PANGO_SCALE; }

// 0 where the font has none.
hb_codepoint_t glyph_of(PangoFont* font, char32_t character) {
  hb_codepoint_t glyph = 0;
  return hb_font_get_nominal_glyph(pango_font_get_hb_font(font), character, &glyph) ? glyph : 0;
}

// Pango shows neither a soft hyphen nor a space without width; like HarfBuzz alone, we keep a space for its text.
unsigned space_of(PangoFont* font) { return glyph_of(font, ' '); }

// By HarfBuzz: Pango asks Cairo, which loads each outline at this size for nothing else.
Box find_ink(PangoFont* font, unsigned glyph) {
  hb_glyph_extents_t drawn{};  // y upwards, the height downwards
  const MemoryWatch memory;
  const bool has = hb_font_get_glyph_extents(pango_font_get_hb_font(font), glyph, &drawn);
  memory.demand();
  if (!has) return nothing();
  if (drawn.width == 0 && drawn.height == 0) return nothing();
  return {{to_units(drawn.x_bearing), to_units(drawn.y_bearing + drawn.height)},
          {to_units(drawn.x_bearing + drawn.width), to_units(drawn.y_bearing)}};
}

ShapedLetters shape_anew(Face face, std::string_view letters) {
  // One font, named: nothing is left to Pango's search for fonts, and what this one lacks comes back as unknown.
  PangoAnalysis analysis{};
  analysis.font = pango_fonts()[face];
  analysis.script = PANGO_SCRIPT_LATIN;
  analysis.language = pango_language_from_string("en");
  const MemoryWatch memory;
  const Held<PangoGlyphString, pango_glyph_string_free> shaped(pango_glyph_string_new());
  const auto length = static_cast<int>(letters.size());
  pango_shape_full(letters.data(), length, letters.data(), length, &analysis, shaped.get());
  memory.demand();

  ShapedLetters result;
  const int count = shaped->num_glyphs;
  const int* clusters = shaped->log_clusters;
  for (int i = 0; i < count; ++i) {
    const PangoGlyphInfo& glyph = shaped->glyphs[i];
    const unsigned index = glyph.glyph == PANGO_GLYPH_EMPTY ? space_of(analysis.font) : glyph.glyph;
    if (index == 0 || (index & PANGO_GLYPH_UNKNOWN_FLAG) != 0)
      throw std::invalid_argument("the shipped font cannot write all of \"" + std::string(letters) + "\"");
    // Glyphs of one cluster stand for its characters together; the first of them carries the text.
    const bool first = i == 0 || clusters[i] != clusters[i - 1];
    int next = i;
    while (next < count && clusters[next] == clusters[i]) ++next;
    const auto start = static_cast<std::size_t>(clusters[i]);
    const std::size_t end = next < count ? static_cast<std::size_t>(clusters[next]) : letters.size();
    result.glyphs.push_back({index,
                             {result.advance + to_units(glyph.geometry.x_offset), -to_units(glyph.geometry.y_offset)},
                             first ? std::string(letters.substr(start, end - start)) : ""});
    result.advance += to_units(glyph.geometry.width);
  }
  return result;
}

}  // namespace

// By HarfBuzz: Pango would have fontconfig list all characters of the font first.
bool has_glyph(Face face, char32_t character) {
  PangoFont* font = pango_fonts()[face];
  const MemoryWatch memory;
  const bool has = glyph_of(font, character) != 0;
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
  if (is_new) entry->second = find_ink(pango_fonts()[face], glyph);
  return entry->second;
}

}  // namespace epure::drawings
