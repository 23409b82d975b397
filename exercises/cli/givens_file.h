// Givens from a file, as --givens names it.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/candidate.h"

namespace epure {

// Either a table, which begins with the names of its columns (variants_of says of which), or lines that the reader of
// INI and TOML files in CLI11 takes, "r = 25 cm", which are one row; # begins a comment.
struct GivensFile {
  std::vector<Candidate> rows;
  bool is_table = false;
};

// `set`: what --set says, of which the file must not say anything else. Throws BadTable, with the file and the line,
// for what cannot be read, is no given of any of the exercises, is no value of it, or is there twice.
GivensFile read_givens_file(const std::string& path, const std::vector<const Exercise*>& exercises,
                            const std::vector<std::string>& set);

// Of each exercise, with what --set and the row say. A sentence of what they cannot be together begins with the row's
// place. Throws as set_givens.
std::vector<Givens> givens_in(const Candidate& row, const std::vector<const Exercise*>& exercises,
                              const std::vector<std::string>& set);

// The sentence, behind the row's place where it has one.
Words in_place(const Candidate& row, const Words& sentence);

}  // namespace epure
