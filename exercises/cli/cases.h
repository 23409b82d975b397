// Quantities of one case of an exercise, "dead_centre.omega_3", stand under its name.
#pragma once

#include <string>
#include <vector>

namespace epure {

class Cases {
 public:
  // The name within its case. When it is another case's than before, the heading goes to `rows` first.
  std::string within(const std::string& name, std::vector<std::vector<std::string>>& rows) {
    const auto point = name.find('.');
    const std::string prefix = point == std::string::npos ? "" : name.substr(0, point + 1);
    if (prefix != now_ && !prefix.empty()) rows.push_back({prefix});
    now_ = prefix;
    return prefix.empty() ? name : "  " + name.substr(prefix.size());
  }

 private:
  std::string now_;
};

}  // namespace epure
