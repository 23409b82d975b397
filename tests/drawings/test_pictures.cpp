// PNG and EPS: what a file says of itself, and what it shows.
#include <png.h>
#include <zlib.h>

#include <cstdint>
#include <map>

#include "drawings/files/flattened.h"
#include "drawings/page.h"
#include "drawings/paths/vectors.h"
#include "tests/support/catch.h"

using namespace epure::drawings;

namespace {

const Colour pure_red{1, 0, 0, 1};

Path box(Point low, Point high) { return polyline({low, {high.x, low.y}, high, {low.x, high.y}}, true); }

// 50 mm x 30 mm: the left half red, letters on the right, and a line in light green below.
Page halves() {
  Page page{"demo", "t", "d", {{0, 0}, {50, 30}}, epure::Language::english, {}};
  page.primitives.emplace_back(Fill{box({0, 0}, {25, 30}), pure_red, {}, {}});
  page.primitives.emplace_back(PlacedText{"fl $\\vec{v}_{B}$", {28, 20}, 3.5, {}, Weight::regular});
  page.primitives.emplace_back(Stroke{segment({28, 5}, {48, 5}), 2, {}, {0, 1, 0, 0.5}, {}, {}});
  return page;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

// Of each kind the content of the first, after its checksum was found right (by zlib's CRC, not ours).
std::map<std::string, std::string> chunks(const std::string& png) {
  REQUIRE(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  std::map<std::string, std::string> found;
  std::size_t at = 8;
  while (at < png.size()) {
    const std::size_t length = number_at(png, at);
    REQUIRE(at + 12 + length <= png.size());
    const std::string checked = png.substr(at + 4, 4 + length);
    CHECK(crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size())) ==
          number_at(png, at + 8 + length));
    found.try_emplace(checked.substr(0, 4), checked.substr(4));
    at += 12 + length;
  }
  CHECK(found.contains("IEND"));
  return found;
}

class Pixelled {
 public:
  explicit Pixelled(const std::string& png) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&image, png.data(), png.size()) != 0);
    image.format = PNG_FORMAT_RGBA;
    width = image.width;
    height = image.height;
    bytes_.resize(PNG_IMAGE_SIZE(image));
    REQUIRE(png_image_finish_read(&image, nullptr, bytes_.data(), 0, nullptr) != 0);
  }
  std::array<int, 4> at(std::size_t x, std::size_t y) const {
    std::array<int, 4> rgba{};
    for (std::size_t i = 0; i < 4; ++i) rgba[i] = bytes_[4 * (y * width + x) + i];
    return rgba;
  }
  std::size_t width = 0, height = 0;

 private:
  std::vector<unsigned char> bytes_;
};

}  // namespace

TEST_CASE("a PNG says how many pixels a metre has, and has as many") {
  // 150 / 0.0254 = 5905.5, 300 / 0.0254 = 11811.02, 96 / 0.0254 = 3779.5; 50 mm at 150 dpi are 295.3 pixels.
  struct Case {
    double dpi;
    std::uint32_t per_metre, width, height;
  };
  for (const Case& c : {Case{150, 5906, 295, 177}, {300, 11811, 591, 354}, {96, 3780, 189, 113}}) {
    CAPTURE(c.dpi);
    const std::string png = write_png(halves(), c.dpi);
    const auto found = chunks(png);
    REQUIRE(found.at("pHYs").size() == 9);
    CHECK(number_at(found.at("pHYs"), 0) == c.per_metre);
    CHECK(number_at(found.at("pHYs"), 4) == c.per_metre);
    CHECK(found.at("pHYs")[8] == 1);
    CHECK(png.find("pHYs") < png.find("IDAT"));
    CHECK(number_at(found.at("IHDR"), 0) == c.width);
    CHECK(number_at(found.at("IHDR"), 4) == c.height);
    CHECK(write_png(halves(), c.dpi) == png);
  }
}

TEST_CASE("a PNG shows the page, on white paper or on nothing") {
  Page page = halves();
  const Pixelled clear(write_png(page, 254));  // ten pixels a millimetre
  REQUIRE(clear.width == 500);
  CHECK(clear.at(100, 150) == std::array{255, 0, 0, 255});
  CHECK(clear.at(499, 299) == std::array{0, 0, 0, 0});
  CHECK(clear.at(380, 250)[3] == 128);
  page.is_paper = true;
  const Pixelled paper(write_png(page, 254));
  CHECK(paper.at(100, 150) == std::array{255, 0, 0, 255});
  CHECK(paper.at(499, 299) == std::array{255, 255, 255, 255});
  CHECK(paper.at(380, 250) == std::array{127, 255, 127, 255});
  int dark = 0;  // letters of 3.5 mm: strokes of some tenths of a millimetre
  for (std::size_t x = 280; x < 400; ++x)
    for (std::size_t y = 60; y < 110; ++y) dark += paper.at(x, y)[0] < 64 ? 1 : 0;
  CHECK(dark > 150);
  CHECK(dark < 1500);
}

TEST_CASE("letters of a PNG stand where the page has them, to a part of a pixel") {
  // The same letters half a pixel further to the right are another picture.
  Page page = halves(), moved = halves();
  std::get<PlacedText>(moved.primitives[1]).baseline.x += 0.05;
  CHECK(write_png(page, 254) != write_png(moved, 254));
}

TEST_CASE("a page too large for a picture is refused") {
  Page page = halves();
  page.extent = {{0, 0}, {2000, 2000}};
  CHECK_THROWS_AS(write_png(page, 150), std::invalid_argument);
  CHECK(pixels(page, 150).width == 11811);
}

TEST_CASE("an EPS has the size of the page, its letters as letters, and no date") {
  const std::string eps = write_eps(halves());
  CHECK(eps.starts_with("%!PS-Adobe-3.0 EPSF-3.0\n"));
  CHECK(eps.find("CreationDate") == eps.npos);
  CHECK(eps.find("\n/FontName ") != eps.npos);
  // 50 mm x 30 mm are 141.7 x 85.04 points; what is drawn ends at 48 mm = 136.06 points.
  CHECK(eps.find("\n%%BoundingBox: 0 0 137 86\n") != eps.npos);
  CHECK(eps.find("ImageType") == eps.npos);
  CHECK(write_eps(halves()) == eps);
}

TEST_CASE("what is translucent is mixed with white and lies below all else") {
  const Page flat = flattened(halves());
  REQUIRE(flat.primitives.size() == 3);
  const auto* below = std::get_if<Stroke>(&flat.primitives[0]);
  REQUIRE(below != nullptr);
  CHECK(below->colour == Colour{0.5, 1, 0.5, 1});
  CHECK(std::get<Fill>(flat.primitives[1]).colour == pure_red);
  CHECK(std::holds_alternative<PlacedText>(flat.primitives[2]));
}

TEST_CASE("only the line of the date leaves a PostScript file") {
  CHECK(without_date("%!PS\n%%CreationDate: Mon\n%%End\n") == "%!PS\n%%End\n");
  CHECK(without_date("%!PS\n%%End\n") == "%!PS\n%%End\n");
}
