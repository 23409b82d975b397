#include "exercises/cli/symbol.h"

#include <algorithm>
#include <string_view>

namespace epure {
namespace {

std::string subscript_digits(const std::string& digits) {
  std::string text;
  for (const char digit : digits) {
    text += "\xE2\x82";  // U+2080 and the nine after it
    text += static_cast<char>('\x80' + (digit - '0'));
  }
  return text;
}

// Of the brace that text begins with; npos: it stays open.
std::size_t closing_brace(std::string_view text) {
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '{') ++depth;
    if (text[at] == '}' && --depth == 0) return at;
  }
  return std::string_view::npos;
}

// "3" and "3'" stand lowered as they are; for "B" or "G₃'" there are no such letters.
std::string lowered(const std::string& subscript) {
  const std::size_t end = std::min(subscript.find_first_not_of("0123456789"), subscript.size());
  const std::string rest = subscript.substr(end);
  const bool is_number = end > 0 && rest.find_first_not_of('\'') == std::string::npos;
  return is_number ? subscript_digits(subscript.substr(0, end)) + rest : "_" + unicode_symbol(subscript);
}

void remove_all(std::string& text, const std::string& what) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at)) text.erase(at, what.size());
}

}  // namespace

std::string unicode_symbol(const std::string& rich_text) {
  std::string rest = rich_text, plain;
  remove_all(rest, "$");
  remove_all(rest, "\\vec");
  remove_all(rest, "\\it");
  while (!rest.empty()) {
    const std::size_t close = rest.starts_with("_{") ? closing_brace(rest.substr(1)) : std::string::npos;
    if (close == std::string::npos) {
      if (rest.front() != '{' && rest.front() != '}') plain += rest.front();
      rest.erase(0, 1);
      continue;
    }
    plain += lowered(rest.substr(2, close - 1));
    rest.erase(0, close + 2);
  }
  return plain;
}

}  // namespace epure
