#include "package/manual_page.h"

#include <fmt/format.h>

#include <sstream>

#include "exercises/cli/options.h"

namespace epure {
namespace {

// Letters that groff takes for its own, or prints as others: a hyphen as typed is "\-".
std::string plain_letters(const std::string& text) {
  std::string set;
  for (const char letter : text) switch (letter) {
      case '\\':
        set += "\\e";
        break;
      case '-':
        set += "\\-";
        break;
      case '\'':
        set += "\\(aq";
        break;
      case '`':
        set += "\\(ga";
        break;
      case '^':
        set += "\\(ha";
        break;
      case '~':
        set += "\\(ti";
        break;
      case '"':
        set += "\\(dq";
        break;
      default:
        set += letter;
    }
  return set.starts_with('.') ? "\\&" + set : set;
}

// In the markup of the macros: what is typed as it stands is bold, what stands for something else italic.
std::string bold(const std::string& text) { return "\\fB" + plain_letters(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + plain_letters(text) + "\\fR"; }

// A line that begins with a stop or a quotation mark would be a request.
std::string paragraph(const std::string& text) { return ".PP\n" + plain_letters(text) + "\n"; }

std::string heading(const Words& words, Language language) { return ".SH " + words.in(language) + "\n"; }

// "-h,--help" is "-h, --help" with each in bold.
std::string spellings(const std::string& names) {
  std::istringstream all(names);
  std::string set;
  for (std::string name; std::getline(all, name, ',');) set += (set.empty() ? "" : ", ") + bold(name);
  return set;
}

std::string entries(const HelpPage& page, Language language) {
  std::string text;
  const bool is_program = page.verb.empty();
  if (!page.names.empty())
    text += is_program ? heading({"VERBS", "VERBI"}, language) : heading({"ARGUMENTS", "ARGOMENTI"}, language);
  for (const HelpEntry& each : page.names)
    text += ".TP\n" + (is_program ? bold(each.name) : italic(each.name)) + "\n" + plain_letters(each.meaning) + "\n";
  text += heading({"OPTIONS", "OPZIONI"}, language);
  for (const HelpEntry& each : page.options)
    text += ".TP\n" + spellings(each.name) + (each.type.empty() ? "" : " " + italic(each.type)) + "\n" +
            plain_letters(each.meaning) + "\n";
  return text;
}

// As they stand, line by line.
std::string examples(const std::string& commands) {
  std::istringstream all(commands);
  std::string text = ".PP\n.EX\n";
  for (std::string line; std::getline(all, line);)
    if (!line.empty()) text += plain_letters(line.substr(std::min<std::size_t>(2, line.size()))) + "\n";
  return text + ".EE\n";
}

// Every page names every other.
std::string see_also(const std::string& verb) {
  std::vector<std::string> others{""};
  for (const std::string& each : verbs()) others.push_back(each);
  std::string text;
  for (const std::string& each : others)
    if (each != verb)
      text += (text.empty() ? "" : ",\n") + std::string(".BR ") + plain_letters(name_of_manual_page(each)) + " (1)";
  return text;
}

}  // namespace

std::string name_of_manual_page(const std::string& verb) { return verb.empty() ? "epure" : "epure-" + verb; }

std::string manual_page(const HelpPage& page, Language language, const std::string& version) {
  const std::string name = name_of_manual_page(page.verb);
  const std::string purpose = page.help.purpose.in(language);
  std::string text = fmt::format(".TH {} 1 \"\" \"epure {}\"\n", plain_letters(name), plain_letters(version));
  text += heading({"NAME", "NOME"}, language) + plain_letters(name) + " \\- " + plain_letters(purpose) + "\n";
  text += heading({"SYNOPSIS", "SINTASSI"}, language) + plain_letters(page.usage) + "\n";
  if (const Words& remarks = page.help.remarks; !remarks.empty())
    text += heading({"DESCRIPTION", "DESCRIZIONE"}, language) + paragraph(remarks.in(language));
  text += entries(page, language);
  text += heading({"EXIT STATUS", "STATO DI USCITA"}, language) + paragraph(exit_codes().in(language));
  text += heading({"EXAMPLES", "ESEMPI"}, language) + examples(page.help.examples);
  return text + heading({"SEE ALSO", "VEDERE ANCHE"}, language) + see_also(page.verb) + "\n";
}

}  // namespace epure
