#include "tests/support/read_svg.h"
#include "tests/support/catch.h"

#include <cmath>
#include <cstdio>
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

double SvgFile::mm() const {
  double left = 1, top = 1, width = 0, height = 0;
  std::istringstream box(root().attribute("viewBox").value());
  REQUIRE(box >> left >> top >> width >> height);
  REQUIRE((left == 0 && top == 0));
  const std::string width_mm = root().attribute("width").value(), height_mm = root().attribute("height").value();
  REQUIRE((width_mm.ends_with("mm") && height_mm.ends_with("mm")));
  const double scale = std::stod(width_mm) / width;
  REQUIRE(std::stod(height_mm) / height == Approx(scale).epsilon(1e-7));
  return scale;
}

std::vector<Point> SvgFile::points(const std::string& id) const { return points(element(id)); }

std::vector<Point> SvgFile::points(pugi::xml_node path) const {
  for (pugi::xml_node node = path; node; node = node.parent()) REQUIRE_FALSE(node.attribute("transform"));
  std::string numbers = path.attribute("d").value();
  for (char& c : numbers)
    if (std::string_view("MLCZ,").find(c) != std::string_view::npos) c = ' ';
  std::istringstream in(numbers);
  const double scale = mm();
  std::vector<Point> points;
  for (Point p; in >> p.x >> p.y;) points.push_back({scale * p.x, scale * p.y});
  REQUIRE(in.eof());
  REQUIRE(points.size() >= 2);
  return points;
}

double SvgFile::length(const std::string& id) const {
  const auto p = points(id);
  return std::hypot(p.back().x - p.front().x, p.back().y - p.front().y);
}

std::string style(pugi::xml_node element, const std::string& property) {
  std::istringstream all(element.attribute("style").value());
  for (std::string each; std::getline(all, each, ';');) {
    const auto start = each.find_first_not_of(' '), colon = each.find(':');
    if (start < colon && colon != each.npos && each.substr(start, colon - start) == property)
      return each.substr(colon + 1);
  }
  FAIL("no " << property << " in " << element.attribute("style").value());
  return "";
}

Colour colour(const std::string& rgb) {
  Colour found;
  CAPTURE(rgb);
  REQUIRE(std::sscanf(rgb.c_str(), "rgb(%lf%%,%lf%%,%lf%%)", &found.red, &found.green, &found.blue) == 3);
  return {found.red / 100, found.green / 100, found.blue / 100, 1};
}

}  // namespace epure::drawings
