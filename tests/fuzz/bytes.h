// An input, read as what is asked for; zeros at its end.
#pragma once

#include <cstddef>
#include <cstdint>

namespace epure::tests {

class Bytes {
 public:
  Bytes(const std::uint8_t* bytes, std::size_t count) : next_(bytes), end_(bytes + count) {}
  bool has_more() const { return next_ != end_; }
  std::uint8_t byte() { return has_more() ? *next_++ : std::uint8_t{0}; }

 private:
  const std::uint8_t *next_, *end_;
};

}  // namespace epure::tests
