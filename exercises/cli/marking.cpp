#include "exercises/cli/marking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawings/text/text.h"
#include "exercises/cli/abreast.h"
#include "exercises/cli/slips.h"
#include "geometry/numbers/given.h"

namespace epure {
namespace {

// The students of one set of givens, whose sheets were drawn alike.
struct Group {
  const Givens* givens;
  const SheetScales* sheets;
  std::vector<std::size_t> students;
};

std::string text_of(const Givens& givens, const SheetScales& sheets) {
  std::string text;
  for (const GivenSpec& spec : givens.specs()) {
    const auto read = givens.reading(spec.symbol);
    text += givens.text(spec.symbol) + (read ? read->unit.symbol : "") + ";";
  }
  for (const auto& [sheet, scale] : sheets) text += sheet + geometry::to_text(scale) + ";";
  return text;
}

std::vector<Group> groups_of(const Answers& answers) {
  std::vector<Group> groups;
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < answers.students.size(); ++i) {
    const auto& [givens, sheets] = std::tie(answers.students[i].givens, answers.students[i].sheets);
    if (!givens) continue;
    const auto [place, is_new] = known.emplace(text_of(*givens, sheets), groups.size());
    if (is_new) groups.push_back({&*givens, &sheets, {}});
    groups[place->second].students.push_back(i);
  }
  return groups;
}

const CheckedQuantity* find_checked(const CheckedExercise& checked, const std::string& name) {
  const auto found = std::find_if(checked.quantities.begin(), checked.quantities.end(),
                                  [&](const CheckedQuantity& each) { return each.spec.name == name; });
  return found == checked.quantities.end() ? nullptr : &*found;
}

std::string after_number(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

// Reasons are rich text; what a student typed is none.
Words in_plain_text(const Words& rich) { return {drawings::plain(rich.english), drawings::plain(rich.italian)}; }

// Why there is no number to hold an answer against.
Words no_value(const CheckedQuantity* quantity) {
  if (!quantity) return {"not marked: nothing is known of it", "non valutata: non se ne sa nulla"};
  if (quantity->settled.kind == geometry::Settled::Kind::absent)
    return format_words("not marked: it does not exist ({})", "non valutata: non esiste ({})",
                        in_plain_text(quantity->settled.reason));
  return format_words("not marked: undecided ({})", "non valutata: non decisa ({})",
                      in_plain_text(quantity->settled.reason));
}

Rational most_points(const std::string& quantity, const MarkingRules& rules) {
  const auto found = rules.points.find(quantity);
  return found == rules.points.end() ? Rational(1) : found->second;
}

// "1.234" is read as 1.234; where 1234 would be right, that is told and not guessed.
Words as_thousands(const std::string& answer, const Decimal& number, double value, const Allowance& allowed,
                   const Quantity& quantity) {
  const auto separator = answer.find_first_of(".,");
  if (separator == std::string::npos || separator == 0) return {};
  const auto digits = std::min(answer.find_first_not_of("0123456789", separator + 1), answer.size()) - separator - 1;
  Decimal thousandfold = number;
  thousandfold.value *= 1000;
  thousandfold.half_unit *= 1000;
  if (digits != 3 || !is_near(thousandfold, value, allowed.size, quantity)) return {};
  return format_words("; or is its \"{}\" a separator of thousands?", "; o il suo \"{}\" separa le migliaia?",
                      answer.substr(separator, 1));
}

// Marks answers for one set of givens.
class Marker {
 public:
  Marker(const Exercise& exercise, const CheckedExercise& checked, const MarkingRules& rules)
      : checked_(checked), rules_(rules), slips_(exercise, checked) {}

  MarkedStudent mark(const Student& student, const std::vector<Quantity>& asked) {
    Allowances& allowances = allowances_of(student);
    MarkedStudent marked;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      marked.marks.push_back(mark(asked[i], student.answers[i], allowances));
      const Mark& mark = marked.marks.back();
      if (mark.kind == Mark::not_marked) continue;
      marked.most += most_points(asked[i].name, rules_);
      marked.points += points_given(mark, asked[i].name, rules_);
    }
    return marked;
  }

  std::vector<Tolerance> tolerances(const Student& student, const std::vector<Quantity>& asked) {
    std::vector<Tolerance> all;
    for (const Quantity& spec : asked)
      if (const CheckedQuantity* quantity = find_checked(checked_, spec.name);
          quantity && has_value(quantity->settled)) {
        const Allowance& allowed = allowances_of(student).of(*quantity);
        all.push_back({spec.name, quantity->settled.enclosure.value, nearest(allowed.size), allowed.by});
      }
    return all;
  }

 private:
  // With the student's own scales before those that hold for all. One class mostly draws at one scale.
  Allowances& allowances_of(const Student& student) {
    Ruler ruler = rules_.ruler;
    ruler.scales.insert(ruler.scales.begin(), student.scales.begin(), student.scales.end());
    if (!allowances_ || allowances_->ruler().scales != ruler.scales) allowances_.emplace(checked_, std::move(ruler));
    return *allowances_;
  }

  Mark mark(const Quantity& spec, const std::string& answer, Allowances& allowances) {
    const CheckedQuantity* quantity = find_checked(checked_, spec.name);
    if (!quantity || !has_value(quantity->settled)) return {Mark::not_marked, no_value(quantity)};
    if (answer.empty()) return {Mark::none};
    try {
      const Decimal number = read_measured(answer, spec.unit);
      const Allowance& by_reading = allowances.of(*quantity);
      const double value = quantity->settled.enclosure.value;
      if (is_near(number, value, allowance_of(number, by_reading).size, spec)) return {Mark::right};
      const Words found =
          format_words("{}{}, true {} ± {}", "{}{}, vero {} ± {}", decimal(nearest(number.value), 6),
                       after_number(spec.unit), decimal(value, 6), decimal(nearest(by_reading.size), 2));
      if (const auto slip = slips_.explain(*quantity, number, allowances))
        return {Mark::slip, found + ": " + *slip + as_thousands(answer, number, value, by_reading, spec)};
      return {Mark::wrong, found};
    } catch (const geometry::BadGiven& unreadable) {
      return {Mark::wrong, unreadable.words()};
    }
  }

  const CheckedExercise& checked_;
  const MarkingRules& rules_;
  Slips slips_;
  std::optional<Allowances> allowances_ = {};
};

// The student and, where it stands, the quantity: the begin of a sentence.
std::string called(const Student& student, const std::string& quantity) {
  return student.number + (student.number.empty() || quantity.empty() ? "" : " ") + quantity;
}

// Where the key has another value: neither within the bounds nor the true value as rounded by a spreadsheet.
std::vector<Words> differences(const Student& student, const CheckedExercise& checked) {
  std::vector<Words> all;
  for (const KeyValue& each : student.key) {
    const CheckedQuantity* quantity = find_checked(checked, each.quantity);
    if (!quantity || !has_value(quantity->settled)) continue;
    try {
      const Decimal number = read_measured(each.text, quantity->spec.unit);
      const auto& [lower, value, upper] = quantity->settled.enclosure;
      const double read = nearest(number.value);  // a key is written in doubles
      const bool is_within = lower <= read && read <= upper;
      if (is_within || CGAL::abs(number.value - Rational(value)) <= number.half_unit) continue;
    } catch (const geometry::BadGiven&) {
      // then it is not the number either
    }
    all.push_back(format_words(
        "{}: {} in the key's line {}, but {} is true: is it the key of another version, or of "
        "other --set?",
        "{}: {} alla riga {} della chiave, ma il vero è {}: è la chiave di un'altra versione, "
        "o di altri --set?",
        called(student, each.quantity), each.text, each.line, decimal(quantity->settled.enclosure.value, 6)));
  }
  return all;
}

// What one group comes to; the groups are marked by several threads.
struct MarkedGroup {
  std::vector<MarkedStudent> students;
  std::vector<Tolerance> tolerances;
  std::vector<Words> undecided, other_key;
  std::size_t keyed = 0, contradicted = 0;
  std::optional<Words> refused;  // why the givens cannot be
};

MarkedGroup mark_group(const Exercise& exercise, const Answers& answers, const Group& group,
                       const MarkingRules& rules) {
  MarkedGroup marked;
  try {
    const CheckedExercise checked = check(exercise, *group.givens, Rung::climb, *group.sheets);
    Marker marker(exercise, checked, rules);
    marked.tolerances = marker.tolerances(answers.students[group.students.front()], answers.asked);
    for (const std::size_t i : group.students) {
      const Student& student = answers.students[i];
      marked.students.push_back(marker.mark(student, answers.asked));
      const std::vector<Words> other = differences(student, checked);
      marked.other_key.insert(marked.other_key.end(), other.begin(), other.end());
      marked.keyed += student.key.empty() ? 0 : 1;
      marked.contradicted += other.empty() ? 0 : 1;
      for (const Quantity& spec : answers.asked)
        if (const CheckedQuantity* quantity = find_checked(checked, spec.name);
            quantity && quantity->settled.kind == geometry::Settled::Kind::undecided)
          marked.undecided.push_back(called(student, spec.name) + ": " + in_plain_text(quantity->settled.reason));
    }
  } catch (const geometry::Undecided& open) {
    for (const std::size_t i : group.students) {
      marked.undecided.push_back(
          called(answers.students[i], answers.students[i].number.empty() ? exercise.about().id : std::string()) +
          ": " + open.words());
    }
    marked.refused = format_words("not marked, as it cannot be decided: {}",
                                  "non valutato, perché non si può decidere: {}", open.words());
  } catch (const BadGivens& impossible) {
    marked.refused =
        format_words("not marked, because of the givens: {}", "non valutato, per i dati: {}", impossible.words());
  } catch (const geometry::Impossible& impossible) {
    marked.refused =
        format_words("not marked, because of the givens: {}", "non valutato, per i dati: {}", impossible.words());
  }
  return marked;
}

}  // namespace

Rational points_given(const Mark& mark, const std::string& quantity, const MarkingRules& rules) {
  if (mark.kind == Mark::right) return most_points(quantity, rules);
  return mark.kind == Mark::slip ? Rational(most_points(quantity, rules) * rules.slip_points) : Rational(0);
}

std::optional<Rational> mark_out_of(const Rational& all, const MarkedStudent& student) {
  if (student.most == 0) return {};
  const Rational tenths = 10 * all * student.points / student.most;
  return Rational(std::floor(nearest(tenths + Rational(1, 2)))) / 10;
}

Marking mark_answers(const Exercise& exercise, Answers& answers, const MarkingRules& rules) {
  const std::vector<Group> groups = groups_of(answers);
  std::vector<MarkedGroup> marked(groups.size());
  abreast(groups.size(), [&](std::size_t i) { marked[i] = mark_group(exercise, answers, groups[i], rules); });

  Marking all;
  const std::vector<Mark> none(answers.asked.size(), {Mark::not_marked});
  all.students.assign(answers.students.size(), {none});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t k = 0; k < groups[g].students.size(); ++k) {
      const std::size_t i = groups[g].students[k];
      if (marked[g].refused)
        answers.students[i].remarks.push_back(*marked[g].refused);
      else
        all.students[i] = std::move(marked[g].students[k]);
    }
    if (all.tolerances.empty()) all.tolerances = std::move(marked[g].tolerances);
    all.undecided.insert(all.undecided.end(), marked[g].undecided.begin(), marked[g].undecided.end());
    all.other_key.insert(all.other_key.end(), marked[g].other_key.begin(), marked[g].other_key.end());
    all.keyed += marked[g].keyed;
    all.contradicted += marked[g].contradicted;
  }
  return all;
}

}  // namespace epure
