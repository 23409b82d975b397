// The marks of a drawn sheet, and what its column says.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "drawings/text/text.h"
#include "exercises/kit/proof/exercise.h"

namespace epure::tests {

template <class Kind>
std::vector<Kind> all_of(const DrawnSheet& drawn) {
  std::vector<Kind> all;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* found = std::get_if<Kind>(&mark)) all.push_back(*found);
  return all;
}

inline drawings::Line line(const DrawnSheet& drawn, const std::string& name) {
  for (const drawings::Line& each : all_of<drawings::Line>(drawn))
    if (each.name == name) return each;
  throw std::logic_error("no line " + name);
}
inline std::pair<drawings::Point, drawings::Point> ends_of(const drawings::Line& of) {
  return {of.path.start, of.path.pieces.back().end};
}

// The steps of the column, as plain text.
inline std::vector<std::string> told_steps(const DrawnSheet& drawn) {
  std::vector<std::string> lines;
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) lines.push_back(drawings::plain(line));
  return lines;
}

// Whether a paragraph of the column, or a step, has this in it.
inline bool tells(const DrawnSheet& drawn, const std::string& words) {
  for (const drawings::Block& block : drawn.sheet.column) {
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block))
      if (paragraph->text.find(words) != std::string::npos) return true;
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& step : steps->lines)
        if (step.find(words) != std::string::npos) return true;
  }
  return false;
}

}  // namespace epure::tests
