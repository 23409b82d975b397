// What of a class set is finished, so that a run that was stopped goes on where it stood.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "exercises/cli/variant.h"

namespace epure {

// What is known of a student once his files are written.
struct ClassEntry {
  std::vector<std::string> givens;  // what varies, as --set takes it
  std::vector<std::string> values;  // of the exercise's quantities, one after the other; empty: there is none
  std::vector<std::string> scales;  // of lengths, sheet after sheet; empty: it shows none
  std::string remarks;              // of the key: why values are missing
  std::string question;             // of a question bank
  Rejections rejected;
};

// A line for each student in the file unfinished.jsonl of the folder, after a line that says of what run they are. A
// journal of another run is begun anew; a line that was cut short, or changed by anybody, counts for nothing. Several
// threads may use it.
class ClassJournal {
 public:
  // Makes the folder, and clears away the drafts that a killed run left in it. Throws drawings::CannotWrite.
  ClassJournal(const std::filesystem::path& folder, const std::string& inputs);

  // None: he has still to be drawn.
  const ClassEntry* entry_of(const Candidate& student) const;
  void add(const Candidate& student, const ClassEntry& entry);
  // All is done.
  void remove() const;

 private:
  static std::string name_of(const Candidate& student);
  void write(const std::string& line);

  std::filesystem::path path_;
  std::map<std::string, ClassEntry> entries_;
  std::mutex one_at_a_time_;
};

}  // namespace epure
