#include "drawings/stopwatch.h"

#include <ctime>

namespace epure::drawings {
namespace {

WorkTimes spent{};
Work current = Work::other;
double since = 0;

// Seconds of processor the process has used; they begin when the program begins to be loaded.
double used() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

void Stopwatch::begin() {
  spent = {};
  since = used();
  spent[static_cast<std::size_t>(Work::start)] = since;
  current = Work::other;
  on_ = true;
}

Work Stopwatch::change_to(Work work) {
  const double now = used();
  spent[static_cast<std::size_t>(current)] += now - since;
  since = now;
  const Work before = current;
  current = work;
  return before;
}

WorkTimes Stopwatch::times() {
  change_to(current);
  return spent;
}

}  // namespace epure::drawings
