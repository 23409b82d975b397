#include "drawings/sheet/title_block.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drawings/marks/style.h"
#include "drawings/paths/vectors.h"
#include "drawings/sheet/layout.h"
#include "drawings/text/sheet_words.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

constexpr double sheet_title_size = 5, text_size = 3, caption_size = 2.2;  // mm
constexpr double field_height = 8.2, further_line = 3.5, bar_height = 6.2;
constexpr double paper_width = 16, sheet_width = 17;  // mm of their fields; the scales have the rest

double room_in_field(double width) { return width - 1.4 * inset; }

// Side by side, or in further lines where they would be small then.
std::vector<std::string> lines_of_scales(const Sheet& sheet) {
  constexpr double legible = 2.7;  // mm
  const std::vector<std::string>& scales = sheet.title_block.scales;
  const auto joined = [&](std::size_t from, std::size_t to) {
    std::string line;
    for (std::size_t i = from; i < to; ++i) line += (i == from ? "" : "  ·  ") + scales[i];
    return line;
  };
  const double room = room_in_field(title_block_width(sheet.paper) - paper_width - sheet_width);
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < scales.size();) {
    std::size_t to = scales.size();
    while (to > from + 1 && measure(joined(from, to), legible).width > room) --to;
    lines.push_back(joined(from, to));
    from = to;
  }
  return lines;
}
double fields_height(const Sheet& sheet) {
  const std::size_t lines = lines_of_scales(sheet).size();
  return field_height + (lines > 1 ? further_line * static_cast<double>(lines - 1) : 0);
}

struct TitleLines {
  std::vector<std::string> heading, exercise, sheet, source;
  double title_part() const {
    return 1.4 + 4.2 * static_cast<double>(heading.size() + exercise.size()) +
           6.0 * static_cast<double>(sheet.size()) + 1.4;
  }
  double source_part() const { return 3.6 + 3.8 * static_cast<double>(source.size()) + 1.0; }
};

// A letter or a short word is no line of its own: then they are all of nearly one length.
std::vector<std::string> wrap_title(const std::string& title, double room) {
  constexpr double short_line = 0.3;  // of the room
  std::vector<std::string> lines = wrap(title, sheet_title_size, room, Weight::bold);
  if (lines.size() > 1 && measure(lines.back(), sheet_title_size, Weight::bold).width < short_line * room)
    return wrap_evenly(title, sheet_title_size, room, Weight::bold);
  return lines;
}

TitleLines title_lines(const Sheet& sheet) {
  const double room = title_block_width(sheet.paper) - 2 * inset;
  const TitleBlock& block = sheet.title_block;
  const auto lines = [&](const std::string& text, double size, Weight weight) {
    return text.empty() ? std::vector<std::string>{} : wrap(text, size, room, weight);
  };
  return {lines(block.heading, text_size, Weight::regular), lines(block.exercise, text_size, Weight::regular),
          wrap_title(block.sheet, room), lines(block.source, text_size, Weight::regular)};
}

class TitleInk {
 public:
  TitleInk(Box box, std::vector<std::string>* conflicts) : box_(box), conflicts_(conflicts) {}

  void rule(Point from, Point to, double width) {
    ink_.push_back(Stroke{segment(from, to), width, {}, black, {}, {}});
  }
  void text(const std::string& text, Point baseline, double size, Weight weight = Weight::regular) {
    ink_.push_back(PlacedText{text, baseline, size, black, weight});
  }
  void caption(const std::string& text, Point at) {
    ink_.push_back(PlacedText{text, at, caption_size, grey, Weight::regular});
  }
  // A small caption with its value below, in one line or several, between `left` and `right`, under the rule at
  // `top`.
  void field(double left, double right, double top, const std::string& name, const std::vector<std::string>& lines) {
    caption(name, {left + inset, top - 2.7});
    double baseline = top - 6.6;
    for (const std::string& line : lines) {
      const double room = room_in_field(right - left), width = line.empty() ? 0 : measure(line, text_size).width;
      // Long values are set smaller rather than over the next rule.
      const double size = width > room ? std::max(smallest, text_size * room / width) : text_size;
      if (conflicts_ && width * size > room * text_size * (1 + 1e-9))
        conflicts_->push_back(fmt::format("title block: no room for {} {}", name, plain(line)));
      if (!line.empty()) text(line, {left + inset, baseline}, size);
      baseline -= further_line;
    }
  }
  Box box() const { return box_; }
  std::vector<Primitive> take() { return std::move(ink_); }

 private:
  static constexpr double smallest = 2.2;  // mm, of letters
  Box box_;
  std::vector<std::string>* conflicts_;
  std::vector<Primitive> ink_;
};

double set_titles(TitleInk& block, const TitleLines& lines, const std::string& source_caption) {
  const double left = block.box().low.x + inset;
  double y = block.box().high.y - 1.4;
  for (const auto* part : {&lines.heading, &lines.exercise})
    for (const std::string& line : *part) {
      block.text(line, {left, y - 3.1}, text_size);
      y -= 4.2;
    }
  for (const std::string& line : lines.sheet) {
    block.text(line, {left, y - 4.7}, sheet_title_size, Weight::bold);
    y -= 6.0;
  }
  y -= 1.4;
  if (lines.source.empty()) return y;
  block.rule({block.box().low.x, y}, {block.box().high.x, y}, fine);
  block.caption(source_caption, {left, y - 2.7});
  double baseline = y - 3.6 - 2.7;
  for (const std::string& line : lines.source) {
    block.text(line, {left, baseline}, text_size);
    baseline -= 3.8;
  }
  return y - lines.source_part();
}

// 50 mm with a tick every 10 mm, and beside it what it is for and which program drew the sheet.
void set_check_bar(TitleInk& block, const std::string& words) {
  const Box box = block.box();
  const double y = box.low.y + 1.7, left = box.low.x + inset;
  block.rule({left, y}, {left + 50, y}, narrow);
  for (int i = 0; i <= 5; ++i) {
    const double height = i % 5 == 0 ? 1.6 : 1.0;
    block.rule({left + 10 * i, y}, {left + 10 * i, y + height}, fine);
  }
  block.caption(words, {left + 1, y + 2.1});
  const std::string program = fmt::format("epure {}", EPURE_VERSION);
  block.text(program, {box.high.x - inset - measure(program, 2.6).width, y + 0.6}, 2.6);
}

}  // namespace

double title_block_height(const Sheet& sheet) {
  const TitleLines lines = title_lines(sheet);
  return lines.title_part() + (lines.source.empty() ? 0 : lines.source_part()) + fields_height(sheet) + bar_height;
}

std::vector<Primitive> set_title_block(const Sheet& sheet, Box box, std::vector<std::string>* conflicts) {
  const SheetWords& w = words(sheet.language);
  const TitleBlock& titles = sheet.title_block;
  TitleInk block(box, conflicts);
  block.rule({box.low.x, box.low.y}, {box.low.x, box.high.y}, wide);
  block.rule({box.low.x - wide / 2, box.high.y}, {box.high.x, box.high.y}, wide);
  const double top = set_titles(block, title_lines(sheet), w.source), bottom = top - fields_height(sheet);
  const double sheet_left = box.high.x - sheet_width, paper_left = sheet_left - paper_width;
  block.rule({box.low.x, top}, {box.high.x, top}, fine);
  block.rule({box.low.x, bottom}, {box.high.x, bottom}, fine);
  block.rule({paper_left, top}, {paper_left, bottom}, fine);
  block.rule({sheet_left, top}, {sheet_left, bottom}, fine);
  block.field(box.low.x, paper_left, top, titles.scales.size() > 1 ? w.scales : w.scale, lines_of_scales(sheet));
  block.field(paper_left, sheet_left, top, w.paper, {sheet.paper == Paper::a4 ? "A4" : "A3"});
  block.field(sheet_left, box.high.x, top, w.sheet,
              {titles.number.empty() ? fmt::format("{}/{}", titles.page, titles.pages) : titles.number});
  set_check_bar(block, w.check_bar);
  return block.take();
}

}  // namespace epure::drawings
