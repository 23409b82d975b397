#include "exercises/kit/givens.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "exercises/kit/suggest.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

// What stays inside is far from where doubles overflow: a fourth power of 1e12 times a million is still below 1e60.
const char* const smallest_size = "1e-12";
const char* const largest_size = "1e12";

std::vector<std::string> symbols(const std::vector<GivenSpec>& specs) {
  std::vector<std::string> names;
  for (const GivenSpec& spec : specs) names.push_back(spec.symbol);
  return names;
}

// The condition that `value` violates; empty when it violates none.
std::string violated(const GivenSpec& spec, const Rational& value) {
  if (spec.range == Range::positive && value <= 0) return "must be positive";
  if (spec.range == Range::not_negative && value < 0) return "must not be negative";
  const Rational size = CGAL::abs(value);
  const bool zero = size == 0;  // where it may be zero: a positive given got no further
  if (zero || (size >= geometry::parse_given(smallest_size, "1") && size <= geometry::parse_given(largest_size, "1")))
    return "";
  return fmt::format("must {}lie between {} and {}{}{}", spec.range == Range::positive ? "" : "be zero or ",
                     smallest_size, largest_size, spec.unit == "1" ? "" : " ", spec.unit == "1" ? "" : spec.unit);
}

// As typed, but no longer than one line can bear.
std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? std::string(text) : std::string(text.substr(0, longest)) + "...";
}

Rational read_word(const GivenSpec& spec, std::string_view text) {
  std::string words;
  for (std::size_t i = 0; i < spec.choices.size(); ++i) {
    if (spec.choices[i].word == text) return Rational(static_cast<int>(i));
    words += (i == 0 ? "" : " or ") + spec.choices[i].word;
  }
  throw BadGivens(fmt::format("{} = {}: must be {}", spec.symbol, shortened(text), words));
}

Rational read(const GivenSpec& spec, std::string_view text) {
  if (!spec.choices.empty()) return read_word(spec, text);
  try {
    Rational value = geometry::parse_given(std::string(text), spec.unit);
    if (const std::string condition = violated(spec, value); !condition.empty())
      throw BadGivens(fmt::format("{} = {}: {}", spec.symbol, shortened(text), condition));
    return value;
  } catch (const geometry::BadGiven& unreadable) {
    throw BadGivens(fmt::format("{}: {}", spec.symbol, unreadable.what()));
  }
}

std::size_t index_of(const std::vector<GivenSpec>& specs, std::string_view symbol) {
  const auto found =
      std::find_if(specs.begin(), specs.end(), [&](const auto& spec) { return spec.symbol == symbol; });
  return static_cast<std::size_t>(found - specs.begin());
}

}  // namespace

Givens::Givens(const std::vector<GivenSpec>& specs) : specs_(specs) {
  for (const GivenSpec& spec : specs_) values_.push_back(read(spec, spec.stated));
}

void Givens::set(std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw BadGivens(fmt::format("\"{}\" sets nothing; write symbol=value, such as {}={}", shortened(assignment),
                                specs_.empty() ? "r" : specs_.front().symbol,
                                specs_.empty() ? "1/4" : specs_.front().stated));
  const std::string symbol(assignment.substr(0, equals));
  if (symbol.empty())
    throw BadGivens(fmt::format("\"{}\" has no symbol before the =; {}", shortened(assignment),
                                did_you_mean(symbol, symbols(specs_))));
  const std::size_t i = index_of(specs_, symbol);
  if (i == specs_.size())
    throw BadGivens(
        fmt::format("\"{}\" is no given here; {}", shortened(symbol), did_you_mean(symbol, symbols(specs_))));
  values_[i] = read(specs_[i], assignment.substr(equals + 1));
}

const Rational& Givens::operator[](std::string_view symbol) const {
  const std::size_t i = index_of(specs_, symbol);
  assert(i < specs_.size() && "an exercise asks for its own givens only");
  return values_[i];
}

const Choice& Givens::chosen(std::string_view symbol) const {
  const std::size_t i = index_of(specs_, symbol);
  assert(i < specs_.size() && !specs_[i].choices.empty() && "a given of words");
  return specs_[i].choices[static_cast<std::size_t>(CGAL::to_double(values_[i]))];
}

std::string Givens::text(std::string_view symbol) const {
  const std::size_t i = index_of(specs_, symbol);
  assert(i < specs_.size() && "an exercise asks for its own givens only");
  return specs_[i].choices.empty() ? geometry::to_text(values_[i]) : chosen(symbol).word;
}

bool Givens::is_changed(std::string_view symbol) const {
  const std::size_t i = index_of(specs_, symbol);
  assert(i < specs_.size() && "an exercise asks for its own givens only");
  return values_[i] != read(specs_[i], specs_[i].stated);
}

bool Givens::as_stated() const {
  return std::none_of(specs_.begin(), specs_.end(), [&](const GivenSpec& spec) { return is_changed(spec.symbol); });
}

}  // namespace epure
