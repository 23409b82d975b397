// The options of verbs, understood. All throw WrongUsage.
#pragma once

#include <vector>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/options.h"
#include "exercises/kit/proof/measured.h"
#include "exercises/kit/statement/csv_style.h"

namespace epure {

enum class Format { pdf, svg, html, png, eps, tex, csv };  // tex: what sets the letters, and a PDF without them

// What --format asks for, each once; PDF and SVG when it says nothing.
std::vector<Format> formats_of(const Options& options);

// The format of the one file -o names: from its ending, else from --format, else (standard output only) PDF.
Format format_of_file(const Options& options);

// Whether it asks for this format, or -o does.
bool is_asked_for(Format format, const Options& options);

// -o - and its other names.
bool is_standard_output(const Options& options);

// The file that -o names may not end as files of another format do than the verb writes: "csv, json or html".
void refuse_ending_of_others(const Options& options, const Words& written);

// --out and -o exclude each other, and the formats must be clear, before anything is drawn.
void demand_sensible_output(const Options& options);

// Two files stand beside each other for TeX, and one of them names the other: in letters that TeX takes for
// themselves.
void demand_name_for_tex(const std::string& option, const std::string& name);

// "1:5" and "1/5" are one fifth, "2:1" is two.
Rational scale_of_lengths(std::string text);

SheetRequest sheet_request(const Options& options);

// --reading, --sheet and --scale, for exercises one of which must have the sheet.
Ruler ruler_asked(const std::vector<const Exercise*>& exercises, const Options& options);

// --csv: plain, or excel.
CsvStyle csv_style(const Options& options);

// How long `bench` is to measure.
double seconds_of(const Options& options);

}  // namespace epure
