#include <unistd.h>

#include <filesystem>

#include "drawings/text/font_folder.h"
#include "drawings/text/shipped_fonts.h"
#include "drawings/text/text.h"
#include "tests/support/catch.h"

using namespace epure::drawings;
namespace fs = std::filesystem;

namespace {

// A copy of the shipped fonts to be spoilt; gone when the test is.
class FontCopy {
 public:
  FontCopy() : folder_(fs::temp_directory_path() / ("epure-fonts-" + std::to_string(getpid()))) {
    fs::create_directory(folder_);
    for (const auto& entry : fs::directory_iterator(font_folder()))
      if (entry.path().extension() == ".otf") fs::copy_file(entry, folder_ / entry.path().filename());
  }
  ~FontCopy() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  FontCopy(const FontCopy&) = delete;
  FontCopy& operator=(const FontCopy&) = delete;

  void replace(const char* file, const char* by) const {
    fs::copy_file(folder_ / by, folder_ / file, fs::copy_options::overwrite_existing);
  }
  void remove(const char* file) const { fs::remove(folder_ / file); }
  void truncate(const char* file) const { fs::resize_file(folder_ / file, 100); }

  std::string complaint() const {
    try {
      ShippedFonts opened(folder_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

 private:
  fs::path folder_;
};

}  // namespace

TEST_CASE("the four shipped fonts are found and are what they should be") {
  const FontCopy fonts;
  CHECK(fonts.complaint() == "");
}

TEST_CASE("a font that is missing, broken or replaced by another one is an error that names it") {
  for (const char* file :
       {"STIXTwoText-Regular.otf", "STIXTwoText-Italic.otf", "STIXTwoText-Bold.otf", "STIXTwoMath-Regular.otf"}) {
    CAPTURE(file);
    FontCopy missing;
    missing.remove(file);
    CHECK_THAT(missing.complaint(), Contains(file) && Contains("missing"));
  }
  {
    FontCopy broken;
    broken.truncate("STIXTwoText-Bold.otf");
    CHECK_THAT(broken.complaint(), Contains("STIXTwoText-Bold.otf"));
  }
  for (const auto& [file, by] : {std::pair{"STIXTwoMath-Regular.otf", "STIXTwoText-Regular.otf"},
                                 std::pair{"STIXTwoText-Italic.otf", "STIXTwoText-Regular.otf"},
                                 std::pair{"STIXTwoText-Bold.otf", "STIXTwoMath-Regular.otf"},
                                 std::pair{"STIXTwoText-Regular.otf", "STIXTwoText-Italic.otf"}}) {
    CAPTURE(file, by);
    FontCopy other;
    other.replace(file, by);
    CHECK_THAT(other.complaint(), Contains(file) && Contains("instead"));
  }
}

TEST_CASE("letters that are not shown keep their place and their text") {
  for (const std::string hidden : {"\u00AD", "\u200B", "\u200D"}) {
    const ShapedLetters shaped = shape(Face::regular, "A" + hidden + "V");
    std::string text;
    for (const ShapedGlyph& glyph : shaped.glyphs) text += glyph.text;
    CHECK(text == "A" + hidden + "V");
    CHECK(shaped.glyphs[1].index == shape(Face::regular, " ").glyphs[0].index);
  }
}

TEST_CASE("accents stand where the font puts them") {
  // Over a q to the left of the pen, and two of them one over the other.
  const ShapedLetters letters = shape(Face::regular, "q\u0301\u0301v");
  REQUIRE(letters.glyphs.size() == 4);
  CHECK(letters.glyphs[1].at.x == 487);
  CHECK(letters.glyphs[1].at.y == 0);
  CHECK(letters.glyphs[2].at.y == 189);
  CHECK(letters.glyphs[3].at.x == 521);
  // Below it is down.
  CHECK(shape(Face::regular, "q\u0331").glyphs[1].at.y < -100);
}
