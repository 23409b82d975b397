#include "drawings/files/signals_later.h"

#include <signal.h>

#include <array>
#include <atomic>
#include <mutex>

namespace epure::drawings {
namespace {

// A mask would be a thread's own, and the system gives a signal to any thread that lets it through, also to one of a
// library's: so they are caught.
constexpr std::array ends{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGXCPU};
std::atomic<int> waiting{0}, living{0};  // a signal; SignalsLater
static_assert(std::atomic<int>::is_always_lock_free, "a handler may not wait");

void let_through() {
  if (const int signal = waiting.exchange(0)) ::raise(signal);
}
// Another thread may come to this when the last one that made it wait has ended.
void note(int signal) {
  waiting = signal;
  if (living == 0) let_through();
}

std::mutex lock;
std::array<struct sigaction, ends.size()> before;

void begin_catching() {
  struct sigaction later {};
  later.sa_handler = note;
  later.sa_flags = SA_RESTART;  // a write goes on
  for (std::size_t i = 0; i < ends.size(); ++i) {
    sigaction(ends[i], nullptr, &before[i]);
    if (before[i].sa_handler != SIG_IGN) sigaction(ends[i], &later, nullptr);
  }
}

void end_catching() {
  for (std::size_t i = 0; i < ends.size(); ++i) sigaction(ends[i], &before[i], nullptr);
}

}  // namespace

SignalsLater::SignalsLater() {
  const std::scoped_lock held(lock);
  if (living++ == 0) begin_catching();
}

SignalsLater::~SignalsLater() {
  const std::scoped_lock held(lock);
  if (--living > 0) return;
  end_catching();
  let_through();
}

bool SignalsLater::is_interrupted() { return waiting != 0; }

}  // namespace epure::drawings
