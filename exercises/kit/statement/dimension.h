// What a unit measures, as powers of length, mass and time: which products and quotients of quantities make sense.
#pragma once

#include <optional>
#include <string>

namespace epure {

// Angles and turns have none: rad/s, rpm and 1/s are one over time.
struct Dimension {
  int length = 0, mass = 0, time = 0;
  bool operator==(const Dimension&) const = default;
};

inline Dimension operator+(const Dimension& a, const Dimension& b) {
  return {a.length + b.length, a.mass + b.mass, a.time + b.time};
}
inline Dimension operator*(int power, const Dimension& a) {
  return {power * a.length, power * a.mass, power * a.time};
}
inline Dimension operator-(const Dimension& a, const Dimension& b) { return a + -1 * b; }

// Of a unit that givens take ("cm/s", "kgf m"), or of a product of SI units as quantities have it ("N*m*s",
// "rad^2/s^2"). None for what is neither.
std::optional<Dimension> dimension_of(const std::string& unit);

}  // namespace epure
