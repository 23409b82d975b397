#include "drawings/files/pdf_objects.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

namespace epure::drawings {
namespace {

std::optional<std::size_t> number_at(std::string_view text, std::size_t at) {
  std::size_t number = 0;
  if (at > text.size()) return {};
  const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

}  // namespace

std::string without_missing_objects(std::string pdf) {
  constexpr std::string_view start = "startxref\n", table = "xref\n0 ", free = "0000000000 65535 f \n";
  const auto told = pdf.rfind(start);
  if (told == std::string::npos) return pdf;
  const auto at = number_at(pdf, told + start.size());
  if (!at || *at > pdf.size() || pdf.compare(*at, table.size(), table) != 0) return pdf;
  const auto count = number_at(pdf, *at + table.size());
  std::size_t entry = pdf.find('\n', *at + table.size()) + 1;
  for (std::size_t object = 0; count && object < *count && entry + free.size() <= pdf.size();
       ++object, entry += free.size()) {
    const auto place = number_at(pdf, entry);
    const std::string begins = fmt::format("{} 0 obj", object);
    if (!place || *place > pdf.size() || pdf.compare(*place, begins.size(), begins) != 0)
      pdf.replace(entry, free.size(), free);
  }
  return pdf;
}

}  // namespace epure::drawings
