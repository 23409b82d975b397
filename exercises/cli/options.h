// What a user can ask for.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace epure {

// Texts as typed; what they mean is found where they are used, because their parsing must not depend on a locale.
struct Options {
  enum class Verb { list, draw, check, bench } verb = Verb::list;
  std::vector<std::string> names;  // ID, ID/SHEET, all
  std::vector<std::string> assignments, measured;
  std::optional<std::string> format, folder, file, scale;
  std::string paper = "a4", language = "en", reading = "0.5mm", arithmetic = "exact", seconds = "60";
  bool bare = false, json = false, times = false;
};

// Either the options, or a text to show instead (help, version). Throws WrongUsage.
struct Parsed {
  Options options;
  std::optional<std::string> text = {};
};
Parsed parse_options(const std::vector<std::string>& arguments);

}  // namespace epure
