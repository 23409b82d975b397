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

 private:
  std::array<Held<hb_font_t, hb_font_destroy>, 4> fonts_;
};

// Opened at the first call.
const ShippedFonts& shipped_fonts();

std::filesystem::path file_of(Face face);

}  // namespace epure::drawings
