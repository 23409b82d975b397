// Words as the text of an XML element.
#pragma once

#include <string>
#include <string_view>

namespace epure::drawings {

inline void add_escaped(std::string& to, std::string_view text) {
  for (const char c : text) {
    if (c == '<')
      to += "&lt;";
    else if (c == '&')
      to += "&amp;";
    else if (c == '>')
      to += "&gt;";
    else
      to += c;
  }
}

inline std::string escaped_for_xml(std::string_view text) {
  std::string all;
  add_escaped(all, text);
  return all;
}

// ... and as the value of an attribute, between double quotes.
inline std::string escaped_for_attribute(std::string_view text) {
  std::string all = escaped_for_xml(text);
  for (auto quote = all.find('"'); quote != all.npos; quote = all.find('"', quote)) all.replace(quote, 1, "&quot;");
  return all;
}

}  // namespace epure::drawings
