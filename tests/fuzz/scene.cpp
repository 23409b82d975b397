// A mechanism or a truss from a file: made an exercise, or refused with its place and a sentence.
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "exercises/scenes/file/truss_file.h"
#include "exercises/scenes/scene_exercise.h"

using namespace epure;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  try {
    if (scenes::truss_of_text("f", text)) return 0;
    scenes::scene_exercise(std::make_shared<const scenes::Scene>("f", text));
  } catch (const scenes::BadScene& bad) {
    if (std::string(bad.what()).rfind("f:", 0) != 0) std::abort();
  } catch (const BadGivens& bad) {  // it does not close
    if (bad.words().english.empty()) std::abort();
  }
  return 0;
}
