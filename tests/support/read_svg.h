// An SVG file read back, by what it says and not by how it was made.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

class SvgFile {
 public:
  explicit SvgFile(const std::string& bytes);

  const pugi::xml_document& xml() const { return xml_; }
  pugi::xml_node root() const { return xml_.child("svg"); }
  std::vector<std::string> ids() const;                 // all, in document order
  std::vector<std::string> references() const;          // what href and url(#..) point to
  pugi::xml_node element(const std::string& id) const;  // fails the test when there is none
  // What a number in the file is on paper: its size in mm over that of its viewBox, the same both ways.
  double mm() const;
  // The numbers of the path as points, in mm of the page.
  std::vector<Point> points(const std::string& id) const;
  std::vector<Point> points(pugi::xml_node path) const;
  // Between the first and the last point of the path.
  double length(const std::string& id) const;

 private:
  pugi::xml_document xml_;
};

// A property of the element's, or of the nearest element around it that has it, or as SVG begins with it; fails the
// test when it has no value.
std::string style(pugi::xml_node element, const std::string& property);
// A colour such as #0072b2 or #fff.
Colour colour(const std::string& hexadecimal);

}  // namespace epure::drawings
