// A marked class as text for people and as CSV for spreadsheets.
#pragma once

#include <string>

#include "exercises/cli/check_report.h"
#include "exercises/cli/marking.h"
#include "exercises/kit/statement/csv_style.h"

namespace epure {

// A line for each student, each answer that is not right, the tolerances, who is absent, and totals; none wider than
// a terminal.
std::string mark_report(const Exercise& exercise, const Answers& answers, const Marking& marking,
                        const MarkingRules& rules, const Reader& reader);

// Number, name, for each quantity its points and its verdict, total, the mark where one is asked for, remarks. Who is
// in the key and has no answers comes last, without points. A number or name that a spreadsheet
// would take for a formula, as it begins with = + - or @, stands behind an apostrophe.
std::string mark_csv(const Answers& answers, const Marking& marking, const MarkingRules& rules, const CsvStyle& style,
                     Language language);

}  // namespace epure
