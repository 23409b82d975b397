// What pages for a browser say of their drawings, which stand in elements of class "sheet".
#pragma once

#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure {

// On a reader's dark screen each colour of the pages becomes what it is on a dark page: the SVG itself stays as it is
// in a file. With the colours --ground, --ink and --now of the page around it.
std::string dark_style(const std::vector<drawings::Page>& pages);

}  // namespace epure
