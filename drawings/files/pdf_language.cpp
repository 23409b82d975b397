#include "drawings/files/pdf_language.h"

#include <fmt/format.h>

#include <string_view>

namespace epure::drawings {

std::string in_language(std::string pdf, Language language) {
  constexpr std::string_view catalogue = "/Type /Catalog", end = "endobj\n", start = "startxref\n";
  const auto at = pdf.rfind(catalogue);
  if (at == std::string::npos) return pdf;
  const auto table = pdf.find(end, at) + end.size();
  const auto told = pdf.find(start, table);
  if (pdf.compare(table, 5, "xref\n") != 0 || told == std::string::npos) return pdf;
  const auto place = told + start.size(), line_end = pdf.find('\n', place);
  if (pdf.substr(place, line_end - place) != fmt::format("{}", table)) return pdf;
  // Only the table of objects moves, and one place says where it is.
  const std::string added = fmt::format("\n   /Lang ({})", language == Language::english ? "en" : "it");
  pdf.replace(place, line_end - place, fmt::format("{}", table + added.size()));
  return pdf.insert(at + catalogue.size(), added);
}

}  // namespace epure::drawings
