#include "drawings/sheet/contents.h"

#include <fmt/format.h>

#include "drawings/marks/style.h"
#include "drawings/paths/vectors.h"
#include "drawings/sheet/layout.h"
#include "drawings/text/text.h"

namespace epure::drawings {
namespace {

constexpr double entry_size = 3.2, line_height = 4.6, before_exercise = 1.6;  // mm
constexpr double contents_size = 6, contents_height = 14, edge = 15, gutter = 12, sheet_indent = 5,
                 room_for_page = 12;

double column_width(Paper paper) { return (paper_box(paper).width() - 2 * edge - gutter) / 2; }

// An entry, its title broken into lines.
struct ContentsLines {
  const ContentsEntry* entry;
  std::vector<std::string> lines;
  double left() const { return entry->is_within ? sheet_indent : 0; }
  Weight weight() const { return entry->is_within ? Weight::regular : Weight::bold; }
  double height() const {
    return line_height * static_cast<double>(lines.size()) + (entry->is_within ? 0 : before_exercise);
  }
};
using ContentsColumn = std::vector<ContentsLines>;

// Filled from above; an exercise does not stand at the foot without a sheet.
std::vector<ContentsColumn> filled(const std::vector<ContentsEntry>& entries, Paper paper) {
  const double room = paper_box(paper).height() - 2 * edge - contents_height;
  std::vector<ContentsColumn> columns(1);
  double left = room;
  for (const ContentsEntry& entry : entries) {
    ContentsLines lines{&entry, {}};
    lines.lines = wrap(entry.title, entry_size, column_width(paper) - room_for_page - lines.left(), lines.weight());
    const double needed = lines.height() + (entry.is_within ? 0 : 2 * line_height);
    if (needed > left && !columns.back().empty()) {
      columns.emplace_back();
      left = room;
    }
    left -= lines.height();
    columns.back().push_back(std::move(lines));
  }
  return columns;
}

Page empty_page(const std::string& id, Paper paper, Language language) {
  Page page{
      .id = id, .title = id, .description = "", .extent = paper_box(paper), .language = language, .primitives = {}};
  page.is_paper = true;
  return page;
}

std::string page_number(std::size_t page) { return fmt::format("{}", page + 1); }

}  // namespace

Page title_page(const std::vector<std::string>& lines, Paper paper, Language language) {
  constexpr double first_size = 10, other_size = 5;
  Page page = empty_page("title", paper, language);
  const double room = page.extent.width() - 4 * edge;
  double y = page.extent.height() * 2 / 3;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double letters = i == 0 ? first_size : other_size;
    const Weight weight = i == 0 ? Weight::bold : Weight::regular;
    for (const std::string& line : wrap(lines[i], letters, room, weight)) {
      page.primitives.emplace_back(PlacedText{line, {2 * edge, y}, letters, black, weight});
      y -= 1.4 * letters;
    }
    y -= letters / 2;
  }
  return page;
}

std::size_t count_contents_pages(const std::vector<ContentsEntry>& entries, Paper paper) {
  return (filled(entries, paper).size() + 1) / 2;
}

std::vector<Page> contents_pages(const std::vector<ContentsEntry>& entries, Paper paper, Language language,
                                 std::size_t first, std::vector<Link>& links) {
  const std::vector<ContentsColumn> columns = filled(entries, paper);
  std::vector<Page> pages;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i % 2 == 0) {
      pages.push_back(empty_page(fmt::format("contents-{}", pages.size() + 1), paper, language));
      pages.back().primitives.emplace_back(PlacedText{Words{"Contents", "Indice"}.in(language),
                                                      {edge, pages.back().extent.high.y - edge - contents_size},
                                                      contents_size,
                                                      black,
                                                      Weight::bold});
    }
    Page& page = pages.back();
    const double left = edge + (i % 2 == 0 ? 0 : column_width(paper) + gutter), right = left + column_width(paper);
    double y = page.extent.high.y - edge - contents_height;
    for (const ContentsLines& each : columns[i]) {
      if (!each.entry->is_within) y -= before_exercise;
      const double top = y;
      for (const std::string& line : each.lines) {
        y -= line_height;
        page.primitives.emplace_back(PlacedText{line, {left + each.left(), y}, entry_size, black, each.weight()});
      }
      const std::string number = page_number(each.entry->page);
      page.primitives.emplace_back(PlacedText{
          number, {right - measure(number, entry_size, each.weight()).width, y}, entry_size, black, each.weight()});
      const double below = line_height / 4;
      links.push_back({first + pages.size() - 1, {{left, y - below}, {right, top - below}}, each.entry->page});
    }
  }
  return pages;
}

}  // namespace epure::drawings
