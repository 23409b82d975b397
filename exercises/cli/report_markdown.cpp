// Markdown as pandoc, GitHub and notebooks read it: pipe tables, and mathematics between dollar signs, which is set
// with its indices in each of them (HTML's own <sub> is lost on the way to Word), and which pandoc hands to LaTeX: so
// what LaTeX knows only there stands there.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "drawings/files/tex.h"
#include "drawings/text/text.h"
#include "drawings/text/unicode.h"
#include "exercises/cli/report_document.h"
#include "exercises/cli/utf8.h"
#include "words/replace_all.h"

namespace epure {
namespace {

using drawings::Node;

std::string plain_markdown(const std::string& text) {
  const std::string signs = "\\`*_[]<>#|$~^&@";
  std::string set;
  for (const char c : text) {
    if (signs.find(c) != std::string::npos) set += '\\';
    set += c;
  }
  return set;
}

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_letter_or_digit(char32_t c) { return is_digit(c) || (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'); }

// Texts and formulas one after another. A dollar sign before a digit, or beside another one, would not end a formula;
// and GitHub knows none that begins within a word.
class MarkdownLine {
 public:
  // Letters as they are. What LaTeX sets in mathematics alone is a formula, with the whole word that it stands in.
  void add_text(const std::string& text) {
    const std::u32string all = drawings::characters(in_one_line(text));
    for (std::size_t from = 0, to = 0; from < all.size(); from = to) {
      const bool is_word = is_of_word(all, from);
      while (to < all.size() && is_of_word(all, to) == is_word) ++to;
      std::string part;
      for (std::size_t i = from; i < to; ++i) part += drawings::utf8(all[i]);
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(from),
                 end = all.begin() + static_cast<std::ptrdiff_t>(to);
      if (std::any_of(begin, end, drawings::is_mathematics_only) || (ends_in_formula_ && is_digit(all[from])))
        add_mathematics(drawings::tex_of_mathematics({Node{.letters = part}}));
      else
        add_plain(plain_markdown(part));
    }
  }

  // What stands between two dollar signs is one formula, or letters alone.
  void add_formula(const std::string& between) {
    const std::vector<Node> nodes = drawings::parse("$" + between + "$");
    if (!std::all_of(nodes.begin(), nodes.end(), drawings::is_text))
      return add_mathematics(drawings::tex_of_mathematics(nodes));
    std::string letters;
    for (const Node& node : nodes) letters += node.letters;
    add_text(letters);
  }

  std::string markdown() && { return std::move(set_); }

 private:
  // Letters, digits, a point or comma between digits, and what is mathematics; behind a root, which pandoc does not
  // take alone, its bracket.
  static bool is_of_word(const std::u32string& all, std::size_t i) {
    const bool parts_digits = (all[i] == U'.' || all[i] == U',') && i > 0 && i + 1 < all.size() &&
                              is_digit(all[i - 1]) && is_digit(all[i + 1]);
    const bool is_bracket_of_root = all[i] == U'(' && i > 0 && all[i - 1] == U'√';
    return parts_digits || is_bracket_of_root || is_letter_or_digit(all[i]) || drawings::is_mathematics_only(all[i]);
  }
  void add_plain(const std::string& markdown) {
    set_ += markdown;
    ends_in_formula_ = ends_in_formula_ && markdown.empty();
  }
  // What LibreOffice cannot read in a formula, it can as text in it: a bracket without its partner, a sign without
  // its terms. A bar parts the cells of a table too.
  static std::string readable(std::string tex) {
    if (tex.find("{)}") != std::string::npos) {  // bears a script
      replace_all(tex, "(", "\\text{(}");
      replace_all(tex, ")", "\\text{)}");
    }
    replace_all(tex, "\\surd (", "\\surd {\\text{(}}");
    replace_all(tex, "*", "\\text{*}");
    replace_all(tex, "+}", "\\text{+}}");
    replace_all(tex, "|", "{\\mid}");
    return tex;
  }
  // Of a script on nothing, on which Word and LibreOffice put an empty box: the word or bracket that stands before
  // it.
  std::string taken_back_base() {
    std::string sign, letters;
    if (set_.ends_with("\\|")) {
      set_.erase(set_.size() - 2);
      sign = "{\\mid}";
    } else if (set_.ends_with(')')) {
      set_.pop_back();
      sign = "{\\text{)}}";
    }
    for (; !set_.empty() && is_letter_or_digit(static_cast<unsigned char>(set_.back())); set_.pop_back())
      letters = set_.back() + letters;
    if (sign.empty() && letters.empty()) return "{}";
    ends_in_formula_ = set_.ends_with('$') && !set_.ends_with("\\$");
    return drawings::tex_of_mathematics({Node{.letters = letters}}) + sign;
  }
  void add_mathematics(std::string tex) {
    tex = readable(std::move(tex));
    if (tex.starts_with("{}_") || tex.starts_with("{}^")) tex.replace(0, 2, taken_back_base());
    tex.erase(tex.find_last_not_of(' ') + 1);
    if (ends_in_formula_)
      set_.back() = ' ';  // they are one
    else
      set_ += '$';
    set_ += tex + "$";
    ends_in_formula_ = true;
  }

  std::string set_;
  bool ends_in_formula_ = false;
};

std::string inline_markdown(const std::string& rich_text) {
  MarkdownLine line;
  std::string part;
  bool is_formula = false;
  for (std::size_t i = 0; i < rich_text.size(); ++i) {
    if (rich_text[i] == '\\' && i + 1 < rich_text.size() && (is_formula || rich_text[i + 1] == '$')) {
      if (is_formula) part += '\\';
      part += rich_text[++i];
    } else if (rich_text[i] == '$') {
      if (is_formula)
        line.add_formula(part);
      else
        line.add_text(part);
      part.clear();
      is_formula = !is_formula;
    } else {
      part += rich_text[i];
    }
  }
  line.add_text(part);
  return std::move(line).markdown();
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

// Of the words of a text, which part at blanks but for those at which no line ends.
std::size_t longest_word(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ' ');) longest = std::max(longest, count_characters(word));
  return longest;
}

// The dashes below a column's head: pandoc makes columns of long tables as wide as these are to each other. What
// cannot part, a number of 17 digits, counts twice: in Word's letters of 12 points it would else part somewhere, for
// want of room.
std::vector<std::size_t> widths_of(const drawings::Table& table) {
  constexpr std::size_t least = 3, most = 20;
  std::vector<std::size_t> widths;
  const auto add = [&](const std::vector<std::string>& row) {
    widths.resize(std::max(widths.size(), row.size()), least);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string text = drawings::plain(row[i]);
      widths[i] = std::max({widths[i], std::min(most, count_characters(text)), 2 * longest_word(text)});
    }
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
