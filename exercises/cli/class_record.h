// Which class a folder holds: the command that made it, so that it is made again, and no other one over it.
#pragma once

#include <filesystem>
#include <string>

#include "exercises/cli/options.h"

namespace epure {

class ClassRecord {
 public:
  static constexpr const char* file_name = "class.txt";

  // `target`: ID or ID/SHEET.
  ClassRecord(const std::string& target, const Options& options);

  // Of the file class.txt: what the lots hang on in its first line, all other options in its second.
  const std::string& text() const { return text_; }

  // Throws WrongUsage when the folder holds the class of another seed, other --vary or other --set, another --scale
  // or another --paper: what does not fit is drawn again, with other lots.
  void demand_same_in(const std::filesystem::path& folder) const;
  void write_to(const std::filesystem::path& folder) const;

 private:
  std::string lots_, text_;
};

}  // namespace epure
