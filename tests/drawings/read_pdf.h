// A PDF file read back with poppler, and its drawing commands with zlib.
#pragma once

#include <poppler-document.h>

#include <memory>
#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

std::unique_ptr<poppler::document> open_pdf(const std::string& bytes);
// What poppler complains of as it reads the document and its pages; it mends much, and tells of it.
std::string complaints_of(const std::string& bytes);
// The object that a document is read from, found as a reader finds it, by the last table of objects.
std::string root_of(const std::string& bytes);
// The text of a page as a reader copies it, white space reduced to single spaces.
std::string text_of(const poppler::document& document, int page);
// The decompressed drawing commands of all pages, one after the other.
std::string commands_of(const std::string& bytes);

struct DrawnLine {
  Point from, to;  // points, y downwards
};
// All strokes that consist of one straight piece.
std::vector<DrawnLine> drawn_lines(const std::string& commands);

// A page as it looks.
class Picture {
 public:
  Picture(const poppler::document& document, int page, double dots_per_mm);
  Colour at(double x, double y_from_top) const;  // mm

 private:
  std::vector<unsigned char> pixels_;  // blue, green, red, unused
  int width_ = 0, height_ = 0, row_ = 0;
  double dots_per_mm_;
};

}  // namespace epure::drawings
