// Sheets that changed as pictures, before beside after, with what only one of them has in colour.
#pragma once

#include <string>
#include <vector>

#include "tests/golden/marks.h"

namespace epure::golden {

struct Change {
  std::string exercise, sheet;  // the sheet's own name, and /2 for its second page
  Lines before, after;          // empty: it did not exist, it is gone
};

// A picture of some of them. Its word stands on the picture and nowhere else: who knows it has seen the picture.
struct Picture {
  std::vector<Change> changes;
  std::string word;
  drawings::Page page;
};
std::vector<Picture> pictures_of(const std::vector<Change>& changes);

}  // namespace epure::golden
