// Drawings are found in doubles where doubles suffice. They must be the drawings that 256 bits make, in every number.
#include "exercises/kit/drawn.h"

#include <cstdlib>
#include <map>
#include <random>

#include "drawings/page.h"
#include "drawings/recording.h"
#include "exercises/kit/exercise.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

// All numbers of the page, as doubles, and those of what is measured on it; or why there is none.
std::string numbers_of(const Exercise& exercise, const std::string& sheet, const Givens& givens) {
  try {
    const DrawnSheet drawn = exercise.draw(sheet, givens, {});
    std::ostringstream all;
    all << drawings::record({drawings::compose(drawn.sheet)}) << std::hexfloat;
    for (const Measurement& m : drawn.measurements)
      all << m.quantity << ' ' << m.from.x << ' ' << m.from.y << ' ' << m.to.x << ' ' << m.to.y << ' ' << m.per_mm;
    return all.str();
  } catch (const Told& reason) {
    return std::string("none: ") + reason.what();
  }
}

bool is_drawn(const std::string& numbers) { return !numbers.starts_with("none"); }

std::string with_bits(const Exercise& exercise, const std::string& sheet, const Givens& givens) {
  const geometry::WithBits bits;
  return numbers_of(exercise, sheet, givens);
}

bool is_count(const GivenSpec& given) { return given.unit == "1" || given.unit.empty(); }

// Some of the givens: words at random, numbers a little larger or smaller, in few digits or in many, or such that
// special positions come about; numbers without a unit, of teeth among them, as they are.
Givens varied(const Description& about, std::mt19937& random) {
  Givens givens(about.givens);
  for (const GivenSpec& given : about.givens) {
    if (random() % 2 == 0) continue;
    std::ostringstream text;
    text << given.symbol << '=';
    if (!given.choices.empty()) {
      text << given.choices[random() % given.choices.size()].word;
    } else if (is_count(given) || given.stated.empty()) {
      continue;
    } else if (given.unit == "deg") {
      text << (random() % 3 == 0 ? Rational(15 * static_cast<int>(random() % 24))
                                 : Rational(static_cast<int>(random() % 36000), 100));
    } else {
      const int digits = random() % 2 == 0 ? 100 : 1000003;
      text << givens[given.symbol] * Rational(static_cast<int>((digits * (80 + random() % 41)) / 100), digits);
    }
    try {
      givens.set(text.str());
    } catch (const BadGivens&) {  // an instant beside an angle
    }
  }
  return givens;
}

// More than the usual few, where somebody wants to know.
int rounds() {
  const char* asked = std::getenv("EPURE_ROUNDS_OF_DRAWINGS");
  return asked ? std::atoi(asked) : 30;
}

}  // namespace

TEST_CASE("every sheet drawn in doubles is the sheet drawn with 256 bits") {
  for (const auto& exercise : catalogue())
    for (const SheetSpec& sheet : exercise->about().sheets) {
      INFO(exercise->about().id << "/" << sheet.name);
      const Givens givens(exercise->about().givens);
      CHECK((numbers_of(*exercise, sheet.name, givens) == with_bits(*exercise, sheet.name, givens)));
    }
}

TEST_CASE("so it is with other givens") {
  std::mt19937 random(20261122);
  std::map<std::string, int> drawn;
  const int all_rounds = rounds();
  for (int round = 0; round < all_rounds; ++round)
    for (const auto& exercise : catalogue()) {
      const Description& about = exercise->about();
      const Givens givens = varied(about, random);
      const std::string& sheet = about.sheets[random() % about.sheets.size()].name;
      std::string said;
      for (const GivenSpec& given : about.givens) said += given.symbol + "=" + givens.text(given.symbol) + " ";
      INFO(about.id << "/" << sheet << " with " << said);
      const std::string numbers = numbers_of(*exercise, sheet, givens);
      CHECK((numbers == with_bits(*exercise, sheet, givens)));
      drawn[about.id] += is_drawn(numbers) ? 1 : 0;
    }
  for (const auto& [id, count] : drawn) {
    INFO(id << ": " << count << " of " << all_rounds);
    CHECK(10 * count > all_rounds);
  }
}
