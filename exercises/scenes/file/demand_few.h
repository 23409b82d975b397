// How much a file may ask for.
#pragma once

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/file/file_head.h"

namespace epure::scenes {

// Each is a curve to be found over all places of the drive: so many take seconds, and no more.
inline void demand_few(const File& file, const TextTree& list, std::size_t asked) {
  constexpr std::size_t most = 24;
  if (asked > most)
    file.refuse(list, format_words("{} are asked for; {} at most", "se ne chiedono {}; al più {}", asked, most));
}

}  // namespace epure::scenes
