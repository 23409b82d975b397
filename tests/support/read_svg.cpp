#include "tests/support/read_svg.h"
#include "tests/support/catch.h"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string_view>

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

namespace {

// The data of a path: M, l, h, v, c and z, as they are written here, and no others.
class PathReader {
 public:
  explicit PathReader(const char* data) : rest_(data) {}

  std::vector<Point> points() {
    while (char letter = command()) {
      if (letter == 'M' || letter == 'm') {
        const Point from = letter == 'm' ? at_ : Point{};
        at_.x = from.x + number();
        at_.y = from.y + number();
        start_ = at_;
        found_.push_back(at_);
      } else if (letter == 'z') {
        at_ = start_;
      } else {
        read(letter);
      }
    }
    return std::move(found_);
  }

 private:
  // The letter holds for further numbers.
  char command() {
    skip_spaces();
    if (*rest_ == 0) return 0;
    if (std::isalpha(static_cast<unsigned char>(*rest_)) != 0) {
      last_ = *rest_++;
      REQUIRE(std::string_view("Mmlhvcz").find(last_) != std::string_view::npos);
    } else {
      REQUIRE(std::string_view("lhvc").find(last_) != std::string_view::npos);
    }
    return last_;
  }

  void read(char letter) {
    const Point from = at_;
    for (int i = letter == 'c' ? 3 : 1; i > 0; --i) {
      at_ = from;
      if (letter != 'v') at_.x += number();
      if (letter != 'h') at_.y += number();
      found_.push_back(at_);
    }
  }

  double number() {
    char* end = nullptr;
    const double value = std::strtod(rest_, &end);
    REQUIRE(end != rest_);
    rest_ = end;
    return value;
  }

  void skip_spaces() {
    while (*rest_ == ' ') ++rest_;
  }

  const char* rest_;
  char last_ = 0;
  Point at_, start_;
  std::vector<Point> found_;
};

}  // namespace

std::vector<Point> SvgFile::points(pugi::xml_node path) const {
  for (pugi::xml_node node = path; node; node = node.parent()) REQUIRE_FALSE(node.attribute("transform"));
  std::vector<Point> points = PathReader(path.attribute("d").value()).points();
  const double scale = mm();
  for (Point& p : points) p = {scale * p.x, scale * p.y};
  REQUIRE(points.size() >= 2);
  return points;
}

double SvgFile::length(const std::string& id) const {
  const auto p = points(id);
  return std::hypot(p.back().x - p.front().x, p.back().y - p.front().y);
}

std::string style(pugi::xml_node element, const std::string& property) {
  for (pugi::xml_node node = element; node; node = node.parent())
    if (const pugi::xml_attribute found = node.attribute(property.c_str())) return found.value();
  if (property == "stroke") return "none";
  if (property == "fill") return "#000";
  FAIL("no " << property);
  return "";
}

Colour colour(const std::string& hexadecimal) {
  CAPTURE(hexadecimal);
  REQUIRE((hexadecimal.size() == 4 || hexadecimal.size() == 7));
  const std::size_t digits = hexadecimal.size() / 3;
  const auto level = [&](std::size_t part) {
    const std::string value = hexadecimal.substr(1 + part * digits, digits);
    return std::stoi(digits == 1 ? value + value : value, nullptr, 16) / 255.0;
  };
  return {level(0), level(1), level(2), 1};
}

}  // namespace epure::drawings
