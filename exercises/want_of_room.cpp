#include "exercises/want_of_room.h"

#include <gmp.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "geometry/numbers/flint.h"

namespace epure {
namespace {

[[noreturn]] void end(std::string_view sentence, int code) {
  if (::write(STDERR_FILENO, sentence.data(), sentence.size()) < 0) ::_exit(code);  // unsaid
  ::_exit(code);
}
[[noreturn]] void end() { end("epure: there is not enough memory for this\n", 3); }

void* or_end(void* memory) {
  if (!memory) end();
  return memory;
}
void* allocate(std::size_t size) { return or_end(std::malloc(size)); }
void* reallocate(void* memory, std::size_t size) { return or_end(std::realloc(memory, size)); }

void on_terminate() {
  try {
    if (const std::exception_ptr cause = std::current_exception()) std::rethrow_exception(cause);
  } catch (const std::bad_alloc&) {
    end();
  } catch (...) {
    std::abort();
  }
  std::abort();
}

// FLINT has said why, unless memory was all it wanted. (Its attribute, as Clang takes it for a part of the type.)
FLINT_NORETURN void on_flint_abort() {
  if (errno == ENOMEM) end();
  end("epure: internal error: FLINT cannot go on; please report it with the command that led to it\n", 70);
}

}  // namespace

void end_as_told_for_want_of_room() {
  mp_set_memory_functions(
      allocate, [](void* memory, std::size_t, std::size_t size) { return reallocate(memory, size); },
      [](void* memory, std::size_t) { std::free(memory); });
  __flint_set_memory_functions(
      allocate, [](std::size_t count, std::size_t size) { return or_end(std::calloc(count, size)); }, reallocate,
      std::free);
  flint_set_abort(on_flint_abort);
  std::set_terminate(on_terminate);
  ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace epure
