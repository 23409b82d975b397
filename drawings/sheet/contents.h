// The pages before a book of sheets: its title, and what is on which page.
#pragma once

#include <string>
#include <vector>

#include "drawings/page.h"

namespace epure::drawings {

struct ContentsEntry {
  std::string title;       // rich text
  std::size_t page = 0;    // from 0, in the whole document
  bool is_within = false;  // of an exercise: one of its sheets
};

// Rich text, the first line the largest.
Page title_page(const std::vector<std::string>& lines, Paper paper, Language language);

// How many pages contents_pages makes, whatever pages its entries are on.
std::size_t count_contents_pages(const std::vector<ContentsEntry>& entries, Paper paper);

// In two columns. Adds a link for each entry to `links`; the first of these pages is page `first` of the document.
std::vector<Page> contents_pages(const std::vector<ContentsEntry>& entries, Paper paper, Language language,
                                 std::size_t first, std::vector<Link>& links);

}  // namespace epure::drawings
