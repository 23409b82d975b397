// What all pages for a browser have around them, and what those that a reader moves through have in common. The
// scripts' texts have neither an ampersand nor a less-than, so that a parser of XML reads a page as
// a browser does.
#pragma once

#include <string>

#include "words/words.h"

namespace epure {

struct HtmlPage {
  Language language = Language::english;
  std::string title;  // plain text
  std::string style;
  std::string body;
};
// A file that asks for no other: a browser refuses to fetch anything for it.
std::string html_page(const HtmlPage& page);

inline constexpr const char* style_of_moved_page =
    R"(:root { color-scheme: light dark; --ground: #fff; --ink: #111; --edge: #8888; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--ink);
  font: 1rem/1.4 "STIX Two Text", Georgia, "Times New Roman", serif; }
h1 { font-size: 1.05rem; margin: .5rem 1rem; }
.controls { position: sticky; bottom: 0; padding: .5rem 1rem; border-top: 1px solid var(--edge);
  background: var(--ground); }
.moves { display: flex; gap: .7rem; align-items: center; max-width: 60rem; margin: auto; }
.moves input { flex: auto; min-width: 4rem; }
.moves button { font: inherit; padding: .1rem .7rem; }
@media (pointer: coarse) { .moves { gap: .5rem; } .moves button, .moves input { min-height: 48px; } }
[hidden] { display: none; }
)";

// Stands before the page's own script, in one function with it.
inline constexpr const char* script_of_moved_page = R"(
  'use strict';
  const page = document.currentScript.parentElement;
  const find = selector => page.querySelector(selector);

  // Keys by their names, but those that what has the focus takes for itself.
  const on_keys = (keys, is_own) => document.addEventListener('keydown', event => {
    const is_modified = event.altKey || event.ctrlKey || event.metaKey || event.shiftKey;
    if (is_modified || !(event.key in keys) || is_own(event.target, event.key)) return;
    event.preventDefault();
    keys[event.key]();
  });
)";

// The element, to stand in the body.
std::string script_of_page(const char* own);

}  // namespace epure
