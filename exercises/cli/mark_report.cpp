#include "exercises/cli/mark_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drawings/text/text.h"
#include "exercises/cli/columns.h"
#include "exercises/cli/harmless_cell.h"
#include "exercises/cli/printable.h"
#include "exercises/cli/terminal_ink.h"

namespace epure {
namespace {

using Lines = std::vector<std::vector<std::string>>;

constexpr std::size_t widest_number = 14, widest_name = 22;

// What a mark looks like, by Mark::Kind, and what it means.
struct Sign {
  const char* text;
  Words meaning;
};
const Sign& sign_of(Mark::Kind kind) {
  static const std::array<Sign, 5> signs = {{{"✓", {"right", "giusta"}},
                                             {"½", {"slip", "svista"}},
                                             {"✗", {"wrong", "sbagliata"}},
                                             {"–", {"no answer", "nessuna risposta"}},
                                             {"?", {"not marked", "non valutata"}}}};
  return signs.at(kind);
}

std::string shown_sign(const Mark& mark, const Reader& reader) {
  const std::string text = sign_of(mark.kind).text;
  if (mark.kind == Mark::none || mark.kind == Mark::not_marked) return text;
  const Ink ink = mark.kind == Mark::right ? Ink::good : mark.kind == Mark::slip ? Ink::doubtful : Ink::bad;
  return coloured(text, ink, reader.colours);
}

Words points_in_words(const Rational& points) { return decimal(nearest(points), 4); }

// What heads the columns of marks: the quantities' names where they fit, else a letter each; of as many as fit.
class MarkColumns {
 public:
  MarkColumns(const std::vector<Quantity>& asked, std::size_t room) {
    std::size_t width = 0;
    for (const Quantity& each : asked) width += display_width(each.name) + between;
    is_lettered_ = width > room;
    const std::size_t shown =
        is_lettered_ ? std::min({asked.size(), room / (1 + between), letters.size()}) : asked.size();
    for (std::size_t i = 0; i < shown; ++i)
      headings_.push_back(is_lettered_ ? std::string(1, letters[i]) : asked[i].name);
  }

  const std::vector<std::string>& headings() const { return headings_; }

  // What the letters stand for.
  std::string key(const std::vector<Quantity>& asked, Language language) const {
    if (!is_lettered_) return "";
    std::vector<std::string> pieces;
    for (std::size_t i = 0; i < headings_.size(); ++i)
      pieces.push_back(headings_[i] + " " + asked[i].name + (i + 1 < headings_.size() ? "," : ""));
    if (headings_.size() < asked.size())
      pieces.push_back(format_words("({} more: --format csv has all)", "(altre {}: --format csv le ha tutte)",
                                    asked.size() - headings_.size())
                           .in(language));
    return wrapped(pieces, 2, 4);
  }

 private:
  static constexpr std::size_t between = 2;
  static constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  bool is_lettered_ = false;
  std::vector<std::string> headings_;
};

// "/30": what heads the marks.
std::string out_of_in_words(const Rational& best, Language language) {
  return "/" + points_in_words(best).in(language);
}

std::string table_of_marks(const Answers& answers, const Marking& marking, const MarkingRules& rules,
                           const Reader& reader) {
  const Language language = reader.language;
  const std::string number = Words{"number", "numero"}.in(language), name = Words{"name", "nome"}.in(language),
                    points = Words{"points", "punti"}.in(language);
  Lines students;
  std::size_t width = display_width(number), width_of_names = display_width(name);
  for (const Student& each : answers.students) {
    students.push_back(
        {cut_to_width(printable(each.number), widest_number), cut_to_width(printable(each.name), widest_name)});
    width = std::max(width, display_width(students.back()[0]));
    width_of_names = std::max(width_of_names, display_width(students.back()[1]));
  }
  constexpr std::size_t indent = 2, between = 2, widest_points = 7;
  const std::size_t of_points = widest_points + (rules.out_of ? between + widest_points : 0);
  const MarkColumns heads(answers.asked,
                          terminal_width - indent - width - between - width_of_names - between - of_points);
  Lines rows = {{number, name}};
  rows[0].insert(rows[0].end(), heads.headings().begin(), heads.headings().end());
  rows[0].push_back(points);
  if (rules.out_of) rows[0].push_back(out_of_in_words(*rules.out_of, language));
  for (std::size_t i = 0; i < students.size(); ++i) {
    rows.push_back(students[i]);
    for (std::size_t k = 0; k < heads.headings().size(); ++k)
      rows.back().push_back(shown_sign(marking.students[i].marks[k], reader));
    rows.back().push_back(points_in_words(marking.students[i].points).in(language));
    if (!rules.out_of) continue;
    const auto mark = mark_out_of(*rules.out_of, marking.students[i]);
    rows.back().push_back(mark ? points_in_words(*mark).in(language) : "–");
  }
  std::vector<std::string> legend;
  for (const auto kind : {Mark::right, Mark::slip, Mark::wrong, Mark::none, Mark::not_marked})
    legend.push_back(sign_of(kind).text + (" " + sign_of(kind).meaning.in(language)) +
                     (kind == Mark::not_marked ? "" : ","));
  return table(rows, indent) + "\n" + heads.key(answers.asked, language) + wrapped(legend, 2, 4);
}

std::string remark_line(const Student& student, const std::string& quantity, const Words& remark, Language language) {
  const std::string who = printable(student.number.empty() ? student.name : student.number);
  std::string text = who + (who.empty() || quantity.empty() ? "" : " ") + quantity;
  text += (text.empty() ? "" : ": ") + printable(remark.in(language));
  return wrapped(text, 2, 4);
}

std::string remarks_on_answers(const Answers& answers, const Marking& marking, Language language) {
  std::string text;
  for (std::size_t i = 0; i < answers.students.size(); ++i) {
    const Student& student = answers.students[i];
    for (const Words& each : student.remarks) text += remark_line(student, "", each, language);
    for (std::size_t k = 0; k < answers.asked.size(); ++k)
      if (const Words& remark = marking.students[i].marks[k].remark; !remark.empty())
        text += remark_line(student, answers.asked[k].name, remark, language);
  }
  return text.empty() ? "" : "\n" + text;
}

std::string tolerances(const Answers& answers, const Marking& marking, Language language) {
  if (marking.tolerances.empty()) return "";
  const auto first = std::find_if(answers.students.begin(), answers.students.end(),
                                  [](const Student& each) { return each.givens.has_value(); });
  const std::string number = printable(first->number);
  std::string text =
      "\n" + wrapped(number.empty()
                         ? Words{"Tolerances:", "Tolleranze:"}.in(language)
                         : format_words("Tolerances, as for {}:", "Tolleranze, come per {}:", number).in(language),
                     2, 4);
  for (const Tolerance& each : marking.tolerances)
    text += wrapped(format_words("{}: {} ± {} ({})", "{}: {} ± {} ({})", each.quantity, decimal(each.value, 6),
                                 decimal(each.size, 2), each.by)
                        .in(language),
                    4, 6);
  return text;
}

std::string absent_students(const Answers& answers, Language language) {
  if (answers.absent.empty()) return "";
  std::vector<std::string> pieces = {
      Words{"In the key, and without answers:", "Nella chiave, e senza risposte:"}.in(language)};
  for (const Student& each : answers.absent)
    pieces.push_back(printable(each.number + (each.name.empty() ? "" : " " + each.name)) + ",");
  pieces.back().pop_back();
  return "\n" + wrapped(pieces, 2, 4);
}

std::string totals_of_marks(const Answers& answers, const Marking& marking, Language language) {
  std::array<std::size_t, 5> counts = {};
  Rational sum = 0, most = 0;
  int marked = 0;  // not who is in no key
  for (const MarkedStudent& student : marking.students) {
    for (const Mark& mark : student.marks) ++counts.at(mark.kind);
    sum += student.points;
    most += student.most;
    marked += student.most > 0 ? 1 : 0;
  }
  const auto students = static_cast<int>(answers.students.size());
  const double share = most == 0 ? 0 : nearest(sum / most * 100);
  const Words text = format_words(
      "{} {}, {} points of {}, mean {} of {} ({} %); answers: right {}, slips {}, wrong {}, missing {}, not marked "
      "{}",
      "{} {}, {} punti su {}, media {} su {} ({} %); risposte: giuste {}, sviste {}, sbagliate {}, mancanti {}, non "
      "valutate {}",
      students, students == 1 ? Words{"student", "studente"} : Words{"students", "studenti"}, points_in_words(sum),
      points_in_words(most), decimal(nearest(sum / std::max(marked, 1)), 3),
      decimal(nearest(most / std::max(marked, 1)), 3), decimal(fmt::format("{:.0f}", share)), counts[0], counts[1],
      counts[2], counts[3], counts[4]);
  return "\n" + wrapped(text.in(language), 0, 2);
}

}  // namespace

std::string mark_report(const Exercise& exercise, const Answers& answers, const Marking& marking,
                        const MarkingRules& rules, const Reader& reader) {
  const Language language = reader.language;
  return wrapped(exercise.about().id + ": " + drawings::plain(exercise.about().title.in(language)), 0, 2) + "\n" +
         table_of_marks(answers, marking, rules, reader) + remarks_on_answers(answers, marking, language) +
         tolerances(answers, marking, language) + absent_students(answers, language) +
         totals_of_marks(answers, marking, language);
}

std::string mark_csv(const Answers& answers, const Marking& marking, const MarkingRules& rules, const CsvStyle& style,
                     Language asked) {
  const Language language = style.language(asked);
  const auto words = [&](const Words& of) { return style.field(of.in(language)); };
  std::vector<std::string> header = {words({"number", "matricola"}), words({"name", "nome"})};
  for (const Quantity& each : answers.asked) {
    header.push_back(words(Words{each.name, each.name} + Words{" points", " punti"}));
    header.push_back(words(Words{each.name, each.name} + Words{" verdict", " giudizio"}));
  }
  header.push_back(words({"total", "totale"}));
  if (rules.out_of) header.push_back(words(Words{"out of ", "su "} + style.number(nearest(*rules.out_of))));
  header.push_back(words({"remarks", "osservazioni"}));
  const auto who = [&](const Student& student) -> std::vector<std::string> {
    return {style.field(harmless_cell(printable(student.number))),
            style.field(harmless_cell(printable(student.name)))};
  };
  std::string text = std::string(style.begin()) + style.record(header);
  for (std::size_t i = 0; i < answers.students.size(); ++i) {
    const Student& student = answers.students[i];
    std::vector<std::string> row = who(student);
    std::string remarks;
    const auto add_remark = [&](const std::string& remark) {
      remarks += (remarks.empty() ? "" : "; ") + printable(remark);
    };
    for (const Words& each : student.remarks) add_remark(each.in(language));
    for (std::size_t k = 0; k < answers.asked.size(); ++k) {
      const Mark& mark = marking.students[i].marks[k];
      const bool is_marked = mark.kind != Mark::not_marked;
      row.push_back(is_marked ? style.number(nearest(points_given(mark, answers.asked[k].name, rules))) : "");
      row.push_back(words(sign_of(mark.kind).meaning));
      if (!mark.remark.empty()) add_remark(answers.asked[k].name + ": " + mark.remark.in(language));
    }
    row.push_back(style.number(nearest(marking.students[i].points)));
    if (rules.out_of) {
      const auto mark = mark_out_of(*rules.out_of, marking.students[i]);
      row.push_back(mark ? style.number(nearest(*mark)) : "");
    }
    row.push_back(style.field(remarks));
    text += style.record(row);
  }
  for (const Student& each : answers.absent) {
    std::vector<std::string> row = who(each);
    row.resize(header.size());
    row.back() = words({"absent: in the key, and without answers", "assente: nella chiave, e senza risposte"});
    text += style.record(row);
  }
  return text;
}

}  // namespace epure
