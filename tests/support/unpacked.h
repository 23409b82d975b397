// What a PDF holds packed, by zlib.
#pragma once

#include <string>
#include <string_view>

namespace epure {

// What the packed bytes stand for, as far as they can be read; what follows them does not matter.
std::string unpacked(std::string_view packed);
// The document, and behind it the objects that it holds packed among others, as Cairo 1.18 writes them.
std::string with_packed_objects(const std::string& pdf);

}  // namespace epure
