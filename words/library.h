// A library that epure is made with, and which one of its versions: of a shared one, that which runs.
#pragma once

#include <string>
#include <vector>

namespace epure {

struct Library {
  std::string name, version;
};
using Libraries = std::vector<Library>;

}  // namespace epure
