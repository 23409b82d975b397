#include "exercises/cli/variation.h"

#include <algorithm>
#include <optional>

#include "exercises/cli/catalogue.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/given_number.h"

namespace epure {
namespace {

using geometry::InUnit;

constexpr std::size_t most_decimals = 30;  // what needs more is shorter as a fraction

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

bool begins_a_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == ',' || c == '+' || c == '-'; }

// The slash of "360deg/361" and of "40rad/s/0.5rad/s", not that of a unit.
std::optional<std::size_t> last_dividing_slash(const std::string& text) {
  for (std::size_t i = text.size(); i-- > 1;)
    if (text[i - 1] == '/' && begins_a_number(text[i])) return i - 1;
  return std::nullopt;
}

bool is_whole(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

[[noreturn]] void refuse_variation(const GivenSpec& given, const Words& why) {
  throw WrongUsage(given.symbol + ": " + why);
}

InUnit as_typed(const GivenSpec& given, const std::string& text, const std::string& unit) {
  try {
    return geometry::read_as_typed(text, unit);
  } catch (const geometry::BadGiven& unreadable) {
    refuse_variation(given, unreadable.words());
  }
}

// The last unit that stands in one of the texts; the given's own when none does.
std::string common_unit(const GivenSpec& given, const std::vector<std::string>& texts) {
  std::string unit = given.unit;
  for (const std::string& text : texts) unit = as_typed(given, text, unit).unit.symbol;
  return unit;
}

Rational in_common_unit(const GivenSpec& given, const std::string& text, const std::string& unit) {
  const InUnit typed = as_typed(given, text, unit);
  const geometry::Unit common = *geometry::find_unit(unit);
  if (typed.unit.counts_turns != common.counts_turns)
    refuse_variation(given,
                     format_words("{} and {} stand side by side, and no fraction leads from one to the other, as "
                                  "π is between them; write all in one unit",
                                  "{} e {} stanno fianco a fianco, e nessuna frazione porta dall'uno all'altro, "
                                  "perché tra loro c'è π; scrivere tutto in una sola unità",
                                  typed.unit.symbol, unit));
  return typed.number * (typed.unit.factor / common.factor);
}

Words with_unit_behind(const Rational& value, const std::string& unit) {
  return decimal(exact_text(value)) + (unit == "1" ? "" : " " + unit);
}

[[noreturn]] void refuse_too_many(const GivenSpec& given) {
  refuse_variation(given, format_words("more than {} values", "più di {} valori", most_values));
}

}  // namespace

std::string exact_text(const Rational& value) {
  return as_decimal(value, most_decimals).value_or(geometry::to_text(value));
}

Variation::Variation(const GivenSpec& given, const std::string& typed) : given_(given) {
  const std::string text = geometry::in_plain_characters(typed);
  const std::vector<std::string> listed = split(text, '|');
  if (listed.size() > 1) {
    is_of_words() ? read_words(listed) : read_list(listed);
  } else if (is_of_words()) {
    refuse_variation(given_, format_words("\"{}\" is no list of words; write them with | between, such as {}|{}",
                                          "\"{}\" non è un elenco di parole; scriverle con | in mezzo, come {}|{}",
                                          typed, given_.choices.front().word, given_.choices.back().word));
  } else {
    read_range(text);
  }
}

void Variation::read_words(const std::vector<std::string>& texts) {
  Givens trial({given_});
  for (const std::string& word : texts) {
    try {
      trial.set(given_.symbol + "=" + word);
    } catch (const BadGivens& unknown) {
      throw WrongUsage(unknown.words());
    }
    if (std::find(words_.begin(), words_.end(), word) != words_.end())
      refuse_variation(given_, format_words("{} stands in its list twice", "{} sta due volte nell'elenco", word));
    words_.push_back(word);
  }
  size_ = words_.size();
}

void Variation::read_list(const std::vector<std::string>& texts) {
  unit_ = common_unit(given_, texts);
  for (const std::string& text : texts) {
    const Rational value = in_common_unit(given_, text, unit_);
    if (std::find(listed_.begin(), listed_.end(), value) != listed_.end())
      refuse_variation(given_, format_words("{} stands in its list twice", "{} sta due volte nell'elenco",
                                            with_unit_behind(value, unit_)));
    listed_.push_back(value);
  }
  size_ = listed_.size();
}

void Variation::read_range(const std::string& text) {
  const auto points = text.find("..");
  if (points == std::string::npos)
    refuse_variation(given_,
                     format_words("\"{0}\" is one value, --set {1}={0}; a range is written FROM..TO/COUNT or "
                                  "FROM..TO/STEP, a list 'A|B|C'",
                                  "\"{0}\" è un solo valore, --set {1}={0}; un intervallo si scrive DA..A/QUANTI "
                                  "o DA..A/PASSO, un elenco 'A|B|C'",
                                  text, given_.symbol));
  const std::string from = text.substr(0, points), rest = text.substr(points + 2);
  if (rest.starts_with('.'))
    refuse_variation(given_, {"three points in a row; write a zero before the decimal point",
                              "tre punti di seguito; scrivere uno zero prima della virgola"});
  const auto slash = last_dividing_slash(rest);
  if (!slash)
    refuse_variation(given_,
                     format_words("\"{0}\" does not say how many values; write {0}/11 for eleven, or a step with a "
                                  "unit or a decimal point",
                                  "\"{0}\" non dice quanti valori; scrivere {0}/11 per undici, o un passo con "
                                  "un'unità o una virgola decimale",
                                  text));
  const std::string to = rest.substr(0, *slash), last = rest.substr(*slash + 1);
  unit_ = common_unit(given_, {from, to});
  from_ = in_common_unit(given_, from, unit_);
  const Rational end = in_common_unit(given_, to, unit_);
  if (from_ == end)
    refuse_variation(given_, format_words("both ends are {}, which is one value; --set {}={}",
                                          "i due estremi sono {}, cioè un solo valore; --set {}={}",
                                          with_unit_behind(end, unit_), given_.symbol, exact_text(end)));
  by_ = end - from_;
  is_whole(last) ? read_count(last) : read_step(last);
}

void Variation::read_count(const std::string& digits) {
  constexpr std::size_t digits_of_most = 10;
  if (digits.size() > digits_of_most) refuse_too_many(given_);
  const std::uint64_t count = std::stoull(digits);
  if (count > most_values) refuse_too_many(given_);
  if (count < 2)
    refuse_variation(given_,
                     format_words("/{0} counts fewer values than the two ends; a step has a unit or a decimal "
                                  "point: /{0}.0",
                                  "/{0} conta meno valori dei due estremi; un passo ha un'unità o una virgola "
                                  "decimale: /{0},0",
                                  digits));
  size_ = count;
  by_ /= Rational(static_cast<double>(count - 1));
}

void Variation::read_step(const std::string& text) {
  const Rational step = in_common_unit(given_, text, unit_), interval = by_;
  if (step <= 0)
    refuse_variation(given_, format_words("a step of {}: must be positive", "un passo di {}: dev'essere positivo",
                                          with_unit_behind(step, unit_)));
  const Rational steps = CGAL::abs(interval) / step;
  if (steps > Rational(static_cast<double>(most_values))) refuse_too_many(given_);
  const CGAL::Gmpz whole = steps.numerator() / steps.denominator();
  if (Rational(whole) != steps) refuse_step(step, Rational(whole));
  by_ = interval < 0 ? -step : step;
  size_ = static_cast<std::uint64_t>(CGAL::to_double(whole)) + 1;
}

void Variation::refuse_step(const Rational& step, const Rational& whole) const {
  const Rational interval = by_, end = from_ + interval;
  const Rational fitting = CGAL::abs(interval) / (whole == 0 ? Rational(1) : whole);
  const Rational reached = from_ + (interval < 0 ? -step : step) * whole;
  refuse_variation(
      given_,
      format_words("a step of {} does not lead from {} to {}: {} would", "un passo di {} non porta da {} a {}: {} sì",
                   with_unit_behind(step, unit_), decimal(exact_text(from_)), with_unit_behind(end, unit_),
                   with_unit_behind(fitting, unit_)) +
          (whole == 0 ? Words{}
                      : format_words(", or an end at {}", ", o un estremo a {}", with_unit_behind(reached, unit_))));
}

Rational Variation::value(std::uint64_t place) const {
  if (!listed_.empty()) return listed_.at(place);
  return from_ + Rational(static_cast<double>(place)) * by_;  // a double holds every place
}

std::string Variation::text(std::uint64_t place) const {
  return is_of_words() ? words_.at(place) : exact_text(value(place));
}

// A unit that begins with a digit, "1/min", keeps apart from the number.
std::string Variation::assignment(std::uint64_t place) const {
  const std::string number = given_.symbol + "=" + text(place);
  if (unit_ == "1") return number;
  return number + (unit_.starts_with('1') ? " " : "") + unit_;
}

double Variation::number(std::uint64_t place) const { return nearest(value(place)); }

}  // namespace epure
