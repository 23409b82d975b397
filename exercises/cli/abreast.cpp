#include "exercises/cli/abreast.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

#include "drawings/stopwatch.h"
#include "geometry/numbers/threads.h"

namespace epure {
namespace {

// Jobs are some milliseconds long, and a thread costs five: the fonts are opened in each. The stopwatch counts the
// work of one thread.
std::size_t threads(std::size_t jobs) {
  constexpr std::size_t worth_a_thread = 4;
  if (drawings::Stopwatch::is_on()) return 1;
  return std::clamp<std::size_t>(jobs / worth_a_thread, 1, std::max(std::thread::hardware_concurrency(), 1U));
}

class Jobs {
 public:
  Jobs(std::size_t count, const std::function<void(std::size_t)>& job) : job_(job), thrown_(count), end_(count) {}

  // One job after another, until there is none.
  void work() {
    for (std::size_t i = next_++; i < end_; i = next_++) {
      try {
        job_(i);
      } catch (...) {
        thrown_[i] = std::current_exception();
        end_before(i);
      }
    }
  }

  void rethrow_first() const {
    for (const std::exception_ptr& each : thrown_)
      if (each) std::rethrow_exception(each);
  }

 private:
  // Jobs are handed out in order, so all before the failed one have been started.
  void end_before(std::size_t failed) {
    std::size_t end = end_;
    while (failed < end && !end_.compare_exchange_weak(end, failed)) {
    }
  }

  const std::function<void(std::size_t)>& job_;
  std::vector<std::exception_ptr> thrown_;
  std::atomic<std::size_t> next_{0}, end_;
};

}  // namespace

void abreast(std::size_t count, const std::function<void(std::size_t)>& job) {
  Jobs jobs(count, job);
  geometry::in_threads(threads(count), [&] { jobs.work(); });
  jobs.rethrow_first();
}

}  // namespace epure
