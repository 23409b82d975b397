// A class set: for each student a sheet to be solved and its solution, and a key of all.
#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "drawings/output.h"
#include "drawings/text/text.h"
#include "exercises/cli/abreast.h"
#include "exercises/cli/answer_columns.h"
#include "exercises/cli/class_journal.h"
#include "exercises/cli/class_record.h"
#include "exercises/cli/class_scale.h"
#include "exercises/cli/givens_file.h"
#include "exercises/cli/harmless_cell.h"
#include "exercises/cli/kept_inputs.h"
#include "exercises/cli/moodle.h"
#include "exercises/cli/moved_by_speed.h"
#include "exercises/cli/must_be_told.h"
#include "exercises/cli/pages.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/progress.h"
#include "exercises/cli/request.h"
#include "exercises/cli/student_columns.h"
#include "exercises/cli/variant.h"
#include "exercises/cli/variations.h"
#include "exercises/cli/verbs.h"
#include "exercises/kit/panels/problem_sheet.h"
#include "exercises/kit/statement/suggest.h"

namespace epure {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_students = 100000;

// With what is to be said of the file that lists them.
std::vector<Candidate> class_of(const Options& options, const Exercise& exercise, std::vector<Words>& remarks) {
  const ClassOptions& of = options.class_set;
  const int sources = (of.students ? 1 : 0) + (options.givens_file ? 1 : 0) + (of.count ? 1 : 0);
  if (sources != 1)
    throw WrongUsage("a class needs one of --students ROSTER.csv, --givens VARIANTS.csv and --count N",
                     "una classe richiede uno fra --students ELENCO.csv, --givens VARIANTI.csv e --count N");
  if (of.students) {
    const CsvTable roster = read_csv_file(*of.students);
    if (!roster.remark.empty()) remarks.push_back(roster.remark);
    return candidates_of(roster);
  }
  if (options.givens_file) return read_givens_file(*options.givens_file, {&exercise}, options.assignments).rows;
  const bool is_number =
      !of.count->empty() && of.count->size() <= 6 && of.count->find_first_not_of("0123456789") == std::string::npos;
  const std::size_t count = is_number ? std::stoul(*of.count) : 0;
  if (count < 1 || count > most_students)
    throw WrongUsage(format_words("--count {}: must be a whole number from 1 to {}",
                                  "--count {}: dev'essere un numero intero da 1 a {}", *of.count, most_students));
  return numbered_candidates(count);
}

// What --set and a table of variants say.
std::vector<std::string> values_of_givens(const Options& options, const std::vector<Candidate>& students) {
  std::vector<std::string> all = options.assignments;
  for (const Candidate& student : students)
    all.insert(all.end(), student.assignments.begin(), student.assignments.end());
  return all;
}

// What the key has no value for, and why; and what is beyond the paper.
Words key_remarks(const Variant& variant) {
  std::vector<std::pair<Words, std::string>> reasons;
  const auto add = [&](const Words& reason, const std::string& quantity) {
    const auto known = std::find_if(reasons.begin(), reasons.end(),
                                    [&](const auto& each) { return each.first.english == reason.english; });
    if (known == reasons.end())
      reasons.emplace_back(reason, quantity);
    else
      known->second += ", " + quantity;
  };
  for (const RouteValue& value : variant.solution.values())
    if (variant.solution.is_reported(value.quantity) && !variant.solution.value(value.quantity))
      add({drawings::plain(value.settled.reason.english), drawings::plain(value.settled.reason.italian)},
          value.quantity);
  std::set<std::string> seen;
  for (const DrawnSheet& sheet : variant.solved)
    for (const Awkwardness& each : sheet.awkward)
      if (const auto name = quantity_not_asked(each);
          name && variant.solution.value(*name) && seen.insert(*name).second)
        add({"off the sheet, not asked", "fuori del foglio, non richiesto"}, *name);
  Words all;
  for (const auto& [reason, quantities] : reasons) all = all + (all.empty() ? "" : "; ") + quantities + ": " + reason;
  return all;
}

SheetRequest class_request(const Options& options) {
  SheetRequest request = sheet_request(options);
  request.for_class = true;
  return request;
}

bool wants_moodle(const Options& options) {
  const std::string format = lower_case(options.format.value_or("pdf"));
  if (format != "pdf" && format != "moodle")
    throw WrongUsage(format_words("\"{}\" is no format of a class; choose pdf or moodle",
                                  "\"{}\" non è un formato di una classe; scegliere pdf o moodle", *options.format));
  return format == "moodle";
}

class ClassSet {
 public:
  ClassSet(const Target& target, const Options& options)
      : exercise_(*target.exercise),
        options_(options),
        students_(class_of(options, exercise_, remarks_on_roster_)),
        lots_{.exercise = exercise_,
              .sheets = target.sheets(),
              .givens = set_givens({&exercise_}, options.assignments).front(),
              .variations =
                  read_variations(exercise_, "--vary", options.variations, values_of_givens(options, students_)),
              .seed = options.class_set.seed,
              .request = class_request(options)},
        ruler_(ruler_asked({&exercise_}, options)),
        style_(csv_style(options)),
        is_moodle_(wants_moodle(options)),
        folder_(fs::path(options.folder.value_or("out")) / (target.file_stem() + "-class")),
        record_(target.exercise->about().id + (target.sheet.empty() ? "" : "/" + target.sheet), options) {
    if (is_moodle_ && options.class_set.booklet)
      throw WrongUsage("--booklet binds sheets, and --format moodle writes none; leave one of them out",
                       "--booklet rilega tavole, e --format moodle non ne scrive; togliere uno dei due");
    record_.demand_same_in(folder_);
    demand_students_of_key();
    for (const char* written : {"key.csv", "questions.xml", "class.txt"}) demand_not_read(folder_ / written, options);
    const auto vary = [&](const std::string& symbol) {
      if (heads_something_else(symbol))
        throw WrongUsage(format_words(
            "a column \"{}\" of the key would not be read as that given: name the given otherwise",
            "una colonna \"{}\" della chiave non sarebbe letta come quel dato: chiamare il dato altrimenti", symbol));
      if (std::find(varied_.begin(), varied_.end(), symbol) == varied_.end()) varied_.push_back(symbol);
    };
    for (const GivenSpec& spec : lots_.givens.specs())
      if (must_be_told(lots_.givens, spec)) vary(spec.symbol);
    for (const Candidate& student : students_)
      for (const std::string& assignment : student.assignments) vary(symbol_in(assignment));
    for (const Variation& each : lots_.variations) vary(each.given().symbol);
  }

  Outcome make(std::ostream& err, bool is_on_terminal) {
    const std::vector<std::string> awkward_anyway = awkward_as_stated(lots_);
    choose_scales(awkward_anyway);
    const bool is_new = !fs::exists(folder_ / ClassRecord::file_name), had_folder = fs::exists(folder_);
    ClassJournal journal(folder_, inputs());
    record_.write_to(folder_);
    std::vector<ClassEntry> entries(students_.size());
    Progress progress(students_.size(), is_on_terminal, err, lots_.request.language);
    std::mutex one_at_a_time;
    std::atomic<bool> is_begun = false;
    try {
      abreast(students_.size(), [&](std::size_t i) {
        const Candidate& student = students_[i];
        if (const ClassEntry* done = journal.entry_of(student); done && has_files(student)) {
          entries[i] = *done;
        } else {
          entries[i] = draw_set(student, awkward_anyway);
          is_begun = true;
          journal.add(student, entries[i]);
        }
        const std::scoped_lock lock(one_at_a_time);
        progress.has_done(1);
      });
    } catch (...) {
      // A class of which nothing could be made stands in nobody's way.
      if (is_new && !is_begun) {
        journal.remove();
        std::error_code ignored;
        fs::remove(folder_ / ClassRecord::file_name, ignored);
        if (!had_folder) fs::remove(folder_, ignored);  // only when nothing is in it
      }
      throw;
    }
    std::vector<drawings::File> files{{folder_ / "key.csv", key(entries)}};
    if (is_moodle_) files.push_back({folder_ / "questions.xml", questions(entries)});
    if (options_.class_set.booklet)
      for (const bool blank : {true, false})
        files.push_back({folder_ / (blank ? "blanks.pdf" : "solutions.pdf"), booklet(entries, blank)});
    drawings::write_whole(files);
    journal.remove();
    return {report(entries), Exit::success, remarks()};
  }

 private:
  static std::string symbol_in(const std::string& assignment) { return assignment.substr(0, assignment.find('=')); }

  // Sheets that are handed out would have lost their key.
  void demand_students_of_key() const {
    const fs::path path = folder_ / "key.csv";
    std::error_code ignored;
    if (!fs::exists(path, ignored)) return;
    const CsvTable key = read_csv_file(path.string());
    const auto numbers = column_of_numbers(key);
    if (!numbers) return;
    std::set<std::string> students;
    for (const Candidate& each : students_) students.insert(harmless_cell(each.number));
    std::vector<std::string> others;
    for (const CsvRow& row : key.rows)
      if (!students.contains(row.cells[*numbers])) others.push_back(row.cells[*numbers]);
    if (others.empty()) return;
    throw WrongUsage(format_words(
        "{} would lose {} of its {} students, such as {}, as they are not in this class; choose another --out, or "
        "delete the folder",
        "{} perderebbe {} dei suoi {} studenti, come {}, che non sono in questa classe; scegliere un'altra --out, o "
        "cancellare la cartella",
        path.string(), others.size(), key.rows.size(), others.front()));
  }

  void choose_scales(const std::vector<std::string>& awkward_anyway) {
    if (lots_.request.scale) return;
    ClassScales found = class_scales(lots_, students_, awkward_anyway);
    lots_.scales = std::move(found.of_sheets);
    too_different_ = std::move(found.too_different);
  }

  // What the files depend on, beside the students.
  std::string inputs() const {
    nlohmann::json all{{"epure", EPURE_VERSION},
                       {"exercise", exercise_.about().id},
                       {"sheets", lots_.sheets},
                       {"set", options_.assignments},
                       {"vary", options_.variations},
                       {"seed", lots_.seed},
                       {"scale", options_.scale.value_or("")},
                       {"scales", scales_in_words()},
                       {"paper", options_.paper},
                       {"lang", options_.language},
                       {"reading", options_.reading},
                       {"course", options_.titles.course},
                       {"author", options_.titles.author},
                       {"title", options_.titles.title},
                       {"number", options_.titles.sheet_number},
                       {"moodle", is_moodle_},
                       {"csv", style_.is_for_spreadsheet},
                       {"mechanism", options_.mechanisms}};
    return all.dump();
  }

  fs::path file(const Candidate& student, const char* ending) const { return folder_ / (student.file + ending); }
  bool has_files(const Candidate& student) const {
    std::error_code ignored;
    if (is_moodle_) return true;
    return fs::exists(file(student, "-blank.pdf"), ignored) && fs::exists(file(student, "-solution.pdf"), ignored);
  }

  // Of the sheets that have one for all students.
  std::map<std::string, std::string> scales_in_words() const {
    std::map<std::string, std::string> all;
    for (const auto& [sheet, scale] : lots_.scales) all.emplace(sheet, scale_in_words(scale));
    return all;
  }

  ClassEntry draw_set(const Candidate& student, const std::vector<std::string>& awkward_anyway) const {
    Variant variant = draw_variant(lots_, student, awkward_anyway);
    ClassEntry entry{.givens = variant.assignments,
                     .values = {},
                     .scales = {},
                     .remarks = key_remarks(variant).in(style_.language(lots_.request.language)),
                     .question = "",
                     .rejected = variant.rejected};
    for (const Quantity& quantity : exercise_.about().quantities()) {
      const auto value = variant.solution.value(quantity.name);
      entry.values.push_back(value ? style_.number(*value) : "");
    }
    for (const DrawnSheet& sheet : variant.solved) {
      const auto scale = scale_shown(sheet);
      entry.scales.push_back(scale ? style_.number(nearest(*scale)) : "");
    }
    if (is_moodle_) {
      entry.question = moodle_question(exercise_, variant, lots_, ruler_);
      return entry;
    }
    const std::vector<DrawnSheet> blank = sheets_of(lots_, variant.solution, student, true);
    drawings::write_whole({{file(student, "-blank.pdf"), drawings::write_pdf(pages(blank), document())},
                           {file(student, "-solution.pdf"), drawings::write_pdf(pages(variant.solved), document())}});
    return entry;
  }

  static std::vector<drawings::Page> pages(const std::vector<DrawnSheet>& sheets) {
    std::vector<drawings::Page> all;
    for (const DrawnSheet& sheet : sheets)
      for (drawings::Page& page : pages_of(sheet)) all.push_back(std::move(page));
    return all;
  }

  drawings::Document document() const {
    return {.title = drawings::plain(exercise_.about().title.in(lots_.request.language)),
            .author = lots_.request.titles.author};
  }

  // The sheets of all students, one after the other, with a bookmark for each. Drawn again: a run that goes on where
  // another stopped has those of the others in files only.
  std::string booklet(const std::vector<ClassEntry>& entries, bool blank) const {
    std::vector<std::vector<drawings::Page>> of_students(students_.size());
    abreast(students_.size(), [&](std::size_t i) {
      of_students[i] = pages(sheets_of(lots_, solution_of(lots_, entries[i].givens), students_[i], blank));
    });
    drawings::Document all = document();
    std::vector<drawings::Page> bound;
    for (std::size_t i = 0; i < students_.size(); ++i) {
      const Candidate& student = students_[i];
      all.bookmarks.push_back({student.number + (student.name.empty() ? "" : " " + student.name), bound.size()});
      for (drawings::Page& page : of_students[i]) bound.push_back(std::move(page));
    }
    return drawings::write_pdf(bound, all);
  }

  // As --set takes it, without the symbol.
  std::string of_all(const std::string& symbol) const {
    const auto read = lots_.givens.reading(symbol);
    const bool is_word = !lots_.givens.specs()[index_of(lots_.givens.specs(), symbol)].choices.empty();
    return lots_.givens.text(symbol) + (is_word || !read || read->unit.symbol == "1" ? "" : read->unit.symbol);
  }

  // The givens of a student that are not the stated ones, in the order of `varied_`.
  std::vector<std::string> givens_in_order(const ClassEntry& entry) const {
    std::vector<std::string> cells;
    for (const std::string& symbol : varied_) {
      const auto& specs = lots_.givens.specs();
      cells.push_back(must_be_told(lots_.givens, specs[index_of(specs, symbol)]) ? of_all(symbol) : "");
      for (const std::string& assignment : entry.givens)
        if (symbol_in(assignment) == symbol) cells.back() = assignment.substr(symbol.size() + 1);
    }
    return cells;
  }

  std::string key(const std::vector<ClassEntry>& entries) const {
    const Language language = style_.language(lots_.request.language);
    const bool has_remarks =
        std::any_of(entries.begin(), entries.end(), [](const ClassEntry& each) { return !each.remarks.empty(); });
    std::vector<std::string> fields{Words{"number", "matricola"}.in(language), Words{"name", "nome"}.in(language)};
    for (const std::string& symbol : varied_) fields.push_back(style_.field(symbol));
    for (const Quantity& quantity : exercise_.about().quantities()) fields.push_back(style_.field(heading(quantity)));
    const std::vector<std::size_t> to_scale = sheets_to_scale(entries);
    for (const std::size_t k : to_scale)
      fields.push_back(style_.field(Words{"scale ", "scala "}.in(language) + lots_.sheets[k]));
    if (has_remarks) fields.push_back(Words{"remarks", "osservazioni"}.in(language));
    std::string text = std::string(style_.begin()) + style_.record(fields);
    for (std::size_t i = 0; i < students_.size(); ++i) {
      fields = {style_.field(harmless_cell(students_[i].number)), style_.field(harmless_cell(students_[i].name))};
      for (const std::string& cell : givens_in_order(entries[i]))
        fields.push_back(style_.field(harmless_given(style_.typed(cell))));
      fields.insert(fields.end(), entries[i].values.begin(), entries[i].values.end());
      for (const std::size_t k : to_scale) fields.push_back(entries[i].scales[k]);
      if (has_remarks) fields.push_back(style_.field(entries[i].remarks));
      text += style_.record(fields);
    }
    return text;
  }

  // The places of the sheets that show lengths. In the key a scale stands as a number, 0.2 for 1 : 5, which a
  // spreadsheet would take for five past one.
  std::vector<std::size_t> sheets_to_scale(const std::vector<ClassEntry>& entries) const {
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < lots_.sheets.size(); ++k)
      if (std::any_of(entries.begin(), entries.end(), [k](const auto& each) { return !each.scales[k].empty(); }))
        all.push_back(k);
    return all;
  }

  // Of a quantity that has the name of a given, with its unit: which of the two it is, who marks must know.
  std::string heading(const Quantity& quantity) const {
    const auto& specs = exercise_.about().givens;
    const bool is_alone = index_of(specs, quantity.name) == specs.size() || quantity.unit == "1";
    return is_alone ? quantity.name : quantity.name + " [" + quantity.unit + "]";
  }

  std::string questions(const std::vector<ClassEntry>& entries) const {
    const std::string& own_title = lots_.request.titles.title;
    std::vector<MoodleQuestion> all;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::string& number = students_[i].number;
      const std::string named = number == std::to_string(i + 1) ? "" : " " + number;
      all.push_back({exercise_.about().id + named, entries[i].question});
    }
    return moodle_quiz(
        own_title.empty() ? drawings::plain(exercise_.about().title.in(lots_.request.language)) : own_title, all);
  }

  std::string report(const std::vector<ClassEntry>& entries) const {
    const Language language = lots_.request.language;
    Rejections rejected;
    for (const ClassEntry& entry : entries)
      for (const auto& [why, count] : entry.rejected) rejected[why] += count;
    std::string text = shown_whole((folder_ / "key.csv").string()) + "\n";
    if (is_moodle_) text += shown_whole((folder_ / "questions.xml").string()) + "\n";
    if (options_.class_set.booklet)
      for (const char* bound : {"blanks.pdf", "solutions.pdf"})
        text += shown_whole((folder_ / bound).string()) + "\n";
    text += format_words("students: {}", "studenti: {}", students_.size()).in(language) + "\n" +
            told_scales().in(language);
    for (const auto& [why, count] : rejected)
      text += format_words("drawn again, {}: {}", "sorteggiate di nuovo, {}: {}", Words{why.first, why.second}, count)
                  .in(language) +
              "\n";
    return text + equal_variants(entries).in(language);
  }

  Words told_scales() const {
    std::string text;
    for (const auto& [sheet, scale] : scales_in_words())
      text += (text.empty() ? "" : ", ") + (lots_.sheets.size() == 1 ? "" : sheet + " ") + scale;
    return text.empty() ? Words{} : format_words("scale of lengths: {}\n", "scala delle lunghezze: {}\n", text);
  }

  // A student's lots hang on the seed and on his number alone, so that nobody's change when the class does: two may
  // be equal. Then it is told how many are.
  Words equal_variants(const std::vector<ClassEntry>& entries) const {
    std::map<std::vector<std::string>, std::size_t> students;
    for (const ClassEntry& each : entries) ++students[each.givens];
    if (lots_.variations.empty())
      return students.size() > 1 || entries.size() == 1
                 ? Words{}
                 : Words{"all students have the same givens; --vary draws lots for each\n",
                         "tutti gli studenti hanno gli stessi dati; --vary li sorteggia per ciascuno\n"};
    std::size_t equal = 0;
    for (const auto& [givens, count] : students) equal += count > 1 ? count : 0;
    if (equal == 0) return {};
    double variants = 1;
    for (const Variation& each : lots_.variations) variants *= static_cast<double>(each.size());
    return format_words(
        "students with the same givens as another: {} ({} different variants were drawn, of {:.6g}; more values in "
        "--vary, fewer such)\n",
        "studenti con gli stessi dati di un altro: {} ({} varianti diverse sorteggiate, su {:.6g}; con più valori in "
        "--vary, meno)\n",
        equal, students.size(), variants);
  }

  std::vector<Words> remarks() const {
    std::vector<Words> all = remarks_on_roster_;
    for (Words& each : moved_by_speed(lots_.givens, varied_)) all.push_back(std::move(each));
    for (const std::string& sheet : too_different_)
      all.push_back(
          format_words("{}: no one scale fits all variants well, so each has its own (--scale sets one)",
                       "{}: nessuna scala va bene a tutte le varianti, e ognuna ha la sua (--scale ne fissa "
                       "una)",
                       sheet));
    const std::vector<std::string> stale = files_of_others();
    if (!stale.empty())
      all.push_back(format_words(
          "{} still holds {} of an earlier class, such as {}; delete what is not of this one, or choose another "
          "--out",
          "{} contiene ancora {} di una classe precedente, come {}; cancellare ciò che non è di questa, o scegliere "
          "un'altra --out",
          folder_.string(),
          stale.size() == 1 ? Words{"a file", "un file"} : format_words("{} files", "{} file", stale.size()),
          stale.front()));
    return all;
  }

  // What is named as sheets of a class are, and this run has not written.
  std::vector<std::string> files_of_others() const {
    std::set<std::string> own;
    for (const Candidate& each : students_)
      for (const char* ending : endings) own.insert(each.file + ending);
    std::vector<std::string> others;
    std::error_code ignored;
    for (const fs::directory_entry& each : fs::directory_iterator(folder_, ignored)) {
      const std::string name = each.path().filename().string();
      const bool is_sheet =
          std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return name.ends_with(ending); });
      const bool is_bound = (name == "blanks.pdf" || name == "solutions.pdf") && !options_.class_set.booklet;
      if (is_bound || (is_moodle_ ? is_sheet : name == "questions.xml" || (is_sheet && !own.contains(name))))
        others.push_back(name);
    }
    std::sort(others.begin(), others.end());
    return others;
  }
  static constexpr std::array<const char*, 2> endings{"-blank.pdf", "-solution.pdf"};

  const Exercise& exercise_;
  const Options& options_;
  std::vector<Words> remarks_on_roster_;
  std::vector<Candidate> students_;
  Lots lots_;
  Ruler ruler_;
  CsvStyle style_;
  bool is_moodle_;
  fs::path folder_;
  ClassRecord record_;
  std::vector<std::string> varied_, too_different_;
};

}  // namespace

Outcome make_class(const Catalogue& exercises, const Options& options, std::ostream& err,
                   const Surroundings& surroundings) {
  const std::vector<Target> targets = find_targets(exercises, options.names);
  if (targets.size() != 1)
    throw WrongUsage("class takes one exercise or one sheet: ID or ID/SHEET",
                     "class prende un esercizio o una tavola: ID o ID/TAVOLA");
  return ClassSet(targets.front(), options).make(err, surroundings.err_is_terminal);
}

}  // namespace epure
