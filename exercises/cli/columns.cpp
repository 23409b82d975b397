#include "exercises/cli/columns.h"

#include <algorithm>
#include <cassert>

#include "exercises/cli/utf8.h"

namespace epure {
namespace {

constexpr std::size_t between_columns = 2;

// The end of what stands at `at`: a whole character, or a whole colour.
std::size_t end_of_character(const std::string& text, std::size_t at) {
  if (text[at] == '\x1b') return std::min(text.find('m', at), text.size() - 1) + 1;
  ++at;
  while (at < text.size() && continues_a_character(text[at])) ++at;
  return at;
}

// As much of the text as has this width, taken off its beginning.
std::string take(std::string& text, std::size_t width) {
  std::size_t end = 0;
  for (std::size_t next = 0; end < text.size(); end = next) {
    next = end_of_character(text, end);
    if (display_width(text.substr(0, next)) > width) break;
  }
  const std::string taken = text.substr(0, end);
  text.erase(0, end);
  return taken;
}

std::vector<std::string> split_at_blanks(const std::string& text) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

// Lines that are filled from the left, column by column or piece by piece.
class Page {
 public:
  explicit Page(std::size_t width) : width_(width) {}

  std::size_t at() const { return display_width(line_); }
  bool is_at_beginning() const { return line_.find_first_not_of(' ') == std::string::npos; }
  void go_to(std::size_t column) { line_.append(column - std::min(column, at()), ' '); }
  void write(const std::string& text) { line_ += text; }
  void new_line() {
    line_.erase(line_.find_last_not_of(' ') + 1);
    text_ += line_ + "\n";
    line_.clear();
  }

  // Lines that begin at `left` take the piece up, broken when a whole one cannot.
  void add_piece(std::string piece, std::size_t left) {
    const std::size_t blank = line_.empty() || line_.back() == ' ' ? 0 : 1;
    if (at() + blank + display_width(piece) <= width_) {
      write(blank == 0 ? piece : " " + piece);
    } else if (left + display_width(piece) <= width_) {
      new_line();
      go_to(left);
      write(piece);
    } else if (const std::vector<std::string> words = split_at_blanks(piece); words.size() > 1) {
      for (const std::string& word : words) add_piece(word, left);
    } else {
      break_word(std::move(piece), left);
    }
  }

  std::string text() const { return text_; }

 private:
  void break_word(std::string word, std::size_t left) {
    assert(left < width_);
    const bool touches = at() + (line_.ends_with(' ') ? 0 : 1) > left;
    if (!line_.empty() && touches) new_line();
    while (!word.empty()) {
      go_to(left);
      write(take(word, width_ - left));
      if (!word.empty()) new_line();
    }
  }

  std::size_t width_;
  std::string text_, line_;
};

std::vector<std::size_t> column_widths(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    if (row.size() == 1) continue;
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], display_width(row[i]));
  }
  return widths;
}

// Each no wider than `most` says, but the first takes what all others leave of a terminal.
void limit(std::vector<std::size_t>& widths, std::size_t indent, std::vector<std::size_t> most) {
  most.resize(widths.size());
  std::size_t others = indent;
  for (std::size_t i = 1; i < widths.size(); ++i) {
    if (most[i] > 0) widths[i] = std::min(widths[i], most[i]);
    others += between_columns + widths[i];
  }
  if (!widths.empty() && most[0] > 0)
    widths[0] = std::min(widths[0], std::max(most[0], terminal_width - std::min(others, terminal_width)));
}

std::vector<std::size_t> column_starts(const std::vector<std::size_t>& widths, std::size_t indent) {
  std::vector<std::size_t> starts = {indent};
  for (const std::size_t width : widths) starts.push_back(starts.back() + width + between_columns);
  return starts;
}

std::string set(const std::vector<std::vector<std::string>>& rows, const std::vector<std::size_t>& starts,
                std::size_t width) {
  Page page(width);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i].empty()) continue;
      if (!page.is_at_beginning() && page.at() + between_columns > starts[i]) page.new_line();
      page.go_to(starts[i]);
      if (page.at() + display_width(row[i]) <= width)
        page.write(row[i]);
      else
        for (const std::string& word : split_at_blanks(row[i])) page.add_piece(word, starts[i]);
    }
    page.new_line();
  }
  return page.text();
}

}  // namespace

std::size_t display_width(const std::string& text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size(); at = end_of_character(text, at)) width += text[at] == '\x1b' ? 0 : 1;
  return width;
}

std::string cut_to_width(const std::string& text, std::size_t width) {
  if (display_width(text) <= width) return text;
  std::string rest = text;
  return take(rest, width - 1) + "…";
}

std::string columns(const std::vector<std::vector<std::string>>& rows, std::size_t indent) {
  return set(rows, column_starts(column_widths(rows), indent), std::string::npos);
}

std::string table(const std::vector<std::vector<std::string>>& rows, std::size_t indent,
                  const std::vector<std::size_t>& most) {
  std::vector<std::size_t> widths = column_widths(rows);
  limit(widths, indent, most);
  return set(rows, column_starts(widths, indent), terminal_width);
}

std::string wrapped(const std::vector<std::string>& pieces, std::size_t indent, std::size_t hanging) {
  Page page(terminal_width);
  page.go_to(indent);
  for (const std::string& piece : pieces) page.add_piece(piece, hanging);
  page.new_line();
  return page.text();
}

std::string wrapped(const std::string& text, std::size_t indent, std::size_t hanging) {
  return wrapped(split_at_blanks(text), indent, hanging);
}

}  // namespace epure
