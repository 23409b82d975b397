// What epure does. Each verb returns the text for standard output; exceptions say why it cannot.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/options.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/checked.h"

namespace epure {

std::string list(const Catalogue& exercises, const Options& options);

// The text for standard output, what else is to be said (a sentence each, for standard error), and the exit code.
struct Outcome {
  std::string text;
  Exit exit = Exit::success;
  std::vector<Words> remarks = {};  // why it is no success
  std::vector<Words> notes = {};    // of a success too
};

// Writes its files before it returns, or none when one cannot be rendered. A sheet on which something could not be
// decided is left out, with a remark: throws geometry::Undecided when no sheet is left. With --times a line on `err`
// says where the time went.
Outcome draw(const Catalogue& exercises, const Options& options, std::ostream& err);

Outcome check(const Catalogue& exercises, const Options& options);

// What exercises that were checked come to; and why sheets were not drawn, once for an exercise, as its other sheets
// mostly fail for the same reason.
Exit exit_of(const std::vector<CheckedExercise>& all);
std::vector<Words> sheets_not_drawn(const std::vector<CheckedExercise>& all);

// Writes the document and its figures, or none of them. It exits as check does.
Outcome report(const Catalogue& exercises, const Options& options);

// Writes its file. What could not be decided is left out, and named in remarks.
Outcome booklet(const Catalogue& exercises, const Options& options);

// Writes each line, to `out` or a file, as soon as it and those before it are found; the text returned is empty. Who
// reads `out` may stop reading.
Outcome sweep(const Catalogue& exercises, const Options& options, std::ostream& out, std::ostream& err,
              const Surroundings& surroundings);
// Writes the files of each student as they are made, and the key at the end.
Outcome make_class(const Catalogue& exercises, const Options& options, std::ostream& err,
                   const Surroundings& surroundings);

// Writes the file of -o, if there is one. What could not be decided is named in remarks.
Outcome mark(const Catalogue& exercises, const Options& options);

// Writes the file of -o, if there is one.
Outcome import_text(const Options& options);

// "en" or "it". Throws WrongUsage.
Language language(const Options& options);

}  // namespace epure
