// An exercise with some of its givens at special values: zero, a right angle, as long as another, or a hair beside
// one of these. Refused in a sentence, undecided, or checked; no two routes disagree, and no sheet shows another
// number.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "exercises/kit/proof/checked.h"
#include "geometry/numbers/given.h"

using namespace epure;

namespace {

// A number beside this one, as text.
std::string beside(const std::string& number, std::uint8_t how) {
  static const std::array<std::string, 4> hairs{"", "001", "000000001", "000000000000000000000000000001"};
  const std::string& hair = hairs[how % hairs.size()];
  if (hair.empty() || number.find_first_of("/e") != std::string::npos) return number;
  return number + (number.find('.') == std::string::npos ? "." : "") + hair;
}

std::string value(const std::vector<GivenSpec>& specs, const GivenSpec& spec, std::uint8_t which, std::uint8_t how) {
  static const std::array<std::string, 16> special{"0",  "1",  "-1",  "2",   "0.5", "90",   "180",    "45",
                                                   "60", "30", "-90", "0.1", "10",  "1000", "0.0001", "1/3"};
  if (!spec.choices.empty()) return spec.choices[which % spec.choices.size()].word;
  if (which < special.size()) return beside(special[which], how);
  const GivenSpec& other = specs[which % specs.size()];
  return other.choices.empty() ? beside(other.stated, how) : spec.stated;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::size_t most = 16;  // five givens
  if (count == 0 || count > most) return 0;
  const Exercise& exercise = *catalogue()[bytes[0] % catalogue().size()];
  const std::vector<GivenSpec>& specs = exercise.about().givens;
  Givens givens(specs);
  std::string told = exercise.about().id;
  try {
    for (std::size_t i = 1; i + 2 < count; i += 3) {
      const GivenSpec& spec = specs[bytes[i] % specs.size()];
      const std::string assignment = spec.symbol + "=" + value(specs, spec, bytes[i + 1], bytes[i + 2]);
      told += " " + assignment;
      givens.set(assignment);
    }
    for (const Complaint& failure : check(exercise, givens, Rung::climb).failures)
      if (failure.about != Complaint::About::mechanism) {
        std::cerr << told << ": " << failure.sentence.english << '\n';
        std::abort();
      }
  } catch (const BadGivens& refused) {
    if (refused.words().english.empty() || refused.words().italian.empty()) std::abort();
  } catch (const geometry::BadGiven&) {
  } catch (const geometry::Impossible&) {
  } catch (const geometry::Undecided&) {
  }
  return 0;
}
