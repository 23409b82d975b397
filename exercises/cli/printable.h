// Texts as typed, made fit for one line of a message.
#pragma once

#include <string>

namespace epure {

// What a terminal would obey instead of showing (control characters, C1 among them, and those that turn the direction
// of writing), what breaks lines, what cannot be seen, and bytes that are no UTF-8 become question marks.
std::string shown_whole(const std::string& text);
// The same; what is far too long is cut in its middle.
std::string printable(const std::string& sentence);

// Whether it has control characters, C1 among them.
bool commands_a_terminal(const std::string& text);

}  // namespace epure
