// A figure whose letters TeX sets, in the font of the document that shows it.
#pragma once

#include <string>
#include <vector>

#include "drawings/page.h"
#include "drawings/text/rich_text.h"

namespace epure::drawings {

// The page that lies below them.
Page without_letters(Page page);

// LaTeX for \input: a picture environment in millimetres, as large as the page, with the file `picture` (which holds
// the page without letters) below and each text around the middle of its place on the page, on the same baseline, in
// its size to a whole point. Needs graphicx; colours need color or xcolor and are left out without. Throws as pdf().
std::string write_tex(const Page& page, const std::string& picture);

// Rich text as LaTeX that shows it, whatever it holds; for text, not mathematics.
std::string tex_of(const std::string& rich_text);
// What stands within mathematics, as LaTeX between dollar signs.
std::string tex_of_mathematics(const std::vector<Node>& nodes);
// Letters as they are: nothing that only mathematics can set.
bool is_text(const Node& node);
// A sign beyond ASCII that LaTeX's fonts of text have not, whatever reads its UTF-8.
bool is_mathematics_only(char32_t character);

}  // namespace epure::drawings
