#include "drawings/files/flattened.h"

#include <algorithm>
#include <variant>

namespace epure::drawings {
namespace {

Colour on_white(const Colour& c) {
  const auto mixed = [&](double part) { return 1 - c.opacity * (1 - part); };
  return {mixed(c.red), mixed(c.green), mixed(c.blue), 1};
}

Colour& colour_of(Primitive& primitive) {
  return std::visit([](auto& p) -> Colour& { return p.colour; }, primitive);
}

}  // namespace

Page flattened(Page page) {
  std::stable_partition(page.primitives.begin(), page.primitives.end(),
                        [](Primitive& each) { return colour_of(each).opacity < 1; });
  for (Primitive& each : page.primitives) colour_of(each) = on_white(colour_of(each));
  return page;
}

std::string without_date(std::string postscript) {
  const auto line = postscript.find("%%CreationDate:");
  if (line != std::string::npos) postscript.erase(line, postscript.find('\n', line) + 1 - line);
  return postscript;
}

}  // namespace epure::drawings
