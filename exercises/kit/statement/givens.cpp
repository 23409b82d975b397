#include "exercises/kit/statement/givens.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "exercises/kit/statement/sensible_size.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {

using geometry::InUnit;

namespace {

std::vector<std::string> symbols(const std::vector<GivenSpec>& specs) {
  std::vector<std::string> names;
  for (const GivenSpec& spec : specs) names.push_back(spec.symbol);
  return names;
}

std::string unit_after_number(const geometry::Unit& unit) { return unit.symbol == "1" ? "" : " " + unit.symbol; }

// The condition that the number violates, if it does.
std::optional<Words> violated(const GivenSpec& spec, const InUnit& read) {
  const Rational& value = read.number;
  if (spec.range == Range::positive && value <= 0) return Words{"must be positive", "deve essere positivo"};
  if (spec.range == Range::not_negative && value < 0) return Words{"must not be negative", "non può essere negativo"};
  if (has_sensible_size(value)) return std::nullopt;  // or is zero where it may be: a positive given got no further
  const Words without_sign =
      value < 0 ? Words{"without its sign it must ", "senza segno deve "} : Words{"must ", "deve "};
  const Words or_zero = spec.range == Range::positive ? Words{} : Words{"be zero or ", "essere zero o "};
  return format_words("{}{}lie between {} and {}{}", "{}{}stare tra {} e {}{}", without_sign, or_zero,
                      std::string(smallest_size), std::string(largest_size), unit_after_number(read.unit));
}

// As typed, but no longer than one line can bear.
std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? std::string(text) : std::string(text.substr(0, longest)) + "...";
}

InUnit read_word(const GivenSpec& spec, std::string_view text) {
  Words words;
  for (std::size_t i = 0; i < spec.choices.size(); ++i) {
    const std::string& word = spec.choices[i].word;
    if (word == text) return {static_cast<int>(i), *geometry::find_unit("1")};
    words.english += (i == 0 ? "" : " or ") + word;
    words.italian += (i == 0 ? "" : " o ") + word;
  }
  throw BadGivens(
      format_words("{} = {}: must be {}", "{} = {}: deve essere {}", spec.symbol, shortened(text), words));
}

InUnit read(const GivenSpec& spec, std::string_view text) {
  if (!spec.choices.empty()) return read_word(spec, text);
  try {
    InUnit value = geometry::read_given(std::string(text), spec.unit);
    if (const auto condition = violated(spec, value))
      throw BadGivens(format_words("{} = {}: {}", "{} = {}: {}", spec.symbol, shortened(text), *condition));
    return value;
  } catch (const geometry::BadGiven& unreadable) {
    throw BadGivens(format_words("{}: {}", "{}: {}", spec.symbol, unreadable.words()));
  }
}

bool is_same(const InUnit& a, const InUnit& b) {
  return geometry::turns(a.unit.kind) ? geometry::angle_of(a) == geometry::angle_of(b) : a.number == b.number;
}

bool is_called(const GivenSpec& spec, std::string_view name) {
  return spec.symbol == name || std::find(spec.also.begin(), spec.also.end(), name) != spec.also.end();
}

}  // namespace

std::size_t index_of(const std::vector<GivenSpec>& specs, std::string_view name) {
  const auto found =
      std::find_if(specs.begin(), specs.end(), [&](const auto& spec) { return is_called(spec, name); });
  return static_cast<std::size_t>(found - specs.begin());
}

Givens::Givens(const std::vector<GivenSpec>& specs) : specs_(specs) {
  for (const GivenSpec& spec : specs_)
    values_.push_back({spec.turned ? InUnit{0, *geometry::find_unit(spec.unit)} : read(spec, spec.stated)});
}

void Givens::set(std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw BadGivens(format_words("\"{}\" sets nothing; write symbol=value, such as {}={}",
                                 "\"{}\" non assegna nulla; scrivere simbolo=valore, come {}={}",
                                 shortened(assignment), specs_.empty() ? "r" : specs_.front().symbol,
                                 specs_.empty() ? "1/4" : specs_.front().stated));
  const std::string symbol(assignment.substr(0, equals));
  if (symbol.empty())
    throw BadGivens(format_words("\"{}\" has no symbol before the =; {}", "\"{}\" non ha simbolo prima di =; {}",
                                 shortened(assignment), did_you_mean(symbol, symbols(specs_))));
  const std::size_t i = index_of(specs_, symbol);
  if (i == specs_.size())
    throw BadGivens(format_words("\"{}\" is no given here; {}", "\"{}\" qui non è un dato; {}", shortened(symbol),
                                 did_you_mean(symbol, symbols(specs_))));
  const auto other = partner(i);
  if (other && values_[*other].was_set)
    throw BadGivens(format_words("{} and {} are two ways to state one thing; set one of them",
                                 "{} e {} sono due modi di dire la stessa cosa; assegnarne uno solo",
                                 specs_[*other].symbol, specs_[i].symbol));
  values_[i] = {read(specs_[i], assignment.substr(equals + 1)), true};
}

std::size_t Givens::place(std::string_view symbol) const {
  const std::size_t i = index_of(specs_, symbol);
  assert(i < specs_.size() && "an exercise asks for its own givens only");
  return i;
}

std::optional<std::size_t> Givens::partner(std::size_t i) const {
  if (specs_[i].turned) return place(specs_[i].turned->instant);
  for (std::size_t k = 0; k < specs_.size(); ++k)
    if (specs_[k].turned && specs_[k].turned->instant == specs_[i].symbol) return k;
  return std::nullopt;
}

bool Givens::follows_at(std::size_t i) const {
  const auto other = partner(i);
  return other && (specs_[i].turned ? !values_[i].was_set : values_[*other].was_set);
}

Angle Givens::turned(const TurnedThrough& by) const {
  return values_[place(by.instant)].reading.number * angle(by.speed);
}

const Rational& Givens::operator[](std::string_view symbol) const {
  const std::size_t i = place(symbol);
  assert(!follows_at(i) && "what follows has no number of its own");
  return values_[i].reading.number;
}

Angle Givens::angle(std::string_view symbol) const {
  const std::size_t i = place(symbol);
  if (specs_[i].turned && follows_at(i)) return turned(*specs_[i].turned);
  return geometry::angle_of(values_[i].reading);
}

const Choice& Givens::chosen(std::string_view symbol) const {
  const std::size_t i = place(symbol);
  assert(!specs_[i].choices.empty() && "a given of words");
  return specs_[i].choices[static_cast<std::size_t>(CGAL::to_double(values_[i].reading.number))];
}

std::optional<InUnit> Givens::reading_at(std::size_t i) const {
  if (!follows_at(i)) return values_[i].reading;
  const geometry::Unit own = *geometry::find_unit(specs_[i].unit);
  if (specs_[i].turned) {
    const Angle through = turned(*specs_[i].turned);
    const bool in_turns = through.radians == 0 && (through.turns != 0 || own.counts_turns);
    const geometry::Unit unit = in_turns == own.counts_turns ? own : *geometry::find_unit(in_turns ? "deg" : "rad");
    return InUnit{(in_turns ? through.turns : through.radians) / unit.factor, unit};
  }
  const GivenSpec& stating = specs_[*partner(i)];
  const Angle speed = angle(stating.turned->speed);
  if (geometry::is_zero(speed)) return std::nullopt;
  const auto instant = geometry::ratio(angle(stating.symbol), speed);
  return instant ? std::optional(InUnit{*instant, own}) : std::nullopt;
}

std::optional<InUnit> Givens::reading(std::string_view symbol) const { return reading_at(place(symbol)); }

std::string Givens::text(std::string_view symbol) const {
  const std::size_t i = place(symbol);
  if (!specs_[i].choices.empty()) return chosen(symbol).word;
  const auto read = reading_at(i);
  return read ? geometry::to_text(read->number) : "";
}

bool Givens::follows(std::string_view symbol) const { return follows_at(place(symbol)); }

bool Givens::is_changed(std::string_view symbol) const {
  const std::size_t i = place(symbol);
  if (follows_at(i)) return false;
  if (specs_[i].turned) return angle(symbol) != Givens(specs_).angle(symbol);
  return values_[i].was_set && !is_same(values_[i].reading, read(specs_[i], specs_[i].stated));
}

bool Givens::as_stated() const {
  return std::none_of(specs_.begin(), specs_.end(), [&](const GivenSpec& spec) { return is_changed(spec.symbol); });
}

}  // namespace epure
