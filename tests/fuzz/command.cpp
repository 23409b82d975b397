// A command line, an argument a line, of the verbs that write no file: an exit code of the contract, and of what is
// wrong one sentence.
#include <cstdint>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "exercises/cli/run.h"
#include "tests/exercises/fake.h"

using namespace epure;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t most = 400;
  if (count > most) return 0;
  static const std::set<std::string> harmless{"list", "check", "sweep", "help", "--help", "--version"};
  std::istringstream text(std::string(reinterpret_cast<const char*>(bytes), count));
  std::vector<std::string> arguments;
  for (std::string line; std::getline(text, line, '\n');) {
    if (line.find('\0') != std::string::npos) return 0;  // no argument can have one
    // No file is to be written, no other one read, and no terminal waited for.
    for (const char* option : {"-o", "--out", "--chart", "--givens", "/", "."})
      if (line.rfind(option, 0) == 0) return 0;
    arguments.push_back(line);
  }
  if (arguments.empty() || !harmless.contains(arguments.front())) return 0;
  for (const std::string& each : arguments)
    if (each == "-" || each.find(".y") != std::string::npos) return 0;
  static const Catalogue catalogue = [] {
    Catalogue all;
    all.emplace_back(std::make_unique<Triangle>());
    return all;
  }();
  std::ostringstream out, err;
  const int code = run_cli(catalogue, arguments, out, err);
  const std::string said = err.str();
  const bool is_of_contract = code == 0 || code == 1 || code == 2 || code == 4;
  const bool is_safe = said.find('\x1b') == std::string::npos && out.str().find('\x1b') == std::string::npos;
  if (!is_of_contract || !is_safe || (code == 2 && said.rfind("epure: ", 0) != 0)) std::abort();
  return 0;
}
