#include "drawings/files/pdf_language.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "drawings/files/packed_catalogue.h"

namespace epure::drawings {
namespace {

constexpr std::string_view catalogue = "/Type /Catalog", start = "startxref\n";

std::string entry(Language language) {
  return fmt::format("\n   /Lang ({})", language == Language::english ? "en" : "it");
}

// Where the catalogue is plain text.
std::optional<std::string> in_plain_catalogue(std::string pdf, Language language) {
  constexpr std::string_view end = "endobj\n";
  const auto at = pdf.rfind(catalogue);
  if (at == std::string::npos) return {};
  const auto table = pdf.find(end, at) + end.size();
  const auto told = pdf.find(start, table);
  if (pdf.compare(table, 5, "xref\n") != 0 || told == std::string::npos) return {};
  const auto place = told + start.size(), line_end = pdf.find('\n', place);
  if (pdf.substr(place, line_end - place) != fmt::format("{}", table)) return {};
  // Only the table of objects moves, and one place says where it is.
  const std::string added = entry(language);
  pdf.replace(place, line_end - place, fmt::format("{}", table + added.size()));
  return pdf.insert(at + catalogue.size(), added);
}

std::string bytes_of(std::size_t number, int count) {
  std::string bytes;
  for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(number >> (8 * i) & 0xFF);
  return bytes;
}

// A catalogue behind the end, and a table of two objects, which are it and the table itself.
std::optional<std::string> behind_the_end(std::string pdf, Language language) {
  const auto packed = packed_catalogue(pdf);
  if (!packed) return {};
  std::string text = packed->text;
  const auto at = text.find(catalogue);
  if (at == std::string::npos) return {};
  text.insert(at + catalogue.size(), entry(language));
  if (!pdf.ends_with('\n')) pdf += '\n';
  const std::size_t of_catalogue = pdf.size();
  pdf += fmt::format("{} 0 obj\n{}\nendobj\n", packed->number, text);
  const std::size_t of_table = pdf.size(), table = packed->objects;
  const std::string places = bytes_of(1, 1) + bytes_of(of_catalogue, 4) + bytes_of(0, 2) +  //
                             bytes_of(1, 1) + bytes_of(of_table, 4) + bytes_of(0, 2);
  pdf += fmt::format(
      "{} 0 obj\n<< /Type /XRef\n   /Length {}\n   /Size {}\n   /W [1 4 2]\n   /Index [{} 1 {} 1]\n   /Root {} 0 R\n"
      "   /Info {} 0 R\n   /Prev {}\n>>\nstream\n",
      table, places.size(), table + 1, packed->number, table, packed->number, packed->information, packed->table);
  return pdf + places + fmt::format("\nendstream\nendobj\n{}{}\n%%EOF\n", start, of_table);
}

}  // namespace

std::string in_language(std::string pdf, Language language) {
  if (auto plain = in_plain_catalogue(pdf, language)) return std::move(*plain);
  if (auto packed = behind_the_end(pdf, language)) return std::move(*packed);
  return pdf;
}

}  // namespace epure::drawings
