#include "exercises/cli/screen_style.h"

#include <fmt/format.h>

#include <map>

#include "drawings/files/svg_colour.h"
#include "drawings/marks/background.h"

namespace epure {

using drawings::Colour;
using drawings::in_css;

std::string dark_style(const std::vector<drawings::Page>& pages) {
  const drawings::Background dark{drawings::dark_background, drawings::Inks::light};
  std::map<std::string, std::string> becomes;
  const auto map = [&](const drawings::Page& page) {
    const drawings::Page on_dark = on_background(page, dark);
    for (std::size_t i = 0; i < page.primitives.size(); ++i) {
      const auto colour = [](const drawings::Primitive& primitive) {
        return in_css(std::visit([](const auto& p) { return p.colour; }, primitive));
      };
      becomes[colour(page.primitives[i])] = colour(on_dark.primitives[i + 1]);  // the first is its ground
    }
  };
  for (const drawings::Page& page : pages) map(page);
  drawings::Page paper{};  // with the letters that have no colour of their own
  paper.primitives = {drawings::Fill{}, drawings::Fill{{}, {1, 1, 1, 1}, {}, {}}};
  map(paper);
  std::string rules = fmt::format(
      "@media screen and (prefers-color-scheme: dark) {{\n"
      ":root {{ --ground: {}; --ink: #eee; --now: #fc0; }}\n.sheet svg {{ fill: {}; }}\n",
      in_css(drawings::dark_background), becomes[in_css(Colour{})]);
  for (const auto& [from, to] : becomes)
    rules +=
        fmt::format(".sheet [fill=\"{0}\"] {{ fill: {1}; }} .sheet [stroke=\"{0}\"] {{ stroke: {1}; }}\n", from, to);
  return rules + "}\n";
}

}  // namespace epure
