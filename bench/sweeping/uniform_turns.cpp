#include "bench/sweeping/uniform_turns.h"

#include "geometry/numbers/deep.h"
#include "geometry/numbers/enclosure.h"

#include <cassert>
#include <cmath>

namespace epure::geometry {

namespace {

// The powers of one turn lose a bit or so each time they double: with 128 bits 60 are left beyond a double's 53 even
// after a thousand of them, and more than enough after a million.
constexpr long bits_of_a_turn = 128;

struct DeepDirection {
  Deep cosine, sine;

  DeepDirection operator*(const DeepDirection& by) const {
    return {cosine * by.cosine - sine * by.sine, sine * by.cosine + cosine * by.sine};
  }
};

std::size_t even_root(std::size_t n) {
  const auto half = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)) / 2);
  return 2 * (half + 1);
}

}  // namespace

UniformTurns::UniformTurns(std::size_t n) {
  assert(n >= 1 && "a sweep of no positions");
  const Arithmetic<Bounded> rounding;
  const Arithmetic<Deep> precision(bits_of_a_turn);
  const std::size_t width = even_root(n);
  const Turn turn{Rational(std::size_t{1}, n)};
  const DeepDirection step{cosine<Deep>(turn), sine<Deep>(turn)};

  DeepDirection at{Deep(1), Deep(0)};
  for (std::size_t i = 0; i < width; i += 2) {
    const DeepDirection next = at * step;
    pairs_.push_back(
        {{to_bounded(at.cosine), to_bounded(next.cosine)}, {to_bounded(at.sine), to_bounded(next.sine)}});
    at = next * step;
  }
  DeepDirection row{Deep(1), Deep(0)};
  for (std::size_t k = 0; k < n; k += width, row = row * at)
    rows_.push_back({TwoBounded(to_bounded(row.cosine)), TwoBounded(to_bounded(row.sine))});
}

}  // namespace epure::geometry
