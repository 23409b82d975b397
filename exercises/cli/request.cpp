#include "exercises/cli/request.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>

#include "drawings/output.h"
#include "drawings/text/text.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/utf8.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/statement/suggest.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

std::optional<Format> format_named(const std::string& typed) {
  const std::string name = lower_case(typed);
  if (name == "pdf") return Format::pdf;
  if (name == "svg") return Format::svg;
  if (name == "html") return Format::html;
  if (name == "png") return Format::png;
  if (name == "eps") return Format::eps;
  if (name == "pdf+tex" || name == "tex") return Format::tex;
  if (name == "csv") return Format::csv;
  return std::nullopt;
}

drawings::Paper paper(const Options& options) {
  const std::string name = lower_case(options.paper);
  if (name == "a4") return drawings::Paper::a4;
  if (name == "a3") return drawings::Paper::a3;
  throw WrongUsage(format_words("\"{}\" is no paper of epure; choose a4 or a3",
                                "\"{}\" non è una carta di epure; scegliere a4 o a3", options.paper));
}

// Beyond them no figure of a metre or of a kilometre is of any use, and the drawing's arithmetic need not hold.
constexpr int largest_scale = 1000000;

// In millimetres of paper.
Rational reading_mm(const Options& options) {
  Rational length;
  try {
    length = geometry::parse_given(options.reading, "mm");
  } catch (const geometry::BadGiven& unreadable) {
    throw WrongUsage("--reading: " + unreadable.words());
  }
  const Rational too_long = 1000;
  if (length > 0 && length < too_long) return length;
  throw WrongUsage(format_words("--reading {}: must be positive and below 1000 mm",
                                "--reading {}: dev'essere positivo e minore di 1000 mm", options.reading));
}

std::optional<Format> format_by_ending(const Options& options) {
  const std::string ending = std::filesystem::path(*options.file).extension().string();
  return ending.empty() ? std::nullopt : format_named(ending.substr(1));
}

}  // namespace

Rational scale_of_lengths(std::string text) {
  const std::string typed = text;
  if (const auto colon = text.find(':'); colon != std::string::npos) text[colon] = '/';
  Rational ratio = 0;
  try {
    ratio = geometry::parse_given(text, "1");
  } catch (const geometry::BadGiven&) {
    // the sentence below says what a scale looks like
  }
  if (ratio > largest_scale || (ratio > 0 && ratio * largest_scale < 1))
    throw WrongUsage(format_words("{}: a scale must lie between 1:{} and {}:1",
                                  "{}: una scala dev'essere tra 1:{} e {}:1", typed, largest_scale, largest_scale));
  if (ratio > 0) return ratio;
  throw WrongUsage(format_words("\"{}\" is no scale; write 1:5, 1/5 or 2:1",
                                "\"{}\" non è una scala; scrivere 1:5, 1/5 o 2:1", typed));
}

namespace {

// What fits the title block, and is a line of letters.
OwnTitles titles(const Options& options) {
  constexpr std::size_t line = 120, field = 8;  // characters
  const OwnTitles& all = options.titles;
  for (const auto& [option, text, most] : {std::tuple{"--course", all.course, line},
                                           {"--author", all.author, line},
                                           {"--title", all.title, line},
                                           {"--sheet-number", all.sheet_number, field}}) {
    const std::size_t length = count_characters(text);
    if (length > most)
      throw WrongUsage(format_words("{} has {} characters, and the title block has room for {}",
                                    "{} ha {} caratteri, e il riquadro delle iscrizioni ne tiene {}",
                                    std::string(option), length, most));
    if (printable(text) != text)
      throw WrongUsage(format_words("{} \"{}\": must be a line of printable letters",
                                    "{} \"{}\": dev'essere una riga di caratteri stampabili", std::string(option),
                                    text));
    if (!drawings::can_write(text))
      throw WrongUsage(
          format_words("{} \"{}\": epure's fonts have Latin, Greek and Cyrillic letters, and one of these "
                       "is none of them",
                       "{} \"{}\": i caratteri di epure hanno lettere latine, greche e cirilliche, e una "
                       "di queste non lo è",
                       std::string(option), text));
  }
  return all;
}

void demand_file_for_tex(const Options& options) {
  if (is_standard_output(options))
    throw WrongUsage(
        "--format pdf+tex writes two files, and standard output is one; name a file, such as -o figure.tex",
        "--format pdf+tex scrive due file, e lo standard output è uno; nominare un file, come -o "
        "figura.tex");
  demand_name_for_tex("-o", std::filesystem::path(*options.file).filename().string());
}

}  // namespace

void demand_name_for_tex(const std::string& option, const std::string& name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '-';
  };
  if (!std::all_of(name.begin(), name.end(), is_plain))
    throw WrongUsage(
        format_words("{} \"{}\": a file for TeX has a name of letters without accents, digits, . _ and -",
                     "{} \"{}\": un file per TeX ha un nome di lettere senza accenti, cifre, . _ e -", option, name));
}

std::vector<Format> formats_of(const Options& options) {
  if (!options.format) return {Format::pdf, Format::svg};
  std::vector<Format> formats;
  std::string rest = *options.format + ",";
  for (auto comma = rest.find(','); comma != std::string::npos; comma = rest.find(',')) {
    const auto format = format_named(rest.substr(0, comma));
    if (!format)
      throw WrongUsage(
          format_words("\"{}\" is no format of epure; choose among pdf, svg, html, png, eps, pdf+tex and csv",
                       "\"{}\" non è un formato di epure; scegliere fra pdf, svg, html, png, eps, pdf+tex e csv",
                       *options.format));
    if (std::find(formats.begin(), formats.end(), *format) == formats.end()) formats.push_back(*format);
    rest.erase(0, comma + 1);
  }
  return formats;
}

bool is_standard_output(const Options& options) {
  return options.file && drawings::is_standard_output(*options.file);
}

Format format_of_file(const Options& options) {
  std::error_code is_not_there;
  if (options.file->ends_with('/') || std::filesystem::is_directory(*options.file, is_not_there))
    throw WrongUsage(format_words("-o names one file, and \"{}\" is a folder; for files in a folder use --out \"{}\"",
                                  "-o nomina un solo file, e \"{}\" è una cartella; per file in una cartella usare "
                                  "--out \"{}\"",
                                  *options.file, *options.file));
  const auto by_ending = format_by_ending(options);
  if (!options.format) {
    if (by_ending) return *by_ending;
    if (is_standard_output(options)) return Format::pdf;
    throw WrongUsage(format_words(
        "\"{}\" tells no format; end it in .pdf, .svg, .html, .png, .eps, .tex or .csv, or add --format",
        "\"{}\" non dice il formato; farlo finire in .pdf, .svg, .html, .png, .eps, .tex o .csv, o aggiungere "
        "--format",
        *options.file));
  }
  const std::vector<Format> asked = formats_of(options);
  if (asked.size() != 1)
    throw WrongUsage("-o writes one file; choose one format, such as --format pdf",
                     "-o scrive un solo file; scegliere un solo formato, come --format pdf");
  if (by_ending && *by_ending != asked.front())
    throw WrongUsage(format_words("\"{}\" is not the ending of --format {}",
                                  "\"{}\" non finisce come vuole --format {}", *options.file, *options.format));
  return asked.front();
}

void refuse_ending_of_others(const Options& options, const Words& written) {
  if (!options.file || is_standard_output(options)) return;
  static const std::set<std::string> known{".pdf", ".svg", ".html", ".png",   ".eps",    ".tex",
                                           ".csv", ".md",  ".json", ".jsonl", ".ndjson", ".xml"};
  const std::string ending = lower_case(std::filesystem::path(*options.file).extension().string());
  if (known.contains(ending))
    throw WrongUsage(format_words("\"{}\" ends as another format does; what is written here is {}",
                                  "\"{}\" finisce come un altro formato; qui si scrive {}", *options.file, written));
}

bool is_asked_for(Format format, const Options& options) {
  const std::vector<Format> asked = options.file ? std::vector{format_of_file(options)} : formats_of(options);
  return std::find(asked.begin(), asked.end(), format) != asked.end();
}

namespace {

void demand_steps_are_shown(const Options& options) {
  if (!options.steps) return;
  if (options.blank)
    throw WrongUsage("--blank draws the sheet to be solved, which has no --steps; choose one of them",
                     "--blank disegna la tavola da svolgere, che non ha passi (--steps); scegliere uno dei due");
  for (const Format format : {Format::png, Format::eps, Format::tex, Format::csv})
    if (is_asked_for(format, options))
      throw WrongUsage(
          "--steps makes a page of a PDF, a class in an SVG and a place of the slider in HTML of each step; other "
          "formats hold one picture, so choose among pdf, svg and html",
          "--steps fa di ogni passo una pagina di un PDF, una classe in un SVG e un posto del cursore in HTML; gli "
          "altri formati tengono una figura sola: scegliere fra pdf, svg e html");
}

}  // namespace

void demand_sensible_output(const Options& options) {
  demand_steps_are_shown(options);
  if (options.folder && options.folder->empty())
    throw WrongUsage("--out \"\" names no folder; name one, such as . or out",
                     "--out \"\" non nomina una cartella; nominarne una, come . o out");
  if (!options.file) {
    formats_of(options);
    return;
  }
  if (options.folder)
    throw WrongUsage("-o names one file and --out a folder; choose one of them",
                     "-o nomina un file e --out una cartella; scegliere uno dei due");
  if (format_of_file(options) == Format::tex) demand_file_for_tex(options);
}

SheetRequest sheet_request(const Options& options) {
  SheetRequest request{.paper = paper(options),
                       .language = language(options),
                       .bare = options.bare,
                       .blank = options.blank,
                       .titles = titles(options)};
  if (options.scale) request.scale = scale_of_lengths(*options.scale);
  return request;
}

CsvStyle csv_style(const Options& options) {
  const std::string style = lower_case(options.csv.value_or("plain"));
  if (style != "plain" && style != "excel")
    throw WrongUsage(format_words("--csv: \"{}\" is no style of epure's; choose plain or excel",
                                  "--csv: \"{}\" non è uno stile di epure; scegliere plain o excel", *options.csv));
  return {style == "excel"};
}

double seconds_of(const Options& options) {
  Rational seconds = 0;
  const Rational longest = 3600;
  try {
    seconds = geometry::parse_given(options.seconds, "s");
  } catch (const geometry::BadGiven& unreadable) {
    throw WrongUsage("--seconds: " + unreadable.words());
  }
  if (seconds > 0 && seconds <= longest) return CGAL::to_double(seconds);
  throw WrongUsage(format_words("--seconds {}: must be positive and at most 3600 s",
                                "--seconds {}: dev'essere positivo e al massimo 3600 s", options.seconds));
}

Ruler ruler_asked(const std::vector<const Exercise*>& exercises, const Options& options) {
  Ruler ruler{.reading_mm = reading_mm(options), .sheet = options.sheet.value_or("")};
  if (options.scale) ruler.scales.push_back({*dimension_of("m"), 1 / (1000 * scale_of_lengths(*options.scale))});
  if (!options.sheet) return ruler;
  std::vector<std::string> sheets;
  for (const Exercise* exercise : exercises)
    for (const SheetSpec& spec : exercise->about().sheets) sheets.push_back(spec.name);
  if (std::find(sheets.begin(), sheets.end(), ruler.sheet) == sheets.end())
    throw WrongUsage(format_words("--sheet: there is no sheet \"{}\"; {}", "--sheet: non c'è la tavola \"{}\"; {}",
                                  ruler.sheet, did_you_mean(ruler.sheet, sheets)));
  return ruler;
}

}  // namespace epure
