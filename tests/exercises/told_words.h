// What a sheet says in its column: its paragraphs, line by line.
#pragma once

#include <string>

#include "tests/exercises/held_against_corpus.h"
#include "tests/support/plain_spaces.h"

namespace epure::tests {

inline std::string told_on(const Tried& tried, const std::string& sheet, const Assignments& given,
                           Language language = Language::english) {
  std::string all;
  for (const drawings::Block& block : tried.draw(sheet, given, {.language = language}).sheet.column)
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) all += paragraph->text + "\n";
  return with_plain_spaces(all);
}

// Its steps and paragraphs, as they are.
inline std::string words_of(const DrawnSheet& drawn) {
  std::string text;
  for (const drawings::Block& block : drawn.sheet.column) {
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) text += line + "\n";
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) text += paragraph->text + "\n";
  }
  return text;
}

}  // namespace epure::tests
