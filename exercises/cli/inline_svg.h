// Drawings in a page of HTML.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>

#include "drawings/page.h"

namespace epure {

// An id stands for one thing in a page. Of outlines of letters and the like it is told by what they are, so the
// drawings of a page have them in common: the first that needs one brings it along.
class InlineSvgs {
 public:
  std::string add(const drawings::Page& page);

 private:
  bool is_there(std::string_view definition);

  std::unordered_set<std::string> ids_;
};

}  // namespace epure
