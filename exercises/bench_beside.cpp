#include "exercises/bench_beside.h"

#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "drawings/files/system_words.h"

namespace epure {

Bench bench_beside(char** words) {
  return [words](const Catalogue&, const Options&, std::ostream&) -> std::string {
    std::error_code unknown;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / "epure-bench";
    ::execv(program.c_str(), words);
    throw WrongUsage(format_words("bench is a program of its own, {}, which cannot be run: ",
                                  "bench è un programma a sé, {}, che non si può avviare: ", program.string()) +
                     drawings::system_words(errno));
  };
}

}  // namespace epure
