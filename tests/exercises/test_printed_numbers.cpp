// Every number that a sheet tells is a quantity of the solution, as it is rounded for that place: in the column, in
// both languages, in the description, and on the picture.
#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/kit/proof/told_numbers.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/workshop_unit.h"
#include "tests/exercises/tried_givens.h"

using namespace epure;
using namespace epure::tests;

namespace {

// Without what is raised or lowered, which belongs to a symbol, but for powers of ten.
std::string without_indices(std::string text) {
  static const std::regex power(R"(·10\$?\^\{[−-]?\d+\})"), index(R"([_^]\{[^}]*\})");
  return std::regex_replace(std::regex_replace(text, power, "·10"), index, "");
}

// Numbers with a decimal sign: whole ones stand in formulas and counts.
std::vector<std::string> numbers_in(const std::string& text) {
  static const std::regex number(R"([−-]?\d+[.,]\d+(e[-+]?\d+|·10)?)");
  const std::string plain = without_indices(text);
  return {std::sregex_token_iterator(plain.begin(), plain.end(), number), std::sregex_token_iterator()};
}

std::string as_number_in(const std::string& rounded) {
  const std::vector<std::string> found = numbers_in(rounded);
  return found.empty() ? rounded : found.front();
}

struct TextOfSheet {
  std::vector<std::string> words;                  // paragraphs, steps, cells
  std::vector<std::vector<std::string>> measured;  // rows of tables that hold measured values
};
TextOfSheet told_by(const drawings::Sheet& sheet) {
  TextOfSheet told{{sheet.description}, {}};
  // What is given, and how near a drawn curve is to the true one, which depends on the sheet's scale.
  const std::set<std::string> of_no_solution{"Given", "Dati", "The curve", "La curva", "The curves", "Le curve"};
  bool is_of_solution = true;
  for (const drawings::Block& block : sheet.column) {
    if (const auto* heading = std::get_if<drawings::Heading>(&block))
      is_of_solution = !of_no_solution.contains(heading->text);
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block); paragraph && is_of_solution)
      told.words.push_back(paragraph->text);
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      told.words.insert(told.words.end(), steps->lines.begin(), steps->lines.end());
    if (const auto* table = std::get_if<drawings::Table>(&block)) {
      for (const auto& row : table->rows) {
        if (table->head.back() == "Δ %")
          told.measured.push_back(row);
        else
          told.words.insert(told.words.end(), row.begin(), row.end());
      }
    }
  }
  return told;
}

// All that a sheet may print: every quantity, as it is rounded anywhere.
std::set<std::string> printable_numbers(const Exercise& exercise, const Solution& solution, Language language) {
  std::set<std::string> all;
  // What is given, what check says is wrong with the mechanism, and what the source printed.
  const auto add_numbers = [&](const std::string& text) {
    for (const std::string& number : numbers_in(text)) all.insert(number);
  };
  for (const GivenSpec& spec : solution.givens().specs())
    if (spec.choices.empty() && !solution.givens().follows(spec.symbol))
      add_numbers(decimal(nearest(solution.givens()[spec.symbol]), 6).in(language));
  for (const Flaw& flaw : exercise.flaws(solution.givens())) add_numbers(flaw.sentence.in(language));
  for (const Printed& printed : exercise.about().printed()) {
    add_numbers(decimal(printed.text).in(language));
    if (printed.explanation) add_numbers(printed.explanation->sentence.in(language));
  }
  for (const RouteValue& value : solution.values()) {
    if (!value.described) continue;
    const auto known = solution.value(value.quantity);
    if (!known) continue;
    for (int digits = 3; digits <= 9; ++digits) {
      all.insert(as_number_in(figures(*known, digits, language)));
      const auto unit = workshop_unit(value.described->unit);
      if (!unit) continue;
      for (const double told : {unit->per_si * *known, std::abs(unit->per_si * *known)})
        all.insert(as_number_in(figures(told, digits, language)));
    }
    const std::string in_description = in_words({"", ""}, {{"x", *known, ""}}, language);
    if (!numbers_in(in_description).empty()) all.insert(numbers_in(in_description).front());
  }
  return all;
}

// The two coordinates or components of each thing, as "(x; y)" tells them.
std::set<std::string> pairs_that_belong_together(const Solution& solution, Language language) {
  std::set<std::string> pairs;
  for (const RouteValue& value : solution.values()) {
    if (!value.quantity.ends_with("_x") || !value.described) continue;
    const std::string name = value.quantity.substr(0, value.quantity.size() - 2);
    if (!solution.has(name + "_y")) continue;  // an abscissa by itself
    if (const std::optional<Place> P = solution.point(name))
      pairs.insert("(" + figures(P->x, 4, language) + "; " + figures(P->y, 4, language) + ")");
  }
  return pairs;
}
bool tells_pairs_among(const std::set<std::string>& pairs, const std::string& text) {
  static const std::regex pair(R"(\([^();]+; [^();]+\))");
  return std::all_of(std::sregex_iterator(text.begin(), text.end(), pair), std::sregex_iterator(),
                     [&](const auto& each) { return pairs.contains(each.str()); });
}

// Half a unit of the last digit of a number without a power of ten.
double half_a_unit(const std::string& number) {
  const auto point = number.find_first_of(".,");
  return point == std::string::npos ? 0.5 : 0.5 * std::pow(10.0, -static_cast<double>(number.size() - point - 1));
}

double read(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  static const std::regex minus("−");
  return std::strtod(std::regex_replace(text, minus, "-").c_str(), nullptr);
}

// The difference of a row, in percent of its first value, is that of both as they are printed.
bool tells_its_difference(const std::vector<std::string>& row) {
  const double first = read(row[1]), difference = first == 0 ? 0 : 100 * (read(row[2]) - first) / first;
  return std::abs(read(row[3]) - std::abs(difference)) <= half_a_unit(row[3]) + 1e-9;
}

// Both values of a row lie as near to its quantity as a ruler can tell, and their last digits.
bool measures_its_quantity(const std::vector<std::string>& row, const Solution& solution) {
  for (const RouteValue& value : solution.values()) {
    if (!value.described || row[0].find(value.described->symbol) > 1) continue;  // perhaps after "|"
    const double known = std::abs(solution[value.quantity]);
    return std::abs(read(row[1]) - known) <= 2e-3 * known + half_a_unit(row[1]) &&
           std::abs(read(row[2]) - known) <= 2e-3 * known + half_a_unit(row[2]);
  }
  return false;
}

// The letters beside points, curves and dimension lines. Not the numbers along an axis; nor what tells of no
// quantity: how far from the axis a pole stands on paper, a close-up's scale, and at which instants (the round ones)
// a point is there.
drawings::Sheet letters_of_picture(const std::string& id, const drawings::Figure& figure) {
  static const std::regex on_paper(R"(((\$h\$ = )?\d+(\.\d+)? mm)|(1 cm ≙ .*))"), instant(R"((\d; )*\d\.\d)");
  drawings::Sheet as_read;
  const auto add = [&](const std::string& text) {
    if (std::regex_match(text, on_paper)) return;
    if (id == "oscillator-pendulum" && std::regex_match(text, instant)) return;
    as_read.column.push_back(drawings::Paragraph{text});
  };
  for (const drawings::Label& label : figure.labels) add(label.text);
  for (const drawings::Mark& mark : figure.marks)
    if (const auto* dimension = std::get_if<drawings::Dimension>(&mark)) add(dimension->text);
  return as_read;
}

// Without letters what is given: as typed, and in the base unit.
std::vector<KnownNumber> known_numbers(const Solution& solution) {
  std::vector<KnownNumber> known;
  for (const RouteValue& value : solution.values()) {
    const auto number = value.described ? solution.value(value.quantity) : std::nullopt;
    if (!number) continue;
    known.push_back({value.quantity, value.described->symbol, *number});
    if (const auto unit = workshop_unit(value.described->unit))
      known.push_back({value.quantity, value.described->symbol, unit->per_si * *number});
  }
  const Givens& givens = solution.givens();
  for (const GivenSpec& spec : givens.specs()) {
    const auto read = givens.reading(spec.symbol);
    if (!read || !spec.choices.empty() || givens.follows(spec.symbol)) continue;
    known.push_back({"", "", nearest(read->number)});
    known.push_back({"", "", nearest(givens[spec.symbol])});
  }
  return known;
}

}  // namespace

TEST_CASE("numbers on the pictures are quantities of the solution") {
  int seen = 0;
  for_each_tried([&](const TriedSolution& tried) {
    const std::vector<KnownNumber> known = known_numbers(tried.solution);
    for (const SheetSpec& spec : tried.exercise.about().sheets) {
      CAPTURE(spec.name);
      const drawings::Sheet letters =
          letters_of_picture(tried.id, tried.exercise.draw(spec.name, tried.solution, {}).sheet.figure);
      for (const WrongNumber& wrong : wrong_numbers(letters, known)) {
        INFO("\"" << wrong.number << "\" in: " << wrong.text);
        CHECK(wrong.number.empty());
      }
      for (const drawings::Block& block : letters.column)
        seen += numbers_in(std::get<drawings::Paragraph>(block).text).empty() ? 0 : 1;
    }
  });
  CHECK(seen > 400);
}

TEST_CASE("what is printed is a quantity of the solution") {
  int seen = 0;
  for_each_tried([&](const TriedSolution& tried) {
    for (const Language language : {Language::english, Language::italian}) {
      const auto& [id, assignments, exercise, solution] = tried;
      const std::set<std::string> printable = printable_numbers(exercise, solution, language),
                                  pairs = pairs_that_belong_together(solution, language);
      for (const SheetSpec& spec : exercise.about().sheets) {
        CAPTURE(spec.name, static_cast<int>(language));
        const TextOfSheet told = told_by(exercise.draw(spec.name, solution, {.language = language}).sheet);
        for (const std::string& text : told.words) {
          CAPTURE(text);
          CHECK(tells_pairs_among(pairs, text));
          for (const std::string& number : numbers_in(text)) {
            INFO("\"" << number << "\" in: " << text);
            CHECK(printable.contains(number));
            ++seen;
          }
        }
        for (const auto& row : told.measured) {
          CAPTURE(row);
          CHECK(measures_its_quantity(row, solution));
          CHECK(tells_its_difference(row));
          ++seen;
        }
      }
    }
  });
  CHECK(seen > 150);
}
