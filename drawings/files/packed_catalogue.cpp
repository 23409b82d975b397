#include "drawings/files/packed_catalogue.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <string_view>

namespace epure::drawings {
namespace {

// The number behind a word: 26 behind "/Root" in "/Root 26 0 R".
std::optional<std::size_t> number_behind(std::string_view text, std::string_view word) {
  const auto at = text.find(word);
  if (at == text.npos) return {};
  const auto digits = text.find_first_of("0123456789", at + word.size());
  std::size_t number = 0;
  if (digits == text.npos ||
      std::from_chars(text.data() + digits, text.data() + text.size(), number).ec != std::errc())
    return {};
  return number;
}

// What a stream holds that begins here; what follows it does no harm. Empty where it is none.
std::string inflated(std::string_view packed) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return {};
  const std::unique_ptr<z_stream, int (*)(z_stream*)> owner(&stream, inflateEnd);
  std::string bytes(packed), text;
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::array<char, 4096> part{};
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(part.data(), part.size() - stream.avail_out);
  }
  return state == Z_STREAM_END ? text : "";
}

// Of this number among those of a stream, whose beginning is pairs of numbers and places.
std::string object_in(const std::string& stream, std::size_t first, std::size_t wanted) {
  std::string_view head = std::string_view(stream).substr(0, first);
  const auto next = [&]() -> std::optional<std::size_t> {
    const auto number = number_behind(head, "");
    if (number) {
      head.remove_prefix(head.find_first_of("0123456789"));
      head.remove_prefix(std::min(head.find_first_not_of("0123456789"), head.size()));
    }
    return number;
  };
  while (const auto number = next()) {
    const auto place = next();
    if (!place || *number != wanted) continue;
    const auto after = next() ? next() : std::nullopt;
    const std::size_t begin = std::min(first + *place, stream.size()), end = after ? first + *after : stream.size();
    std::string text = stream.substr(begin, end - begin);
    text.erase(text.find_last_not_of(" \n") + 1);
    return text;
  }
  return {};
}

}  // namespace

std::optional<PackedCatalogue> packed_catalogue(const std::string& pdf) {
  constexpr std::string_view start = "startxref\n", of_stream = "/Type /ObjStm", begins = "stream\n";
  const auto told = pdf.rfind(start);
  if (told == std::string::npos) return {};
  const std::string_view whole = pdf;
  const auto table = number_behind(whole.substr(told), start);
  if (!table || *table >= told) return {};
  const std::string_view dictionary = whole.substr(*table, whole.find(begins, *table) - *table);
  const auto root = number_behind(dictionary, "/Root"), information = number_behind(dictionary, "/Info"),
             size = number_behind(dictionary, "/Size");
  if (dictionary.find("/Type /XRef") == dictionary.npos || !root || !information || !size) return {};
  for (auto at = whole.find(of_stream); at != whole.npos; at = whole.find(of_stream, at + 1)) {
    const auto data = whole.find(begins, at);
    const auto first = number_behind(whole.substr(at, data - at), "/First");
    if (data == whole.npos || !first) continue;
    const std::string text = object_in(inflated(whole.substr(data + begins.size())), *first, *root);
    if (!text.empty()) return PackedCatalogue{text, *root, *information, *size, *table};
  }
  return {};
}

}  // namespace epure::drawings
