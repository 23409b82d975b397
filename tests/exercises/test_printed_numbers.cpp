// Every number that a sheet tells is a quantity of the solution, as it is rounded for that place: in the column, in
// both languages, and in the description. (Of the exercises whose sheets are made of panels.)
#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/kit/statement/decimal.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<std::pair<std::string, std::vector<Assignments>>> tried{
    {"gear-pair",
     {{},
      {"z1=8"},
      {"x1=0.5", "x2=0.3", "z1=17", "z2=35"},
      {"kind=internal", "z1=20", "z2=60"},
      {"kind=rack", "alpha=20"},
      {"ha=0.5", "alpha=28"},
      {"z1=60", "z2=10", "ha=1.2", "hf=1.45", "alpha=15"}}},
    {"friction-efficiency",
     {{},
      {"phi=12"},
      {"phi=0"},
      {"wedge_collar.theta=25", "wedge_collar.w=0.05", "double_slider.l=2"},
      {"sliding_levers.direction_P=73", "fairbairn.theta=10", "double_slider_pins.r=0.03"}}},
    {"ideal-statics",
     {{},
      {"wedge_collar.theta=20", "double_slider.theta=30"},
      {"wedge_collar.Q=1234", "wedge_collar.y_lower=-0.01", "double_slider.l=2"},
      {"sliding_levers.direction_P=73", "fairbairn.theta=10"},
      {"sliding_levers.y_C=0", "fairbairn.AB=0.5", "sliding_levers_Q_on_2.x_Q=0.4"}}},
    {"velocity-centre",
     {{}, {"phi=200", "omega=-2.7"}, {"V=0"}, {"omega=0"}, {"omega=0", "omega_dot=0"}, {"phi=90"}, {"L=0.37"}}},
    {"pin-in-slot",
     {{}, {"OB=0.2"}, {"omega=-1", "omega_dot=1"}, {"omega_dot=-20"}, {"omega=0"}, {"OB=0.25"}, {"J2=0", "M1=0"}}},
    {"four-bar",
     {{},
      {"branch=left", "n=-50"},
      {"C_side=left", "alpha_2=3"},
      {"t=0.42"},
      {"A0A=0.2", "B0B=0.4", "AB=0.74", "x_B0=0.5", "y_B0=0.24", "AC=0.5", "t=0"},
      {"A0A=0.3", "AB=0.35", "B0B=0.32", "x_B0=0.1", "y_B0=0.05", "AC=0.21"}}},
    {"slider-crank-velocity",
     {{}, {"phi=200"}, {"phi=90"}, {"phi=0"}, {"e=0.05"}, {"delta=20", "phi=-33"}, {"n=-41"}}},
    {"four-bar-constraints",
     {{},
      {"theta_3_start=-1.4", "theta_4_start=0.6"},
      {"theta_3_start=0.5", "theta_4_start=-1.8"},
      {"theta_3_start=100", "theta_4_start=3"},
      {"n=-300", "alpha_2=50", "theta_2=200"},
      {"A0B0=800", "A0A=200", "AB=500", "B0B=700"}}},
    {"slider-crank-acceleration",
     {{},
      {"phi=0"},
      {"phi=90"},
      {"r=0.03", "phi=2"},
      {"alpha_2=300", "e=0.05"},
      {"delta=20", "phi=110", "alpha_2=20"},
      {"n=-200"}}},
    {"rivals-polygons", {{}, {"phi=0"}, {"phi=90"}, {"n=-100", "phi=200"}, {"AG=-0.2", "alpha_2=900"}, {"AG=0"}}},
    {"four-bar-analytic",
     {{},
      {"branch=right"},
      {"n=-400", "alpha_2=300"},
      {"theta_2=240"},
      {"A0B0=0.2", "A0A=0.6"},
      {"A0B0=0.5", "A0A=0.4", "AB=0.2", "B0B=0.45", "theta_2=60"},
      {"AP_along=0.7", "AP_across=-0.3"}}},
    {"roulette",
     {{},
      {"phi=480"},
      {"how=circle_on_line", "d=0.3", "alpha=3"},
      {"how=circle_on_line", "d=0.075", "phi=60"},
      {"how=circle_inside_circle", "R=0.3", "omega=-2"},
      {"how=line_on_circle", "d=0"},
      {"omega=0", "alpha=4"}}},
    {"cycloid-involute",
     {{},
      {"phi=0", "s=0", "t1=0"},
      {"phi=90", "s=1"},
      {"phi=500", "s=6", "t1=0.2", "t2=0.1"},
      {"d=1.4", "d_0=3", "omega_1=3000", "t1=0.0001"},
      {"d=40", "s=1000", "d_0=0.05"}}}};

// Without what is raised or lowered, which belongs to a symbol, but for powers of ten.
std::string without_indices(std::string text) {
  text = std::regex_replace(text, std::regex(R"(·10\$?\^\{[−-]?\d+\})"), "·10");
  return std::regex_replace(text, std::regex(R"([_^]\{[^}]*\})"), "");
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
  for (const Printed& printed : exercise.about().printed) {
    add_numbers(decimal(printed.text).in(language));
    if (printed.explanation) add_numbers(printed.explanation->sentence.in(language));
  }
  for (const RouteValue& value : solution.values()) {
    if (!value.described) continue;
    const auto known = solution.value(value.quantity);
    if (!known) continue;
    for (int digits = 3; digits <= 9; ++digits) {
      all.insert(as_number_in(figures(*known, digits, language)));
      if (value.described->unit != "m") continue;
      for (const double mm : {1000 * *known, std::abs(1000 * *known)})
        all.insert(as_number_in(figures(mm, digits, language)));
    }
    const std::string in_description = in_words({"", ""}, {{"x", *known, ""}}, language);
    if (!numbers_in(in_description).empty()) all.insert(numbers_in(in_description).front());
  }
  return all;
}

// "(x; y)" tells the two coordinates or components of one thing.
bool tells_pairs_that_belong_together(const std::string& text, const Solution& solution, Language language) {
  static const std::regex pair(R"(\(([^();]+); ([^();]+)\))");
  for (auto each = std::sregex_iterator(text.begin(), text.end(), pair); each != std::sregex_iterator(); ++each) {
    const auto is_this_pair = [&](const RouteValue& value) {
      if (!value.quantity.ends_with("_x") || !value.described) return false;
      const std::string name = value.quantity.substr(0, value.quantity.size() - 2);
      const std::optional<Place> P = solution.point(name);
      return P && figures(P->x, 4, language) == (*each)[1] && figures(P->y, 4, language) == (*each)[2];
    };
    const auto& all = solution.values();
    if (std::none_of(all.begin(), all.end(), is_this_pair)) return false;
  }
  return true;
}

// Both values of a row lie as near to its quantity as a ruler can tell.
bool measures_its_quantity(const std::vector<std::string>& row, const Solution& solution) {
  const auto read = [](std::string text) {
    std::replace(text.begin(), text.end(), ',', '.');
    return std::strtod(std::regex_replace(text, std::regex("−"), "-").c_str(), nullptr);
  };
  for (const RouteValue& value : solution.values()) {
    if (!value.described || row[0].find(value.described->symbol) > 1) continue;  // perhaps after "|"
    const double known = std::abs(solution[value.quantity]);
    return std::abs(read(row[1]) - known) <= 2e-3 * known && std::abs(read(row[2]) - known) <= 2e-3 * known;
  }
  return false;
}

}  // namespace

TEST_CASE("what is printed is a quantity of the solution") {
  int seen = 0;
  for (const auto& [id, sets] : tried)
    for (const Assignments& assignments : sets)
      for (const Language language : {Language::english, Language::italian}) {
        const Exercise& exercise = find_exercise(catalogue(), id);
        const Solution solution = exercise.solution(Tried(id).givens(assignments));
        const std::set<std::string> printable = printable_numbers(exercise, solution, language);
        for (const SheetSpec& spec : exercise.about().sheets) {
          CAPTURE(id, assignments, spec.name, static_cast<int>(language));
          const TextOfSheet told = told_by(exercise.draw(spec.name, solution, {.language = language}).sheet);
          for (const std::string& text : told.words) {
            CAPTURE(text);
            CHECK(tells_pairs_that_belong_together(text, solution, language));
            for (const std::string& number : numbers_in(text)) {
              INFO("\"" << number << "\" in: " << text);
              CHECK(printable.contains(number));
              ++seen;
            }
          }
          for (const auto& row : told.measured) {
            CAPTURE(row);
            CHECK(measures_its_quantity(row, solution));
            ++seen;
          }
        }
      }
  CHECK(seen > 150);
}
