// Where the time of a drawing goes. Off, a Timed costs one look at a flag; on, two readings of the processor's clock.
//
//   const Timed timed(Work::layout);   until the end of the block; what is timed inside of it counts there alone
//
// Processor time of the whole process, so that other programs do not count: only for work in a single thread.
#pragma once

#include <array>
#include <cstddef>

namespace epure::drawings {

enum class Work {
  start,         // until the stopwatch is started: loading the program and its libraries
  other,         // what nothing below accounts for
  construction,  // from the givens to the marks of a sheet
  layout,        // from marks to a page: symbols, labels' places, column, title block
  fonts,         // opening the shipped fonts
  text,          // letters to glyphs
  pdf,
  svg,
  files,  // writing them
};
inline constexpr std::size_t kinds_of_work = 9;

// Seconds by Work.
using WorkTimes = std::array<double, kinds_of_work>;

class Stopwatch {
 public:
  // From now on; what the process has used before goes to Work::start.
  static void begin();
  static bool is_on() { return on_; }
  // Up to now.
  static WorkTimes times();

 private:
  friend class Timed;
  // Returns what was being timed.
  static Work change_to(Work work);
  inline static bool on_ = false;
};

class Timed {
 public:
  explicit Timed(Work work) {
    if (Stopwatch::on_) before_ = Stopwatch::change_to(work);
  }
  ~Timed() {
    if (Stopwatch::on_) Stopwatch::change_to(before_);
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  Work before_ = Work::other;
};

}  // namespace epure::drawings
