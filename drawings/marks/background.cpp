#include "drawings/marks/background.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawings/marks/style.h"
#include "drawings/paths/vectors.h"

namespace epure::drawings {
namespace {

// WCAG 2.1, "relative luminance".
double luminance(const Colour& c) {
  const auto linear = [](double part) {
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

Colour mixed(const Colour& c, const Colour& with, double share) {
  const auto part = [&](double of, double other) { return of + share * (other - of); };
  return {part(c.red, with.red), part(c.green, with.green), part(c.blue, with.blue), c.opacity};
}

// As little of `with` as makes it stand out so much.
Colour standing_out(const Colour& ink, const Colour& ground, const Colour& with, double least) {
  constexpr int shares = 32;
  for (int i = 0; i < shares; ++i)
    if (const Colour tried = mixed(ink, with, static_cast<double>(i) / shares); contrast(tried, ground) >= least)
      return tried;
  return mixed(ink, with, 1);
}

class Map {
 public:
  explicit Map(const Background& background)
      : is_light_(background.inks == Inks::light),
        ground_(background.colour.value_or(is_light_ ? dark_background : white)) {}

  Colour operator()(const Colour& c) const {
    if (c == white) return ground_;
    if (is_light_) return standing_out(light_ink(c), ground_, white, legible);
    return standing_out(c, ground_, black, std::min(legible, contrast(c, white)));
  }

 private:
  bool is_light_;
  Colour ground_;
};

// Beyond the page, so that no border of it shows through.
Fill painted(const Box& extent, const Colour& colour) {
  const Box box = grown(extent, 1);
  return {polyline({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, true), colour, {}, {}};
}

}  // namespace

double contrast(const Colour& a, const Colour& b) {
  const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
  return (lighter + 0.05) / (darker + 0.05);
}

Inks inks_for(const Colour& ground) {
  return contrast(ground, white) > contrast(ground, black) ? Inks::light : Inks::dark;
}

Page on_background(Page page, const Background& background) {
  const Map map(background);
  for (Primitive& primitive : page.primitives) std::visit([&](auto& p) { p.colour = map(p.colour); }, primitive);
  page.is_paper = false;
  if (background.colour) page.primitives.insert(page.primitives.begin(), painted(page.extent, *background.colour));
  return page;
}

}  // namespace epure::drawings
