#include "exercises/cli/sweep_words.h"

#include "exercises/cli/typographic.h"
#include "exercises/kit/panels/results.h"

namespace epure {

std::string letters_of_given(const GivenSpec& given) { return given.letters.empty() ? given.symbol : given.letters; }

std::string value_with_unit(const Variation& of, std::uint64_t place, Language language) {
  if (of.is_of_words()) return of.text(place);
  return with_true_minus(decimal(of.number(place), 6).in(language)) + unit_after_number(of.unit(), language);
}

std::string position_in_words(const SweepStudy& study, const std::vector<std::uint64_t>& places, Language language) {
  std::string words;
  for (std::size_t i = 0; i < places.size(); ++i)
    words += (i == 0 ? "" : ", ") + letters_of_given(study.over[i].given()) + " = " +
             value_with_unit(study.over[i], places[i], language);
  return words;
}

}  // namespace epure
