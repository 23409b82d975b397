// A file of YAML as texts, lists and maps, each with its line and column: no value is a number or a truth value
// before who reads it says so. A strict part of YAML: anchors and aliases, tags, several documents, a key that stands
// twice, deep nesting and files without measure are refused, each with one sentence and its place.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "words/words.h"

namespace epure::scenes {

// What is wrong with a file; the sentence begins with "file:line:column: ", where it has a place.
struct BadScene : Told {
  using Told::Told;
  Words without_place = {};  // none where it has none
};

struct TextTree {
  enum class Kind { nothing, text, list, map };
  Kind kind = Kind::nothing;
  int line = 1, column = 1;
  std::string text = {};
  std::vector<TextTree> items = {};                         // of a list
  std::vector<std::pair<TextTree, TextTree>> entries = {};  // of a map, in their order; keys are texts

  // The value of a map's key; none when there is none. Of what is no map, none.
  const TextTree* find(std::string_view key) const;
};

// Throws BadScene. `file` is the name that messages give it.
TextTree read_text_tree(const std::string& file, std::string_view bytes);

// To be thrown: the sentence at the place of `at`.
BadScene bad_scene(const std::string& file, const TextTree& at, const Words& sentence);

}  // namespace epure::scenes
