// Standard output.
#pragma once

#include <iosfwd>
#include <string>

#include "drawings/output.h"

namespace epure {

// Who read standard output has had enough.
struct NobodyReads : drawings::CannotWrite {
  using CannotWrite::CannotWrite;
};

// Throws CannotWrite when not all of the text could be written.
void print(std::ostream& out, const std::string& text);

}  // namespace epure
