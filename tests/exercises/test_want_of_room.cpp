// Libraries that would end the program: each in a process of its own, which shows how it ended.
#include <gmp.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>

#include "exercises/want_of_room.h"
#include "geometry/numbers/flint.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

struct Ended {
  int exit = -1;     // none: by a signal
  int signal = 0;    // none: by itself
  std::string said;  // on both streams
};

// What runs to its end exits with 0. Catch2 leaves the child's signals alone.
Ended ended(const std::function<void()>& task) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  // What still waits to be said would be said by the child too: Catch2 3 begins with a line of its own, and FLINT 3
  // flushes before it aborts.
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int each : {SIGABRT, SIGTRAP, SIGSEGV}) ::signal(each, SIG_DFL);
    const rlimit no_core = {0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::dup2(ends[1], STDERR_FILENO);
    ::dup2(ends[1], STDOUT_FILENO);
    end_as_told_for_want_of_room();
    task();
    ::_exit(0);
  }
  ::close(ends[1]);
  Ended how;
  char piece[256];
  for (ssize_t got = 0; (got = ::read(ends[0], piece, sizeof piece)) > 0;)
    how.said.append(piece, static_cast<std::size_t>(got));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status)) how.exit = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) how.signal = WTERMSIG(status);
  return how;
}

constexpr std::size_t too_much = std::size_t{1} << 60;
constexpr const char* sentence = "epure: there is not enough memory for this\n";

void is_want_of_room(const std::function<void()>& task) {
  const Ended how = ended(task);
  CHECK(how.signal == 0);
  CHECK(how.exit == 3);
  CHECK(how.said == sentence);
}

void throws_where_nothing_may(const std::function<void()>& task) noexcept { task(); }

}  // namespace

TEST_CASE("want of memory in FLINT is exit 3 and one sentence") {
  is_want_of_room([] { flint_malloc(too_much); });
  is_want_of_room([] { flint_calloc(1, too_much); });
  is_want_of_room([] { flint_realloc(flint_malloc(8), too_much); });
  is_want_of_room([] {
    errno = ENOMEM;  // as where FLINT allocates by other ways
    flint_abort();
  });
  CHECK(ended([] {
          void* const memory = flint_realloc(flint_calloc(1, 8), 1 << 20);
          flint_free(memory);
        }).exit == 0);
}

TEST_CASE("what else FLINT aborts for is an internal error") {
  const Ended how = ended([] {
    errno = 0;
    fmpz_t zero, one;
    fmpz_init(zero);
    fmpz_init_set_ui(one, 1);
    fmpz_fdiv_q(one, one, zero);
  });
  CHECK(how.exit == 70);
  CHECK(how.said.find("epure: internal error") != std::string::npos);
  CHECK(how.said.find("memory") == std::string::npos);
}

TEST_CASE("want of memory in GMP is exit 3 and one sentence") {
  const auto limit_room = [] {
    const rlimit little = {1u << 30, 1u << 30};
    ::setrlimit(RLIMIT_AS, &little);
  };
  constexpr mp_bitcnt_t much = std::size_t{1} << 35;  // bits: 4 GB, and no more than GMP itself allows
  is_want_of_room([&] {
    limit_room();
    mpz_t large;
    mpz_init2(large, much);
  });
  is_want_of_room([&] {
    limit_room();
    mpz_t large;
    mpz_init_set_ui(large, 1);
    mpz_realloc2(large, much);
  });
  CHECK(ended([] {
          mpz_t number;
          mpz_init2(number, 64);
          mpz_realloc2(number, 1 << 20);
          mpz_clear(number);
        }).exit == 0);
}

TEST_CASE("want of memory where nothing may be thrown is exit 3; anything else there is no want of memory") {
  is_want_of_room([] { throws_where_nothing_may([] { throw std::bad_alloc(); }); });
  CHECK(ended([] { throws_where_nothing_may([] { throw std::runtime_error("else"); }); }).signal == SIGABRT);
  CHECK(ended([] { std::terminate(); }).signal == SIGABRT);
}

TEST_CASE("a file that grows too large is a failed write") {
  CHECK(ended([] {
          const rlimit little = {16, 16};
          ::setrlimit(RLIMIT_FSIZE, &little);
          char name[] = "/tmp/epure-large-XXXXXX";
          const int file = ::mkstemp(name);
          ::unlink(name);
          const char bytes[64] = {};
          const bool first = ::write(file, bytes, sizeof bytes) == 16;
          if (!first || ::write(file, bytes, sizeof bytes) >= 0 || errno != EFBIG) ::_exit(1);
        }).exit == 0);
}
