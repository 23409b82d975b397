#include "exercises/cli/givens_file.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

constexpr const char* blanks = " \t\r";

// Nothing, or a comment.
bool says_nothing(const std::string& line) {
  const auto first = line.find_first_not_of(blanks);
  return first == std::string::npos || line[first] == '#' || line[first] == ';';
}

// A header holds names, and no name has such a sign.
bool is_of_lines(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (says_nothing(line)) continue;
    if (names_separator(line.substr(0, line.find('\r')))) return false;
    return line.find('=') != std::string::npos || line.find('[') != std::string::npos;
  }
  return false;
}

// One line at a time, as CLI11 does not say which one it cannot read; and without its arrays, which would part
// "0,25".
std::pair<std::string, std::string> read_line(const std::string& line) {
  CLI::ConfigTOML reader;  // whose comments begin with #, also behind a value
  reader.arrayBounds('\1', '\1')->parentSeparator('\1');
  std::istringstream in(line);
  const std::vector<CLI::ConfigItem> items = reader.from_config(in);
  if (items.size() != 1 || items.front().inputs.size() != 1) return {};
  return {items.front().name, items.front().inputs.front()};
}

std::string symbol_in(const std::string& assignment) { return assignment.substr(0, assignment.find('=')); }

class LinesReader {
 public:
  LinesReader(const std::string& file, const std::vector<const Exercise*>& exercises)
      : file_(file), exercises_(exercises) {
    row_.place = {file, file};
  }

  Candidate read(const std::string& text) && {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      ++number_;
      if (!says_nothing(line)) add(line);
    }
    return std::move(row_);
  }

 private:
  void add(const std::string& line) {
    if (line.find('[') == line.find_first_not_of(blanks))
      refuse({"sections are not for givens; write each as symbol = value",
              "i dati non hanno sezioni; scrivere ciascuno come simbolo = valore"});
    const auto [name, value] =
        line.find('=') == std::string::npos ? std::pair<std::string, std::string>{} : read_line(line);
    if (name.empty() || value.empty())
      refuse(format_words("\"{}\" is no given; write symbol = value, such as r = 25 cm",
                          "\"{}\" non è un dato; scrivere simbolo = valore, come r = 25 cm",
                          line.substr(0, line.find_last_not_of(blanks) + 1)));
    const auto symbol = given_meant(name, exercises_);
    if (!symbol)
      refuse(format_words("\"{}\" is no given of {}; {}", "\"{}\" non è un dato di {}; {}", name,
                          names_of(exercises_), did_you_mean(name, symbols_of(exercises_))));
    const auto same = [&](const std::string& before) { return symbol_in(before) == *symbol; };
    if (std::any_of(row_.assignments.begin(), row_.assignments.end(), same))
      refuse(format_words("{} is given a second time; which value is meant?",
                          "{} è dato una seconda volta; quale valore si intende?", *symbol));
    row_.assignments.push_back(*symbol + "=" + value);
    demand_value(row_.assignments.back());
  }

  void demand_value(const std::string& assignment) const {
    try {
      set_givens(exercises_, {assignment});
    } catch (const BadGivens& why) {
      refuse(why.words());
    }
  }

  [[noreturn]] void refuse(const Words& why) const { refuse_line(file_, number_, why); }

  const std::string& file_;
  const std::vector<const Exercise*>& exercises_;
  Candidate row_{"1", "", "1"};
  std::size_t number_ = 0;
};

void demand_free(const Candidate& row, const std::vector<const Exercise*>& exercises,
                 const std::vector<std::string>& set) {
  for (const std::string& assignment : set) {
    const std::string symbol = given_meant(symbol_in(assignment), exercises).value_or("");
    for (const std::string& own : row.assignments)
      if (symbol_in(own) == symbol)
        throw BadTable(
            in_place(row, format_words("{} has a value here, and --set {} gives it one too; which is meant?",
                                       "{} ha un valore qui, e anche --set {} gliene dà uno; quale si "
                                       "intende?",
                                       symbol, assignment)));
  }
}

}  // namespace

GivensFile read_givens_file(const std::string& path, const std::vector<const Exercise*>& exercises,
                            const std::vector<std::string>& set) {
  const std::string text = read_text_file(path);
  GivensFile file;
  file.is_table = !is_of_lines(text);
  if (file.is_table)
    file.rows = variants_of(read_csv(text, path), exercises);
  else
    file.rows = {LinesReader(path, exercises).read(text)};
  for (const Candidate& row : file.rows) {
    demand_free(row, exercises, set);
    givens_in(row, exercises, set);
  }
  return file;
}

std::vector<Givens> givens_in(const Candidate& row, const std::vector<const Exercise*>& exercises,
                              const std::vector<std::string>& set) {
  std::vector<std::string> all = set;
  all.insert(all.end(), row.assignments.begin(), row.assignments.end());
  try {
    return set_givens(exercises, all);
  } catch (const BadGivens& why) {
    throw BadGivens(in_place(row, why.words()));
  }
}

Words in_place(const Candidate& row, const Words& sentence) {
  return row.place.empty() ? sentence : row.place + ": " + sentence;
}

}  // namespace epure
