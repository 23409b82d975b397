// The shipped fonts as Pango opens them; for the files that set and paint letters.
#pragma once

#include <fontconfig/fontconfig.h>
#include <pango/pango.h>

#include <array>
#include <filesystem>
#include <memory>

#include "drawings/text/fonts.h"
#include "drawings/text/release.h"

namespace epure::drawings {

// Closes the fonts with it.
using FontContext = Held<PangoContext, g_object_unref>;

// The shipped font files, which all threads share.
class KnownFonts {
 public:
  // Throws Unavailable naming the file that is missing.
  explicit KnownFonts(const std::filesystem::path& folder);
  FcConfig* get() const { return known_.get(); }

 private:
  Held<FcConfig, FcConfigDestroy> known_;
};

// Pango's objects belong to the thread that made them.
class PangoFonts {
 public:
  // Throws Unavailable naming the font that another one came for.
  explicit PangoFonts(const KnownFonts& known);

  PangoFont* operator[](Face face) const { return fonts_.at(static_cast<std::size_t>(face)).get(); }

 private:
  FontContext context_;
  std::array<Held<PangoFont, g_object_unref>, 4> fonts_;
};

// This thread's, opened at its first call.
const PangoFonts& pango_fonts();

// Pango's fonts as Cairo draws them, taken from `known` alone, without hinting: a letter measured at one size is the
// letter drawn at another.
FontContext unhinted_context(FcConfig* known);

}  // namespace epure::drawings
