// What the sheets of the bench share.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/sheets/table.h"
#include "drawings/picture.h"
#include "exercises/kit/statement/format_words.h"

namespace epure::bench {

using Rows = std::vector<std::vector<std::string>>;
inline constexpr double letters = 2.5;  // mm, of the tables

// A report that is being drawn.
struct Drawn {
  const Report& report;
  Language language;
  drawings::Paper paper;

  std::string say(const Words& words) const { return words.in(language); }
  drawings::Box area() const { return drawings::drawing_area(paper); }

  // Title block and machine, and nothing drawn.
  drawings::Sheet blank(int page, const std::string& id, const Words& title, const Words& description) const;
  // How it is to be read.
  void explain(drawings::Sheet& sheet, const std::vector<Words>& steps) const;
};

drawings::Sheet speed_against_error(const Drawn& drawn);
drawings::Sheet worst_errors(const Drawn& drawn);
drawings::Sheet curves(const Drawn& drawn);
drawings::Sheet whole_sheets(const Drawn& drawn);

}  // namespace epure::bench
