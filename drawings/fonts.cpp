#include "drawings/fonts.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include <hb-ot.h>
#include <hb.h>

#include <array>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>

#include "drawings/release.h"
#include "drawings/unicode.h"
#include "drawings/vectors.h"

// The four files, byte for byte, in the read-only data of the program.
#define EPURE_EMBED(symbol, file)                                                                     \
  asm(".pushsection .rodata\n.balign 16\n.hidden " symbol "\n.hidden " symbol "_end\n.global " symbol \
      "\n.global " symbol "_end\n" symbol ":\n.incbin \"" EPURE_FONT_DIR "/" file "\"\n" symbol       \
      "_end:\n.byte 0\n.popsection\n")
EPURE_EMBED("epure_font_regular", "STIXTwoText-Regular.otf");
EPURE_EMBED("epure_font_italic", "STIXTwoText-Italic.otf");
EPURE_EMBED("epure_font_bold", "STIXTwoText-Bold.otf");
EPURE_EMBED("epure_font_mathematics", "STIXTwoMath-Regular.otf");
#undef EPURE_EMBED

extern "C" {
extern const char epure_font_regular[], epure_font_regular_end[];
extern const char epure_font_italic[], epure_font_italic_end[];
extern const char epure_font_bold[], epure_font_bold_end[];
extern const char epure_font_mathematics[], epure_font_mathematics_end[];
}

namespace epure::drawings {
namespace {

std::span<const char> embedded(Face face) {
  switch (face) {
    case Face::regular:
      return {epure_font_regular, epure_font_regular_end};
    case Face::italic:
      return {epure_font_italic, epure_font_italic_end};
    case Face::bold:
      return {epure_font_bold, epure_font_bold_end};
    case Face::mathematics:
      return {epure_font_mathematics, epure_font_mathematics_end};
  }
  throw std::logic_error("no such face");
}

FT_Library freetype() {
  static const auto library = [] {
    FT_Library opened = nullptr;
    if (FT_Init_FreeType(&opened)) throw std::runtime_error("FreeType does not start");
    return Held<std::remove_pointer_t<FT_Library>, FT_Done_FreeType>(opened);
  }();
  return library.get();
}

// One font, as FreeType draws it and as HarfBuzz sets it.
class Font {
 public:
  explicit Font(std::span<const char> file) {
    const auto* bytes = reinterpret_cast<const FT_Byte*>(file.data());
    FT_Face opened = nullptr;
    if (FT_New_Memory_Face(freetype(), bytes, static_cast<FT_Long>(file.size()), 0, &opened))
      throw std::logic_error("a shipped font cannot be read");
    drawn_.reset(opened);
    if (drawn_->units_per_EM != static_cast<FT_UShort>(units_per_em))
      throw std::logic_error("a shipped font has other units than the rest");
    Held<hb_blob_t, hb_blob_destroy> blob(
        hb_blob_create(file.data(), static_cast<unsigned>(file.size()), HB_MEMORY_MODE_READONLY, nullptr, nullptr));
    Held<hb_face_t, hb_face_destroy> face(hb_face_create(blob.get(), 0));
    set_.reset(hb_font_create(face.get()));  // its scale is units_per_em, so metrics come out as they were designed
  }

  FT_Face drawn() const { return drawn_.get(); }
  hb_font_t* set() const { return set_.get(); }

  // The outline stays valid until the next glyph is loaded.
  FT_Outline& load(unsigned glyph) const {
    if (FT_Load_Glyph(drawn_.get(), glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING))
      throw std::logic_error("a glyph of a shipped font cannot be read");
    return drawn_->glyph->outline;
  }

  std::map<unsigned, Box> inks;  // found so far

 private:
  Held<FT_FaceRec, FT_Done_Face> drawn_;
  Held<hb_font_t, hb_font_destroy> set_;
};

Font& font(Face face) {
  freetype();  // opened first, so that it is closed last
  static std::array<std::unique_ptr<Font>, 4> fonts;
  auto& wanted = fonts.at(static_cast<std::size_t>(face));
  if (!wanted) wanted = std::make_unique<Font>(embedded(face));
  return *wanted;
}

Point to_point(const FT_Vector* v) { return {static_cast<double>(v->x), static_cast<double>(v->y)}; }

const FT_Outline_Funcs& path_builder() {
  static const FT_Outline_Funcs funcs = [] {
    FT_Outline_Funcs f{};
    f.move_to = [](const FT_Vector* to, void* paths) {
      static_cast<std::vector<Path>*>(paths)->push_back({to_point(to), {}, true});
      return 0;
    };
    f.line_to = [](const FT_Vector* to, void* paths) {
      static_cast<std::vector<Path>*>(paths)->back().pieces.push_back({true, {}, {}, to_point(to)});
      return 0;
    };
    f.conic_to = [](const FT_Vector*, const FT_Vector*, void*) { return 1; };  // the shipped fonts are cubic
    f.cubic_to = [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* paths) {
      static_cast<std::vector<Path>*>(paths)->back().pieces.push_back(
          {false, to_point(a), to_point(b), to_point(to)});
      return 0;
    };
    return f;
  }();
  return funcs;
}

}  // namespace

bool has_glyph(Face face, char32_t character) {
  hb_codepoint_t glyph = 0;
  return hb_font_get_nominal_glyph(font(face).set(), character, &glyph) && glyph != 0;
}

ShapedLetters shape(Face face, std::string_view letters) {
  const Held<hb_buffer_t, hb_buffer_destroy> buffer(hb_buffer_create());
  hb_buffer_add_utf8(buffer.get(), letters.data(), static_cast<int>(letters.size()), 0, -1);
  // Set, not guessed: a guess would look at the language of the machine.
  hb_buffer_set_direction(buffer.get(), HB_DIRECTION_LTR);
  hb_buffer_set_script(buffer.get(), HB_SCRIPT_LATIN);
  hb_buffer_set_language(buffer.get(), hb_language_from_string("en", -1));
  hb_shape(font(face).set(), buffer.get(), nullptr, 0);

  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
  const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer.get(), nullptr);
  ShapedLetters shaped;
  for (unsigned i = 0; i < count; ++i) {
    if (infos[i].codepoint == 0)
      throw std::invalid_argument("the shipped font cannot write all of \"" + std::string(letters) + "\"");
    // Glyphs of one cluster stand for its characters together; the first of them carries the text.
    const bool first = i == 0 || infos[i].cluster != infos[i - 1].cluster;
    unsigned next = i;
    while (next < count && infos[next].cluster == infos[i].cluster) ++next;
    const std::size_t end = next < count ? infos[next].cluster : letters.size();
    shaped.glyphs.push_back({infos[i].codepoint,
                             {shaped.advance + positions[i].x_offset, static_cast<double>(positions[i].y_offset)},
                             first ? std::string(letters.substr(infos[i].cluster, end - infos[i].cluster)) : ""});
    shaped.advance += positions[i].x_advance;
  }
  return shaped;
}

Box ink(Face face, unsigned glyph) {
  Font& from = font(face);
  const auto [entry, is_new] = from.inks.try_emplace(glyph, nothing());
  if (is_new) {
    FT_Outline& drawn = from.load(glyph);
    if (drawn.n_points > 0) {
      FT_BBox box;
      FT_Outline_Get_CBox(&drawn, &box);
      entry->second = {{static_cast<double>(box.xMin), static_cast<double>(box.yMin)},
                       {static_cast<double>(box.xMax), static_cast<double>(box.yMax)}};
    }
  }
  return entry->second;
}

std::vector<Path> outline(Face face, unsigned glyph) {
  std::vector<Path> paths;
  if (FT_Outline_Decompose(&font(face).load(glyph), &path_builder(), &paths))
    throw std::logic_error("the outline of a glyph cannot be read");
  return paths;
}

FT_FaceRec_* freetype_face(Face face) { return font(face).drawn(); }

}  // namespace epure::drawings
