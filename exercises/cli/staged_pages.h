// The pages of a drawn sheet as its construction goes on, with the values of what its marks show.
#pragma once

#include <vector>

#include "drawings/page.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// The first page in its steps. A mark tells the quantity it is named for, or that the sheet shows as its place or its
// length, which check holds against the drawing; the number is the solution's, as the column prints it.
// `given`: the figure of the sheet to be solved.
std::vector<drawings::Page> staged_pages(DrawnSheet drawn, const drawings::Figure& given, const Solution& solution,
                                         Language language);

// What each step leaves on a page, from the first to the page itself; a page without steps alone.
std::vector<drawings::Page> page_of_each_step(const drawings::Page& page);

// For who shows it and cannot be asked: marks tell nothing.
drawings::Page silent(drawings::Page page);

}  // namespace epure
