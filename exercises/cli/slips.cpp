#include "exercises/cli/slips.h"

#include <cmath>
#include <numbers>

#include "exercises/cli/must_be_told.h"
#include "exercises/kit/proof/verdict.h"

namespace epure {
namespace {

using geometry::Kind;

// A number that is a multiple of what it should be.
struct Multiple {
  double factor;
  Words slip;
};

std::optional<Kind> kind_of(const std::string& unit) {
  const auto known = geometry::find_unit(unit);
  return known ? std::optional(known->kind) : std::nullopt;
}

void add_powers_of_ten(std::vector<Multiple>& all) {
  for (const int power : {1, 2, 3, 4, 6}) {  // µm for m, and what a slipped decimal sign makes
    const std::string times = power == 1 ? "10" : "10^" + std::to_string(power);
    all.push_back({std::pow(10.0, power), format_words("{} times too large (factor {})",
                                                       "{} volte troppo grande (fattore {})", times, times)});
    all.push_back({std::pow(10.0, -power), format_words("{} times too small (factor 1/{})",
                                                        "{} volte troppo piccola (fattore 1/{})", times, times)});
  }
}

void add_turns(std::vector<Multiple>& all, std::optional<Kind> kind) {
  constexpr double rpm = 30 / std::numbers::pi, degrees = 180 / std::numbers::pi;
  if (kind == Kind::angle || kind == Kind::angular_velocity || kind == Kind::angular_acceleration) {
    all.push_back({degrees, {"degrees taken for radians (factor 180/π)", "gradi per radianti (fattore 180/π)"}});
    all.push_back({1 / degrees, {"radians taken for degrees (factor π/180)", "radianti per gradi (fattore π/180)"}});
  }
  const bool is_acceleration = kind == Kind::acceleration || kind == Kind::angular_acceleration;
  if (!is_acceleration && kind != Kind::velocity && kind != Kind::angular_velocity) return;
  all.push_back({rpm, {"rpm taken for rad/s (factor 30/π)", "giri/min per rad/s (fattore 30/π)"}});
  all.push_back({1 / rpm, {"rad/s taken for rpm (factor π/30)", "rad/s per giri/min (fattore π/30)"}});
  if (!is_acceleration) return;
  all.push_back(
      {rpm * rpm, {"rpm taken for rad/s, squared (factor 900/π²)", "giri/min per rad/s, al quadrato (900/π²)"}});
  all.push_back({1 / (rpm * rpm),
                 {"rad/s taken for rpm, squared (factor π²/900)", "rad/s per giri/min, al quadrato (π²/900)"}});
}

std::vector<Multiple> multiples_of(const std::string& unit) {
  std::vector<Multiple> all;
  add_powers_of_ten(all);
  add_turns(all, kind_of(unit));
  all.push_back({2, {"twice too large (factor 2)", "doppia del vero (fattore 2)"}});
  all.push_back({0.5, {"half of it (factor 1/2)", "metà del vero (fattore 1/2)"}});
  return all;
}

// The givens with another value for one of them. Whatever states the same thing otherwise is left out.
Givens with(const Givens& givens, const std::string& symbol, const std::string& value) {
  Givens other(givens.specs());
  for (const GivenSpec& spec : givens.specs()) {
    const bool states_it = spec.turned && spec.turned->instant == symbol;
    const GivenSpec& changed = givens.specs()[index_of(givens.specs(), symbol)];
    const bool stated_by_it = changed.turned && changed.turned->instant == spec.symbol;
    if (spec.symbol == symbol || states_it || stated_by_it || !must_be_told(givens, spec)) continue;
    const std::string unit = spec.choices.empty() ? givens.reading(spec.symbol)->unit.symbol : "";
    other.set(spec.symbol + "=" + givens.text(spec.symbol) + (unit == "1" ? "" : unit));
  }
  other.set(symbol + "=" + value);
  return other;
}

// Whether the number is so many times the value, to so many times what that may be off; a direction is no whole turns
// more or less then. Nobody can tell where what may be off leaves a right number to be its own multiple.
bool is_multiple(const Decimal& number, double factor, double value, const Allowance& by_reading) {
  const Rational times(factor), size = CGAL::abs(Rational(value)), off = by_reading.size;
  const bool is_told_apart = factor > 1 ? times * (size - off) > size + off : times * (size + off) < size - off;
  const Allowance scaled = allowance_of(number, {times * off, {}});
  return is_told_apart && CGAL::abs(excess(number, factor * value)) <= scaled.size;
}

std::string in_unit(const Rational& number, const std::string& unit) { return geometry::to_text(number) + unit; }

}  // namespace

void Slips::add_mistaken(const std::string& symbol, const std::string& value, const Words& slip) {
  try {
    Mistaken found{slip, {}};
    for (const RouteValue& each : exercise_.solve(with(checked_.givens, symbol, value), Rung::bounded))
      if (has_value(each.settled)) found.values.emplace(each.quantity, each.settled.enclosure.value);
    mistaken_->push_back(std::move(found));
  } catch (const Told&) {
    // With the given so mistaken nobody finds anything: it is no slip that leads to a number.
  }
}

const std::vector<Slips::Mistaken>& Slips::mistaken() {
  if (mistaken_) return *mistaken_;
  mistaken_.emplace();
  for (const GivenSpec& given : checked_.givens.specs()) {
    const auto read = checked_.givens.reading(given.symbol);
    if (!read || !given.choices.empty()) continue;
    const Rational& number = read->number;
    const std::string &name = given.symbol, &unit = read->unit.symbol;
    if (read->unit.kind == Kind::angle && read->unit.counts_turns) {
      add_mistaken(
          name, in_unit(Rational(1, 4) / read->unit.factor - number, unit),
          format_words("sine for cosine (90° - {} for {})", "seno per coseno (90° - {} per {})", name, name));
      add_mistaken(name, in_unit(number, "rad"),
                   format_words("{} {} taken for radians", "{} {} presi per radianti", name, unit));
    } else if (read->unit.kind == Kind::length) {
      add_mistaken(name, in_unit(2 * number, unit),
                   format_words("{} doubled (diameter for radius)", "{} raddoppiato (diametro per raggio)", name));
      add_mistaken(name, in_unit(number / 2, unit),
                   format_words("{} halved (radius for diameter)", "{} dimezzato (raggio per diametro)", name));
    }
  }
  return *mistaken_;
}

std::optional<Words> Slips::explain(const CheckedQuantity& quantity, const Decimal& number, Allowances& allowances) {
  const Allowance& by_reading = allowances.of(quantity);
  const std::string& unit = quantity.spec.unit;
  const double value = quantity.settled.enclosure.value;
  if (number.value == 0) return std::nullopt;  // which any other zero would explain
  const auto fits = [&](double mistaken_value, const Rational& size) {
    return is_near(number, mistaken_value, allowance_of(number, {size, {}}).size, quantity.spec);
  };
  for (const PrintedVerdict& printed : quantity.printed) {
    const Decimal text = read_printed(printed.text);
    if (printed.verdict == Verdict::disagrees && is_near(number, nearest(text.value), text.half_unit, quantity.spec))
      return Words{"the number that the source printed", "il numero stampato dalla fonte"};
  }
  if (number.signed_text && fits(-value, by_reading.size)) return Words{"the opposite sense", "il verso opposto"};
  for (const Multiple& each : multiples_of(unit))
    if (is_multiple(number, each.factor, value, by_reading)) return each.slip;
  for (const Mistaken& each : mistaken())
    if (const auto found = each.values.find(quantity.spec.name);
        found != each.values.end() && fits(found->second, by_reading.size))
      return each.slip;
  const auto is_told_from_zero = [&](const CheckedQuantity& other) {
    return std::abs(other.settled.enclosure.value) > nearest(allowances.of(other).size);
  };
  for (const CheckedQuantity& other : checked_.quantities)
    if (other.spec.name != quantity.spec.name && other.spec.unit == unit && has_value(other.settled) &&
        is_told_from_zero(other) && fits(other.settled.enclosure.value, allowances.of(other).size))
      return format_words("this is {}", "questa è {}", other.spec.name);
  return std::nullopt;
}

}  // namespace epure
