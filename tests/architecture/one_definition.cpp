// Two types of one name in one namespace are one type to the linker, which then takes the destructor of the one for
// the other. No compiler sees it where the two headers never meet in a source.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.h"

namespace {

namespace fs = std::filesystem;

// The types defined in namespaces that have a name: "epure::geometry::Link". As clang-format lays a file out, what
// stands in no type and no function begins its line.
std::set<std::string> types_of(std::istream& text) {
  static const std::regex opening(R"(^namespace ?([\w:]*) \{.*)"), closing(R"(^\}  // namespace.*)"),
      type(R"(^(?:struct|class|enum class|enum|union) (\w+)(?: final)?(?: : [^;]*| )?\{.*)");
  std::vector<std::string> within;
  std::set<std::string> types;
  std::smatch match;
  for (std::string line; std::getline(text, line);) {
    if (std::regex_match(line, match, opening)) {
      within.push_back(match[1]);
    } else if (std::regex_match(line, closing)) {
      within.pop_back();
    } else if (std::regex_match(line, match, type)) {
      std::string name;
      bool has_name = true;
      for (const std::string& one : within) {
        has_name = has_name && !one.empty();
        name += one + "::";
      }
      if (has_name) types.insert(name + match[1].str());
    }
  }
  return types;
}

}  // namespace

TEST_CASE("no two files define types of one name") {
  const fs::path root = EPURE_SOURCE_DIR;
  std::map<std::string, std::string> defined_in;
  for (const std::string room : {"geometry", "drawings", "exercises", "bench", "package", "tests", "words"})
    for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      std::ifstream text(entry.path());
      const std::string file = entry.path().lexically_relative(root).generic_string();
      for (const std::string& type : types_of(text)) {
        const auto [first, is_new] = defined_in.emplace(type, file);
        INFO(type << " is defined in " << first->second << " and in " << file);
        CHECK(is_new);
      }
    }
  CHECK(defined_in.size() > 300);
  CHECK(defined_in.count("epure::geometry::Link") == 1);
}

TEST_CASE("types are told from what only looks like them") {
  std::istringstream text(
      "namespace a::b {\n\nstruct Declared;\nstruct One {\n  struct Inner {};\n};\nenum class Two { x };\n\n"
      "class Three final : public One {\n};\nstruct One<int> {\n};\nnamespace {\nstruct Hidden {\n};\n}  // "
      "namespace\n"
      "struct Four : Two {};\n}  // namespace a::b\nstruct Free {\n};\n");
  CHECK(types_of(text) == std::set<std::string>{"a::b::Four", "a::b::One", "a::b::Three", "a::b::Two", "Free"});
}
