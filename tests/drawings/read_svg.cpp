#include "read_svg.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

namespace epure::drawings {

SvgFile::SvgFile(const std::string& bytes) {
  const auto result = xml_.load_string(bytes.c_str(), pugi::parse_full);
  INFO(result.description());
  REQUIRE(result);
}

std::vector<std::string> SvgFile::ids() const {
  std::vector<std::string> found;
  for (const auto& node : xml_.select_nodes("//@id")) found.emplace_back(node.attribute().value());
  return found;
}

std::vector<std::string> SvgFile::references() const {
  std::vector<std::string> found;
  for (const auto& node : xml_.select_nodes("//@*")) {
    const std::string value = node.attribute().value();
    if (value.starts_with("url(#")) found.push_back(value.substr(5, value.size() - 6));
    if (std::string(node.attribute().name()) == "xlink:href") found.push_back(value.substr(1));
  }
  return found;
}

pugi::xml_node SvgFile::element(const std::string& id) const {
  INFO("id " << id);
  const auto found = xml_.select_nodes(("//*[@id='" + id + "']").c_str());
  REQUIRE(found.size() == 1);
  return found.first().node();
}

std::vector<Point> SvgFile::points(const std::string& id) const {
  const pugi::xml_node path = element(id);
  for (pugi::xml_node node = path; node; node = node.parent()) REQUIRE_FALSE(node.attribute("transform"));
  std::string numbers = path.attribute("d").value();
  for (char& c : numbers)
    if (std::string_view("MLCZ,").find(c) != std::string_view::npos) c = ' ';
  std::istringstream in(numbers);
  std::vector<Point> points;
  for (Point p; in >> p.x >> p.y;) points.push_back(p);
  REQUIRE(in.eof());
  REQUIRE(points.size() >= 2);
  return points;
}

double SvgFile::length(const std::string& id) const {
  const auto p = points(id);
  return std::hypot(p.back().x - p.front().x, p.back().y - p.front().y);
}

}  // namespace epure::drawings
