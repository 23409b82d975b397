// The numbers that a scene's sheets have: which are drawn is decided after all are made, and before one is drawn.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/statement/format_words.h"

namespace epure::scenes {

class SheetNumbers {
 public:
  void are_of(std::vector<std::string> sheets) const { *sheets_ = std::move(sheets); }
  // "sheet 5"; empty of one that is not drawn.
  Words of(const std::string& sheet) const {
    const auto found = std::find(sheets_->begin(), sheets_->end(), sheet);
    return found == sheets_->end() ? Words{} : format_words("sheet {}", "tavola {}", found - sheets_->begin() + 1);
  }

 private:
  std::shared_ptr<std::vector<std::string>> sheets_ = std::make_shared<std::vector<std::string>>();
};

}  // namespace epure::scenes
