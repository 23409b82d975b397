// A number with a unit, as it is typed: read exactly, or refused with a sentence.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "geometry/numbers/given.h"

using namespace epure::geometry;

namespace {

void demand(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  if (count == 0) return 0;
  const auto& units = known_units();
  const Unit& own = units[bytes[0] % units.size()];
  const std::string text(reinterpret_cast<const char*>(bytes) + 1, count - 1);
  try {
    const InUnit typed = read_as_typed(text, own.symbol), given = read_given(text, own.symbol);
    demand(typed.unit.kind == own.kind && given.unit.kind == own.kind);
    // What is written is read as the same.
    demand(read_as_typed(to_text(typed.number) + " " + typed.unit.symbol, own.symbol).number == typed.number);
  } catch (const BadGiven& bad) {
    demand(!bad.words().english.empty() && !bad.words().italian.empty());
  }
  return 0;
}
