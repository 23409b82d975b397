// Text for a terminal of 80 columns.
#pragma once

#include <string>
#include <vector>

namespace epure {

constexpr std::size_t terminal_width = 80;

// Cells the text takes on a terminal: characters of UTF-8; what colours it (ESC [ ... m) takes none.
std::size_t display_width(const std::string& text);

// The text where it is no wider than that, else its beginning and "…".
std::string cut_to_width(const std::string& text, std::size_t width);

// Each row a line, its cells padded to the widest of their column and set two blanks apart, after `indent` blanks. No
// blanks at the end of a line.
std::string columns(const std::vector<std::vector<std::string>>& rows, std::size_t indent = 0);

// The same, but nothing is wider than a terminal. Column i is no wider than most[i] (0 or none: as wide as its widest
// cell), but the first takes what the others leave; a cell that is wider runs on to the right, and what it leaves no
// room for stands on the next line, in its column. What reaches the right edge is wrapped. A row of one cell is a
// heading over all columns.
std::string table(const std::vector<std::vector<std::string>>& rows, std::size_t indent,
                  const std::vector<std::size_t>& most = {});

// Pieces set in lines, one blank apart: the first line after `indent` blanks, the others after `hanging`. A piece is
// broken, between its words or within one, only when it is longer than a line.
std::string wrapped(const std::vector<std::string>& pieces, std::size_t indent, std::size_t hanging);
// The same for the words of a text.
std::string wrapped(const std::string& text, std::size_t indent = 0, std::size_t hanging = 0);

}  // namespace epure
