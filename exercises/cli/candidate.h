// The students of a class, as a roster lists them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/csv_reader.h"

namespace epure {

struct Candidate {
  std::string number, name;
  std::string file;                           // the number, fit for the name of a file
  std::vector<std::string> assignments = {};  // givens of his own, as --set takes them
  Words place = {};                           // where these stand: "variants.csv, line 3"
};

// A row each, out of the columns of numbers and names (student_columns.h). Throws BadTable: a column is missing, a
// number is missing, is there twice, or looks like another's in the name of a file; a name or number that is no line
// of at most 80 printable characters. Other columns are left alone.
std::vector<Candidate> candidates_of(const CsvTable& roster);

// The same of a table of variants, which may have no numbers: then they are counted. Each other column is headed by a
// given (its symbol, letters or another name), whose cells are its values. An empty cell leaves the given as it is.
// Throws as above, and for a column that is a given of none of the exercises, or the second of one.
std::vector<Candidate> variants_of(const CsvTable& table, const std::vector<const Exercise*>& exercises);

// Students without names, numbered from 1.
std::vector<Candidate> numbered_candidates(std::size_t count);

}  // namespace epure
