// A table of others: a roster, answers, a key.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "exercises/cli/csv_reader.h"

using namespace epure;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  try {
    const CsvTable table = read_csv(std::string(reinterpret_cast<const char*>(bytes), count), "f");
    if (table.header.empty()) std::abort();
    for (const CsvRow& row : table.rows)
      if (row.cells.size() != table.header.size() || row.line == 0) std::abort();
  } catch (const BadTable& bad) {
    if (bad.words().english.empty() || bad.words().italian.empty()) std::abort();
  }
  return 0;
}
