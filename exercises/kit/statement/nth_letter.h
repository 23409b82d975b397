// Letters for as many as there are.
#pragma once

#include <string>

namespace epure {

// 0: "a", 25: "z", then "a_{1}", "b_{1}": to stand in mathematics.
inline std::string nth_letter(std::size_t n) {
  constexpr std::size_t alphabet = 26;
  const std::string letter{static_cast<char>('a' + n % alphabet)};
  return n < alphabet ? letter : letter + "_{" + std::to_string(n / alphabet) + "}";
}

}  // namespace epure
