// A sentence in the languages epure speaks. An exercise keeps its words beside its figures, each in all languages.
#pragma once

#include <string>

#include "drawings/picture.h"

namespace epure {

using drawings::Language;

struct Words {
  std::string english, italian;
  const std::string& in(Language language) const { return language == Language::english ? english : italian; }
};

}  // namespace epure
