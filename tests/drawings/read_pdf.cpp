#include "read_pdf.h"
#include "tests/support/catch.h"
#include "tests/support/unpacked.h"

#include <poppler-global.h>
#include <poppler-page-renderer.h>
#include <poppler-page.h>

#include <regex>
#include <sstream>

namespace epure::drawings {
namespace {

unsigned long last_number(const std::string& bytes, const std::string& word) {
  const auto at = bytes.rfind(word);
  REQUIRE(at != bytes.npos);
  return std::stoul(bytes.substr(at + word.size(), 20));
}

}  // namespace

std::unique_ptr<poppler::document> open_pdf(const std::string& bytes) {
  poppler::byte_array data(bytes.begin(), bytes.end());  // the document takes it over
  std::unique_ptr<poppler::document> document(poppler::document::load_from_data(&data));
  REQUIRE(document);
  return document;
}

std::string complaints_of(const std::string& bytes) {
  std::string complaints;
  poppler::set_debug_error_function(
      [](const std::string& complaint, void* all) { *static_cast<std::string*>(all) += complaint + "\n"; },
      &complaints);
  const auto document = open_pdf(bytes);
  for (int i = 0; i < document->pages(); ++i) text_of(*document, i);
  poppler::set_debug_error_function([](const std::string&, void*) {}, nullptr);
  return complaints;
}

std::string root_of(const std::string& bytes) {
  const std::size_t table = last_number(bytes, "startxref\n"), root = last_number(bytes, "/Root ");
  std::size_t place = 0;
  if (bytes.compare(table, 7, "xref\n0 ") == 0) {  // of all objects, 20 bytes each
    place = std::stoul(bytes.substr(bytes.find('\n', table + 5) + 1 + 20 * root, 10));
  } else {  // packed: of the root and of itself, what kind of place each has, and four bytes that say where
    const std::string own = std::to_string(last_number(bytes, "/Size ") - 1);
    REQUIRE(bytes.compare(table, own.size() + 7, own + " 0 obj\n") == 0);
    REQUIRE(bytes.find("/Index [" + std::to_string(root) + " 1 " + own + " 1]", table) != bytes.npos);
    const std::string places = unpacked(std::string_view(bytes).substr(bytes.find("stream\n", table) + 7));
    REQUIRE(places.size() == 10);
    CHECK((places[0] == 1 && places[5] == 1));
    const auto read = [&](std::size_t at) {
      std::size_t number = 0;
      for (const char digit : places.substr(at, 4)) number = 256 * number + static_cast<unsigned char>(digit);
      return number;
    };
    CHECK(read(6) == table);
    place = read(1);
  }
  const std::string begin = std::to_string(root) + " 0 obj\n";
  REQUIRE(bytes.compare(place, begin.size(), begin) == 0);
  return bytes.substr(place + begin.size(), bytes.find("endobj\n", place) - place - begin.size());
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
    const std::string plain = unpacked({bytes.data() + start, bytes.find(ends, start) - start});
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
