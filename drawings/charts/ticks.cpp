#include "drawings/charts/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

// An end that misses a tick by a millionth of a step lies on it: 0.1 + 0.2 is to be 0.3, and no file can hold the
// difference.
constexpr double slack = 1e-6;

constexpr double numbers_apart = 2.5;                    // mm between numbers side by side
constexpr double shortest_across = 12, shortest_up = 7;  // mm between numbered ticks
constexpr double shortest_between = 1.8;                 // mm between short ticks
constexpr double shortest_decade = 8;                    // mm, to show its 2 to 9

// A decimal number, digits times ten to the exponent: what a tick says is never rounded.
struct Decimal {
  long long digits = 0;
  int exponent = 0;
};

double value_of(Decimal number) {
  const std::string text = fmt::format("{}e{}", number.digits, number.exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// All numbers of an axis show as many decimals as its step, but a zero is a zero.
std::string text_of(Decimal number, Language language) {
  if (number.digits == 0) return "0";
  const std::string_view sign = number.digits < 0 ? "−" : "";
  const long long digits = std::abs(number.digits);
  if (number.exponent >= 0)
    return fmt::format("{}{}{}", sign, digits, std::string(std::size_t(number.exponent), '0'));
  const int decimals = -number.exponent;
  const std::string all = fmt::format("{:0{}}", digits, decimals + 1);
  const std::string_view whole = std::string_view(all).substr(0, all.size() - std::size_t(decimals));
  const std::string_view point = language == Language::italian ? "," : ".";
  return fmt::format("{}{}{}{}", sign, whole, point, std::string_view(all).substr(whole.size()));
}

// Numbers from 100,000 on and up to a thousandth are written in thousands, millions, thousandths, ...
int common_power(double low, double high) {
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest > 1e-3 && largest < 1e5) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3 + slack));
}

// The numbers keep their distance where the axis puts them.
bool fit(const Ticks& candidate, const AxisMap& map, Along along) {
  const std::vector<Tick>& all = candidate.numbered;
  double width = 0;  // of the number before
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double gap = i == 0 ? INFINITY : map.at(all[i].value) - map.at(all[i - 1].value);
    if (gap < (along == Along::horizontal ? shortest_across : shortest_up)) return false;
    if (along == Along::vertical) continue;
    const double own = measure(all[i].text, number_size).width;
    if (gap < (width + own) / 2 + numbers_apart) return false;
    width = own;
  }
  return true;
}

class Numbering {
 public:
  Numbering(const Axis& axis, double length, Along along, Language language)
      : axis_(axis), length_(length), along_(along), language_(language) {}

  Ticks run() const { return axis_.scale == AxisScale::linear ? linear() : logarithmic(); }

 private:
  bool suits(const Ticks& candidate) const {
    return fit(candidate, axis_map(axis_, candidate.low, candidate.high, 0, length_), along_);
  }

  // Every multiple of the step on the axis. More than a few hundred could not fit anyway: none.
  Ticks multiples(Decimal step, int power, bool widen) const {
    const double size = value_of(step);
    const double first = axis_.low / size, last = axis_.high / size;
    const auto from = static_cast<long long>(widen ? std::floor(first + slack) : std::ceil(first - slack));
    const auto to = static_cast<long long>(widen ? std::ceil(last - slack) : std::floor(last + slack));
    Ticks found{axis_.low, axis_.high, power, {}, {}};
    for (long long i = from; i <= to; ++i)
      found.numbered.push_back(
          {value_of({i * step.digits, step.exponent}), text_of({i * step.digits, step.exponent - power}, language_)});
    if (widen) {
      found.low = found.numbered.front().value;
      found.high = found.numbered.back().value;
    }
    return found;
  }

  bool may_be_tried(Decimal step) const {
    const double narrowest = along_ == Along::horizontal ? shortest_across : shortest_up;
    return (axis_.high - axis_.low) / value_of(step) * narrowest <= 2 * length_;
  }

  // Short ticks at the multiples of the finest of `steps` that leave them apart.
  void add_between(Ticks& found, Decimal step, const std::vector<Decimal>& steps) const {
    for (const Decimal& small : steps) {
      const double parts = value_of(step) / value_of(small);
      const double apart = value_of(small) / (found.high - found.low) * length_;
      if (apart < shortest_between || std::abs(parts - std::round(parts)) > slack) continue;
      const double size = value_of(small);
      const auto from = static_cast<long long>(std::ceil(found.low / size - slack));
      const auto to = static_cast<long long>(std::floor(found.high / size + slack));
      const auto each = static_cast<long long>(std::round(parts));
      for (long long i = from; i <= to; ++i)
        if (i % each != 0) found.between.push_back(value_of({i * small.digits, small.exponent}));
      return;
    }
  }

  std::optional<Ticks> by_given_steps() const {
    std::vector<Decimal> smaller;
    for (const int given : axis_.steps) {
      const Decimal step{given, 0};
      if (axis_.high - axis_.low < given * (1 - slack)) break;
      if (may_be_tried(step)) {
        Ticks found = multiples(step, 0, axis_.to_ticks);
        if (found.numbered.size() >= 2 && suits(found)) {
          add_between(found, step, smaller);
          return found;
        }
      }
      smaller.push_back(step);
    }
    return std::nullopt;
  }

  Ticks linear() const {
    if (auto found = by_given_steps()) return *found;
    return by_decimal_steps(axis_.to_ticks);
  }

  Ticks by_decimal_steps(bool widen) const {
    const int power = common_power(axis_.low, axis_.high);
    const int finest = static_cast<int>(std::floor(std::log10(axis_.high - axis_.low))) - 2;
    for (int exponent = finest;; ++exponent)
      for (const int digit : {1, 2, 5}) {
        const Decimal step{digit, exponent};
        if (!may_be_tried(step)) continue;
        Ticks found = multiples(step, power, widen);
        // With one interval left there is nothing coarser worth having.
        const bool coarsest = value_of(step) > axis_.high - axis_.low;
        if (!coarsest && !suits(found)) continue;
        if (found.numbered.size() < 2 && !widen) return by_decimal_steps(true);  // one number gives no scale
        const int tenth = exponent - 1;
        add_between(found, step,
                    digit == 1   ? std::vector<Decimal>{{2, tenth}, {5, tenth}}
                    : digit == 2 ? std::vector<Decimal>{{5, tenth}, {1, exponent}}
                                 : std::vector<Decimal>{{1, exponent}});
        return found;
      }
  }

  Ticks logarithmic() const {
    const double low = std::log10(axis_.low), high = std::log10(axis_.high);
    for (const int every : {1, 2, 3, 5, 10, 20, 50, 100, 200}) {
      const bool widen = axis_.to_ticks;
      const auto from = static_cast<int>(widen ? std::floor(low / every + slack) : std::ceil(low / every - slack));
      const auto to = static_cast<int>(widen ? std::ceil(high / every - slack) : std::floor(high / every + slack));
      Ticks found = powers(from, to, every);
      if (found.numbered.size() < 2) return within_a_decade();
      if (suits(found)) {
        add_between_powers(found, every);
        return found;
      }
    }
    return within_a_decade();
  }

  Ticks powers(int from, int to, int every) const {
    Ticks found{axis_.low, axis_.high, 0, {}, {}};
    for (int i = from; i <= to; ++i)
      found.numbered.push_back({value_of({1, i * every}), fmt::format("$10^{{{}}}$", i * every)});
    if (axis_.to_ticks) {
      found.low = found.numbered.front().value;
      found.high = found.numbered.back().value;
    }
    return found;
  }

  void add_between_powers(Ticks& found, int every) const {
    const double low = std::log10(found.low), high = std::log10(found.high);
    const double decade = length_ / (high - low);
    for (int i = static_cast<int>(std::floor(low)) - 1; i <= static_cast<int>(std::ceil(high)); ++i) {
      if (every > 1 && i % every != 0 && decade >= shortest_between) add_inside(found, {1, i});
      for (int digit = 2; digit < 10 && every == 1 && decade >= shortest_decade; ++digit)
        add_inside(found, {digit, i});
    }
  }

  static void add_inside(Ticks& found, Decimal number) {
    const double value = value_of(number);
    if (value >= found.low && value <= found.high) found.between.push_back(value);
  }

  // A logarithmic axis with fewer than two powers of ten: 1, 2, 5, 10, ..., and failing that as a linear axis.
  Ticks within_a_decade() const {
    const auto first = static_cast<int>(std::floor(std::log10(axis_.low)));
    const int power = common_power(axis_.low, axis_.high);
    Ticks found{axis_.low, axis_.high, power, {}, {}};
    for (int exponent = first; exponent <= first + 2; ++exponent)
      for (const int digit : {1, 2, 5}) {
        const double value = value_of({digit, exponent});
        if (value < axis_.low * (1 - slack) || value > axis_.high * (1 + slack)) continue;
        found.numbered.push_back({value, text_of({digit, exponent - power}, language_)});
      }
    if (found.numbered.size() >= 2 && suits(found)) {
      add_between_powers(found, 1);
      std::erase_if(found.between, [&](double value) {
        return std::any_of(found.numbered.begin(), found.numbered.end(),
                           [&](const Tick& t) { return t.value == value; });
      });
      return found;
    }
    return by_decimal_steps(false);
  }

  const Axis& axis_;
  double length_;
  Along along_;
  Language language_;
};

}  // namespace

Ticks ticks(const Axis& axis, double length, Along along, Language language) {
  return Numbering(axis, length, along, language).run();
}

std::string title(const Axis& axis, int power) {
  std::string unit = axis.unit;
  if (power != 0) unit = fmt::format("$10^{{{}}}${}{}", power, unit.empty() ? "" : " ", unit);
  if (unit.empty()) return axis.quantity;
  return axis.quantity.empty() ? unit : fmt::format("{} ({})", axis.quantity, unit);
}

void require_sound(const Axis& axis) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("axis {}: {}", plain(title(axis)), why));
  };
  for (const double end : {axis.low, axis.high}) {
    if (!std::isfinite(end)) refuse(fmt::format("an end at {} gives no scale", end));
    if (std::abs(end) > 1e300) refuse(fmt::format("an end at {} is too far out", end));
  }
  if (axis.low == axis.high) refuse(fmt::format("both ends are {}", axis.low));
  if (axis.low > axis.high) refuse(fmt::format("the low end {} is above the high end {}", axis.low, axis.high));
  const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
  // Ten figures a number are more than anyone reads.
  if (axis.high - axis.low < std::max(1e-9 * largest, 1e-290))
    refuse(fmt::format("the ends {} and {} are too close to tell numbers between them apart", axis.low, axis.high));
  if (axis.scale == AxisScale::logarithmic && !(axis.low > 1e-290))
    refuse(fmt::format("a logarithmic axis has no place for {}", axis.low));
  for (const int step : axis.steps)
    if (step < 1) refuse(fmt::format("a step of {}", step));
}

AxisMap axis_map(const Axis& axis, double low, double high, double from, double to) {
  return {axis.scale, low, high, from, to};
}

}  // namespace epure::drawings
