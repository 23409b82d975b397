// What a class answered, row by row, and to which givens.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/csv_reader.h"
#include "exercises/kit/proof/measured.h"

namespace epure {

// A value as a key states it: the file's cell, and in which line.
struct KeyValue {
  std::string quantity, text;
  std::size_t line;
};

struct Student {
  std::string number, name;           // as in the file
  std::optional<Givens> givens = {};  // none: why is the first remark
  std::vector<PaperScale> scales = {};
  SheetScales sheets = {};                // at which scale they were drawn for him
  std::vector<std::string> answers = {};  // to each quantity asked, with its unit; empty: none
  std::vector<KeyValue> key = {};
  std::vector<Words> remarks = {};  // what could not be read
};

struct Answers {
  std::vector<Quantity> asked;  // what there are columns for
  std::vector<Student> students;
  std::vector<Student> absent = {};      // whose numbers the key has and the answers have not, with their names
  std::vector<std::string> sheets = {};  // that were handed out, as the key says; empty: it says nothing
  std::vector<Words> remarks = {};       // on the tables as wholes
};

// "1:5"; "1 cm = 2 m/s" (or with ≙); "2 m/s per cm" (Italian "al cm"). Throws geometry::BadGiven and WrongUsage.
PaperScale read_paper_scale(const std::string& text);

// `answers` has a column for each quantity asked, under its name or letters, with a unit in brackets if it is not the
// quantity's own ("v_B [cm/s]"), and as it likes: number, name, date, scale and scale_... (of lengths, velocities ...
// on the student's own paper), and givens. `key` has number, and as it likes name, date, givens (under their symbols)
// and quantities, whose values are kept to be compared. With a key the givens are the key's. What neither of them
// states is as in `otherwise`. Which column is what: answer_columns.h; whose row of the key it is: key_rows.h.
//
// The key's `scale SHEET` says at which scale a student's sheet was drawn. Of a number that the student was not sure
// of ("circa 3.2", "~3.2", "3.2?") the number counts, and a remark tells it.
//
// A given or a scale that cannot be read is a remark of the student; a column that is none of these, one on the
// table. Throws BadTable for columns that stand there twice or are nearly one of these, a number that is missing or
// there twice, answers without any quantity, and a key that has none of the students or is none of this exercise.
Answers read_answers(const Exercise& exercise, const CsvTable& answers, const CsvTable* key, const Givens& otherwise);

}  // namespace epure
