// Words with numbers and names in them, in all languages at once. An exercise keeps its words beside its figures.
#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>

#include "words/words.h"

namespace epure {

template <class T>
using InOneLanguage = std::conditional_t<std::is_same_v<T, Words>, std::string, T>;

template <class T>
const InOneLanguage<T>& in_language(Language language, const T& argument) {
  if constexpr (std::is_same_v<T, Words>) {
    return argument.in(language);
  } else {
    return argument;
  }
}

// A number with so many significant digits at most.
inline Words decimal(double value, int significant) { return decimal(fmt::format("{:.{}g}", value, significant)); }

// The same with as few digits as read back as the same double.
inline Words all_digits(double value) { return decimal(fmt::format("{}", value)); }

// fmt::format in both languages. An argument that is Words comes in the language of the format around it.
template <class... Arguments>
Words format_words(fmt::format_string<InOneLanguage<Arguments>...> english,
                   fmt::format_string<InOneLanguage<Arguments>...> italian, const Arguments&... arguments) {
  return {fmt::vformat(english, fmt::make_format_args(in_language(Language::english, arguments)...)),
          fmt::vformat(italian, fmt::make_format_args(in_language(Language::italian, arguments)...))};
}

}  // namespace epure
