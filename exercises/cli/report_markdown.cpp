// Markdown as pandoc, GitHub and notebooks read it: pipe tables, and mathematics between dollar signs, which is set
// with its indices in each of them (HTML's own <sub> is lost on the way to Word).
#include <fmt/format.h>

#include <algorithm>

#include "drawings/files/tex.h"
#include "drawings/text/text.h"
#include "exercises/cli/report_document.h"
#include "exercises/cli/utf8.h"

namespace epure {
namespace {

using drawings::Node;

std::string plain_markdown(const std::string& text) {
  const std::string signs = "\\`*_[]<>#|$~^&@";
  std::string set;
  for (const char c : text) {
    if (signs.find(c) != std::string::npos) set += '\\';
    set += c == '\n' ? ' ' : c;
  }
  return set;
}

// What stands between two dollar signs is one formula, or letters alone.
std::string formula(const std::string& between) {
  const std::vector<Node> nodes = drawings::parse("$" + between + "$");
  std::string letters;
  for (const Node& node : nodes) letters += node.letters;
  if (std::all_of(nodes.begin(), nodes.end(), drawings::is_text)) return plain_markdown(letters);
  std::string tex = drawings::tex_of_mathematics(nodes);
  for (auto bar = tex.find('|'); bar != std::string::npos; bar = tex.find('|'))
    tex.replace(bar, 1, "\\vert ");  // else it would part the cells of a table
  tex.erase(tex.find_last_not_of(' ') + 1);
  return "$" + tex + "$";
}

std::string inline_markdown(const std::string& rich_text) {
  std::string set, part;
  bool is_formula = false;
  for (std::size_t i = 0; i < rich_text.size(); ++i) {
    if (rich_text[i] == '\\' && i + 1 < rich_text.size() && (is_formula || rich_text[i + 1] == '$')) {
      if (is_formula) part += '\\';
      part += rich_text[++i];
    } else if (rich_text[i] == '$') {
      set += is_formula ? formula(part) : plain_markdown(part);
      part.clear();
      is_formula = !is_formula;
    } else {
      part += rich_text[i];
    }
  }
  return set + plain_markdown(part);
}

// At its beginning "+", "-" or "3." would begin a list.
std::string paragraph(const std::string& rich_text) {
  std::string text = inline_markdown(rich_text);
  const auto digits = text.find_first_not_of("0123456789");
  if (text.starts_with('+') || text.starts_with('-')) return "\\" + text;
  if (digits != std::string::npos && digits > 0 && (text[digits] == '.' || text[digits] == ')'))
    text.insert(digits, "\\");
  return text;
}

// The dashes below a column's head: pandoc makes columns of long tables as wide as these are to each other.
std::vector<std::size_t> widths_of(const drawings::Table& table) {
  constexpr std::size_t least = 3, most = 24;
  std::vector<std::size_t> widths;
  const auto add = [&](const std::vector<std::string>& row) {
    widths.resize(std::max(widths.size(), row.size()), least);
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], std::min(most, count_characters(drawings::plain(row[i]))));
  };
  add(table.head);
  for (const auto& row : table.rows) add(row);
  return widths;
}

class Markdown {
 public:
  void operator()(const ReportHeading& heading) {
    text_ +=
        std::string(static_cast<std::size_t>(heading.level) + 1, '#') + " " + inline_markdown(heading.text) + "\n\n";
  }
  void operator()(const drawings::Paragraph& words) { text_ += paragraph(words.text) + "\n\n"; }
  void operator()(const drawings::Steps& steps) {
    int number = steps.first;
    for (const std::string& line : steps.lines) text_ += fmt::format("{}. {}\n", number++, paragraph(line));
    text_ += "\n";
  }
  void operator()(const ReportList& list) {
    for (const std::string& item : list.items) text_ += "- " + paragraph(item) + "\n";
    text_ += "\n";
  }
  void operator()(const drawings::Table& table) {
    const std::vector<std::size_t> widths = widths_of(table);
    add_row(table.head, widths.size());
    text_ += "|";
    for (const std::size_t width : widths) text_ += std::string(width, '-') + "|";
    text_ += "\n";
    for (const auto& row : table.rows) add_row(row, widths.size());
    text_ += "\n";
  }
  void operator()(const ReportFigure& figure) {
    text_ += fmt::format("![{}]({}.svg)\n\n", inline_markdown(figure.caption), figure.name);
  }
  std::string text() && { return std::move(text_); }

 private:
  void add_row(const std::vector<std::string>& cells, std::size_t columns) {
    text_ += "|";
    for (std::size_t i = 0; i < columns; ++i)
      text_ += " " + (i < cells.size() ? inline_markdown(cells[i]) : "") + " |";
    text_ += "\n";
  }

  std::string text_;
};

}  // namespace

std::string markdown_of(const ReportDocument& document) {
  Markdown writer;
  for (const ReportBlock& block : document.blocks) std::visit(writer, block);
  return "# " + inline_markdown(document.title) + "\n\n" + inline_markdown(document.source) + "\n\n" +
         std::move(writer).text();
}

}  // namespace epure
