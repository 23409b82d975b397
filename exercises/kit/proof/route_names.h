// The routes' names in both languages.
#pragma once

#include <string>

#include "words/words.h"

namespace epure {

// In the words of a report: "polar diagram" is "diagramma polare". What has no entry is the same in both.
Words route_in_words(const std::string& route);

}  // namespace epure
