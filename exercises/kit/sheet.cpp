#include "exercises/kit/sheet.h"

#include <fmt/format.h>

#include <cassert>

#include "drawings/words.h"
#include "exercises/kit/scale.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

constexpr double bar_strip = 17;     // mm: caption, bar and ticks
constexpr double bar_distance = 78;  // mm from one bar to the next

// 0.2 where the decimals end within six figures, else 1/72.
std::string exactly(const Rational& value, Language language) {
  const std::string decimal = short_number(CGAL::to_double(value), Language::english);
  try {
    if (geometry::parse_given(decimal, "1") == value) return short_number(CGAL::to_double(value), language);
  } catch (const geometry::BadGiven&) {
    // Written as a power of ten: the fraction says more.
  }
  return geometry::to_text(value);
}

std::string in_one_line(const Givens& givens, Language language) {
  std::string line;
  for (const GivenSpec& spec : givens.specs()) {
    const std::string unit = spec.unit == "rad/s^2" ? "rad/s²" : spec.unit;
    line += (line.empty() ? "" : ", ") + (spec.letters.empty() ? spec.symbol : spec.letters) + " = " +
            exactly(givens[spec.symbol], language) + " " + unit;
  }
  return line;
}

}  // namespace

DrawnSheet blank_sheet(const Description& about, const std::string& sheet, const Givens& givens,
                       const SheetRequest& request) {
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
  if (!givens.as_stated()) block.source += language == Language::english ? ", givens changed" : ", dati cambiati";
  onto.sheet.column.push_back(drawings::Heading{language == Language::english ? "Given" : "Dati"});
  onto.sheet.column.push_back(drawings::Paragraph{in_one_line(givens, language)});
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
