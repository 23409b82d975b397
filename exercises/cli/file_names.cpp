#include "exercises/cli/file_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "exercises/cli/printable.h"
#include "exercises/cli/request.h"
#include "exercises/cli/variation.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

constexpr std::size_t longest_name = 200;  // bytes, so that endings find room in the 255 that a name has

const std::vector<std::string> fields_of_all{"id", "sheet", "lang"}, fields_of_tables{"row", "number", "student"};

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// No folder, nothing that a shell would read otherwise. Letters with accents stay.
std::string fit(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    name += is_plain || c == '-' || c == '.' || static_cast<unsigned char>(c) >= 0x80 ? c : '_';
  }
  return name;
}

// In the given's unit, as a decimal where it has an end; or the word.
std::string value_of(const Givens& givens, const std::string& symbol) {
  const auto read = givens.reading(symbol);
  if (!read) return givens.text(symbol);
  const GivenSpec& spec = givens.specs()[index_of(givens.specs(), symbol)];
  return spec.choices.empty() ? exact_text(read->number) : givens.text(symbol);
}

[[noreturn]] void refuse_pattern(const std::string& pattern, const Words& why) {
  throw WrongUsage(format_words("--name \"{}\": {}", "--name \"{}\": {}", pattern, why));
}

void demand_letters(const std::string& pattern) {
  if (pattern.size() > longest_name)
    refuse_pattern(pattern, format_words("is longer than {} bytes", "è più lungo di {} byte", longest_name));
  if (pattern.find_first_of("/\\") != std::string::npos)
    refuse_pattern(pattern, {"names a file and no folder, which --out names",
                             "nomina un file e non una cartella, che nomina --out"});
  if (printable(pattern) != pattern)
    refuse_pattern(pattern, {"must be a line of printable letters", "dev'essere una riga di caratteri stampabili"});
}

// Without --name.
const char* pattern_of(bool has_table) { return has_table ? "{id}-{sheet}-{number}" : "{id}-{sheet}"; }

std::string in_braces(const std::string& name) { return "{" + name + "}"; }

}  // namespace

FileNames::FileNames(const Options& options, const std::vector<const Exercise*>& exercises, bool has_table)
    : language_(language(options) == Language::english ? "en" : "it"),
      is_asked_(options.name.has_value()),
      has_table_(has_table),
      is_for_tex_(!options.file && is_asked_for(Format::tex, options)) {
  if (is_asked_ && options.file)
    throw WrongUsage("-o names one file and --name many; choose one of them",
                     "-o nomina un file e --name molti; scegliere uno dei due");
  read(options.name.value_or(pattern_of(has_table)));
  for (const Part& part : parts_)
    if (part.is_field) demand_known(part.text, exercises, has_table);
}

void FileNames::read(const std::string& pattern) {
  demand_letters(pattern);
  parts_.push_back({""});
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    if (pattern[at] == '}')
      refuse_pattern(pattern, {"a brace is closed and not opened", "una graffa è chiusa e non aperta"});
    if (pattern[at] != '{') {
      parts_.back().text += pattern[at];
      continue;
    }
    const auto end = pattern.find('}', at);
    if (end == std::string::npos)
      refuse_pattern(pattern, {"a brace is opened and not closed", "una graffa è aperta e non chiusa"});
    parts_.push_back({pattern.substr(at + 1, end - at - 1), true});
    parts_.push_back({""});
    at = end;
  }
}

void FileNames::demand_known(const std::string& field, const std::vector<const Exercise*>& exercises,
                             bool has_table) const {
  if (is_among(fields_of_all, field)) return;
  if (is_among(fields_of_tables, field)) {
    if (has_table) return;
    throw WrongUsage(format_words("--name: {} is told by the rows of a table, and no --givens names one",
                                  "--name: {} lo dicono le righe di una tabella, e nessun --givens ne nomina una",
                                  in_braces(field)));
  }
  for (const Exercise* exercise : exercises)
    if (!given_meant(field, {exercise})) {
      std::vector<std::string> known = fields_of_all;
      known.insert(known.end(), fields_of_tables.begin(), fields_of_tables.end());
      for (const std::string& symbol : symbols_of({exercise})) known.push_back(symbol);
      for (std::string& name : known) name = in_braces(name);
      throw WrongUsage(format_words("--name: {} is no field for {}; choose among {}",
                                    "--name: {} non è un campo per {}; scegliere fra {}", in_braces(field),
                                    exercise->about().id, alternatives(known)));
    }
}

bool FileNames::has_field(const std::string& name) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return part.is_field && part.text == name; });
}

std::string FileNames::value(const std::string& field, const DrawnVariant& drawn, const std::string& sheet) const {
  if (field == "id") return drawn.exercise.about().id;
  if (field == "sheet") return sheet;
  if (field == "lang") return language_;
  if (field == "row") return fmt::format("{}", drawn.row_number);
  if (field == "number") return fit(drawn.row.number);
  if (field == "student") return fit(drawn.row.name.empty() ? drawn.row.number : drawn.row.name);
  return fit(value_of(drawn.givens, *given_meant(field, {&drawn.exercise})));
}

std::string FileNames::stem(const DrawnVariant& drawn, const std::string& sheet) const {
  std::string name;
  for (const Part& part : parts_) {
    const bool is_left_out = part.is_field && part.text == "sheet" && sheet.empty();
    if (is_left_out && name.ends_with('-')) name.pop_back();
    if (!is_left_out) name += part.is_field ? value(part.text, drawn, sheet) : part.text;
  }
  if (name.empty()) throw WrongUsage("--name \"\" names no file", "--name \"\" non nomina un file");
  if (name.starts_with('.') || name.starts_with('-'))
    throw WrongUsage(format_words("--name: \"{}\" would begin with \"{}\"; put a letter before it",
                                  "--name: \"{}\" comincerebbe con \"{}\"; metterci davanti una lettera", name,
                                  name.substr(0, 1)));
  if (name.size() > longest_name)
    throw WrongUsage(format_words("--name: \"{}\" is longer than {} bytes", "--name: \"{}\" è più lungo di {} byte",
                                  name, longest_name));
  if (is_for_tex_) demand_name_for_tex("--name", name);
  return name;
}

bool FileNames::claim(const std::filesystem::path& path, const std::string& content) {
  const auto [known, is_new] = claimed_.try_emplace(lower_case(path.string()), content);
  if (!is_new && known->second != content)
    throw WrongUsage(format_words("{} and {} would be one file, {}; tell them apart by --name, such as {}",
                                  "{} e {} sarebbero un solo file, {}; distinguerli con --name, come {}",
                                  known->second, content, path.string(), pattern_of(has_table_)));
  return is_new;
}

}  // namespace epure
