#include "exercises/want_of_room.h"

#include <glib.h>
#include <gmp.h>
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

namespace epure {
namespace {

[[noreturn]] void end() {
  constexpr std::string_view sentence = "epure: there is not enough memory for this\n";
  if (::write(STDERR_FILENO, sentence.data(), sentence.size()) < 0) ::_exit(3);  // unsaid
  ::_exit(3);
}

void* or_end(void* memory) {
  if (!memory) end();
  return memory;
}

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

}  // namespace

void end_as_told_for_want_of_room() {
  mp_set_memory_functions(
      [](std::size_t size) { return or_end(std::malloc(size)); },
      [](void* memory, std::size_t, std::size_t size) { return or_end(std::realloc(memory, size)); },
      [](void* memory, std::size_t) { std::free(memory); });
  g_log_set_default_handler(
      [](const char* domain, GLogLevelFlags level, const char* message, void* data) {
        if ((level & G_LOG_LEVEL_ERROR) != 0) end();
        g_log_default_handler(domain, level, message, data);
      },
      nullptr);
  std::set_terminate(on_terminate);
  ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace epure
