// What files of all kinds are read with, and what stands at their head: id, title, source, givens, printed numbers.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/statement/description.h"
#include "exercises/scenes/file/text_tree.h"

namespace epure::scenes {

// Throws with the file's name before each sentence.
class File {
 public:
  // The name must outlive it.
  explicit File(const std::string& name) : name_(name) {}

  const std::string& name() const { return name_; }

  [[noreturn]] void refuse(const TextTree& at, const Words& sentence) const { throw bad_scene(name_, at, sentence); }

  const TextTree& demand(const TextTree& at, TextTree::Kind kind, const Words& what) const {
    if (at.kind != kind) refuse(at, what);
    return at;
  }
  const TextTree& map(const TextTree& at, const Words& what) const { return demand(at, TextTree::Kind::map, what); }
  const std::string& text(const TextTree& at, const Words& what) const {
    return demand(at, TextTree::Kind::text, what).text;
  }

  void demand_keys(const TextTree& map, const std::vector<std::string>& known) const;

  // A line of text in one language, or in both: {en: ..., it: ...}.
  Words words(const TextTree& at) const;

 private:
  // That a sheet can print.
  const std::string& line(const TextTree& at) const;

  const std::string& name_;
};

// As the name of a file; a hyphen with a sheet behind it would be an option.
inline constexpr const char* standard_input = "/dev/stdin";

// Of a shipped file by its id too. Throws BadScene where it cannot be read.
std::string bytes_of(const std::string& file);

// What a file says is text, not markup.
Words escaped(const Words& words);

// A letter, then letters, digits and underscores.
bool is_name(const std::string& text);

// Small letters, digits and hyphens, a letter first.
bool is_id(const std::string& text);

// Between blanks.
std::vector<std::string> parted(const std::string& text);

struct FileHead {
  std::string id;
  Words title, source;
  std::vector<GivenSpec> givens;
  std::vector<Printed> printed;
};

// Throws BadScene.
FileHead read_head(const File& file, const TextTree& root);

}  // namespace epure::scenes
