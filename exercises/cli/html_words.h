// Rich text as HTML, which an XML parser reads too.
#pragma once

#include <string>

namespace epure {

std::string html(const std::string& rich_text);

// What a page's style sheet says of it.
inline constexpr const char* style_of_words = R"(sub, sup { line-height: 0; }
.vector { position: relative; }
.vector::before { content: "→"; position: absolute; left: 0; right: 0; top: -.75em; text-align: center;
  font-style: normal; font-size: .75em; }
)";

}  // namespace epure
