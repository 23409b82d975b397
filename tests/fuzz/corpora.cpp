// Each file of the corpora, given to its fuzzer as libFuzzer does; what is wrong ends the program.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

using Fuzzer = int(const std::uint8_t*, std::size_t);
extern "C" {
Fuzzer fuzz_given, fuzz_scene, fuzz_table, fuzz_command, fuzz_letters, fuzz_import, fuzz_labels, fuzz_picture,
    fuzz_givens;
}

namespace {

namespace fs = std::filesystem;

int run_all(Fuzzer* fuzzer, const fs::path& folder) {
  int count = 0;
  for (const auto& each : fs::directory_iterator(folder)) {
    if (!each.is_regular_file()) continue;
    std::cout << each.path().string() << std::endl;  // the last one is the culprit
    std::ifstream file(each.path(), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    fuzzer(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++count;
  }
  return count;
}

}  // namespace

int main(int, char** arguments) {
  const fs::path corpus = arguments[1], docs = arguments[2];
  const std::map<std::string, Fuzzer*> fuzzers{
      {"given", fuzz_given},     {"scene", fuzz_scene},     {"table", fuzz_table},
      {"command", fuzz_command}, {"letters", fuzz_letters}, {"import", fuzz_import},
      {"labels", fuzz_labels},   {"picture", fuzz_picture}, {"givens", fuzz_givens}};
  int count = run_all(fuzz_scene, docs / "scenes") + run_all(fuzz_scene, docs / "trusses") +
              run_all(fuzz_table, docs / "examples");
  for (const auto& each : fs::directory_iterator(corpus))
    count += run_all(fuzzers.at(each.path().filename().string()), each.path());
  std::cout << count << " inputs\n";
}
