#include "drawings/text/rich_text.h"

#include <fmt/format.h>

#include <stdexcept>

#include "drawings/text/text.h"
#include "drawings/text/unicode.h"

namespace epure::drawings {
namespace {

constexpr int deepest_nesting = 4;

// Of letters within mathematics: in their usual style capitals are points, and upright.
enum class Style { usual, upright, italic };

bool is_italic(char32_t c, Style style) {
  if (style == Style::upright) return false;
  if (style == Style::italic && ((c >= U'A' && c <= U'Z') || (c >= U'Α' && c <= U'Ω'))) return true;
  const bool latin = (c >= U'a' && c <= U'z') || (c >= U'ß' && c <= U'ÿ' && c != U'÷');
  const bool greek = (c >= U'α' && c <= U'ω') || c == U'ϑ' || c == U'ϕ' || c == U'ϵ';
  return latin || greek;
}

// What stands in mathematics for a character of the keyboard.
char32_t in_mathematics(char32_t c) {
  if (c == U'-') return U'−';
  if (c == U'\'') return U'′';
  return c;
}

bool is_bare(const Node& node) { return node.group.empty() && node.below.empty() && node.above.empty(); }

class Parser {
 public:
  explicit Parser(std::string_view rich_text) : source_(rich_text) {
    if (source_.size() > longest_label)
      throw std::invalid_argument(fmt::format("a label of {} bytes is too long (at most {}): \"{}...\"",
                                              source_.size(), longest_label, source_.substr(0, 40)));
    text_ = characters(source_);
  }

  std::vector<Node> whole() {
    std::vector<Node> nodes;
    while (!at_end()) {
      if (accept(U'$')) {
        for (Node& node : mathematics(U'$', Style::usual, 0)) nodes.push_back(std::move(node));
      } else {
        if (peek() == U'\\' && position_ + 1 < text_.size() && text_[position_ + 1] == U'$') ++position_;
        append(nodes, take(), false);
      }
    }
    return nodes;
  }

 private:
  // Up to and including `end`.
  std::vector<Node> mathematics(char32_t end, Style style, int depth) {
    if (depth > deepest_nesting) fail("nested too deeply");
    std::vector<Node> nodes;
    while (!accept(end)) {
      if (at_end()) fail(end == U'$' ? "a dollar sign has no partner" : "a brace has no partner");
      if (accept(U'_')) {
        give_script(nodes, &Node::below, depth);
      } else if (accept(U'^')) {
        give_script(nodes, &Node::above, depth);
      } else if (accept(U'\\')) {
        command(nodes, style, depth);
      } else if (accept(U'{')) {
        nodes.push_back({.group = mathematics(U'}', style, depth + 1)});
      } else if (peek() == U'}' || peek() == U'$') {
        fail("a brace has no partner");
      } else {
        const char32_t c = in_mathematics(take());
        append(nodes, c, is_italic(c, style));
      }
    }
    return nodes;
  }

  void command(std::vector<Node>& nodes, Style style, int depth) {
    if (accept(U"vec{")) {
      nodes.push_back({.group = mathematics(U'}', style, depth + 1), .arrow = true});
    } else if (accept(U"it{")) {
      for (Node& node : mathematics(U'}', Style::italic, depth + 1)) nodes.push_back(std::move(node));
    } else if (!at_end() && std::u32string_view(U"$_^{}\\").find(peek()) != std::u32string_view::npos) {
      append(nodes, take(), false);
    } else {
      fail("only \\vec{..} and \\it{..} are known");
    }
  }

  void give_script(std::vector<Node>& nodes, std::vector<Node> Node::*where, int depth) {
    if (nodes.empty()) nodes.emplace_back();  // it follows text outside: "m/s$^{2}$"
    leave_last_letter_alone(nodes);
    auto& script = nodes.back().*where;
    if (!script.empty()) fail("a script is given twice");
    if (accept(U'{')) {
      script = mathematics(U'}', Style::upright, depth + 1);
    } else {
      if (at_end() || std::u32string_view(U"$_^}\\").find(peek()) != std::u32string_view::npos)
        fail("a script is missing");
      append(script, in_mathematics(take()), false);
    }
    if (script.empty()) fail("a script is empty");
  }

  // A script belongs to the last letter only.
  static void leave_last_letter_alone(std::vector<Node>& nodes) {
    Node& last = nodes.back();
    if (!is_bare(last)) return;
    const std::u32string letters = characters(last.letters);
    if (letters.size() < 2) return;
    const Node alone{.letters = utf8(letters.back()), .italic = last.italic};
    last.letters.resize(last.letters.size() - alone.letters.size());
    nodes.push_back(alone);
  }

  static void append(std::vector<Node>& nodes, char32_t c, bool italic) {
    const bool joins =
        !nodes.empty() && is_bare(nodes.back()) && !nodes.back().letters.empty() && nodes.back().italic == italic;
    if (joins)
      nodes.back().letters += utf8(c);
    else
      nodes.push_back({.letters = utf8(c), .italic = italic});
  }

  bool at_end() const { return position_ == text_.size(); }
  char32_t peek() const { return text_[position_]; }
  char32_t take() { return text_[position_++]; }
  bool accept(char32_t c) {
    const bool there = !at_end() && peek() == c;
    if (there) ++position_;
    return there;
  }
  bool accept(std::u32string_view word) {
    const bool there = text_.compare(position_, word.size(), word) == 0;
    if (there) position_ += word.size();
    return there;
  }
  [[noreturn]] void fail(std::string_view why) const {
    throw std::invalid_argument(fmt::format("label \"{}\": {}", source_, why));
  }

  std::string_view source_;
  std::u32string text_;
  std::size_t position_ = 0;
};

std::string plain_letters(const std::vector<Node>& nodes) {
  std::string text;
  for (const Node& node : nodes) {
    text += node.letters + plain_letters(node.group);
    if (!node.below.empty()) text += "_" + plain_letters(node.below);
    if (!node.above.empty()) text += "^" + plain_letters(node.above);
  }
  return text;
}

}  // namespace

std::vector<Node> parse(std::string_view rich_text) { return Parser(rich_text).whole(); }

std::string escaped(const std::string& plain_text) {
  std::string text;
  for (const char c : plain_text) text += c == '$' ? std::string("\\$") : std::string(1, c);
  return text;
}

std::string plain(const std::string& rich_text) { return plain_letters(parse(rich_text)); }

}  // namespace epure::drawings
