// How long something takes.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace epure::bench {

// The compiler must have computed `value`.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

// Seconds of the fastest of `times` calls.
template <class Call>
double least_seconds(const Call& call, int times) {
  using Clock = std::chrono::steady_clock;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < times; ++i) {
    const auto start = Clock::now();
    call();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return least;
}

// Seconds that one call takes: the best of at least three rounds, each of enough calls for the clock, until `budget`
// seconds are spent.
template <class Call>
double seconds_per_call(const Call& call, double budget) {
  using Clock = std::chrono::steady_clock;
  const auto round = [&](long calls) {
    const auto start = Clock::now();
    for (long i = 0; i < calls; ++i) call();
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  double spent = round(1);
  double best = spent;
  const double enough = std::min(0.01, budget / 5);
  const long calls = std::clamp(static_cast<long>(enough / std::max(best, 1e-9)), 1L, 1000000L);
  for (int rounds = 0; rounds < 3 || spent < budget; ++rounds) {
    if (rounds >= 1 && spent > 3 * budget) break;  // a call that takes longer than all that is allowed
    const double taken = round(calls);
    best = std::min(best, taken / static_cast<double>(calls));
    spent += taken;
  }
  return best;
}

}  // namespace epure::bench
