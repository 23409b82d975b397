#include "exercises/cli/class_record.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>

#include "drawings/output.h"
#include "exercises/kit/statement/format_words.h"

namespace epure {
namespace {

// As a shell takes it for itself.
std::string quoted(const std::string& word) {
  const auto is_plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string("-_./=:,+^").find(c) != std::string::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

ClassRecord::ClassRecord(const std::string& target, const Options& options) {
  lots_ = "epure class " + quoted(target) + " --seed " + quoted(options.class_set.seed);
  for (const std::string& each : options.variations) lots_ += " --vary " + quoted(each);
  for (const std::string& each : options.assignments) lots_ += " --set " + quoted(each);
  if (options.scale) lots_ += " --scale " + quoted(*options.scale);
  lots_ += " --paper " + quoted(options.paper);
  text_ = lots_ + " \\\n ";
  const std::optional<std::string> language = options.language, reading = options.reading;
  const auto typed = [](const std::string& text) { return text.empty() ? std::nullopt : std::optional(text); };
  const OwnTitles& titles = options.titles;
  for (const auto& [option, value] : {std::pair{"--students", options.class_set.students},
                                      {"--count", options.class_set.count},
                                      {"--givens", options.givens_file},
                                      {"--format", options.format},
                                      {"--csv", options.csv},
                                      {"--reading", reading},
                                      {"--course", typed(titles.course)},
                                      {"--author", typed(titles.author)},
                                      {"--title", typed(titles.title)},
                                      {"--sheet-number", typed(titles.sheet_number)},
                                      {"--lang", language},
                                      {"--out", options.folder}})
    if (value) text_ += std::string(" ") + option + " " + quoted(*value);
  text_ += options.class_set.booklet ? " --booklet\n" : "\n";
}

void ClassRecord::demand_same_in(const std::filesystem::path& folder) const {
  std::ifstream in(folder / file_name, std::ios::binary);
  std::string held;
  if (!in || !std::getline(in, held)) return;
  if (held.ends_with(" \\")) held.resize(held.size() - 2);
  if (held == lots_) return;
  throw WrongUsage(format_words(
      "{} holds the class of another command ({}); choose another --out, or delete the folder",
      "{} contiene la classe di un altro comando ({}); scegliere un'altra --out, o cancellare la cartella",
      folder.string(), held));
}

void ClassRecord::write_to(const std::filesystem::path& folder) const {
  drawings::write_whole(folder / file_name, text_);
}

}  // namespace epure
