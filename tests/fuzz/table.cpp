// A table of others as a roster, as variants, and as answers with or without a key: read, or refused in a sentence;
// marks are a table again, in which no cell is a formula and nothing obeyed by a terminal.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "exercises/cli/candidate.h"
#include "exercises/cli/csv_reader.h"
#include "exercises/cli/harmless_cell.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/run.h"
#include "tests/exercises/fake.h"

using namespace epure;

namespace {

void demand(bool holds) {
  if (!holds) std::abort();
}

const Catalogue& triangle() {
  static const Catalogue catalogue = [] {
    Catalogue all;
    all.emplace_back(std::make_unique<Triangle>());
    return all;
  }();
  return catalogue;
}

// A file that is nowhere.
class Kept {
 public:
  explicit Kept(const std::string& bytes) : file_(memfd_create("table", 0)) {
    demand(write(file_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  }
  ~Kept() { close(file_); }
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

template <class Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const BadTable& bad) {
    demand(!bad.words().english.empty() && !bad.words().italian.empty());
  }
}

void as_rosters(const std::string& text) {
  CsvTable table;
  read_or_refuse([&] {
    table = read_csv(text, "f");
    demand(!table.header.empty());
    for (const CsvRow& row : table.rows) demand(row.cells.size() == table.header.size() && row.line > 0);
  });
  if (table.header.empty()) return;
  read_or_refuse([&] {
    std::set<std::string> files;
    for (const Candidate& each : candidates_of(table)) {
      demand(each.file.find('/') == std::string::npos && !each.file.starts_with('.') &&
             files.insert(each.file).second);
      demand(!commands_a_terminal(each.name) && !commands_a_terminal(each.number));
    }
  });
  read_or_refuse([&] { variants_of(table, {&*triangle().front()}); });
}

void as_answers(const std::string& answers, const std::string* key) {
  const Kept answered(answers), known(key ? *key : "");
  std::vector<std::string> arguments{"mark", "triangle", "--format", "csv", "--answers", answered.path()};
  if (key) arguments.insert(arguments.end(), {"--key", known.path()});
  std::ostringstream out, err;
  const int code = run_cli(triangle(), arguments, out, err);
  demand(code == 0 || code == 2 || code == 4);
  demand(!commands_a_terminal(err.str().substr(0, err.str().find('\n'))));
  if (code == 2) return demand(err.str().starts_with("epure: "));
  for (const CsvRow& row : read_csv(out.str(), "marks").rows)
    for (const std::string& cell : row.cells) demand(!looks_like_formula(cell) && !commands_a_terminal(cell));
}

}  // namespace

// A line of three hyphens parts the answers from their key.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t most = 4000;
  if (count > most) return 0;
  const std::string text(reinterpret_cast<const char*>(bytes), count), parting = "\n---\n";
  const std::size_t parted = text.find(parting);
  as_rosters(text);
  if (parted == std::string::npos) {
    as_answers(text, nullptr);
  } else {
    const std::string key = text.substr(parted + parting.size());
    as_answers(text.substr(0, parted), &key);
  }
  return 0;
}
