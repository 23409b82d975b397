#include "tests/golden/marks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "tests/support/plain_spaces.h"

namespace epure::golden {
namespace {

using namespace drawings;

constexpr double per_mm = 10;

long tenths(double mm) { return std::lround(mm * per_mm); }
std::string written(Point p) { return fmt::format(" {} {}", tenths(p.x), tenths(p.y)); }
std::string written(const Box& box) {
  return fmt::format("{},{},{},{}", tenths(box.low.x), tenths(box.low.y), tenths(box.high.x), tenths(box.high.y));
}
std::string written(const std::optional<Box>& box) { return box ? written(*box) : "-"; }
std::string written(const Colour& colour) {
  const auto byte = [](double part) { return std::lround(255 * part); };
  const std::string ink = fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green), byte(colour.blue));
  return colour.opacity == 1 ? ink : ink + fmt::format("{:02x}", byte(colour.opacity));
}
std::string written(const Path& path) {
  std::string all = "M" + written(path.start);
  for (const Piece& piece : path.pieces)
    all += piece.straight ? " L" + written(piece.end)
                          : " C" + written(piece.first_control) + written(piece.second_control) + written(piece.end);
  return all + (path.closed ? " Z" : "");
}
std::string or_none(const std::string& text) { return text.empty() ? "-" : text; }

struct Written {
  std::string operator()(const Stroke& stroke) const {
    return fmt::format("stroke {} {} {} {} {} {}", stroke.width, written(stroke.colour),
                       or_none(fmt::format("{:.2g}", fmt::join(stroke.dashes, ","))), written(stroke.clip),
                       or_none(stroke.name), written(stroke.path));
  }
  std::string operator()(const Fill& fill) const {
    return fmt::format("fill {} {} {} {}", written(fill.colour), written(fill.clip), or_none(fill.name),
                       written(fill.path));
  }
  std::string operator()(const PlacedText& text) const {
    return fmt::format(
        "text {} {} {}{} {}", text.size, text.weight == Weight::bold ? "bold" : "regular", written(text.colour),
        written(text.baseline),
        text.text.starts_with("epure ") ? "epure" : tests::with_plain_spaces(text.text));  // whatever the version
  }
};

// The words of a line, one after the other.
class LineReader {
 public:
  explicit LineReader(const std::string& line) : line_(line), in_(line) {}

  template <class T>
  T next() {
    T value{};
    if (!(in_ >> value)) throw std::runtime_error("not the line of a mark: " + line_);
    return value;
  }
  double mm() { return static_cast<double>(next<long>()) / per_mm; }
  Point point() {
    const double x = mm();
    return {x, mm()};
  }
  Colour colour() {
    const std::string ink = next<std::string>().substr(1);
    const unsigned long all = std::stoul(ink.size() > 6 ? ink : ink + "ff", nullptr, 16);
    const auto part = [all](int place) { return static_cast<double>((all >> (8 * place)) & 0xff) / 255; };
    return {part(3), part(2), part(1), part(0)};
  }
  std::vector<double> numbers() {
    std::vector<double> all;
    std::istringstream in(next<std::string>());
    for (std::string number; std::getline(in, number, ',') && number != "-";) all.push_back(std::stod(number));
    return all;
  }
  std::optional<Box> box() {
    const std::vector<double> all = numbers();
    if (all.empty()) return {};
    return Box{{all.at(0) / per_mm, all.at(1) / per_mm}, {all.at(2) / per_mm, all.at(3) / per_mm}};
  }
  std::string name() {
    const std::string name = next<std::string>();
    return name == "-" ? "" : name;
  }
  Path path() {
    next<std::string>();  // M
    Path path{.start = point(), .pieces = {}};
    for (std::string kind; in_ >> kind;) {
      if (kind == "Z") {
        path.closed = true;
        break;
      }
      Piece piece;
      piece.straight = kind == "L";
      if (!piece.straight) {
        piece.first_control = point();
        piece.second_control = point();
      }
      piece.end = point();
      path.pieces.push_back(piece);
    }
    return path;
  }
  std::string rest() {
    std::string rest;
    std::getline(in_ >> std::ws, rest);
    return rest;
  }

 private:
  const std::string& line_;
  std::istringstream in_;
};

}  // namespace

std::string line_of(const Primitive& primitive) { return std::visit(Written{}, primitive); }

Lines lines_of(const Page& page) {
  Lines lines{"page" + written(page.extent.low) + written(page.extent.high),
              "told " + tests::with_plain_spaces(page.description)};
  for (const Primitive& primitive : page.primitives) lines.push_back(line_of(primitive));
  return lines;
}

std::optional<Primitive> primitive_of(const std::string& line) {
  LineReader words(line);
  const auto kind = words.next<std::string>();
  if (kind == "stroke") {
    Stroke stroke;
    stroke.width = words.next<double>();
    stroke.colour = words.colour();
    stroke.dashes = words.numbers();
    stroke.clip = words.box();
    stroke.name = words.name();
    stroke.path = words.path();
    return stroke;
  }
  if (kind == "fill") {
    Fill fill;
    fill.colour = words.colour();
    fill.clip = words.box();
    fill.name = words.name();
    fill.path = words.path();
    return fill;
  }
  if (kind == "text") {
    PlacedText text;
    text.size = words.next<double>();
    text.weight = words.next<std::string>() == "bold" ? Weight::bold : Weight::regular;
    text.colour = words.colour();
    text.baseline = words.point();
    text.text = words.rest();
    return text;
  }
  if (kind == "page" || kind == "told") return {};
  throw std::runtime_error("not the line of a mark: " + line);
}

}  // namespace epure::golden
