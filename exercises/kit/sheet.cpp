#include "exercises/kit/sheet.h"

#include <fmt/format.h>

#include <cassert>

#include "drawings/words.h"
#include "exercises/kit/scale.h"

namespace epure {
namespace {

constexpr double bar_strip = 17;     // mm: caption, bar and ticks
constexpr double bar_distance = 78;  // mm from one bar to the next

}  // namespace

DrawnSheet blank_sheet(const Description& about, const std::string& sheet, const SheetRequest& request) {
  const Language language = request.language;
  DrawnSheet onto;
  onto.sheet.id = about.id + "-" + sheet;
  onto.sheet.paper = request.paper;
  onto.sheet.language = language;
  onto.sheet.bare = request.bare;
  drawings::TitleBlock& block = onto.sheet.title_block;
  block.exercise = about.title.in(language);
  block.source = about.source.in(language);
  block.pages = static_cast<int>(about.sheets.size());
  for (std::size_t i = 0; i < about.sheets.size(); ++i) {
    if (about.sheets[i].name != sheet) continue;
    block.sheet = about.sheets[i].title.in(language);
    block.page = static_cast<int>(i) + 1;
  }
  assert(!block.sheet.empty());
  onto.sheet.title = block.exercise + ": " + block.sheet;
  return onto;
}

drawings::Box room_above_scale_bars(const SheetRequest& request) {
  drawings::Box room = drawings::drawing_area(request.paper);
  room.low = {room.low.x + 1, room.low.y + bar_strip};
  room.high = {room.high.x - 1, room.high.y - 1};
  return room;
}

void add_scale_bars(DrawnSheet& onto, const std::vector<Scale>& scales, const SheetRequest& request) {
  const drawings::Box area = drawings::drawing_area(request.paper);
  double x = area.low.x + 6;
  for (const Scale& scale : scales) {
    onto.sheet.figure.marks.push_back(bar(scale, {x, area.low.y + 8}, request.language));
    onto.sheet.title_block.scales.push_back(scale.caption);
    x += bar_distance;
  }
}

std::string figures(double value, int count, Language language) { return drawings::number(value, count, language); }

std::string percent(double value, Language language) {
  std::string text = fmt::format("{:.3f}", value);
  if (language == Language::italian) text.replace(text.find('.'), 1, ",");
  return text;
}

std::string in_words(const Words& sentence, const std::vector<Value>& values, Language language) {
  std::string text = sentence.in(language);
  const char* before = ": ";
  for (const Value& v : values) {
    std::string number = fmt::format("{:.4g}", v.value);
    if (const auto point = number.find('.'); language == Language::italian && point != std::string::npos)
      number[point] = ',';
    text += before + v.name + " = " + number + (v.unit.empty() ? "" : " " + v.unit);
    before = "; ";
  }
  return text + ".";
}

}  // namespace epure
