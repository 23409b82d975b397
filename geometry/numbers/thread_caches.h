// What the numbers keep for a thread beside their values.
//
// FLINT, and Arb and Calcium on it, hold freed integers and computed constants for reuse, apart for each thread, and
// do not notice when a thread ends. So every thread but the first that computes opens one of these before all else.
#pragma once

#include <flint/flint.h>

namespace epure::geometry {

class ThreadCaches {
 public:
  ThreadCaches() = default;
  ThreadCaches(const ThreadCaches&) = delete;
  ThreadCaches& operator=(const ThreadCaches&) = delete;
  // Numbers that outlive the thread stay whole.
  ~ThreadCaches() { flint_cleanup(); }
};

}  // namespace epure::geometry
