// Text of the code page that spreadsheets of Western Europe write CSV in, unless told otherwise.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace epure {

// In UTF-8. None where the bytes are no text of that code page: five bytes stand for nothing there, nor does a NUL
// stand in text; or where some of them are characters of UTF-8 of several bytes, which nobody writes in that page by
// chance: then it is UTF-8 with a fault.
std::optional<std::string> from_windows_1252(std::string_view bytes);

}  // namespace epure
