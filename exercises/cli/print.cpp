#include "exercises/cli/print.h"

#include <cerrno>
#include <ostream>

#include "drawings/files/system_words.h"

namespace epure {

void print(std::ostream& out, const std::string& text) {
  errno = 0;
  out << text << std::flush;
  if (out) return;
  const int error = errno;
  const Words why = Words{"cannot write to standard output", "impossibile scrivere sullo standard output"} +
                    (error == 0 ? Words{} : ": " + drawings::system_words(error));
  if (error == EPIPE) throw NobodyReads(why);
  throw drawings::CannotWrite(why);
}

}  // namespace epure
