// Numbers in bytes, as files hold them.
#pragma once

#include <cstdint>
#include <string>

namespace epure::drawings {

// The most significant byte first, as PNG and PDF have all numbers.
inline void add_number(std::string& to, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) to += static_cast<char>(number >> shift & 0xff);
}

}  // namespace epure::drawings
