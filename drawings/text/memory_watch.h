// HarfBuzz, FreeType and Cairo may go on after a failed allocation, without some of the letters and without a
// word. But it leaves its mark in errno, which no library sets back.
#pragma once

#include <cerrno>
#include <new>

namespace epure::drawings {

class MemoryWatch {
 public:
  MemoryWatch() { errno = 0; }
  // Throws std::bad_alloc when an allocation has failed since.
  void demand() const {
    if (errno == ENOMEM) throw std::bad_alloc();
  }
};

}  // namespace epure::drawings
