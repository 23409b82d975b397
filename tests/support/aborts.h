// Caller mistakes are assertions: they end the program. Tried in a child process.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace epure::testing {

// True when `mistake()` ends the process by an assertion.
template <class Mistake>
bool aborts(const Mistake& mistake) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL);  // or the test framework reports the child's end as a failure
    if (!std::freopen("/dev/null", "w", stderr)) _exit(1);  // the message of the assertion is expected
    mistake();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}

}  // namespace epure::testing
