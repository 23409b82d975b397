#include "exercises/cli/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/help.h"
#include "exercises/cli/version.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/suggest.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

// "r=25cm" of "r = 25cm ", "phi=0..360/3" of "phi = 0 .. 360 / 3".
std::string without_blanks_about(const std::vector<std::string>& signs, const std::string& typed) {
  std::string text = geometry::in_plain_characters(typed);
  std::replace(text.begin(), text.end(), '\t', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
  for (const std::string& sign : signs)
    for (auto at = text.find(sign); at != std::string::npos; at = text.find(sign, at + sign.size())) {
      for (; at > 0 && text[at - 1] == ' '; --at) text.erase(at - 1, 1);
      const std::size_t after = at + sign.size();
      while (after < text.size() && text[after] == ' ') text.erase(after, 1);
    }
  return text;
}

// CLI11 reads the options. What it would say of them depends on its version and is English: the help and the
// refusals are our own.
class Parser {
 public:
  Parser(Options& options, Language language) : options_(options), language_(language) {
    program_.require_subcommand(0, 1);  // none is answered here, in our own words
    program_
        .set_version_flag(
            "--version,-V", version_for_people,
            say({"print the version, and those of the libraries", "mostra la versione, e quelle delle librerie"}))
        ->disable_flag_override();
    prepare(program_);
    add_list();
    add_draw();
    add_check();
    add_report();
    add_booklet();
    add_sweep();
    add_class();
    add_mark();
    add_import();
    add_bench();
  }

  void parse(const std::vector<std::string>& arguments) {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 wants them
    program_.parse(reversed);
    if (const auto before = program_.remaining(false); !before.empty()) refuse_before_verb(before.front());
    if (const auto left = chosen().remaining(false); !left.empty()) refuse(left.front());
  }

  // The verb that was typed; the program itself when there is none.
  const CLI::App& chosen() const {
    const auto found = program_.get_subcommands();
    return found.empty() ? program_ : *found.front();
  }

  HelpPage help_page(const CLI::App& app) const;
  HelpPage help_page(const std::string& verb) const {
    return help_page(verb.empty() ? program_ : *program_.get_subcommand(verb));
  }

  // Why the argument, or the option that CLI11's sentence names, cannot be read.
  [[noreturn]] void refuse(const std::string& typed) const;
  [[noreturn]] void refuse_before_verb(const std::string& typed) const;
  [[noreturn]] void refuse_value(const std::string& of_cli11) const;

 private:
  std::string say(const Words& words) const { return words.in(language_); }

  void prepare(CLI::App& app) {
    app.set_help_flag("--help,-h", say({"print this help", "mostra questo aiuto"}))->disable_flag_override();
    app.allow_extras();  // refused by ourselves
  }
  CLI::App& add_verb(const std::string& name) {
    CLI::App& verb = *program_.add_subcommand(name);
    prepare(verb);
    return verb;
  }

  template <class Value>
  void add(CLI::App& verb, const std::string& name, Value& value, const Words& type, const Words& meaning) {
    verb.add_option(name, value, say(meaning))->type_name(say(type));
  }
  // One that may be repeated and takes one value each time, so that what follows the value is a name again.
  void add_repeatable(CLI::App& verb, const std::string& name, std::vector<std::string>& values, const Words& type,
                      const Words& meaning, const std::vector<std::string>& signs = {"="}) {
    verb.add_option(name, values, say(meaning))
        ->transform([signs](const std::string& typed) { return without_blanks_about(signs, typed); })
        ->allow_extra_args(false)
        ->type_name(say(type));
  }

  // Values of a given, from one to another or one by one.
  void add_variations(CLI::App& verb, const std::string& name, const Words& type, const Words& meaning) {
    add_repeatable(verb, name, options_.variations, type, meaning, {"=", "..", "|", "/"});
  }

  void add_flag(CLI::App& verb, const std::string& name, bool& value, const Words& meaning) {
    verb.add_flag(name, value, say(meaning))->disable_flag_override();  // --bare=3 would be --bare
  }

  void add_names(CLI::App& verb, const Words& name, const Words& meaning) {
    verb.add_option(say(name), options_.names, say(meaning));
  }
  void add_givens(CLI::App& verb) {
    add_repeatable(verb, "--set", options_.assignments, {"SYMBOL=VALUE[UNIT]", "SIMBOLO=VALORE[UNITÀ]"},
                   {"another value for a given", "un altro valore per un dato"});
  }
  void add_givens_file(CLI::App& verb, const Words& meaning) {
    add(verb, "--givens", options_.givens_file, {"FILE", "FILE"}, meaning);
  }
  void add_language(CLI::App& verb) {
    add(verb, "--lang", options_.language, {"LANGUAGE", "LINGUA"},
        {"en or it (default: EPURE_LANG, else en)", "en o it (predefinita: EPURE_LANG, altrimenti en)"});
  }
  void add_formats(CLI::App& verb, const Words& more = {}) {
    add(verb, "--format", options_.format, {"FORMATS", "FORMATI"},
        Words{"pdf, svg or both (default: pdf,svg)", "pdf, svg o entrambi (predefinito: pdf,svg)"} + more);
  }
  void add_ruler(CLI::App& verb) {
    add(verb, "--reading", options_.reading, {"LENGTH", "LUNGHEZZA"},
        {"how well a ruler is read (default: 0.5mm)", "quanto bene si legge un righello (predefinita: 0,5mm)"});
    add(verb, "--sheet", options_.sheet, {"SHEET", "TAVOLA"},
        {"the sheet that was measured (default: of those that show it the smallest in scale)",
         "la tavola misurata (predefinita: tra quelle che la mostrano la più ridotta)"});
    add(verb, "--scale", options_.scale, {"SCALE", "SCALA"},
        {"scale of lengths of the drawing that was measured, such as 1:5 (default: the sheet's)",
         "scala delle lunghezze del disegno misurato, come 1:5 (predefinita: della tavola)"});
  }
  // Of what is drawn.
  void add_scale(CLI::App& verb, const Words& more = {}) {
    add(verb, "--scale", options_.scale, {"SCALE", "SCALA"},
        Words{"scale of lengths, such as 1:5 (default: the largest standard one",
              "scala delle lunghezze, come 1:5 (predefinita: la maggiore normalizzata"} +
            more + ")");
  }
  void add_folder(CLI::App& verb) {
    add(verb, "--out", options_.folder, {"DIR", "CARTELLA"},
        {"folder to write to (default: out)", "cartella in cui scrivere (predefinita: out)"});
  }
  void add_course(CLI::App& verb) {
    const Words text{"TEXT", "TESTO"};
    OwnTitles& titles = options_.titles;
    add(verb, "--course", titles.course, text,
        {"in the title block: the course", "nel riquadro delle iscrizioni: il corso"});
    add(verb, "--author", titles.author, text, {"beside it: whose sheet it is", "accanto: di chi è la tavola"});
  }
  void add_titles(CLI::App& verb) {
    const Words text{"TEXT", "TESTO"};
    OwnTitles& titles = options_.titles;
    add_course(verb);
    add(verb, "--title", titles.title, text,
        {"instead of the exercise's title", "al posto del titolo dell'esercizio"});
    add(verb, "--sheet-number", titles.sheet_number, text,
        {"instead of 1/4, at most 8 characters", "al posto di 1/4, al massimo 8 caratteri"});
  }
  // Of a verb that has few formats of its own.
  void add_format(CLI::App& verb, const Words& meaning) {
    add(verb, "--format", options_.format, {"FORMAT", "FORMATO"}, meaning);
  }
  void add_file(CLI::App& verb, const Words& meaning) { add(verb, "-o", options_.file, {"FILE", "FILE"}, meaning); }
  void add_csv(CLI::App& verb) {
    add(verb, "--csv", options_.csv, {"STYLE", "STILE"},
        {"plain (default), or excel: semicolons, decimal commas, words by --lang",
         "plain (predefinito), o excel: punti e virgola, virgole decimali, parole di --lang"});
  }
  // What sheets for people have: whose they are, on which paper.
  void add_sheets(CLI::App& verb) {
    add_folder(verb);
    add_paper(verb);
    add_titles(verb);
  }
  void add_paper(CLI::App& verb) {
    add(verb, "--paper", options_.paper, {"PAPER", "CARTA"},
        {"a4 (default) or a3, landscape", "a4 (predefinita) o a3, orizzontale"});
  }

  void add_document(CLI::App& verb) {
    DocumentOptions& of = options_.document;
    add(verb, "--width", of.width, {"LENGTH", "LUNGHEZZA"},
        {"--bare, no wider than this: the largest standard scale at which it is not, such as 120mm",
         "--bare, non più larga di così: la maggiore scala normalizzata con cui non lo è, come 120mm"});
    add(verb, "--height", of.height, {"LENGTH", "LUNGHEZZA"},
        {"the same of its height; both may stand together", "lo stesso per l'altezza; possono stare insieme"});
    add(verb, "--dpi", of.dpi, {"NUMBER", "NUMERO"},
        {"png: dots per inch, 20 to 1200 (default: 150)", "png: punti per pollice, da 20 a 1200 (predefinito: 150)"});
    add(verb, "--background", of.background, {"COLOUR", "COLORE"},
        {"white, none or #rrggbb (default: white; of --bare none)",
         "white, none o #rrggbb (predefinito: white; di --bare none)"});
    add(verb, "--ink", of.ink, {"INK", "INCHIOSTRO"},
        {"dark, or light for dark pages (default: what is read best on the background)",
         "dark, o light per pagine scure (predefinito: ciò che si legge meglio sullo sfondo)"});
  }

  void add_list() {
    CLI::App& verb = add_verb("list");
    add_names(verb, {"ID", "ID"},
              {"an exercise, or a mechanism from a file: show its sheets, givens and quantities",
               "un esercizio, o un meccanismo da file: mostra tavole, dati e grandezze"});
    add_flag(verb, "--json", options_.json,
             {"print all this as JSON (schema epure.list/1)", "stampa tutto ciò in JSON (schema epure.list/1)"});
    add_language(verb);
  }
  void add_draw() {
    CLI::App& verb = add_verb("draw");
    add_names(verb, {"NAME", "NOME"},
              {"exercises, mechanisms from files or single sheets: ID, ID/SHEET, all or scenes",
               "esercizi, meccanismi da file o singole tavole: ID, ID/TAVOLA, all o scenes"});
    add_formats(verb, {"; also html, png, eps, pdf+tex; csv: the long table of a sheet",
                       "; anche html, png, eps, pdf+tex; csv: la tabella lunga di una tavola"});
    add_csv(verb);
    add_file(verb,
             {"write one file instead; - is standard output", "scrive invece un solo file; - è lo standard output"});
    add(verb, "--name", options_.name, {"PATTERN", "MODELLO"},
        {"names of the files, such as {id}-{sheet}-{r}; also {lang}; of a table {number}, {student}, {row}",
         "nomi dei file, come {id}-{sheet}-{r}; anche {lang}; di una tabella {number}, {student}, {row}"});
    add_givens(verb);
    add_givens_file(verb, {"givens from lines such as r = 25 cm; or CSV: a column each, and each row is drawn",
                           "dati da righe come r = 25 cm; o CSV: una colonna ciascuno, e si disegna ogni riga"});
    add_sheets(verb);
    add_scale(verb);
    add_language(verb);
    add_flag(verb, "--bare", options_.bare,
             {"the figure alone: no frame, no column, no title block",
              "la sola figura: senza squadratura, colonna e riquadro delle iscrizioni"});
    add_document(verb);
    add_flag(verb, "--blank", options_.blank,
             {"the sheet to be solved: what is given, the question, an empty table of what is asked",
              "la tavola da svolgere: i dati, il quesito, una tabella vuota di ciò che si chiede"});
    add_flag(verb, "--steps", options_.steps,
             {"a page of the PDF for each step of the construction; in SVG what step 3 draws has the class step-3",
              "una pagina del PDF per ogni passo della costruzione; in SVG ciò che il passo 3 disegna ha la classe "
              "step-3"});
    add_flag(verb, "--times", options_.times,
             {"say on standard error where the time went", "dice sullo standard error dove è andato il tempo"});
  }
  void add_check() {
    CLI::App& verb = add_verb("check");
    add_names(
        verb, {"ID", "ID"},
        {"exercises, or all; mechanisms from files, or scenes", "esercizi, o all; meccanismi da file, o scenes"});
    add_givens(verb);
    add_givens_file(verb, {"givens from lines such as r = 25 cm; or CSV: a column each, and each row is checked",
                           "dati da righe come r = 25 cm; o CSV: una colonna ciascuno, e si verifica ogni riga"});
    add_repeatable(verb, "--measured", options_.measured, {"NAME=VALUE[UNIT]", "NOME=VALORE[UNITÀ]"},
                   {"a number you measured, held against the true one",
                    "un numero che hai misurato, confrontato con quello vero"});
    add_ruler(verb);
    add_flag(verb, "--quiet", options_.quiet,
             {"only what was measured, and the totals", "solo ciò che è misurato, e i totali"});
    add_flag(
        verb, "--json", options_.json,
        {"print the report as JSON (schema epure.check/1)", "stampa il resoconto in JSON (schema epure.check/1)"});
    add(verb, "--arithmetic", options_.arithmetic, {"KIND", "TIPO"},
        {"fast (doubles), bounded (intervals) or exact (default: as many digits as it takes)",
         "fast (double), bounded (intervalli) o exact (predefinita: tante cifre quante ne servono)"});
    add_language(verb);
  }
  void add_report() {
    CLI::App& verb = add_verb("report");
    add_names(verb, {"ID", "ID"}, {"an exercise", "un esercizio"});
    add(verb, "--format", options_.format, {"FORMAT", "FORMATO"},
        {"md (default), tex or html", "md (predefinito), tex o html"});
    add_folder(verb);
    add(verb, "-o", options_.file, {"FILE", "FILE"},
        {"write this file, and its figures beside it; - is standard output, for html",
         "scrive questo file, e le figure accanto; - è lo standard output, per html"});
    add_givens(verb);
    add_givens_file(verb, {"givens from lines such as r = 25 cm, or CSV of one row",
                           "dati da righe come r = 25 cm, o CSV di una riga"});
    add_language(verb);
  }
  void add_booklet() {
    CLI::App& verb = add_verb("booklet");
    add_names(verb, {"ID", "ID"}, {"exercises (default: all)", "esercizi (predefiniti: tutti)"});
    add_folder(verb);
    add(verb, "-o", options_.file, {"FILE", "FILE"},
        {"write this PDF; - is standard output", "scrive questo PDF; - è lo standard output"});
    add_paper(verb);
    add_course(verb);
    add(verb, "--title", options_.titles.title, {"TEXT", "TESTO"}, {"of the first page", "della prima pagina"});
    add_language(verb);
  }
  void add_sweep() {
    CLI::App& verb = add_verb("sweep");
    add_names(verb, {"ID", "ID"}, {"an exercise", "un esercizio"});
    add_variations(verb, "--over", {"SYMBOL=FROM..TO/N", "SIMBOLO=DA..A/N"},
                   {"N values of a given, both ends among them; or FROM..TO/STEP, or 'A|B|C'",
                    "N valori di un dato, estremi compresi; o DA..A/PASSO, o 'A|B|C'"});
    add_repeatable(verb, "--quantity", options_.quantities, {"NAMES", "NOMI"},
                   {"what to find, such as v_B,omega_3", "che cosa trovare, come v_B,omega_3"});
    add_givens(verb);
    add_givens_file(verb, {"givens from lines such as r = 25 cm, or CSV of one row",
                           "dati da righe come r = 25 cm, o CSV di una riga"});
    add_format(
        verb,
        {"csv (default); json: an object a line (schema epure.sweep/1); or html: a page on which the mechanism moves",
         "csv (predefinito); json: un oggetto per riga (schema epure.sweep/1); o html: una pagina su cui il "
         "meccanismo si muove"});
    add_csv(verb);
    add_file(verb, {"write a file; - is standard output (default)",
                    "scrive un file; - è lo standard output (predefinito)"});
    add(verb, "--part", options_.part, {"K/M", "K/M"},
        {"only the K-th of M parts, one after the other", "solo la K-esima di M parti, una dopo l'altra"});
    add(verb, "--chart", options_.chart, {"FILE", "FILE"},
        {"draw them too, PDF or SVG: over the first --over, a curve for each value of the others",
         "le disegna anche, in PDF o SVG: sul primo --over, una curva per ogni valore degli altri"});
    add_language(verb);
  }
  void add_class() {
    CLI::App& verb = add_verb("class");
    add_names(verb, {"NAME", "NOME"},
              {"an exercise or a sheet: ID or ID/SHEET", "un esercizio o una tavola: ID o ID/TAVOLA"});
    ClassOptions& of = options_.class_set;
    add(verb, "--students", of.students, {"FILE", "FILE"},
        {"CSV: number, name (or surname, name); a sheet to be solved and a solution for each",
         "CSV: matricola, nome (o cognome, nome); una tavola da svolgere e una soluzione per ciascuno"});
    add(verb, "--count", of.count, {"N", "N"}, {"so many students without names", "tanti studenti senza nome"});
    add_givens_file(verb, {"CSV: each row's own givens, a column each; or lines such as r = 25 cm",
                           "CSV: i dati propri di ogni riga, una colonna ciascuno; o righe come r = 25 cm"});
    add_variations(
        verb, "--vary", {"SYMBOL=FROM..TO/STEP", "SIMBOLO=DA..A/PASSO"},
        {"a given drawn by lot; or FROM..TO/COUNT, or A|B|C", "un dato sorteggiato; o DA..A/QUANTI, o A|B|C"});
    add(verb, "--seed", of.seed, {"TEXT", "TESTO"},
        {"the same seed draws the same lots (default: 1)", "lo stesso seme dà gli stessi sorteggi (predefinito: 1)"});
    add_givens(verb);
    add_scale(verb,
              {"; of a class the largest one that fits all", "; di una classe la maggiore che va bene a tutti"});
    add_flag(verb, "--booklet", of.booklet,
             {"also all sheets to be solved in one PDF to print, blanks.pdf, and all solutions, solutions.pdf",
              "anche tutte le tavole da svolgere in un PDF da stampare, blanks.pdf, e tutte le soluzioni, "
              "solutions.pdf"});
    add_format(verb,
               {"pdf (default), or moodle: a question bank", "pdf (predefinito), o moodle: una banca di domande"});
    add_csv(verb);
    add(verb, "--reading", options_.reading, {"LENGTH", "LUNGHEZZA"},
        {"moodle: what an answer may be off on the sheet (default: 0.5mm)",
         "moodle: di quanto una risposta può scostarsi sulla tavola (predefinita: 0,5mm)"});
    add_sheets(verb);
    add_language(verb);
  }
  void add_mark() {
    CLI::App& verb = add_verb("mark");
    add_names(verb, {"ID", "ID"}, {"the exercise", "l'esercizio"});
    add(verb, "--answers", options_.answers, {"FILE", "FILE"},
        {"CSV: number, name, a column a quantity, as v_B [cm/s]; also scale, givens",
         "CSV: matricola, nome, una colonna per grandezza, come v_B [cm/s]; anche scala, dati"});
    add(verb, "--key", options_.key, {"FILE", "FILE"},
        {"CSV: number and each student's own givens", "CSV: matricola e i dati propri di ogni studente"});
    add_givens(verb);
    add_ruler(verb);
    add(verb, "--points", options_.points, {"NAME=POINTS,...", "NOME=PUNTI,..."},
        {"what quantities are worth (default: 1 each)", "quanto valgono le grandezze (predefinito: 1 ciascuna)"});
    add(verb, "--slip-points", options_.slip_points, {"SHARE", "QUOTA"},
        {"of the points, for a slip that is named (default: 0.5)",
         "dei punti, per una svista riconosciuta (predefinita: 0,5)"});
    add(verb, "--out-of", options_.out_of, {"MARK", "VOTO"},
        {"also the mark that all points would be, such as 30",
         "anche il voto, su tanti che valgano tutti i punti, come 30"});
    add_format(verb, {"text (default) or csv", "text (predefinito) o csv"});
    add_csv(verb);
    add_file(verb, {"write to this file; .csv: as CSV; - is standard output",
                    "scrive in questo file; .csv: in CSV; - è lo standard output"});
    add_language(verb);
  }
  void add_import() {
    CLI::App& verb = add_verb("import");
    add_names(verb, {"TEXT", "TESTO"},
              {"an expression of pyslvs, a share link of PMKS+, or a file that holds one; - is standard input",
               "un'espressione di pyslvs, un collegamento di PMKS+, o un file che ne contiene uno; - è lo standard "
               "input"});
    add_file(verb, {"write to this file; else to standard output",
                    "scrive in questo file; altrimenti sullo standard "
                    "output"});
    add_language(verb);
  }
  void add_bench() {
    CLI::App& verb = add_verb("bench");
    add_flag(
        verb, "--json", options_.json,
        {"print the results as JSON (schema epure.bench/1)", "stampa i risultati in JSON (schema epure.bench/1)"});
    add(verb, "--seconds", options_.seconds, {"TIME", "TEMPO"},
        {"about how long to measure (default: 60)", "circa quanto a lungo misurare (predefinito: 60)"});
    add_folder(verb);
    add_formats(verb);
    add_paper(verb);
    add_language(verb);
  }

  Options& options_;
  Language language_;
  CLI::App program_{"", "epure"};
};

Help help_of(const std::string& verb) {
  if (verb == "list") return help_of_list();
  if (verb == "draw") return help_of_draw();
  if (verb == "check") return help_of_check();
  if (verb == "report") return help_of_report();
  if (verb == "booklet") return help_of_booklet();
  if (verb == "sweep") return help_of_sweep();
  if (verb == "class") return help_of_class();
  if (verb == "mark") return help_of_mark();
  if (verb == "import") return help_of_import();
  return verb == "bench" ? help_of_bench() : help_of_program();
}

bool takes_several_names(const std::string& verb) { return verb == "draw" || verb == "check" || verb == "booklet"; }

HelpPage Parser::help_page(const CLI::App& app) const {
  const bool is_program = &app == &program_;
  HelpPage page{.verb = is_program ? "" : app.get_name(), .help = help_of(app.get_name())};
  for (const CLI::Option* each : app.get_options())
    (each->get_positional() ? page.names : page.options)
        .push_back({.name = each->get_name(false, true),
                    .type = each->get_positional() ? "" : each->get_type_name(),
                    .meaning = each->get_description()});
  page.usage = "epure";
  if (is_program) {
    page.usage += say({" VERB [OPTIONS]", " VERBO [OPZIONI]"});
    for (const std::string& verb : verbs())
      page.names.push_back({.name = verb, .meaning = help_of(verb).purpose.in(language_)});
  } else {
    page.usage +=
        " " + app.get_name() + say({" [OPTIONS]", " [OPZIONI]"}) +
        (page.names.empty() ? ""
                            : " [" + page.names.front().name + (takes_several_names(app.get_name()) ? "...]" : "]"));
  }
  return page;
}

void Parser::refuse(const std::string& typed) const {
  const CLI::App& app = chosen();
  const std::string where = &app == &program_ ? "" : " " + app.get_name();
  const Words explained = {" (epure help" + where + " explains)", " (epure help" + where + " spiega)"};
  if (!typed.starts_with('-'))
    throw WrongUsage(format_words("\"{}\" is not expected after epure{}{}", "\"{}\" non è atteso dopo epure{}{}",
                                  typed, where, explained));
  std::vector<std::string> known;
  for (const CLI::Option* each : app.get_options())
    if (!each->get_positional())
      for (const std::string& name : each->get_lnames()) known.push_back("--" + name);
  const std::string name = typed.substr(0, typed.find('='));
  throw WrongUsage(format_words("\"{}\" is no option of epure{}; {}{}", "\"{}\" non è un'opzione di epure{}; {}{}",
                                name, where, did_you_mean(name, known), explained));
}

void Parser::refuse_before_verb(const std::string& typed) const {
  if (&chosen() == &program_) {
    const std::string name = typed.substr(0, typed.find('='));
    for (const CLI::App* verb : program_.get_subcommands({}))
      if (name.starts_with("--") && verb->get_option_no_throw(name) != nullptr)
        throw WrongUsage(
            format_words("{} follows the verb: epure VERB {}", "{} segue il verbo: epure VERBO {}", name, typed));
    refuse(typed);
  }
  throw WrongUsage(format_words("\"{}\" stands before the verb, which comes first: epure {} ...",
                                "\"{}\" sta prima del verbo, che viene per primo: epure {} ...", typed,
                                chosen().get_name()));
}

// A name of an option that is not a part of a longer one, as -o of --out.
bool names_option(const std::string& sentence, const std::string& name) {
  const auto is_of_name = [&](std::size_t at) {
    return at < sentence.size() &&
           (std::isalnum(static_cast<unsigned char>(sentence[at])) != 0 || sentence[at] == '-');
  };
  for (auto at = sentence.find(name); at != std::string::npos; at = sentence.find(name, at + 1))
    if ((at == 0 || !is_of_name(at - 1)) && !is_of_name(at + name.size())) return true;
  return false;
}

void Parser::refuse_value(const std::string& of_cli11) const {
  for (const CLI::Option* option : chosen().get_options()) {
    const std::string name = option->get_name();
    const std::string without_dashes = name.substr(name.find_first_not_of('-'));  // of a flag that is given a value
    const bool is_meant = names_option(of_cli11, name) || of_cli11.starts_with(without_dashes + " was");
    if (option->get_positional() || !is_meant) continue;
    if (option->count() > 1)
      throw WrongUsage(
          format_words("{} is given twice; which one is meant?", "{} è dato due volte; quale si intende?", name));
    if (option->get_expected_max() == 0 || option->get_type_name().empty())
      throw WrongUsage(format_words("{} takes no value", "{} non prende un valore", name));
    throw WrongUsage(
        format_words("{} needs a value: {} {}", "{} vuole un valore: {} {}", name, name, option->get_type_name()));
  }
  throw WrongUsage(format_words("\"{}\" cannot be understood", "\"{}\" non si capisce", of_cli11));
}

// What should follow a verb and stands in its place.
void refuse_name_as_verb(const Catalogue& exercises, const std::string& name) {
  if (name == "all")
    throw WrongUsage("\"all\" stands after a verb: epure draw all, or epure check all",
                     "\"all\" va dopo un verbo: epure draw all, o epure check all");
  const std::string id = name.substr(0, name.find('/'));
  if (std::none_of(exercises.begin(), exercises.end(), [&](const Listed& each) { return each.id() == id; })) return;
  throw WrongUsage(format_words("\"{0}\" stands after a verb: epure list {1}, epure draw {0}, or epure check {1}",
                                "\"{0}\" va dopo un verbo: epure list {1}, epure draw {0}, o epure check {1}", name,
                                id));
}

// The word where the verb should be.
void demand_verb(const Catalogue& exercises, const std::vector<std::string>& arguments) {
  if (arguments.empty())
    throw WrongUsage(
        "say what to do: list, draw, check, report, booklet, class, mark, sweep, import or bench (epure help "
        "explains)",
        "dire che cosa fare: list, draw, check, report, booklet, class, mark, sweep, import o bench (epure help "
        "spiega)");
  const std::string& first = arguments.front();
  if (first.starts_with('-')) return;
  refuse_name_as_verb(exercises, first);
  if (std::find(verbs().begin(), verbs().end(), first) == verbs().end())
    throw WrongUsage(format_words("\"{}\" is nothing epure can do; {}", "\"{}\" non è cosa che epure sappia fare; {}",
                                  first, did_you_mean(first, verbs())));
}

// "help" is "--help", and "help draw" is "draw --help".
std::vector<std::string> with_help_as_option(std::vector<std::string> arguments) {
  if (arguments.empty() || arguments.front() != "help") return arguments;
  arguments.erase(arguments.begin());
  const bool names_a_verb = !arguments.empty() && !arguments.front().starts_with('-');
  arguments.insert(arguments.begin() + (names_a_verb ? 1 : 0), "--help");
  return arguments;
}

}  // namespace

const std::vector<std::string>& verbs() {
  static const std::vector<std::string> all{"list",  "draw", "check", "report", "booklet",
                                            "class", "mark", "sweep", "import", "bench"};
  return all;
}

HelpPage help_page(const std::string& verb, Language language) {
  Options unused;
  return Parser(unused, language).help_page(verb);
}

Language language_of_messages(const std::vector<std::string>& arguments, const std::string& otherwise) {
  const std::string option = "--lang";
  std::string asked = otherwise;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == option && i + 1 < arguments.size()) asked = arguments[i + 1];
    if (arguments[i].starts_with(option + "=")) asked = arguments[i].substr(option.size() + 1);
  }
  return lower_case(asked) == "it" ? Language::italian : Language::english;
}

Parsed parse_options(const Catalogue& exercises, const std::vector<std::string>& typed, const std::string& language) {
  const std::vector<std::string> arguments = with_help_as_option(typed);
  demand_verb(exercises, arguments);
  Parsed parsed;
  if (!language.empty()) parsed.options.language = language;
  const Language messages = language_of_messages(arguments, language);
  Parser parser(parsed.options, messages);
  try {
    parser.parse(arguments);
  } catch (const CLI::CallForHelp&) {
    parsed.text = help_text(parser.help_page(parser.chosen()), messages);
    return parsed;
  } catch (const CLI::CallForVersion& version) {
    parsed.text = version.what();
    return parsed;
  } catch (const CLI::ParseError& error) {
    parser.refuse_value(error.what());
  }
  const std::string verb = parser.chosen().get_name();
  if (verb == "epure") demand_verb(exercises, {});
  parsed.options.verb = verb == "list"      ? Options::Verb::list
                        : verb == "draw"    ? Options::Verb::draw
                        : verb == "check"   ? Options::Verb::check
                        : verb == "report"  ? Options::Verb::report
                        : verb == "booklet" ? Options::Verb::booklet
                        : verb == "sweep"   ? Options::Verb::sweep
                        : verb == "class"   ? Options::Verb::make_class
                        : verb == "mark"    ? Options::Verb::mark
                        : verb == "import"  ? Options::Verb::import_text
                                            : Options::Verb::bench;
  return parsed;
}

}  // namespace epure
