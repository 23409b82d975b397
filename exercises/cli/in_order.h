// A long row of independent jobs on all processors, whose results are wanted in order.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "geometry/numbers/threads.h"

namespace epure {

// Whoever has made the result that is to be taken next takes it, and those behind it that wait already.
template <class Result, class Make, class Take>
class JobsInOrder {
 public:
  JobsInOrder(std::uint64_t count, std::size_t window, const Make& make, const Take& take)
      : make_(make), take_(take), end_(count), made_(window) {}

  // In as many threads as there are. Does not throw.
  void work() {
    std::unique_lock lock(mutex_);
    while (const auto mine = next(lock)) {
      lock.unlock();
      Made made = outcome_of(*mine);
      lock.lock();
      place(*mine).emplace(std::move(made));
      if (!is_taking_) take_what_waits(lock);
    }
  }

  // Once all threads have ended.
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  struct Made {
    std::optional<Result> result;
    std::exception_ptr thrown;
  };

  std::optional<Made>& place(std::uint64_t job) { return made_[job % made_.size()]; }

  std::optional<std::uint64_t> next(std::unique_lock<std::mutex>& lock) {
    room_.wait(lock, [&] { return next_ >= end_ || next_ < taken_ + made_.size(); });
    return next_ < end_ ? std::optional(next_++) : std::nullopt;
  }

  Made outcome_of(std::uint64_t job) const {
    try {
      return {make_(job), {}};
    } catch (...) {
      return {{}, std::current_exception()};
    }
  }

  void take_what_waits(std::unique_lock<std::mutex>& lock) {
    is_taking_ = true;
    while (taken_ < end_ && place(taken_)) {
      const Made made = *std::exchange(place(taken_), std::nullopt);
      lock.unlock();
      const bool goes_on = is_taken(made);
      lock.lock();
      ++taken_;
      if (!goes_on) end_ = taken_;
      room_.notify_all();
    }
    is_taking_ = false;
  }

  bool is_taken(const Made& made) {
    try {
      if (made.thrown) std::rethrow_exception(made.thrown);
      return take_(*made.result);
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
  }

  const Make& make_;
  const Take& take_;
  std::mutex mutex_;
  std::condition_variable room_;
  std::uint64_t next_ = 0, taken_ = 0, end_;
  std::vector<std::optional<Made>> made_;
  bool is_taking_ = false;
  std::exception_ptr thrown_;  // by the one that takes
};

// Calls take(make(0)), take(make(1)), ..., take(make(count - 1)): what is made by several threads at a time is taken
// by one at a time, in this order, soon after it is made. No more results wait to be taken than a few for each
// processor. When take returns false no more is made. When a call throws, what comes before it is taken, and the
// exception comes through.
template <class Make, class Take>
void in_order(std::uint64_t count, const Make& make, const Take& take) {
  constexpr std::size_t waiting_for_each_processor = 8;
  const std::size_t threads = std::max(std::thread::hardware_concurrency(), 1U);
  JobsInOrder<decltype(make(count)), Make, Take> jobs(count, threads * waiting_for_each_processor, make, take);
  geometry::in_threads(threads, [&] { jobs.work(); });
  jobs.rethrow();
}

}  // namespace epure
