// Work in several threads.
#pragma once

#include "geometry/numbers/flint.h"

#include <system_error>
#include <thread>
#include <vector>

namespace epure::geometry {

// What the numbers keep for a thread beside their values. FLINT, and Arb and Calcium on it, hold freed integers and
// computed constants for reuse, apart for each thread, and do not notice when a thread ends. So every thread but the
// first that computes opens one of these before all else. Numbers that outlive the thread stay whole.
class ThreadCaches {
 public:
  ThreadCaches() = default;
  ThreadCaches(const ThreadCaches&) = delete;
  ThreadCaches& operator=(const ThreadCaches&) = delete;
  ~ThreadCaches() { flint_cleanup(); }
};

// Calls work() in this thread and in `threads - 1` others at the same time, and returns when all calls have ended;
// in fewer where the system has no more to give. So work() takes from a common heap until nothing is left, whoever
// calls it. It must not throw.
template <class Work>
void in_threads(std::size_t threads, const Work& work) {
  std::vector<std::jthread> others;
  try {
    while (others.size() + 1 < threads)
      others.emplace_back([&work] {
        const ThreadCaches caches;
        work();
      });
  } catch (const std::system_error&) {  // those that have started do it all
  }
  work();
}

}  // namespace epure::geometry
