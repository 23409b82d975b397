// Ctrl-C while there is something to clear away.
#pragma once

#include <signal.h>

namespace epure::drawings {

// Ctrl-C and a plain kill wait until what was begun is done: no draft stays behind, and of several files none is
// replaced without the others.
class SignalsLater {
 public:
  SignalsLater() { pthread_sigmask(SIG_BLOCK, &held(), &before_); }
  ~SignalsLater() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsLater(const SignalsLater&) = delete;
  SignalsLater& operator=(const SignalsLater&) = delete;

  // Whether one waits.
  bool is_interrupted() const {
    sigset_t waiting;
    sigpending(&waiting);
    for (const int each : ends)
      if (sigismember(&waiting, each) == 1) return true;
    return false;
  }
  // What is not to wait: the mask for a program that is started meanwhile.
  const sigset_t& before() const { return before_; }

 private:
  static constexpr int ends[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
  static const sigset_t& held() {
    static const sigset_t all = [] {
      sigset_t set;
      sigemptyset(&set);
      for (const int each : ends) sigaddset(&set, each);
      return set;
    }();
    return all;
  }

  sigset_t before_;
};

}  // namespace epure::drawings
