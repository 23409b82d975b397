// Any text as the letters of a figure, and as what a user has printed on a sheet: the SVG is well-formed XML, by a
// parser that is not ours.
#include <cstdint>
#include <cstdlib>
#include <pugixml.hpp>
#include <string>

#include "drawings/output.h"
#include "drawings/text/text.h"

using namespace epure;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t most = 200;
  if (count > most) return 0;
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  if (!drawings::can_write(text)) return 0;
  drawings::Sheet sheet;
  sheet.id = "f";
  sheet.bare = true;
  sheet.title = drawings::escaped(text);
  const drawings::Point at{100, 100};
  sheet.figure.labels.push_back({drawings::escaped(text), at, at, drawings::Meaning::text});
  const std::string drawn = drawings::svg(sheet);
  if (!pugi::xml_document().load_buffer(drawn.data(), drawn.size())) std::abort();
  return 0;
}
