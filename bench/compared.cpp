#include "bench/measure_family.h"

namespace epure::bench {
namespace {

constexpr double of_references = 1e-109;  // relative error of references, which have 110 digits or more

// The largest double in the ball, which is not negative.
double upper(const Deep& x) { return std::max(0.0, enclosure(x).upper); }

Deep relative(const Deep& x, const Rational& reference) {
  const Deep difference = x - from_rational<Deep>(reference);
  const Deep size = from_rational<Deep>(reference < 0 ? Rational(-reference) : reference);
  return quotient(sign(difference) == Sign::negative ? -difference : difference, size);
}

// Of a point that is known exactly.
double error_of(const Deep& point, const Rational& reference) {
  const Arithmetic<Deep> scope(comparing_bits);
  return upper(relative(point, reference));
}

}  // namespace

Compared compared(Fast x, const Rational& reference) {
  if (!std::isfinite(x)) return {x, INFINITY, {}};
  return {x, error_of(Deep::from_double(x), reference), {}};
}

Compared compared(const Bounded& x, const Rational& reference) {
  if (!std::isfinite(x.inf()) || !std::isfinite(x.sup())) return {0, INFINITY, INFINITY};
  const Arithmetic<Deep> scope(comparing_bits);
  const Deep low = Deep::from_double(x.inf()), high = Deep::from_double(x.sup());
  const Deep half = from_rational<Deep>(Rational(1, 2));
  const Deep middle = half * (low + high);
  const Deep width =
      quotient(half * (high - low), from_rational<Deep>(reference < 0 ? Rational(-reference) : reference));
  return {enclosure(middle).value, upper(relative(middle, reference)), upper(width)};
}

Compared compared(const Deep& x, const Rational& reference) {
  const Arithmetic<Deep> scope(comparing_bits);
  const Deep middle = midpoint(x);
  const Deep off = x - middle;
  const Deep width = quotient(off, from_rational<Deep>(reference));
  return {enclosure(middle).value, upper(relative(middle, reference)), std::max(upper(width), upper(-width))};
}

// The references are rounded; an exact value that agrees with all their digits is not off.
Compared compared(const Exact& x, const Rational& reference) {
  const Arithmetic<Deep> scope(comparing_bits);
  const double error = compared(to_deep(x), reference).error;
  return {enclosure(to_deep(x)).value, error < of_references ? 0 : error, 0.0};
}

void count(const Decided& decided, DecisionResult& result) {
  ++result.asked;
  if (decided.word == "undecided")
    ++result.undecided;
  else if (decided.rung == "Bounded")
    ++result.by_bounded;
  else if (decided.rung.starts_with("Deep"))
    ++result.by_deep;
  else
    ++result.otherwise;
}

FamilyResult Account::result() const {
  FamilyResult result = result_;
  if (result.results > 0) result.handed_over = static_cast<double>(handed_) / static_cast<double>(result.results);
  std::vector<double> errors = errors_;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  if (errors.empty()) return result;
  std::nth_element(errors.begin(), middle, errors.end());
  result.median_relative_error = *middle;
  return result;
}

bool Account::note(const std::string& what, const Compared& x, const Rational& truth, bool is_fast) {
  constexpr double rounded = 1 + 1e-15;  // error and bound are each rounded upwards
  if (x.bound && x.error > *x.bound * rounded + of_references) ++result_.wrong;
  const double limit = result_.number == "deep" ? deep_asks : 1;
  if (!is_fast && !(x.bound && *x.bound <= limit)) return false;
  if (!std::isfinite(x.error)) {
    ++result_.wrong;
    return is_fast;
  }
  errors_.push_back(x.error);
  if (x.error >= result_.max_relative_error) {
    result_.max_relative_error = x.error;
    result_.worst = {what, x.value, from_rational<Fast>(truth)};
  }
  if (x.bound) result_.max_relative_bound = std::max(result_.max_relative_bound.value_or(0), *x.bound);
  return true;
}

}  // namespace epure::bench
