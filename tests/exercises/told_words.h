// What a sheet says in its column: its paragraphs, line by line.
#pragma once

#include <string>

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

// Those that do not break too.
inline std::string with_plain_spaces(std::string text) {
  const std::string unbroken = "\u00a0";
  for (auto at = text.find(unbroken); at != std::string::npos; at = text.find(unbroken, at))
    text.replace(at, unbroken.size(), " ");
  return text;
}

inline std::string told_on(const Tried& tried, const std::string& sheet, const Assignments& given,
                           Language language = Language::english) {
  std::string all;
  for (const drawings::Block& block : tried.draw(sheet, given, {.language = language}).sheet.column)
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) all += paragraph->text + "\n";
  return with_plain_spaces(all);
}

}  // namespace epure::tests
