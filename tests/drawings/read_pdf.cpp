#include "read_pdf.h"
#include "tests/support/catch.h"

#include <poppler-page-renderer.h>
#include <poppler-page.h>
#include <zlib.h>

#include <array>
#include <regex>
#include <sstream>

namespace epure::drawings {
namespace {

std::string inflated(std::string_view packed) {
  z_stream stream = {};
  REQUIRE(inflateInit(&stream) == Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib only reads it
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string plain;
  int status = Z_OK;
  while (status == Z_OK) {
    std::array<Bytef, 65536> part;
    stream.next_out = part.data();
    stream.avail_out = part.size();
    status = inflate(&stream, Z_NO_FLUSH);
    plain.append(reinterpret_cast<const char*>(part.data()), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END ? plain : "";
}

}  // namespace

std::unique_ptr<poppler::document> open_pdf(const std::string& bytes) {
  poppler::byte_array data(bytes.begin(), bytes.end());  // the document takes it over
  std::unique_ptr<poppler::document> document(poppler::document::load_from_data(&data));
  REQUIRE(document);
  return document;
}

std::string text_of(const poppler::document& document, int page) {
  const std::unique_ptr<poppler::page> opened(document.create_page(page));
  REQUIRE(opened);
  const poppler::byte_array utf8 = opened->text().to_utf8();
  std::istringstream words(std::string(utf8.begin(), utf8.end()));
  std::string text;
  for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string commands_of(const std::string& bytes) {
  std::string commands;
  constexpr std::string_view begins = "stream\n", ends = "\nendstream";
  for (std::size_t at = bytes.find("\nstream\n"); at != bytes.npos; at = bytes.find("\nstream\n", at + 1)) {
    const std::size_t start = at + 1 + begins.size();
    const std::string plain = inflated({bytes.data() + start, bytes.find(ends, start) - start});
    if (plain.starts_with("1 0 0 -1 0 ")) commands += plain;  // the frame Cairo gives the contents of a page
  }
  REQUIRE_FALSE(commands.empty());
  return commands;
}

std::vector<DrawnLine> drawn_lines(const std::string& commands) {
  static const std::regex line(R"((\S+)\s(\S+)\sm\s(\S+)\s(\S+)\sl\sS\b)");
  std::vector<DrawnLine> lines;
  for (std::sregex_iterator it(commands.begin(), commands.end(), line), end; it != end; ++it) {
    const auto number = [&](std::size_t i) { return std::stod((*it)[i].str()); };
    lines.push_back({{number(1), number(2)}, {number(3), number(4)}});
  }
  return lines;
}

Picture::Picture(const poppler::document& document, int page, double dots_per_mm) : dots_per_mm_(dots_per_mm) {
  const std::unique_ptr<poppler::page> opened(document.create_page(page));
  REQUIRE(opened);
  poppler::page_renderer renderer;
  renderer.set_image_format(poppler::image::format_argb32);
  renderer.set_render_hint(poppler::page_renderer::antialiasing, false);
  const double resolution = dots_per_mm * 25.4;
  const poppler::image image = renderer.render_page(opened.get(), resolution, resolution);
  REQUIRE(image.is_valid());
  width_ = image.width();
  height_ = image.height();
  row_ = image.bytes_per_row();
  const auto* data = reinterpret_cast<const unsigned char*>(image.const_data());
  pixels_.assign(data, data + static_cast<std::size_t>(row_) * static_cast<std::size_t>(height_));
}

Colour Picture::at(double x, double y_from_top) const {
  const auto column = static_cast<int>(x * dots_per_mm_), line = static_cast<int>(y_from_top * dots_per_mm_);
  REQUIRE((column >= 0 && column < width_ && line >= 0 && line < height_));
  const unsigned char* pixel = pixels_.data() + line * row_ + 4 * column;
  return {pixel[2] / 255.0, pixel[1] / 255.0, pixel[0] / 255.0, 1};
}

}  // namespace epure::drawings
