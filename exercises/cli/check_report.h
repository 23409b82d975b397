// Checked exercises as text for people and as JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "exercises/cli/candidate.h"
#include "exercises/kit/proof/checked.h"

namespace epure {

// What a report is written for.
struct Reader {
  Language language = Language::english;
  bool colours = false;  // a terminal that shows them
};

// Tables, remarks, and what failed or is undecided. No line is wider than a terminal.
std::string text_report(const CheckedExercise& checked, const Reader& reader);

// The measured numbers alone; nothing when there are none.
std::string measured_report(const CheckedExercise& checked, const Reader& reader);

// "ID: N quantities, M routes, passed", for one of several.
std::string closing_line(const CheckedExercise& checked, const Reader& reader);

// "passed: N quantities; printed: ...": all there is, counted in one line. Who measured is told of that instead of
// what the source printed.
std::string totals(const std::vector<CheckedExercise>& all, const Reader& reader);

// Schema epure.check/1. Its words are English: it is read by programs. `rows`: of each exercise, the row of a table
// that its givens come from; empty: there is no table.
std::string json_report(const std::vector<CheckedExercise>& all, const std::vector<Candidate>& rows = {});

// "within reading" or "beyond reading".
Words verdict(const Measured& measured);

}  // namespace epure
