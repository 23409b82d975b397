// Names of the files that a drawing is written to.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "exercises/cli/candidate.h"
#include "exercises/cli/options.h"

namespace epure {

// What is drawn with one set of givens.
struct DrawnVariant {
  const Exercise& exercise;
  const Givens& givens;
  const Candidate& row;  // of --givens
  std::size_t row_number = 1;
};

class FileNames {
 public:
  // --name, or else "{id}-{sheet}", with "-{number}" where givens come from a table. Throws WrongUsage: a field that
  // is none, or that one of the exercises has not; a pattern with a folder in it; one beside -o.
  FileNames(const Options& options, const std::vector<const Exercise*>& exercises, bool has_table);

  // Whether each sheet has a file of its own, also in a format that takes several.
  bool tells_sheet() const { return is_asked_ && has_field("sheet"); }

  // Without its ending; `sheet` may be empty, and is then left out with the hyphen before it. Throws WrongUsage: no
  // name, one that is hidden, looks like an option or is too long.
  std::string stem(const DrawnVariant& drawn, const std::string& sheet) const;

  // True the first time; false for the same content again. Throws WrongUsage where two contents would be one file.
  bool claim(const std::filesystem::path& path, const std::string& content);

 private:
  // Letters as they are, or a field.
  struct Part {
    std::string text;
    bool is_field = false;
  };
  void read(const std::string& pattern);
  void demand_known(const std::string& field, const std::vector<const Exercise*>& exercises, bool has_table) const;
  bool has_field(const std::string& name) const;
  std::string value(const std::string& field, const DrawnVariant& drawn, const std::string& sheet) const;

  std::string language_;
  bool is_asked_, has_table_, is_for_tex_;
  std::vector<Part> parts_;
  std::map<std::string, std::string> claimed_;  // content by path, small letters only
};

}  // namespace epure
