// Why a mechanism cannot be placed, or does not close where its givens put it: in the letters of its file.
#pragma once

#include "exercises/scenes/scene.h"
#include "geometry/linkages/carried_out.h"

namespace epure::scenes {

// Of `built` the linkage and its letters are read. All open sides at once, each with the two lines to choose from; of
// what contradicts a side nothing is told, the file knows its line.
Words in_words(const geometry::NotPlaced& open, const Built& built);

// Which joint, and by how much it misses where that is a length.
Words in_words(const geometry::NotClosed& open, const Built& built);

// The same of what is placed, but at a limit, so that its motion is not determined.
Words in_words_at_limit(const geometry::NotClosed& open, const Built& built);

// Of a step that is at its limit, or very near: what is special about its place.
enum class LettersAs { plain, rich_text };
Words special_in_words(std::size_t step, const Built& built, LettersAs as);
// The same of one that is proved to be, and that the motion is not determined there.
Words limit_in_words(std::size_t step, const Built& built);

// "A", "A and B", "A, B and C".
Words enumerated(const std::vector<std::string>& names);

}  // namespace epure::scenes
