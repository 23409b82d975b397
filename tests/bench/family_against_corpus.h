// A family held against its hard corpus with every number.
//
//   Bounded          contains the reference, or says why it does not know
//   Deep, 1024 bits  contains it and is narrower than its 120 digits: agreement means agreement in all of them
//   Exact, Calcium   (the second where the first has no such field) contains the reference to 120 digits and proves
//                    what is zero or absent, or says why it cannot
//   Fast             gives a number that is not NaN, or says why it has none
//   climb            the double nearest to the reference, from whichever number
// Where nothing exists, no number may report anything.
#pragma once

#include "bench/family.h"
#include "tests/support/catch.h"
#include "tests/support/overlaps.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace epure::tests {

using namespace geometry;
using bench::CorpusCase;

inline constexpr long deep_bits = 1024;  // 308 digits: a case loses at most 180

// Half a unit of the last of 120 digits.
inline Rational reference_error(const Rational& reference) { return abs(reference) * bench::exact_decimal("5e-120"); }

template <class Enclosing>
bool may_be(const Enclosing& x, const Rational& reference) {
  return overlaps(x, reference, reference_error(reference));
}

// The radius is less than 1e-118 of the value; of a reference that is zero, less than 1e-118 itself.
inline bool is_narrow(const Deep& x, const Rational& reference) {
  arb_t radius;
  arb_init(radius);
  arb_get_rad_arb(radius, x.ball());
  const Deep r = Deep::from_ball(radius);
  arb_clear(radius);
  const Rational size = reference == 0 ? Rational(1) : Rational(abs(reference));
  return sign(from_rational<Deep>(size * bench::exact_decimal("1e-118")) - r) == Sign::positive;
}

// What a number says of a case: its readings, or the sentence with which it gave up.
template <class T>
struct Said {
  std::optional<bench::Readings<T>> readings = {};
  bool is_impossible = false;
  std::string reason = {};
};

template <class Family, class T>
Said<T> said(const typename Family::Givens& of) {
  try {
    return {.readings = bench::readings<Family, T>(of)};
  } catch (const Impossible& proved) {
    return {.is_impossible = true, .reason = proved.what()};
  } catch (const Undecided& open) {
    return {.reason = open.what()};
  }
}

inline bool holds(Fast x, const Rational&) { return !std::isnan(x); }
inline bool holds(const Bounded& x, const Rational& reference) { return may_be(enclosure(x), reference); }
inline bool holds(const Deep& x, const Rational& reference) {
  return may_be(x, reference) && is_narrow(x, reference);
}
template <class T>
requires std::same_as<T, Exact> || std::same_as<T, Calcium>
bool holds(const T& x, const Rational& reference) {
  if (reference == 0) return sign(x) == Sign::zero;
  const Arithmetic<Deep> scope(deep_bits);
  return may_be(to_deep(x), reference);
}

template <class T>
constexpr bool proves = std::same_as<T, Exact> || std::same_as<T, Calcium>;

template <class T>
void check_reading(const Reading<T>& reading, const std::string& reference) {
  REQUIRE(!reference.empty());
  if (!reading.value()) {
    INFO("reason: " << reading.reason().english);
    CHECK(!reading.reason().english.empty());
    // Fast takes a computed zero for a proof.
    if constexpr (!std::same_as<T, Fast>) CHECK((!reading.is_absent() || reference == "absent"));
    // Deep knows every value, and Exact leaves nothing open.
    if constexpr (std::same_as<T, Deep>) CHECK(reference == "absent");
    if constexpr (std::same_as<T, Exact>) CHECK(reading.is_absent());
    return;
  }
  // Fast divides by noise where others prove a zero.
  if constexpr (!std::same_as<T, Fast>) CHECK(reference != "absent");
  if (reference != "absent") CHECK(holds(*reading.value(), bench::exact_decimal(reference)));
}

template <class Family, class T>
void check_number(const CorpusCase& c, const typename Family::Givens& of) {
  const Said<T> answer = said<Family, T>(of);
  if (c.reference(Family::name) == "impossible") {
    if constexpr (!std::same_as<T, Fast>) CHECK(!answer.readings);
    if constexpr (proves<T>) CHECK((answer.is_impossible || std::same_as<T, Calcium>));
    return;
  }
  INFO("reason: " << answer.reason);
  if constexpr (std::same_as<T, Exact>) REQUIRE(answer.readings);
  if constexpr (!std::same_as<T, Fast>) CHECK(!answer.is_impossible);
  if (!answer.readings) return;
  for (std::size_t i = 0; i < answer.readings->values.size(); ++i) {
    CAPTURE(answer.readings->names[i]);
    check_reading(answer.readings->values[i], c.reference(answer.readings->names[i]));
  }
}

// The whole climb: each result is certain, or proved absent.
template <class Family>
void check_climb(const CorpusCase& c, const typename Family::Givens& of) {
  if (c.reference(Family::name) == "impossible") {
    CHECK_THROWS(climb(bench::scene_of<Family>(of)));
    return;
  }
  const std::vector<Settled> results = climb(bench::scene_of<Family>(of));
  std::vector<std::string> names;
  {
    const Arithmetic<Deep> scope(deep_bits);
    if (const auto deep = said<Family, Deep>(of); deep.readings) names = deep.readings->names;
  }
  for (std::size_t i = 0; i < results.size() && i < names.size(); ++i) {
    CAPTURE(names[i], results[i].rung, results[i].reason.english);
    const std::string reference = c.reference(names[i]);
    if (reference == "absent") {
      CHECK(results[i].kind == Settled::Kind::absent);
    } else {
      CHECK(results[i].kind == Settled::Kind::certain);
      CHECK(Rational(results[i].enclosure.value) == Rational(from_rational<Fast>(bench::exact_decimal(reference))));
    }
  }
}

template <class Family>
void hold_against_corpus() {
  const std::vector<CorpusCase> cases = bench::read_corpus(EPURE_HARD_CORPUS "/" + std::string(Family::corpus));
  for (const CorpusCase& c : cases) {
    CAPTURE(c.name, c.why);
    const auto of = Family::givens(c);
    {
      INFO("Fast");
      const Arithmetic<Fast> scope;
      check_number<Family, Fast>(c, of);
    }
    {
      INFO("Bounded");
      const Arithmetic<Bounded> scope;
      check_number<Family, Bounded>(c, of);
    }
    {
      INFO("Deep");
      const Arithmetic<Deep> scope(deep_bits);
      check_number<Family, Deep>(c, of);
    }
    try {
      INFO("Exact");
      const Arithmetic<Exact> scope;
      check_number<Family, Exact>(c, of);
    } catch (const LeavesTheTower&) {
      INFO("Calcium");
      const Arithmetic<Calcium> scope;
      check_number<Family, Calcium>(c, of);
    }
    {
      INFO("climb");
      check_climb<Family>(c, of);
    }
    for (const bench::Question& question : Family::questions(of)) {
      CAPTURE(question.name);
      CHECK(question.ask().word == c.reference(question.name));
    }
  }
}

}  // namespace epure::tests
