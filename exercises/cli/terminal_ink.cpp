#include "exercises/cli/terminal_ink.h"

namespace epure {

std::string coloured(const std::string& text, Ink ink, bool colours) {
  if (!colours) return text;
  const char* const code = ink == Ink::good ? "32" : ink == Ink::doubtful ? "33" : "1;31";
  return std::string("\x1b[") + code + "m" + text + "\x1b[0m";
}

}  // namespace epure
