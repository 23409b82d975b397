// Finding exercises and sheets by the names a user types.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/proof/exercise.h"

namespace epure {

// The user asked for something that does not exist; the message is one sentence (exit code 2).
struct WrongUsage : Told {
  using Told::Told;
};

const Exercise& find_exercise(const Catalogue& exercises, const std::string& id);

// Of one of its sheets.
const Words& title_of_sheet(const Exercise& exercise, const std::string& sheet);

// A name as a program types it beside the letters of the sheet: "omega_3" and "ω₃".
struct NameAndLetters {
  std::string name, letters;
};
// The name that was typed, by itself or by its letters; what is neither stays as typed. Throws WrongUsage when the
// letters belong to several names.
std::string ascii_name(const std::string& typed, const std::vector<NameAndLetters>& known);

// Of quantities, "ω₃" and, as one copies it from a sheet, "ω_3".
std::vector<NameAndLetters> quantity_names(const std::vector<Quantity>& quantities);

// The givens' names beside their letters, as plain text, and beside the other names they have.
std::vector<NameAndLetters> given_names(const Exercise& exercise);

// The symbol of the given that is meant by this name, its letters or another name of it, in the first of the
// exercises that has one; none: there is none. Throws as ascii_name.
std::optional<std::string> given_meant(const std::string& name, const std::vector<const Exercise*>& exercises);
// Of all of them, each once.
std::vector<std::string> symbols_of(const std::vector<const Exercise*>& exercises);
// "four-bar", or "any exercise named".
Words names_of(const std::vector<const Exercise*>& exercises);

// The exercises named, each once, in the order named; "all" stands for all of them.
std::vector<const Exercise*> find_exercises(const Catalogue& exercises, const std::vector<std::string>& ids);

// What to draw of an exercise: one sheet, or all of them.
struct Target {
  const Exercise* exercise;
  std::string sheet = {};  // empty: all
  std::vector<std::string> sheets() const;
  std::string file_stem() const;  // "ID" or "ID-SHEET"
};
// The same for ID and ID/SHEET.
std::vector<Target> find_targets(const Catalogue& exercises, const std::vector<std::string>& names);

// The givens of each exercise, with the assignments that apply to it. Throws WrongUsage for an assignment that
// applies to none of them, or is made twice; BadGivens as Givens does.
std::vector<Givens> set_givens(const std::vector<const Exercise*>& exercises,
                               const std::vector<std::string>& assignments);

}  // namespace epure
