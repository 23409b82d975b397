#include "exercises/kit/panels/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "drawings/text/sheet_words.h"
#include "drawings/text/text.h"
#include "exercises/kit/panels/results.h"
#include "exercises/kit/panels/scale_bar.h"
#include "exercises/kit/statement/given_number.h"

namespace epure {
namespace {

constexpr double bar_strip = 17;     // mm: caption, bar and ticks
constexpr double bar_distance = 78;  // mm from one bar to the next, where there is room

// A given stays on one line with its unit. Written as an escape: the character itself looks like a space, and has
// been taken for one.
constexpr const char* no_break = "\u00a0";

std::string in_one_line(const Givens& givens, const std::set<std::string>& without_part, Language language) {
  std::string line;
  for (const GivenSpec& spec : givens.specs()) {
    if (without_part.contains(spec.symbol) || givens.follows(spec.symbol)) continue;
    if (spec.beyond_source && !givens.is_changed(spec.symbol)) continue;
    if (!line.empty()) line += ", ";
    if (!spec.choices.empty()) {
      line += givens.chosen(spec.symbol).meaning.in(language);
      continue;
    }
    const auto read = *givens.reading(spec.symbol);
    line += (spec.letters.empty() ? spec.symbol : spec.letters) + no_break + equal_to(read.number, language) +
            unit_after_number(read.unit.symbol, language);
  }
  return line;
}

// "..., N.3": the number stays on one line with the word before it.
std::string with_its_number(std::string source) {
  const std::string before = ", N.";
  if (const auto at = source.rfind(before); at != std::string::npos) source.replace(at + 1, 1, no_break);
  return source;
}

}  // namespace

DrawnSheet blank_sheet(const Description& about, const std::string& sheet, const Givens& givens,
                       const SheetRequest& request, const std::set<std::string>& without_part) {
  const Language language = request.language;
  DrawnSheet onto;
  onto.sheet.id = about.id + "-" + sheet + (request.blank ? "-blank" : "");
  onto.sheet.paper = request.paper;
  onto.sheet.language = language;
  onto.sheet.bare = request.bare;
  drawings::TitleBlock& block = onto.sheet.title_block;
  block.exercise = about.title.in(language);
  block.source = with_its_number(about.source.in(language));
  block.pages = static_cast<int>(about.sheets.size());
  for (std::size_t i = 0; i < about.sheets.size(); ++i) {
    if (about.sheets[i].name != sheet) continue;
    block.sheet = about.sheets[i].title.in(language);
    block.page = static_cast<int>(i) + 1;
  }
  assert(!block.sheet.empty());
  const auto own = [](const std::string& text) { return drawings::escaped(text); };
  const OwnTitles& titles = request.titles;
  std::string heading;
  for (const std::string& part : {titles.course, titles.author, request.solver.number, request.solver.name})
    if (!part.empty()) heading += (heading.empty() ? "" : ", ") + part;
  block.heading = own(heading);
  block.number = own(titles.sheet_number);
  if (!titles.title.empty()) block.exercise = own(titles.title);
  if (!givens.as_stated()) block.source += language == Language::english ? ", givens changed" : ", dati cambiati";
  std::string given = in_one_line(givens, without_part, language);
  for (const Words& each : about.also_given(givens)) given += (given.empty() ? "" : ", ") + each.in(language);
  if (!given.empty()) {
    onto.sheet.column.push_back(drawings::Heading{language == Language::english ? "Given" : "Dati"});
    onto.sheet.column.push_back(drawings::Paragraph{given});
  }
  onto.sheet.title = drawings::plain(block.exercise + ": " + block.sheet);
  return onto;
}

drawings::Box figure_area(const SheetRequest& request) {
  drawings::Box area = drawings::drawing_area(request.paper);
  if (request.room_width) area.high.x = std::min(area.high.x, area.low.x + *request.room_width);
  if (request.room_height) area.high.y = std::min(area.high.y, area.low.y + *request.room_height);
  return area;
}

drawings::Box room_above_scale_bars(const SheetRequest& request) {
  drawings::Box room = figure_area(request);
  room.low = {room.low.x + 1, room.low.y + bar_strip};
  room.high = {room.high.x - 1, room.high.y - 1};
  return room;
}

void add_scale_bars(DrawnSheet& onto, const std::vector<Scale>& scales, const SheetRequest& request) {
  const drawings::Box area = drawings::drawing_area(request.paper);
  constexpr double first_bar = 6;     // mm from the edge
  constexpr double last_number = 13;  // mm: room for it and its unit, where bars are many
  constexpr std::size_t few = 3;
  const double distance = std::min(bar_distance, (area.width() - first_bar) / static_cast<double>(scales.size()));
  // What a caption is too long for its share the others give.
  constexpr double caption_size = 3.2, apart = 5;  // mm
  const auto wants = [&](const Scale& scale) {
    return std::max(0.0, drawings::measure(scale.caption, caption_size).width + apart - distance);
  };
  double wanted = 0, giving = 0;
  for (const Scale& scale : scales) {
    wanted += wants(scale);
    giving += wants(scale) == 0 ? 1 : 0;
  }
  const double given = giving > 0 ? wanted / giving : 0;
  double x = area.low.x + first_bar;
  for (const Scale& scale : scales) {
    const drawings::Point at{x, area.low.y + 8};
    onto.sheet.figure.marks.push_back(scales.size() > few
                                          ? bar(scale, at, distance - given - last_number, request.language)
                                          : bar(scale, at, request.language));
    onto.sheet.title_block.scales.push_back(scale.caption);
    x += distance + (wants(scale) > 0 ? wants(scale) : -given);
  }
}

std::string figures(double value, int count, Language language) {
  return value == 0 ? "0" : drawings::number(value, count, language);
}

std::string percent(double value, Language language) {
  std::string text = fmt::format("{:.1f}", value);
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
