#include "exercises/cli/inline_svg.h"

namespace epure {

std::string InlineSvgs::add(const drawings::Page& page) {
  const std::string svg = drawings::write_svg(page);
  const std::string_view rest = std::string_view(svg).substr(svg.find("<svg"));  // no declaration within a page
  const std::string_view opened = "<defs>\n", closed = "</defs>\n";
  const auto begin = rest.find(opened);
  if (begin == rest.npos) return std::string(rest);
  const auto end = rest.find(closed, begin);
  std::string inside(rest.substr(0, begin + opened.size()));
  for (auto at = begin + opened.size(); at < end;) {  // one a line
    const auto next = rest.find('\n', at) + 1;
    const std::string_view definition = rest.substr(at, next - at);
    if (!is_there(definition)) inside += definition;
    at = next;
  }
  return inside.append(rest.substr(end));
}

bool InlineSvgs::is_there(std::string_view definition) {
  const std::string_view before = "id=\"";
  const auto from = definition.find(before) + before.size();
  return !ids_.emplace(definition.substr(from, definition.find('"', from) - from)).second;
}

}  // namespace epure
