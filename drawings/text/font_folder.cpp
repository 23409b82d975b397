#include "drawings/text/font_folder.h"

namespace epure::drawings {

namespace fs = std::filesystem;

fs::path font_folder() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path installed = (program.parent_path() / EPURE_FONTS_FROM_PROGRAM).lexically_normal();
  return !unknown && fs::is_directory(installed, unknown) ? installed : fs::path(EPURE_FONTS_IN_SOURCES);
}

}  // namespace epure::drawings
