// A number in a sentence for the user: six significant digits, with a point in English and a comma in Italian,
// whatever the locale. Not for reporting: reported numbers are enclosures.
#pragma once

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

#include <array>
#include <charconv>

namespace epure::geometry::analytic {

inline Words digits(Fast x) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, 6);
  return decimal({text.data(), end.ptr});
}

inline Words digits(const Bounded& x) { return digits(enclosure(x).value); }
inline Words digits(const Deep& x) { return digits(enclosure(x).value); }

// Exact, Generic and Calcium have no double of their own: their ball at 64 bits has.
template <class T>
requires requires(const T x) { to_deep(x); }
Words digits(const T& x) {
  const Arithmetic<Deep> scope(64);
  return digits(to_deep(x));
}

// Of a series in a parameter, its value.
template <class T>
requires requires(const T x) { x.c[0]; }
Words digits(const T& x) { return digits(x.c[0]); }

}  // namespace epure::geometry::analytic
