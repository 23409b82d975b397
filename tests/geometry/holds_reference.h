// A ball held against one of the 40 printed digits of a corpus.
#pragma once

#include "tests/geometry/reference.h"
#include "tests/support/catch.h"

namespace epure::tests {

inline void holds(const CorpusCase& c, const std::string& name, const geometry::Deep& found) {
  const std::string text = c.reference(name);
  CAPTURE(c.name, name, text);
  REQUIRE_FALSE(text.empty());
  const geometry::Rational expected = exact_decimal(text);
  CHECK(overlaps(found, expected));
  if (expected != 0) CHECK(narrow(found));
}

}  // namespace epure::tests
