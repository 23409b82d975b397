#include "tests/exercises/run.h"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace epure {

Ran run_catalogue(const Catalogue& catalogue, const std::vector<std::string>& arguments,
                  const Surroundings& surroundings) {
  std::ostringstream out, err;
  const int exit = run_cli(catalogue, arguments, out, err, surroundings);
  return {exit, out.str(), err.str()};
}

Ran run_on(Triangle triangle, const std::vector<std::string>& arguments) {
  Catalogue catalogue;
  catalogue.emplace_back(std::make_unique<Triangle>(std::move(triangle)));
  return run_catalogue(catalogue, arguments);
}

Ran run(const std::vector<std::string>& arguments) { return run_on(Triangle(), arguments); }

Ran run_on_two(const std::vector<std::string>& arguments) {
  Triangle other;
  other.description.id = "other";
  other.description.givens.push_back({.symbol = "k", .meaning = {}, .unit = "1", .stated = "1"});
  other.change_quantities(
      [](auto& all) { std::erase_if(all, [](const Quantity& spec) { return spec.name == "omega"; }); });
  other.spoil_values = [](auto& values) {
    std::erase_if(values, [](const RouteValue& value) { return value.quantity == "omega"; });
  };
  Catalogue catalogue;
  catalogue.emplace_back(std::make_unique<Triangle>(std::move(other)));
  catalogue.emplace_back(std::make_unique<Triangle>());
  return run_catalogue(catalogue, arguments);
}

Scratch::Scratch() : before_(std::filesystem::current_path()) {
  std::string name = (std::filesystem::temp_directory_path() / "epure-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no scratch folder");
  path_ = name;
  std::filesystem::current_path(path_);
}

Scratch::~Scratch() {
  std::filesystem::current_path(before_);
  std::filesystem::remove_all(path_);
}

std::vector<std::string> Scratch::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path_))
    if (!entry.is_directory()) names.push_back(entry.path().lexically_relative(path_).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace epure
