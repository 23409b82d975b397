#include "bench/corpus_folder.h"

namespace epure::bench {

namespace fs = std::filesystem;

fs::path corpus_folder() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path installed = (program.parent_path() / EPURE_CORPORA_FROM_PROGRAM).lexically_normal();
  return !unknown && fs::is_directory(installed, unknown) ? installed : fs::path(EPURE_CORPORA_IN_SOURCES);
}

}  // namespace epure::bench
