// Writes what is installed beside the program and is made of its own words: pages of the manual, completion of
// shells.
//   documents FOLDER FOLDER_OF_SCRIPTS
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "exercises/cli/options.h"
#include "package/completion.h"
#include "package/manual_page.h"

namespace epure {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_manual(const fs::path& folder, Language language) {
  std::vector<std::string> pages{""};
  for (const std::string& verb : verbs()) pages.push_back(verb);
  for (const std::string& verb : pages)
    write(folder / (name_of_manual_page(verb) + ".1"),
          manual_page(help_page(verb, language), language, EPURE_VERSION));
}

// A script of a shell is complete but for a line that says where the lines go.
void write_completion(const fs::path& to, const fs::path& script) {
  const std::string place = "@lines@\n";
  std::string text = contents(script);
  const auto at = text.find(place);
  if (at == std::string::npos) throw std::runtime_error(script.string() + " has no place for its lines");
  write(to, text.replace(at, place.size(), completion_lines(catalogue())));
}

void write_documents(const fs::path& folder, const fs::path& scripts) {
  write_manual(folder / "man/man1", Language::english);
  write_manual(folder / "man/it/man1", Language::italian);
  write_completion(folder / "bash-completion/completions/epure", scripts / "completion.bash");
  write_completion(folder / "zsh/site-functions/_epure", scripts / "completion.zsh");
  write_completion(folder / "fish/vendor_completions.d/epure.fish", scripts / "completion.fish");
}

}  // namespace
}  // namespace epure

int main(int count, char** words) {
  try {
    if (count != 3) throw std::runtime_error("documents FOLDER FOLDER_OF_SCRIPTS");
    epure::write_documents(words[1], words[2]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
