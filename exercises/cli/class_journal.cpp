#include "exercises/cli/class_journal.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>

#include "drawings/files/left_drafts.h"
#include "drawings/files/system_words.h"
#include "drawings/output.h"

namespace epure {
namespace {

std::string record_of(const std::string& student, const ClassEntry& entry) {
  const nlohmann::json record{{"student", student},        {"givens", entry.givens},   {"values", entry.values},
                              {"scales", entry.scales},    {"remarks", entry.remarks}, {"question", entry.question},
                              {"rejected", entry.rejected}};
  return record.dump();
}

// A record behind its check: what a disk or an editor has changed is not taken for a student's.
std::string sealed(const std::string& record) {
  const auto* bytes = reinterpret_cast<const Bytef*>(record.data());
  return fmt::format("{:08x} {}", crc32_z(0, bytes, record.size()), record);
}
bool is_sealed(const std::string& line) {
  constexpr std::size_t check = 9;
  return line.size() > check && sealed(line.substr(check)) == line;
}

}  // namespace

ClassJournal::ClassJournal(const std::filesystem::path& folder, const std::string& inputs)
    : path_(folder / "unfinished.jsonl") {
  drawings::demand_writable(folder);
  drawings::remove_left_drafts(folder);
  std::ifstream in(path_, std::ios::binary);
  std::string line;
  if (in && std::getline(in, line) && line == inputs) {
    // What was cut short has no line's end, or another check.
    while (std::getline(in, line) && !in.eof()) {
      if (!is_sealed(line)) continue;
      const auto found = nlohmann::json::parse(line.substr(line.find(' ')));
      entries_[found["student"]] = {found["givens"],  found["values"],   found["scales"],
                                    found["remarks"], found["question"], found["rejected"]};
    }
  }
  in.close();
  // Begun anew also where it goes on: what was cut short must not run into the next line.
  std::string text = inputs + "\n";
  for (const auto& [student, entry] : entries_) text += sealed(record_of(student, entry)) + "\n";
  drawings::write_whole(path_, text);
}

std::string ClassJournal::name_of(const Candidate& student) {
  return nlohmann::json{student.number, student.name, student.assignments}.dump();
}

const ClassEntry* ClassJournal::entry_of(const Candidate& student) const {
  const auto found = entries_.find(name_of(student));
  return found == entries_.end() ? nullptr : &found->second;
}

void ClassJournal::add(const Candidate& student, const ClassEntry& entry) {
  write(sealed(record_of(name_of(student), entry)) + "\n");
}

void ClassJournal::write(const std::string& line) {
  const std::scoped_lock lock(one_at_a_time_);
  errno = 0;
  std::ofstream out(path_, std::ios::binary | std::ios::app);
  out << line << std::flush;
  if (!out)
    throw drawings::CannotWrite(Words{"cannot write to ", "impossibile scrivere su "} + path_.string() +
                                (errno == 0 ? Words{} : ": " + drawings::system_words(errno)));
}

void ClassJournal::remove() const {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace epure
