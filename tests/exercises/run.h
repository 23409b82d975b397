// The command line on the triangle, in this process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "exercises/cli/run.h"
#include "tests/exercises/fake.h"

namespace epure {

struct Ran {
  int exit;
  std::string out, err;
};

// On triangle alone, or on triangle and a second one with id "other" that has a given k besides, and no quantity
// omega.
Ran run(const std::vector<std::string>& arguments);
Ran run_on_two(const std::vector<std::string>& arguments);
Ran run_on(Triangle triangle, const std::vector<std::string>& arguments);

Ran run_catalogue(const Catalogue& catalogue, const std::vector<std::string>& arguments,
                  const Surroundings& surroundings = {});
// On all the real exercises: for test programs that are linked with them.
inline Ran run_on_all(const std::vector<std::string>& arguments, const Surroundings& surroundings = {}) {
  return run_catalogue(catalogue(), arguments, surroundings);
}

// An empty folder that is the working folder while it lives, then gone.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }
  // Every file below it, by name from here, sorted.
  std::vector<std::string> files() const;

 private:
  std::filesystem::path before_, path_;
};

std::string contents(const std::filesystem::path& path);

}  // namespace epure
