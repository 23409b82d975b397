// Ten thousand random constructions, on which the tower of fields and the Calcium library must agree. They share no
// code: the tower reads zero off its coefficients, Calcium works with ideals of relations between algebraic numbers.
//
// EPURE_SEED=n repeats a run or tries another.
#include "geometry/numbers/numbers.h"
#include "tests/support/catch.h"

#include <cstdio>
#include <cstdlib>
#include <random>

using namespace epure::geometry;

namespace {

using Random = std::mt19937_64;

int up_to(Random& random, std::size_t n) { return static_cast<int>(random() % n); }

template <class T>
T small_rational(Random& random) {
  return from_rational<T>(Rational(up_to(random, 19) - 9, 1 + up_to(random, 9)));
}

// A step from two numbers to a third. Divisors and radicands are positive by their form, so that no step needs a
// sign.
template <class T>
T step(Random& random, const T& x, const T& y) {
  switch (random() % 7) {
    case 0:
      return x + y;
    case 1:
      return x - y;
    case 2:
      return x * y;
    case 3:
      return x / T(square(y) + 1);
    case 4:
      return root(T(square(x) + square(y)));  // the length of a vector
    case 5:
      return root(T(square(x) + 1));
    default:
      return T(x + y) / 2;
  }
}

template <class T>
T construct(Random& random) {
  std::vector<T> numbers{small_rational<T>(random), small_rational<T>(random),
                         cosine<T>(Turn{Rational(up_to(random, 12), 12)}),
                         sine<T>(Turn{Rational(up_to(random, 8), 8)})};
  for (int steps = 1 + up_to(random, 5); steps > 0; --steps) {
    const T& x = numbers[random() % numbers.size()];
    const T& y = numbers[random() % numbers.size()];
    numbers.push_back(step(random, x, y));
  }
  return numbers.back();
}

// Two different ways to one number: the difference is zero, whatever x and y are.
template <class T>
T identity(Random& random, const T& x, const T& y) {
  const T a = square(x) + 1, b = square(y) + 2;
  switch (random() % 5) {
    case 0:
      return root(a) * root(b) - root(T(a * b));
    case 1:
      return root(T(a + b + 2 * root(T(a * b)))) - root(a) - root(b);
    case 2:
      return T(x + y) / a - x / a - y / a;
    case 3:
      return root(T(square(x) * b)) * root(T(square(x) * b)) - square(x) * b;
    default:
      return (root(b) - x) * (root(b) + x) - (b - square(x));
  }
}

enum class Shape { free, zero, nearly_zero };

template <class T>
T question(std::uint64_t seed, Shape shape) {
  Random random(seed);
  const T x = construct<T>(random);
  if (shape == Shape::free) return x;
  const T y = small_rational<T>(random);
  const T zero = identity(random, x, y);
  if (shape == Shape::zero) return zero;
  T tiny = from_rational<T>(Rational(random() % 2 ? 1 : -1, 1000000));
  for (int i = 0; i < 3; ++i) tiny = tiny * square(from_rational<T>(Rational(1, 1000000)));  // ±1e-42
  return zero + tiny;
}

struct Tally {
  int agreed = 0, left_the_tower = 0, calcium_undecided = 0, zeros = 0;
};

void hold_against_each_other(std::uint64_t seed, Shape shape, Tally& tally) {
  Sign by_calcium = Sign::undecided;
  {
    const Arithmetic<Calcium> scope;
    by_calcium = sign(question<Calcium>(seed, shape));
  }
  if (by_calcium == Sign::undecided) ++tally.calcium_undecided;
  if (shape == Shape::zero) CHECK((by_calcium == Sign::zero || by_calcium == Sign::undecided));
  if (shape == Shape::nearly_zero) CHECK(by_calcium != Sign::zero);
  try {
    const Arithmetic<Exact> scope;
    const Sign by_tower = sign(question<Exact>(seed, shape));
    if (shape == Shape::zero) CHECK(by_tower == Sign::zero);
    if (by_calcium == Sign::undecided) return;
    CHECK(by_tower == by_calcium);
    ++tally.agreed;
    if (by_tower == Sign::zero) ++tally.zeros;
  } catch (const LeavesTheTower&) {
    ++tally.left_the_tower;
  }
}

}  // namespace

TEST_CASE("Tower and Calcium agree on ten thousand random constructions", "[duel]") {
  const char* chosen = std::getenv("EPURE_SEED");
  const std::uint64_t first = chosen ? std::strtoull(chosen, nullptr, 10) : 20240501;
  Tally tally;
  for (int i = 0; i < 10000; ++i) {
    const std::uint64_t seed = first * 1000003 + static_cast<std::uint64_t>(i);
    const Shape shape = static_cast<Shape>(i % 3);
    CAPTURE(first, i, seed);
    hold_against_each_other(seed, shape, tally);
  }
  std::printf("duel with seed %llu: %d agreed (%d of them zero), %d left the tower, %d undecided by Calcium\n",
              static_cast<unsigned long long>(first), tally.agreed, tally.zeros, tally.left_the_tower,
              tally.calcium_undecided);
  CHECK(tally.agreed > 8000);
  CHECK(tally.zeros > 2500);
}
