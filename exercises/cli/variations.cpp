#include "exercises/cli/variations.h"

#include <set>

#include "exercises/cli/catalogue.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

// Of an angle the instant that states it too, of that instant the angle; else empty.
std::string other_statement_of(const std::vector<GivenSpec>& givens, const GivenSpec& given) {
  if (given.turned) return given.turned->instant;
  for (const GivenSpec& other : givens)
    if (other.turned && other.turned->instant == given.symbol) return other.symbol;
  return {};
}

class VariationReader {
 public:
  VariationReader(const Exercise& exercise, std::string option, const std::vector<std::string>& assignments)
      : givens_(exercise.about().givens), names_(given_names(exercise)), option_(std::move(option)) {
    for (const std::string& assignment : assignments) valued_.insert(symbol_in(assignment));
  }

  void add(const std::string& typed) {
    const auto equals = typed.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw WrongUsage(format_words("{} {}: write a symbol, = and its values, such as {}=0..1/11",
                                    "{} {}: scrivere un simbolo, = e i suoi valori, come {}=0..1/11", option_, typed,
                                    givens_.empty() ? "phi" : givens_.front().symbol));
    const GivenSpec& given = given_named(symbol_in(typed));
    demand_free(given);
    read_.emplace_back(given, typed.substr(equals + 1));
  }

  std::vector<Variation> read() && { return std::move(read_); }

 private:
  std::string symbol_in(const std::string& typed) const {
    return ascii_name(typed.substr(0, typed.find('=')), names_);
  }

  const GivenSpec& given_named(const std::string& symbol) const {
    const std::size_t place = index_of(givens_, symbol);
    if (place < givens_.size()) return givens_[place];
    std::vector<std::string> known;
    for (const GivenSpec& given : givens_) known.push_back(given.symbol);
    throw WrongUsage(format_words("{}: \"{}\" is no given here; {}", "{}: \"{}\" qui non è un dato; {}", option_,
                                  symbol, did_you_mean(symbol, known)));
  }

  void demand_free(const GivenSpec& given) const {
    const std::string other = other_statement_of(givens_, given);
    if (valued_.contains(given.symbol))
      throw WrongUsage(format_words("{} is set, and {} varies it; which of the two is meant?",
                                    "{} è assegnato, e {} lo fa variare; quale dei due si intende?", given.symbol,
                                    option_));
    if (valued_.contains(other)) refuse_two_statements(given.symbol, other);
    for (const Variation& before : read_) {
      if (before.given().symbol == given.symbol)
        throw WrongUsage(format_words("{} stands in {} twice; which values are meant?",
                                      "{} sta due volte in {}; quali valori si intendono?", given.symbol, option_));
      if (before.given().symbol == other) refuse_two_statements(given.symbol, other);
    }
  }

  [[noreturn]] static void refuse_two_statements(const std::string& one, const std::string& other) {
    throw WrongUsage(format_words("{} and {} are two ways to state one thing; keep one of them",
                                  "{} e {} sono due modi di dire la stessa cosa; tenerne uno solo", one, other));
  }

  const std::vector<GivenSpec>& givens_;
  std::vector<NameAndLetters> names_;
  std::string option_;
  std::set<std::string> valued_;  // by their symbols
  std::vector<Variation> read_;
};

}  // namespace

std::vector<Variation> read_variations(const Exercise& exercise, const std::string& option,
                                       const std::vector<std::string>& typed,
                                       const std::vector<std::string>& assignments) {
  VariationReader reader(exercise, option, assignments);
  for (const std::string& each : typed) reader.add(each);
  return std::move(reader).read();
}

}  // namespace epure
