// A sheet as a page for a browser.
#pragma once

#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure {

struct SheetOnScreen {
  bool is_bare = false;        // printed in the middle of paper that holds it; a whole sheet on paper of its size
  bool follows_reader = true;  // light or dark as the reader likes it; false: on the ground that the pages have
};
// One file that needs no other, of staged pages. Printed, it is true to scale. No id in it but those of the SVGs.
std::string sheet_html(const std::vector<drawings::Page>& pages, SheetOnScreen as);

}  // namespace epure
