#include "bench/sweeping/second_order_sweep.h"

#include "bench/sweeping/two_bounded.h"
#include "bench/sweeping/uniform_turns.h"
#include "geometry/numbers/climb.h"
#include "geometry/numbers/threads.h"

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <cmath>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>
#include <vector>

namespace epure::geometry {

namespace {

// The processor as the enclosures need it: rounding upwards; subnormals kept (a caller's flush-to-zero would make a
// bound 0 that has to be a little more); nothing trapped. Everything of the caller comes back at the end.
class Processor {
 public:
  Processor() {
    std::fegetenv(&outer_);
    std::fesetenv(FE_DFL_ENV);
    rounding_.emplace();
  }
  ~Processor() {
    rounding_.reset();
    std::fesetenv(&outer_);
  }
  Processor(const Processor&) = delete;
  Processor& operator=(const Processor&) = delete;

  // The flags for a NaN that was made and for an overflow.
  void put_flags_down() const { std::feclearexcept(watched); }
  bool is_any_flag_raised() const { return std::fetestexcept(watched) != 0; }

 private:
  static constexpr int watched = FE_INVALID | FE_OVERFLOW;
  std::fenv_t outer_;
  std::optional<Arithmetic<Bounded>> rounding_;
};

Point<Bounded> lane(const Point<TwoBounded>& P, int i) { return {P.x.lane(i), P.y.lane(i)}; }

void keep_lane(Swept& result, const SecondOrder<TwoBounded>& found, int i) {
  SecondOrder<Bounded>& at = result.at;
  at.A = lane(found.A, i), at.B = lane(found.B, i), at.C = lane(found.C, i);
  at.omega_3 = found.omega_3.lane(i), at.alpha_3 = found.alpha_3.lane(i);
  at.driven_velocity = found.driven_velocity.lane(i), at.driven_acceleration = found.driven_acceleration.lane(i);
  at.P0 = lane(found.P0, i), at.K = lane(found.K, i), at.centre = lane(found.centre, i);
  result.position = result.motion = result.P0 = result.K = result.centre = Truth::yes;
}

// What is not known.
Swept unknown() {
  const Bounded any = Bounded::largest();
  const Point<Bounded> anywhere{any, any};
  const Truth open = Truth::undecided;
  return {
      {anywhere, anywhere, anywhere, any, any, any, any, anywhere, anywhere, anywhere}, open, open, open, open, open};
}
Swept not_closing() {
  Swept result = unknown();
  for (Truth* fact : {&result.position, &result.motion, &result.P0, &result.K, &result.centre}) *fact = Truth::no;
  return result;
}
bool is_settled(const Swept& result) {
  for (const Truth fact : {result.position, result.motion, result.P0, result.K, result.centre})
    if (fact == Truth::undecided) return false;
  return true;
}

// What a rung of the ladder lets stand: of Bounded an enclosure with two ends; of Deep every one, since a value
// beyond the doubles has no other. Exact is asked only for what does not exist.
Bounded enclosed(const Bounded& x) {
  if (!std::isfinite(x.inf()) || !std::isfinite(x.sup()))
    throw Undecided("an enclosure without bounds", "un intervallo senza limiti");
  return x;
}
Bounded enclosed(const Deep& x) { return to_bounded(x); }
Bounded enclosed(const Exact&) {
  throw Undecided("it exists, but exact numbers are not enclosed here",
                  "esiste, ma qui i numeri esatti non si racchiudono in intervalli");
}
template <class T>
Point<Bounded> enclosed(const Point<T>& P) {
  return {enclosed(P.x), enclosed(P.y)};
}
template <class T>
Point<Bounded> enclosed(const ProjectivePoint<T>& P) {
  if (sign(P.w) == Sign::zero) throw Impossible("at infinity, or not determined", "all'infinito, o non determinato");
  return enclosed(finite(P));
}

// A fact stays open when the computation cannot tell.
template <class Computation>
void settle(Truth& fact, const Computation& computation) {
  try {
    computation();
    fact = Truth::yes;
  } catch (const Impossible&) {
    fact = Truth::no;
  } catch (const Undecided&) {
  }
}

// One rung: everything that this number can tell of one position.
template <class T, class Driven>
void analyse(const Driven& driven, const Vector<T>& crank, Swept& result) {
  const typename Driven::template On<T> of(driven);
  const auto position = Reading<decltype(of.position(crank))>::from([&] { return of.position(crank); });
  if (position.is_absent()) result = not_closing();
  if (!position.value()) return;
  const auto& at = *position.value();
  const Point<T> C = of.C(at);
  SecondOrder<Bounded>& found = result.at;
  settle(result.position, [&] { found.A = enclosed(at.A), found.B = enclosed(at.B), found.C = enclosed(C); });
  settle(result.P0, [&] { found.P0 = enclosed(at.pole()); });

  const auto rates = Reading<CouplerRates<T>>::from([&] { return of.rates(at); });
  if (rates.is_absent()) result.motion = result.K = result.centre = Truth::no;
  if (!rates.value()) return;
  const CouplerRates<T>& motion = *rates.value();
  settle(result.motion, [&] {
    found.omega_3 = enclosed(motion.coupler.omega), found.alpha_3 = enclosed(motion.coupler.alpha);
    found.driven_velocity = enclosed(motion.driven_velocity);
    found.driven_acceleration = enclosed(motion.driven_acceleration);
  });
  settle(result.K, [&] { found.K = enclosed(motion.coupler.acceleration_pole()); });
  settle(result.centre, [&] { found.centre = enclosed(motion.coupler.centre_of_curvature(C)); });
}

template <class Driven>
class Sweep {
 public:
  Sweep(const Driven& driven, std::span<Swept> results)
      : driven_(driven), results_(results), turns_(results.size()) {}

  SweepCount run(unsigned threads) {
    in_threads(std::min<std::size_t>(threads, turns_.rows()), [this] { work(); });
    if (failure_) std::rethrow_exception(failure_);
    return count_;
  }

 private:
  using Linkage = typename Driven::template On<TwoBounded>;

  // Takes rows until none is left.
  void work() {
    SweepCount count;
    std::exception_ptr failure;
    try {
      const Processor processor;
      std::optional<Linkage> linkage;
      read_givens(linkage);
      if (processor.is_any_flag_raised()) linkage.reset();
      std::vector<std::size_t> left;
      for (std::size_t row = next_row_++; row < turns_.rows(); row = next_row_++)
        take(row, linkage, processor, left, count);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    count_ += count;
    if (failure) failure_ = failure;
  }

  std::size_t first_of(std::size_t row) const { return std::min(row * turns_.width(), results_.size()); }

  // Leaves the linkage out when its givens cannot be decided two at a time (a plate that barely closes).
  [[gnu::noinline]] void read_givens(std::optional<Linkage>& linkage) const {
    try {
      linkage.emplace(driven_);
    } catch (const Undecided&) {
    }
  }

  void take(std::size_t row, const std::optional<Linkage>& linkage, const Processor& processor,
            std::vector<std::size_t>& left, SweepCount& count) const {
    const std::size_t first = first_of(row), size = first_of(row + 1) - first;
    left.clear();
    processor.put_flags_down();
    if (linkage) analyse_row(*linkage, row, left);
    if (!linkage || processor.is_any_flag_raised()) {
      left.resize(size);
      std::iota(left.begin(), left.end(), first);
    }
    count.side_by_side += size - left.size();
    for (const std::size_t k : left) hand_over(k, count);
  }

  void analyse_row(const Linkage& linkage, std::size_t row, std::vector<std::size_t>& left) const {
    const std::size_t end = first_of(row + 1);
    std::size_t pair = 0;
    for (std::size_t k = first_of(row); k < end; k += 2, ++pair) {
      Swept beyond_the_end;
      try {
        analyse_pair(linkage, turns_, row, pair, results_[k], k + 1 < end ? results_[k + 1] : beyond_the_end);
      } catch (const Impossible&) {
        give_up(linkage, pair, k, end, left);
      } catch (const Undecided&) {
        leave(k, end, left);
      }
    }
  }

  // noinline, here and wherever is worked with intervals: the compiler knows neither of the rounding mode nor of the
  // flags and may move arithmetic past where they are set or asked, but not out of a function that it does not inline
  // and that writes to memory others see.
  [[EPURE_ALL_INLINED]] static void analyse_pair(const Linkage& linkage, const UniformTurns& turns, std::size_t row,
                                                 std::size_t pair, Swept& first, Swept& second) {
    const auto [cosine, sine] = turns(row, pair);
    const SecondOrder<TwoBounded> found = second_order(linkage, Vector<TwoBounded>{cosine, sine});
    keep_lane(first, found, 0);
    keep_lane(second, found, 1);
  }

  static void leave(std::size_t k, std::size_t end, std::vector<std::size_t>& left) {
    for (std::size_t i = k; i < std::min(k + 2, end); ++i) left.push_back(i);
  }
  // Impossible is proved for both: where it is the closure, nothing is left to find out.
  [[gnu::noinline]] void give_up(const Linkage& linkage, std::size_t pair, std::size_t k, std::size_t end,
                                 std::vector<std::size_t>& left) const {
    const auto [cosine, sine] = turns_(k / turns_.width(), pair);
    const Vector<TwoBounded> crank{cosine, sine};
    Truth closes = Truth::undecided;
    settle(closes, [&] { linkage.position(crank); });
    if (closes != Truth::no) return leave(k, end, left);
    for (std::size_t i = k; i < std::min(k + 2, end); ++i) results_[i] = not_closing();
  }

  // One position, from number to number until all is settled.
  [[gnu::noinline]] void hand_over(std::size_t k, SweepCount& count) const {
    const Turn turn{Rational(k, results_.size())};
    Swept& result = results_[k] = unknown();
    if (is_settled_by<Bounded>(turn, result)) return void(++count.bounded);
    for (const long bits : {128L, 256L}) {
      const Arithmetic<Deep> precision(bits);
      if (is_settled_by<Deep>(turn, result)) return void(++count.deep);
    }
    const bool is_in_the_tower = Rational(24 * turn.fraction).denominator() == 1;
    const Arithmetic<Exact> tower;
    if (is_in_the_tower && is_settled_by<Exact>(turn, result)) return void(++count.exact);
    ++count.open;
  }

  template <class T>
  bool is_settled_by(const Turn& turn, Swept& result) const {
    try {
      analyse(driven_, Vector<T>{cosine<T>(turn), sine<T>(turn)}, result);
    } catch (const Undecided&) {
    } catch (const LeavesTheTower&) {
    }
    return is_settled(result);
  }

  const Driven& driven_;
  const std::span<Swept> results_;
  const UniformTurns turns_;
  std::atomic<std::size_t> next_row_ = 0;
  std::mutex mutex_;
  SweepCount count_;
  std::exception_ptr failure_;
};

template <class Driven>
SweepCount sweep(const Driven& driven, std::span<Swept> results, unsigned threads) {
  if (results.empty()) return {};
  return Sweep<Driven>(driven, results).run(threads > 0 ? threads : std::thread::hardware_concurrency());
}

}  // namespace

SweepCount sweep_second_order(const DrivenFourBar& driven, std::span<Swept> results, unsigned threads) {
  return sweep(driven, results, threads);
}
SweepCount sweep_second_order(const DrivenSliderCrank& driven, std::span<Swept> results, unsigned threads) {
  return sweep(driven, results, threads);
}

}  // namespace epure::geometry
