#include "drawings/text/shipped_fonts.h"

#include <fmt/format.h>
#include <hb-ot.h>

#include <string>

#include "drawings/output.h"
#include "drawings/stopwatch.h"
#include "drawings/text/font_folder.h"
#include "drawings/text/memory_watch.h"

namespace epure::drawings {
namespace {

// In the order of Face. Each is named by what its font is called in PostScript.
constexpr std::array<const char*, 4> names{"STIXTwoText-Regular", "STIXTwoText-Italic", "STIXTwoText-Bold",
                                           "STIXTwoMath-Regular"};

std::string file_named(const char* name) { return std::string(name) + ".otf"; }

std::string name_in(hb_face_t* face) {
  std::array<char, 64> name{};
  unsigned length = name.size();
  hb_ot_name_get_utf8(face, HB_OT_NAME_ID_POSTSCRIPT_NAME, HB_LANGUAGE_INVALID, &length, name.data());
  return name.data();
}

hb_font_t* open(const std::filesystem::path& folder, const char* name) {
  const MemoryWatch memory;
  const std::string path = (folder / file_named(name)).string();
  const Held<hb_blob_t, hb_blob_destroy> bytes(hb_blob_create_from_file_or_fail(path.c_str()));
  memory.demand();
  if (!bytes)
    throw Unavailable(fmt::format("the font {} is missing or cannot be read", path),
                      fmt::format("il carattere {} manca o non si può leggere", path));
  const Held<hb_face_t, hb_face_destroy> face(hb_face_create(bytes.get(), 0));
  // Of what is no font, or of a part of one, HarfBuzz makes a face without any glyph.
  if (hb_face_get_glyph_count(face.get()) == 0)
    throw Unavailable(fmt::format("the font {} cannot be read", path),
                      fmt::format("il carattere {} non si può leggere", path));
  if (const std::string came = name_in(face.get()); came != name)
    throw Unavailable(fmt::format("{} does not hold its font: it holds {} instead", path, came),
                      fmt::format("{} non contiene il suo carattere: contiene invece {}", path, came));
  if (hb_face_get_upem(face.get()) != static_cast<unsigned>(units_per_em))
    throw Unavailable(fmt::format("{} is drawn in other units than {} to the em", path, units_per_em),
                      fmt::format("{} è disegnato in unità diverse da {} per em", path, units_per_em));
  Held<hb_font_t, hb_font_destroy> font(hb_font_create(face.get()));
  hb_font_make_immutable(font.get());
  memory.demand();
  return font.release();
}

}  // namespace

ShippedFonts::ShippedFonts(const std::filesystem::path& folder) {
  letters_.direction = HB_DIRECTION_LTR;
  letters_.script = HB_SCRIPT_LATIN;
  letters_.language = hb_language_from_string("en", -1);  // it would be the machine's
  for (std::size_t i = 0; i < names.size(); ++i) {
    fonts_.at(i).reset(open(folder, names.at(i)));
    const MemoryWatch memory;
    plans_.at(i).reset(hb_shape_plan_create(hb_font_get_face(fonts_.at(i).get()), &letters_, nullptr, 0, nullptr));
    memory.demand();
  }
}

const ShippedFonts& shipped_fonts() {
  static const ShippedFonts fonts = [] {
    const Timed timed(Work::fonts);
    return ShippedFonts(font_folder());
  }();
  return fonts;
}

std::filesystem::path file_of(Face face) {
  return font_folder() / file_named(names.at(static_cast<std::size_t>(face)));
}

}  // namespace epure::drawings
