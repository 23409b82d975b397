// The shipped fonts as HarfBuzz opens them; for the files that set and paint letters.
#pragma once

#include <hb.h>

#include <array>
#include <filesystem>

#include "drawings/text/fonts.h"
#include "drawings/text/release.h"

namespace epure::drawings {

// Whose units are those of the font. Any number of threads may use them at once.
class ShippedFonts {
 public:
  // Throws Unavailable naming the file that is missing, cannot be read or holds another font.
  explicit ShippedFonts(const std::filesystem::path& folder);

  hb_font_t* operator[](Face face) const { return fonts_.at(static_cast<std::size_t>(face)).get(); }
  // How the font sets letters, from left to right, Latin, by the rules of English: asked for each word, HarfBuzz
  // would look for its plan as long as it sets the word.
  hb_shape_plan_t* plan(Face face) const { return plans_.at(static_cast<std::size_t>(face)).get(); }
  const hb_segment_properties_t& letters() const { return letters_; }

 private:
  hb_segment_properties_t letters_ = HB_SEGMENT_PROPERTIES_DEFAULT;
  std::array<Held<hb_font_t, hb_font_destroy>, 4> fonts_;
  std::array<Held<hb_shape_plan_t, hb_shape_plan_destroy>, 4> plans_;
};

// Opened at the first call.
const ShippedFonts& shipped_fonts();

std::filesystem::path file_of(Face face);

}  // namespace epure::drawings
