#include "exercises/cli/help_page.h"

#include "exercises/cli/columns.h"

namespace epure {
namespace {

std::string paragraph(const Words& words, Language language) {
  return words.empty() ? "" : wrapped(words.in(language)) + "\n";
}

std::vector<std::vector<std::string>> rows(const std::vector<HelpEntry>& entries) {
  std::vector<std::vector<std::string>> rows;
  for (const HelpEntry& each : entries)
    rows.push_back({each.name + (each.type.empty() ? "" : " " + each.type), each.meaning});
  return rows;
}

}  // namespace

std::string help_text(const HelpPage& page, Language language) {
  return paragraph(page.help.purpose, language) + Words{"Usage: ", "Uso: "}.in(language) + page.usage + "\n\n" +
         (page.names.empty() ? "" : table(rows(page.names), 2) + "\n") + table(rows(page.options), 2, {26}) + "\n" +
         paragraph(page.help.remarks, language) + Words{"Examples:", "Esempi:"}.in(language) + page.help.examples +
         "\n" + wrapped(exit_codes().in(language));
}

}  // namespace epure
