#include "exercises/scenes/file/text_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>

#include "exercises/kit/statement/format_words.h"

namespace epure::scenes {
namespace {

// So that no file that is let in is more work than seconds.
constexpr std::size_t most_bytes = 64 << 10, longest_text = 4096, most_entries = 2'000, most_together = 80,
                      deepest = 12;

BadScene bad_scene_at(const std::string& file, int line, int column, const Words& sentence) {
  BadScene bad(format_words("{}:{}:{}: {}", "{}:{}:{}: {}", file, line, column, sentence));
  bad.without_place = sentence;
  return bad;
}

// What yaml-cpp would let pass, or say nothing useful of.
void demand_plain_text(const std::string& file, std::string_view bytes) {
  if (bytes.size() > most_bytes)
    throw BadScene(format_words("{}: the file has {} bytes; a scene has at most {}",
                                "{}: il file ha {} byte; una scena ne ha al più {}", file, bytes.size(), most_bytes));
  int line = 1, column = 1;
  bool is_indentation = true;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if (byte == '\n') {
      ++line;
      column = 1;
      is_indentation = true;
      continue;
    }
    if (byte == '\t' && is_indentation)
      throw bad_scene_at(file, line, column,
                         {"a tab before a line; YAML takes blanks", "un tabulatore a inizio riga; YAML vuole spazi"});
    if ((byte < 0x20 && byte != '\t' && byte != '\r') || byte == 0x7f)
      throw bad_scene_at(
          file, line, column,
          {"a control character; a scene is plain text", "un carattere di controllo; una scena è testo"});
    if (byte != ' ') is_indentation = false;
    if ((byte & 0xC0U) != 0x80) ++column;
  }
}

// The length of the UTF-8 sequence at `i`; 0 when it is none (Unicode, table 3-7).
std::size_t length_of_utf8(std::string_view bytes, std::size_t i) {
  const auto at = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U; };
  const unsigned first = at(i);
  const auto continues = [&](std::size_t k, unsigned lowest = 0x80, unsigned highest = 0xBF) {
    return at(k) >= lowest && at(k) <= highest;
  };
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return continues(i + 1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF)
    return continues(i + 1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF) && continues(i + 2) ? 3 : 0;
  if (first >= 0xF0 && first <= 0xF4)
    return continues(i + 1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF) && continues(i + 2) &&
                   continues(i + 3)
               ? 4
               : 0;
  return 0;
}

void demand_utf8(const std::string& file, std::string_view bytes) {
  int line = 1, column = 1;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t length = length_of_utf8(bytes, i);
    if (length == 0)
      throw bad_scene_at(file, line, column,
                         {"these bytes are no text in UTF-8", "questi byte non sono testo in UTF-8"});
    column = bytes[i] == '\n' ? 1 : column + 1;
    line += bytes[i] == '\n';
    i += length;
  }
}

class Growing : public YAML::EventHandler {
 public:
  explicit Growing(std::string file) : file_(std::move(file)) {}

  TextTree tree() { return std::move(root_); }
  bool has_document() const { return has_document_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (has_document_)
      refuse(mark, {"a second document; a scene is one", "un secondo documento; una scena ne ha uno"});
    has_document_ = true;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    add(made(mark, TextTree::Kind::nothing));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(mark, {"an alias (*name); write out what is meant", "un alias (*nome); scrivere per esteso"});
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (value.size() > longest_text)
      refuse(mark, format_words("a text of {} characters; at most {}", "un testo di {} caratteri; al più {}",
                                value.size(), longest_text));
    TextTree text = made(mark, TextTree::Kind::text);
    text.text = value;
    add(std::move(text));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    begin(mark, tag, anchor, TextTree::Kind::list);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(mark, tag, anchor, TextTree::Kind::map);
  }
  void OnMapEnd() override { end(); }

 private:
  [[noreturn]] void refuse(const YAML::Mark& mark, const Words& sentence) const {
    throw bad_scene_at(file_, mark.line + 1, mark.column + 1, sentence);
  }
  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0) refuse(mark, {"an anchor (&name) has no meaning here", "un'ancora (&nome) qui non ha senso"});
  }
  // yaml-cpp calls a plain text "?" and a quoted one "!".
  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!")
      refuse(mark, {"a tag (!name) has no meaning here", "un'etichetta (!nome) qui non ha senso"});
  }
  TextTree made(const YAML::Mark& mark, TextTree::Kind kind) {
    if (++count_ > most_entries) refuse(mark, format_words("more than {} entries", "più di {} voci", most_entries));
    TextTree tree;
    tree.kind = kind;
    tree.line = mark.line + 1;
    tree.column = mark.column + 1;
    return tree;
  }
  void begin(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, TextTree::Kind kind) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (open_.size() >= deepest)
      refuse(mark, format_words("nested deeper than {}", "annidato oltre {} livelli", deepest));
    open_.push_back(made(mark, kind));
  }
  void end() {
    TextTree done = std::move(open_.back());
    open_.pop_back();
    add(std::move(done));
  }
  // A map's keys and values come in turn: a key waits among its items.
  void add(TextTree node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    TextTree& parent = open_.back();
    if (std::max(parent.items.size(), parent.entries.size()) >= most_together)
      throw bad_scene(file_, node,
                      format_words("more than {} entries in one list", "più di {} voci in un elenco", most_together));
    if (parent.kind == TextTree::Kind::list) {
      parent.items.push_back(std::move(node));
    } else if (parent.items.empty()) {
      demand_new_key(parent, node);
      parent.items.push_back(std::move(node));
    } else {
      parent.entries.emplace_back(std::move(parent.items.back()), std::move(node));
      parent.items.clear();
    }
  }
  void demand_new_key(const TextTree& map, const TextTree& key) const {
    if (key.kind != TextTree::Kind::text)
      throw bad_scene(file_, key, {"a key must be a text", "una chiave dev'essere un testo"});
    for (const auto& [known, value] : map.entries)
      if (known.text == key.text)
        throw bad_scene(file_, key,
                        format_words("\"{}\" stands here twice (first in line {})",
                                     "\"{}\" sta qui due volte (prima alla riga {})", key.text, known.line));
  }

  std::string file_;
  TextTree root_;
  std::vector<TextTree> open_;
  std::size_t count_ = 0;
  bool has_document_ = false;
};

}  // namespace

BadScene bad_scene(const std::string& file, const TextTree& at, const Words& sentence) {
  return bad_scene_at(file, at.line, at.column, sentence);
}

const TextTree* TextTree::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.first.text == key; });
  return found == entries.end() ? nullptr : &found->second;
}

TextTree read_text_tree(const std::string& file, std::string_view bytes) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  demand_plain_text(file, bytes);
  demand_utf8(file, bytes);
  std::istringstream in{std::string(bytes)};
  Growing growing(file);
  try {
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(growing)) {
    }
  } catch (const YAML::Exception& bad) {
    const std::string said = bad.msg;
    throw bad_scene_at(file, bad.mark.line + 1, bad.mark.column + 1,
                       format_words("this is no YAML: {}", "questo non è YAML: {}", said));
  }
  if (!growing.has_document()) throw BadScene(format_words("{}: the file is empty", "{}: il file è vuoto", file));
  return growing.tree();
}

}  // namespace epure::scenes
