// An expression of pyslvs or a link of PMKS+: a scene that is read again with the same joints, or refused with a
// sentence.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "exercises/scenes/file/file_head.h"
#include "exercises/scenes/import/drawn_linkage.h"
#include "exercises/scenes/scene_exercise.h"

using namespace epure;

namespace {

// With the last letter that PMKS+ would give it, so that damage is found further on.
std::string counted(const std::string& link) {
  const std::string digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
  constexpr std::size_t count_of_letters = 62;
  const std::size_t from = link.find('?') + 1;
  return link + digits[(link.size() - from) % count_of_letters];
}

void import(const std::string& text) {
  try {
    const scenes::Imported made = scenes::import_scene(text, "f");
    if (made.scene.find("id: f\n") == std::string::npos) std::abort();
  } catch (const scenes::BadScene& bad) {
    if (std::string(bad.what()).empty()) std::abort();
  } catch (const BadGivens& bad) {  // it does not close
    if (bad.words().english.empty() || bad.words().italian.empty()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t most = 2000;
  if (count == 0 || count > most) return 0;
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  // Never the name of a file.
  if (text.starts_with("M[")) {
    import(text);
  } else {
    import("http://p/?" + text);
    import(counted("http://p/?" + text));
  }
  return 0;
}
