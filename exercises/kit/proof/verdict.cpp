#include "exercises/kit/proof/verdict.h"

#include <cmath>

#include "exercises/kit/statement/decimal.h"

namespace epure {
namespace {

Verdict verdict_on(const Decimal& printed, double reading, double value) {
  const Rational apart = CGAL::abs(excess(printed, value));
  if (apart <= printed.half_unit) return Verdict::rounding;
  return apart <= printed.half_unit + Rational(reading) ? Verdict::reading : Verdict::disagrees;
}

bool rounds_to(const Decimal& printed, double value) {
  return std::isfinite(value) && CGAL::abs(excess(printed, value)) <= printed.half_unit;
}

}  // namespace

std::string name(Verdict verdict) {
  switch (verdict) {
    case Verdict::rounding:
      return "rounding";
    case Verdict::reading:
      return "reading";
    case Verdict::disagrees:
      break;
  }
  return "disagrees";
}

bool has_value(const geometry::Settled& quantity) {
  using Kind = geometry::Settled::Kind;
  return quantity.kind == Kind::certain || quantity.kind == Kind::enclosed || quantity.kind == Kind::unbounded;
}

PrintedVerdict judge(const Printed& printed, const geometry::Settled& quantity) {
  PrintedVerdict result{.text = printed.text, .route = printed.route};
  const Decimal number = read_printed(printed.text);
  if (has_value(quantity)) {
    result.difference_percent = percent(excess(number, quantity.enclosure.value), quantity.enclosure.value);
    result.verdict = verdict_on(number, printed.reading, quantity.enclosure.value);
  }
  if (result.verdict != Verdict::disagrees || !printed.explanation) return result;
  result.explanation_holds = rounds_to(number, printed.explanation->evaluate());
  if (result.explanation_holds) result.explanation = printed.explanation->sentence;
  return result;
}

}  // namespace epure
