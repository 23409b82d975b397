#include "exercises/cli/symbol.h"

#include <algorithm>

namespace epure {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string subscript_digits(const std::string& digits) {
  std::string text;
  for (const char digit : digits) {
    text += "\xE2\x82";  // U+2080 and the nine after it
    text += static_cast<char>('\x80' + (digit - '0'));
  }
  return text;
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
    const auto close = rest.find('}');
    if (!rest.starts_with("_{") || close == std::string::npos) {
      if (rest.front() != '{' && rest.front() != '}') plain += rest.front();
      rest.erase(0, 1);
      continue;
    }
    const std::string lowered = rest.substr(2, close - 2);
    plain += std::all_of(lowered.begin(), lowered.end(), is_digit) ? subscript_digits(lowered) : "_" + lowered;
    rest.erase(0, close + 1);
  }
  return plain;
}

}  // namespace epure
