#include "exercises/cli/report_document.h"

#include "drawings/text/rich_text.h"

namespace epure {

std::vector<std::string> labels_in(const std::string& rich_text) {
  std::vector<std::string> parts{""};
  std::string word;
  bool is_mathematics = false, is_escaped = false;
  const auto end_word = [&] {
    if (parts.back().size() + word.size() > drawings::longest_label) parts.emplace_back();
    parts.back() += word;
    word.clear();
  };
  for (const char c : rich_text) {
    word += c;
    if (c == '$' && !is_escaped) is_mathematics = !is_mathematics;
    is_escaped = c == '\\' && !is_escaped;
    if (c == ' ' && !is_mathematics) end_word();
  }
  end_word();
  return parts;
}

}  // namespace epure
