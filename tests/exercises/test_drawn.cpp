// Drawings are found in doubles where doubles suffice. They must be the drawings that 256 bits make.
#include "exercises/kit/drawn.h"

#include <map>
#include <random>

#include "drawings/output.h"
#include "exercises/kit/exercise.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

// The file, whose numbers are rounded to 1/256 pt; or why there is none.
std::string file_of(const Exercise& exercise, const std::string& sheet, const Givens& givens) {
  try {
    return drawings::pdf({exercise.draw(sheet, givens, {}).sheet}, "");
  } catch (const BadGivens& reason) {
    return reason.what();
  }
}

bool is_pdf(const std::string& file) { return file.starts_with("%PDF"); }

std::string with_bits(const Exercise& exercise, const std::string& sheet, const Givens& givens) {
  const WithBits bits;
  return file_of(exercise, sheet, givens);
}

// A few of the givens that are numbers, each made a little larger or smaller.
Givens varied(const Description& about, std::mt19937& random) {
  Givens givens(about.givens);
  for (const GivenSpec& given : about.givens) {
    if (!given.choices.empty() || random() % 2 == 0) continue;
    const Rational factor(static_cast<int>(80 + random() % 41), 100);
    const Rational value = givens[given.symbol] * factor;
    if (given.stated.find_first_not_of("0123456789") == std::string::npos) continue;  // a count of teeth
    std::ostringstream text;
    text << given.symbol << '=' << value;
    givens.set(text.str());
  }
  return givens;
}

}  // namespace

TEST_CASE("every sheet drawn in doubles is the sheet drawn with 256 bits") {
  for (const auto& exercise : catalogue())
    for (const SheetSpec& sheet : exercise->about().sheets) {
      INFO(exercise->about().id << "/" << sheet.name);
      const Givens givens(exercise->about().givens);
      CHECK((file_of(*exercise, sheet.name, givens) == with_bits(*exercise, sheet.name, givens)));
    }
}

TEST_CASE("so it is with other givens") {
  std::mt19937 random(20261122);
  std::map<std::string, int> drawn;
  int all = 0;
  for (int round = 0; round < 30; ++round)
    for (const auto& exercise : catalogue()) {
      const Description& about = exercise->about();
      const Givens givens = varied(about, random);
      const std::string& sheet = about.sheets[random() % about.sheets.size()].name;
      std::string said;
      for (const GivenSpec& given : about.givens) said += given.symbol + "=" + givens.text(given.symbol) + " ";
      INFO(about.id << "/" << sheet << " with " << said);
      const std::string file = file_of(*exercise, sheet, givens);
      CHECK((file == with_bits(*exercise, sheet, givens)));
      drawn[about.id] += is_pdf(file) ? 1 : 0;
      all += is_pdf(file) ? 1 : 0;
    }
  CHECK(all > 250);
  for (const auto& exercise : catalogue()) {
    INFO(exercise->about().id);
    CHECK(drawn[exercise->about().id] > 5);
  }
}
