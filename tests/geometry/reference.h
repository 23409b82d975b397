// A number held against a reference of the corpus, which is printed with 40 digits.
#pragma once

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"
#include "tests/support/corpus.h"
#include "tests/support/overlaps.h"

#include <string>

namespace epure::tests {

inline const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/slider_crank.txt");
  return cases;
}

inline bool closes(const CorpusCase& c) { return c.reference("closure_gap").empty(); }
inline bool is_value(const std::string& reference) { return reference != "infinite" && reference != "undefined"; }

// A printed reference of 40 digits is off by at most half a unit of its last digit.
inline geometry::Rational reference_error(const geometry::Rational& reference) {
  return abs(reference) * exact_decimal("5e-40");
}

template <class Enclosing>
bool overlaps(const Enclosing& x, const geometry::Rational& reference) {
  return overlaps(x, reference, reference_error(reference));
}

// Narrower than the 40 digits of the reference, so that agreement means agreement in all of them.
inline bool narrow(const geometry::Deep& x) {
  using namespace geometry;
  const Deep radius_times = from_rational<Deep>(exact_decimal("1e38"));
  arb_t radius;
  arb_init(radius);
  arb_get_rad_arb(radius, x.ball());
  const Deep r = Deep::from_ball(radius);
  arb_clear(radius);
  return sign(r) == Sign::zero || sign(root(square(x)) - radius_times * r) == Sign::positive;
}

}  // namespace epure::tests
