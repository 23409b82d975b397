// What a user can ask for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/cli/help_page.h"
#include "exercises/kit/proof/exercise.h"

namespace epure {

// Of a class set: who is in it, and the seed of the lots.
struct ClassOptions {
  std::optional<std::string> students, count;
  std::string seed = "1";
  bool booklet = false;  // all in one PDF too
};

// What a drawing is to be like where it is put into a document.
struct DocumentOptions {
  std::optional<std::string> width, height, dpi, background, ink;
};

// Texts as typed; what they mean is found where they are used, because their parsing must not depend on a locale.
struct Options {
  enum class Verb {
    list,
    draw,
    check,
    report,
    booklet,
    make_class,
    mark,
    sweep,
    import_text,
    bench
  } verb = Verb::list;
  std::vector<std::string> names;  // ID, ID/SHEET, all
  std::string mechanisms = {};     // what the files say that are named, one after the other
  std::vector<std::string> assignments, measured;
  std::optional<std::string> givens_file;
  std::vector<std::string> variations, quantities;  // of a sweep, a class
  std::optional<std::string> part, chart;
  std::optional<std::string> format, folder, file, scale, name;
  std::optional<std::string> sheet, answers, key, points, out_of, csv;
  std::string paper = "a4", language = "en", reading = "0.5mm", arithmetic = "exact", seconds = "60",
              slip_points = "0.5";
  bool bare = false, blank = false, steps = false, json = false, times = false, quiet = false;
  OwnTitles titles = {};
  DocumentOptions document = {};
  ClassOptions class_set = {};
  bool colours = false;  // of the terminal, not typed
};

// What may stand first, in the order of the help.
const std::vector<std::string>& verbs();

// What --help says of a verb, or of the program (empty).
HelpPage help_page(const std::string& verb, Language language);

// Either the options, or a text to show instead (help, version). Throws WrongUsage.
struct Parsed {
  Options options;
  std::optional<std::string> text = {};
};
// `language`: what --lang says otherwise; empty: English. An exercise where the verb should be is answered as such.
Parsed parse_options(const Catalogue& exercises, const std::vector<std::string>& arguments,
                     const std::string& language);

// The language of a refusal, also of arguments that cannot be parsed: what the last --lang says, else `otherwise`.
// What is no language of epure is answered in English.
Language language_of_messages(const std::vector<std::string>& arguments, const std::string& otherwise);

}  // namespace epure
