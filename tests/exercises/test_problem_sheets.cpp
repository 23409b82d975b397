// Sheets to be solved: what is given lies where it lies on the solved sheet, and nothing tells what is to be found.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "drawings/output.h"
#include "drawings/page.h"
#include "exercises/kit/panels/problem_sheet.h"
#include "exercises/kit/proof/solution.h"
#include "tests/exercises/tried_givens.h"

using namespace epure;
using namespace epure::tests;

namespace {

// Every point through which a line or an area of the picture runs, to the micrometre; letters apart.
using Outline = std::vector<long>;
Outline outline_of(const drawings::Path& path) {
  Outline all;
  const auto add = [&](const drawings::Point& p) {
    for (const double x : {p.x, p.y}) all.push_back(std::lround(1000 * x));
  };
  add(path.start);
  for (const drawings::Piece& piece : path.pieces) {
    if (!piece.straight) {
      add(piece.first_control);
      add(piece.second_control);
    }
    add(piece.end);
  }
  return all;
}

std::vector<Outline> outlines_of_figure(const drawings::Sheet& sheet) {
  drawings::Sheet bare = sheet;
  bare.bare = true;
  bare.figure.labels.clear();
  bare.figure.steps.clear();
  std::vector<Outline> all;
  // The scale bars, which a bare figure has right under it, as they stand on the sheet: after all other marks.
  while (!bare.figure.marks.empty()) {
    const auto* bar = std::get_if<drawings::ScaleBar>(&bare.figure.marks.back());
    if (!bar) break;
    all.push_back(outline_of(drawings::segment(bar->at, {bar->at.x + bar->length, bar->at.y})));
    bare.figure.marks.pop_back();
  }
  for (const drawings::Primitive& primitive : drawings::compose(bare).primitives) {
    if (const auto* stroke = std::get_if<drawings::Stroke>(&primitive)) all.push_back(outline_of(stroke->path));
    if (const auto* fill = std::get_if<drawings::Fill>(&primitive)) all.push_back(outline_of(fill->path));
  }
  return all;
}

// Two short strokes: a cross where a polygon begins.
std::size_t crosses_of_starts(const drawings::Sheet& sheet) {
  return static_cast<std::size_t>(
      std::count_if(sheet.figure.marks.begin(), sheet.figure.marks.end(), [](const drawings::Mark& mark) {
        const auto* cross = std::get_if<drawings::Cross>(&mark);
        return cross && cross->meaning == drawings::Meaning::construction;
      }));
}

// What a sheet asks for, cell by cell: "$v_{B}$ (m/s)"; and the same with what it is, or of which case.
std::vector<std::string> cells_in(const drawings::Table& table) {
  std::vector<std::string> all;
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); i += 2)
      if (!row[i].empty()) all.push_back(row[i]);
  return all;
}
std::string without_caption(const std::string& cell) { return cell.substr(0, cell.find('\n')); }
std::vector<std::string> asked_in(const drawings::Table& table) {
  std::vector<std::string> all = cells_in(table);
  for (std::string& cell : all) cell = without_caption(cell);
  return all;
}

std::vector<drawings::Table> tables_of(const drawings::Sheet& sheet) {
  std::vector<drawings::Table> all;
  for (const drawings::Block& block : sheet.column)
    if (const auto* table = std::get_if<drawings::Table>(&block)) all.push_back(*table);
  return all;
}

std::string paragraphs_of(const DrawnSheet& drawn) {
  std::string all;
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) all += paragraph->text + "\n";
  return all;
}

bool has_label(const DrawnSheet& drawn, const std::string& text) {
  const auto& labels = drawn.sheet.figure.labels;
  return std::any_of(labels.begin(), labels.end(), [&](const drawings::Label& each) { return each.text == text; });
}

std::string letter_at(const DrawnSheet& drawn, const drawings::Point& at) {
  for (const drawings::Label& each : drawn.sheet.figure.labels)
    if (!each.to && each.at.x == at.x && each.at.y == at.y) return each.text;
  return {};
}

DrawnSheet blank_sheet_of(const std::string& id, const std::string& sheet, const Assignments& assignments = {}) {
  for (const auto& exercise : catalogue()) {
    if (exercise.id() != id) continue;
    Givens givens(exercise->about().givens);
    for (const std::string& assignment : assignments) givens.set(assignment);
    return exercise->draw(sheet, givens, {.blank = true, .for_class = true});
  }
  throw std::logic_error("no " + id);
}

bool is_empty_table(const drawings::Table& table) {
  for (const auto& row : table.rows)
    for (std::size_t i = 1; i < row.size(); i += 2)
      if (!row[i].empty()) return false;
  return table.to_fill_in;
}

template <class Check>
void for_all_sheets(const Check& check) {
  for (const auto& exercise : catalogue()) {
    std::vector<Assignments> tried{{}};
    for (const auto& [id, sets] : tried_givens())
      if (id == exercise.id()) tried = sets;
    for (std::size_t i = 0; i < tried.size(); ++i) {
      Givens givens(exercise->about().givens);
      for (const std::string& assignment : tried[i]) givens.set(assignment);
      const Solution solution = exercise->solution(givens);
      SheetRequest request{.language = i % 2 == 0 ? Language::english : Language::italian, .for_class = true};
      for (const SheetSpec& sheet : exercise->about().sheets) {
        INFO(exercise.id() << "/" << sheet.name << ", set " << i);
        request.blank = false;
        const DrawnSheet solved = exercise->draw(sheet.name, solution, request);
        request.blank = true;
        check(*exercise, solved, exercise->draw(sheet.name, solution, request));
      }
    }
  }
}

}  // namespace

TEST_CASE("What a sheet to be solved shows lies where the solved sheet has it") {
  std::size_t shared = 0, with_less = 0;
  for_all_sheets([&](const Exercise&, const DrawnSheet& solved, const DrawnSheet& blank) {
    const std::vector<Outline> all = outlines_of_figure(solved.sheet), given = outlines_of_figure(blank.sheet);
    const std::set<Outline> there(all.begin(), all.end());
    const auto is_new = [&](const Outline& each) { return !there.contains(each); };
    const auto alone = static_cast<std::size_t>(std::count_if(given.begin(), given.end(), is_new));
    CHECK(alone <= 2 * crosses_of_starts(blank.sheet));
    shared += given.size() - alone;
    if (given.size() - alone < all.size()) ++with_less;
    CHECK(blank.sheet.title_block.scales == solved.sheet.title_block.scales);
  });
  CHECK(shared > 10000);
  CHECK(with_less > 500);  // all but those of what does not exist at some givens
}

TEST_CASE("A sheet to be solved tells the question and leaves the answers open") {
  for_all_sheets([&](const Exercise& exercise, const DrawnSheet& solved, const DrawnSheet& blank) {
    CHECK_FALSE(exercise.about().question.english.empty());
    CHECK_FALSE(exercise.about().question.italian.empty());
    CHECK(blank.sheet.figure.steps.empty());
    CHECK(blank.measurements.empty());
    CHECK(blank.sheet.id == solved.sheet.id + "-blank");
    CHECK(blank.asked == solved.asked);
    for (const std::string& name : blank.asked) {  // else no key has it, and nobody can mark it
      const auto& reported = exercise.about().quantities();
      CAPTURE(name);
      CHECK(std::any_of(reported.begin(), reported.end(), [&](const Quantity& each) { return each.name == name; }));
    }
    std::size_t tables = 0;
    for (const drawings::Block& block : blank.sheet.column) {
      CHECK_FALSE(std::holds_alternative<drawings::Steps>(block));
      CHECK_FALSE(std::holds_alternative<drawings::VectorEquation>(block));
      if (const auto* table = std::get_if<drawings::Table>(&block)) {
        CHECK(is_empty_table(*table));
        ++tables;
      }
    }
    CHECK(tables == (blank.asked.empty() ? 1 : 2));
    std::vector<std::string> conflicts;
    drawings::compose(blank.sheet, &conflicts);
    // Letters find room as they do on the solved sheet, which has tests of its own; the column is another here.
    std::erase_if(conflicts, [](const std::string& each) { return each.find("column") == std::string::npos; });
    CAPTURE(conflicts);
    CHECK(conflicts.empty());
  });
}

TEST_CASE("A sheet to be solved asks for each thing once, with the unit it is told in") {
  std::size_t long_ones = 0, alike = 0, all_told = 0;
  for_all_sheets([&](const Exercise& exercise, const DrawnSheet&, const DrawnSheet& blank) {
    if (blank.asked.empty()) return;
    const drawings::Table table = tables_of(blank.sheet).front();
    const std::vector<std::string> asked = asked_in(table);
    CHECK(asked.size() == blank.asked.size());
    CHECK(std::set<std::string>(blank.asked.begin(), blank.asked.end()).size() == blank.asked.size());
    if (table.rows.front().size() == 4) ++long_ones;
    // A symbol alone does not tell at which position, with which mass: nothing is written twice.
    const std::vector<std::string> cells = cells_in(table);
    CAPTURE(cells);
    CHECK(std::set<std::string>(cells.begin(), cells.end()).size() == cells.size());
    const auto has_caption = [](const std::string& cell) { return cell.find('\n') != std::string::npos; };
    const bool are_all_told = std::all_of(cells.begin(), cells.end(), has_caption);
    all_told += are_all_told ? 1 : 0;
    for (const std::string& cell : cells) {
      const auto times = std::count(asked.begin(), asked.end(), without_caption(cell));
      alike += times > 1 ? 1 : 0;
    }
    // In two columns they are read down the first, then down the second.
    std::vector<std::string> in_order;
    for (std::size_t column = 0; column < table.rows.front().size(); column += 2)
      for (const auto& row : table.rows)
        if (!row[column].empty()) in_order.push_back(row[column]);
    const auto& quantities = exercise.about().quantities();
    for (std::size_t i = 0; i < in_order.size() && i < blank.asked.size(); ++i)
      for (const Quantity& quantity : quantities)
        if (quantity.name == blank.asked[i]) CHECK(in_order[i].starts_with(quantity.symbol));
  });
  CHECK(long_ones > 5);
  CHECK(alike > 20);
  CHECK(all_told > 100);
  const auto wheels = asked_in(tables_of(blank_sheet_of("gear-pair", "wheels").sheet).front());
  CHECK(std::find(wheels.begin(), wheels.end(), "$r_{b1}$ (mm)") != wheels.end());
  CHECK(asked_in(tables_of(blank_sheet_of("gear-pair", "wheels", {"kind=rack"}).sheet).front()).size() ==
        5);  // wheel 1 alone
}

// What the solved sheet measures is on it, so it is asked; and what it asks for has a value.
TEST_CASE("A sheet to be solved does not ask for what is off it, or is nowhere") {
  std::size_t off = 0, nowhere = 0, measured = 0;
  for_all_sheets([&](const Exercise&, const DrawnSheet& solved, const DrawnSheet& blank) {
    std::set<std::string> shown;
    for (const Measurement& each : solved.measurements) shown.insert(each.quantity);
    for (const Awkwardness& each : solved.awkward) {
      const auto name = quantity_not_asked(each);
      if (!name) continue;
      INFO(*name);
      CHECK_FALSE(shown.contains(*name));
      CHECK(std::find(blank.asked.begin(), blank.asked.end(), *name) == blank.asked.end());
      (each.sentence.english.find("off") != std::string::npos ? off : nowhere) += 1;
    }
    for (const std::string& each : blank.asked) measured += shown.contains(each) ? 1 : 0;
  });
  CHECK(off > 10);
  CHECK(nowhere > 10);
  CHECK(measured > 1000);
  // The rod of the slider-crank translates: its pole is at infinity, its rate is zero.
  const DrawnSheet blank = blank_sheet_of("slider-crank-velocity", "poles", {"phi=90deg"});
  for (const char* gone : {"P0_x", "P0_y", "P0A", "P0B", "P0C", "P0M"})
    CHECK(std::find(blank.asked.begin(), blank.asked.end(), gone) == blank.asked.end());
  CHECK(std::find(blank.asked.begin(), blank.asked.end(), "omega_3") != blank.asked.end());
  CHECK(paragraphs_of(blank).find("Not asked, as it lies at infinity or does not exist: ") != std::string::npos);
}

TEST_CASE("A sheet to be solved says which sense is positive of what it asks") {
  CHECK(paragraphs_of(blank_sheet_of("slider-crank-velocity", "poles"))
            .find("\nPositive sense: counter-clockwise.\n") != std::string::npos);
  CHECK(paragraphs_of(blank_sheet_of("four-bar", "circles"))
            .find("x to the right, y upwards; coordinates from $A_{0}$.\n") != std::string::npos);
  CHECK(paragraphs_of(blank_sheet_of("michell-bearing", "load")).find("Positive sense") == std::string::npos);
}

TEST_CASE("The case of a meaning is what it has beyond those that begin as it does") {
  using List = std::vector<std::string>;
  CHECK(cases_of({"weight, with 600 kg", "weight"}) == List{"with 600 kg", ""});
  CHECK(cases_of({"pull, heavy one, rolling", "pull, heavy one", "pull, light one"}) ==
        List{"heavy one, rolling", "heavy one", "light one"});
  CHECK(cases_of({"time (oscillator)", "time (pendulum)"}) == List{"oscillator", "pendulum"});
  CHECK(cases_of({"speed of A", "speed of AB"}) == List{"speed of A", "speed of AB"});
}

TEST_CASE("A sheet that asks for coordinates says from where they count") {
  for (const auto& [id, sheet, letter] :
       std::vector<std::array<std::string, 3>>{{"ideal-statics", "double-slider-virtual-work", "$O$"},
                                               {"velocity-centre", "velocities", "$O$"},
                                               {"four-bar", "circles", "$A_{0}$"}}) {
    INFO(id << "/" << sheet);
    CHECK(paragraphs_of(blank_sheet_of(id, sheet))
              .find("x to the right, y upwards; coordinates from " + letter + ".\n") != std::string::npos);
  }
}

TEST_CASE("A sheet to be solved shows the mechanism, and where its loads act") {
  const DrawnSheet beam = blank_sheet_of("boat-crane", "reactions");
  for (const char* letter : {"$A$", "$B$", "$C$", "$D$", "$\\it{P}$"}) CHECK(has_label(beam, letter));
  CHECK_FALSE(has_label(beam, "$\\it{Y}_{A}$"));
  CHECK_FALSE(has_label(beam, "$\\it{R}_{B}$"));
  const DrawnSheet slider = blank_sheet_of("ideal-statics", "double-slider-virtual-work");
  for (const char* letter : {"$\\vec{\\it{Q}}$", "$\\vec{\\it{P}}$", "$O$"}) CHECK(has_label(slider, letter));
  CHECK(std::find(slider.asked.begin(), slider.asked.end(), "double_slider.P") == slider.asked.end());
  const DrawnSheet rubs = blank_sheet_of("friction-efficiency", "double-slider");
  for (const char* letter : {"$\\vec{\\it{Q}}$", "$\\vec{\\it{P}}$", "3", "$O_{2}$", "$O_{2}^{'}$"})
    CHECK(has_label(rubs, letter));
  const DrawnSheet spool = blank_sheet_of("spool-slip", "friction-cone");
  for (const char* letter : {"$C$", "$G$", "$A$", "$m_{b}$"}) CHECK(has_label(spool, letter));
  const DrawnSheet checks = blank_sheet_of("boat-crane", "checks");
  CHECK(checks.asked.size() == 12);
  CHECK(std::find(checks.asked.begin(), checks.asked.end(), "mass_600kg.buckling_utilisation") != checks.asked.end());
}

TEST_CASE("A sheet of forces to be solved shows the load, and of the effort the line of action alone") {
  const auto forces = [](const DrawnSheet& drawn) {
    const auto& marks = drawn.sheet.figure.marks;
    return std::count_if(marks.begin(), marks.end(), [](const drawings::Mark& mark) {
      const auto* arrow = std::get_if<drawings::Arrow>(&mark);
      return arrow && arrow->meaning == drawings::Meaning::force;
    });
  };
  // Its length says nothing of how large the force is found to be.
  const auto lines_of_action = [](const DrawnSheet& drawn) {
    const auto& marks = drawn.sheet.figure.marks;
    return std::count_if(marks.begin(), marks.end(), [](const drawings::Mark& mark) {
      const auto* line = std::get_if<drawings::Line>(&mark);
      if (!line || line->meaning != drawings::Meaning::construction || line->path.pieces.size() != 1) return false;
      const drawings::Point from = line->path.start, to = line->path.pieces.front().end;
      return std::abs(std::hypot(to.x - from.x, to.y - from.y) - 28) < 1e-6;
    });
  };
  // How often the load stands there, on the mechanism and on the body cut free, and how often the effort.
  for (const auto& [id, sheet, loads, efforts] :
       std::vector<std::tuple<std::string, std::string, int, int>>{{"ideal-statics", "wedge", 2, 2},
                                                                   {"ideal-statics", "two-forces", 2, 1},
                                                                   {"ideal-statics", "double-slider", 2, 2},
                                                                   {"ideal-statics", "levers", 2, 2},
                                                                   {"friction-efficiency", "wedge", 2, 2},
                                                                   {"friction-efficiency", "two-forces", 1, 1},
                                                                   {"friction-efficiency", "double-slider", 2, 2},
                                                                   {"friction-efficiency", "levers", 2, 2}}) {
    INFO(id << "/" << sheet);
    const DrawnSheet blank = blank_sheet_of(id, sheet);
    CHECK(forces(blank) == loads);
    CHECK(has_label(blank, "$\\vec{\\it{Q}}$"));
    CHECK(has_label(blank, "$\\vec{\\it{P}}$"));
    CHECK(lines_of_action(blank) == efforts);
  }
  CHECK(forces(blank_sheet_of("ideal-statics", "fairbairn")) == 2);  // F on the ram, and what it passes on
}

TEST_CASE("The blank sheet of a long table is the empty table") {
  const DrawnSheet blank = blank_sheet_of("point-mass", "table");
  std::size_t heads = 0;
  for (const drawings::Mark& mark : blank.sheet.figure.marks)
    if (const auto* writing = std::get_if<drawings::Writing>(&mark)) heads += writing->row == 0 ? 1 : 0;
  CHECK(heads == 15);  // t, F, a and v, q, E, s three times
}

TEST_CASE("A polygon begins at a cross, and only a polygon does") {
  const DrawnSheet polygon = blank_sheet_of("slider-crank-velocity", "polar-diagram"),
                   poles = blank_sheet_of("slider-crank-velocity", "poles");
  CHECK(crosses_of_starts(polygon.sheet) == 1);
  CHECK(has_label(polygon, "$O_{v}$"));
  CHECK(crosses_of_starts(poles.sheet) == 0);
  CHECK_FALSE(has_label(poles, "$O_{v}$"));
}

// Where a cross stands, as its letter does on both sheets.
TEST_CASE("Where a polygon begins has one letter on the blank sheet and on the solved one") {
  std::size_t lettered = 0;
  for (const auto& exercise : catalogue()) {
    const Givens stated(exercise->about().givens);
    for (const SheetSpec& spec : exercise->about().sheets) {
      CAPTURE(exercise.id(), spec.name);
      SheetRequest request;
      const DrawnSheet solved = exercise->draw(spec.name, stated, request);
      request.blank = true;
      const DrawnSheet blank = exercise->draw(spec.name, stated, request);
      for (const drawings::Mark& mark : blank.sheet.figure.marks) {
        const auto* cross = std::get_if<drawings::Cross>(&mark);
        if (!cross || cross->meaning != drawings::Meaning::construction) continue;
        const std::string letter = letter_at(blank, cross->at);
        CHECK(letter == letter_at(solved, cross->at));
        CHECK(letter != "$O$");
        lettered += letter.empty() ? 0 : 1;
      }
    }
  }
  CHECK(lettered > 20);
}

TEST_CASE("A sheet to be solved asks its own question, in both languages") {
  std::set<std::string> seen;
  for (const auto& exercise : catalogue()) {
    const Description& about = exercise->about();
    for (const SheetSpec& spec : about.sheets) {
      CAPTURE(about.id, spec.name);
      const Words question = question_of(about, spec.name);
      if (about.id != "truss") {  // which asks for all bars on both its sheets
        CHECK(question.english == spec.question.english);
        CHECK_FALSE(spec.question.english.empty());
        CHECK_FALSE(spec.question.italian.empty());
        CHECK(question.english != about.question.english);
        CHECK(seen.insert(about.id + question.english).second);
        CHECK(seen.insert(about.id + question.italian).second);
      } else {
        CHECK(question.english.starts_with("On this sheet: " + spec.title.english + ". The whole exercise: "));
        CHECK(question.italian.starts_with("In questa tavola: " + spec.title.italian + ". L'esercizio intero: "));
        CHECK(seen.insert(about.id + question.english).second);
        CHECK(seen.insert(about.id + question.italian).second);
      }
      for (const Language language : {Language::english, Language::italian}) {
        SheetRequest request{.language = language, .blank = true};
        const DrawnSheet blank = exercise->draw(spec.name, Givens(about.givens), request);
        const auto& column = blank.sheet.column;
        CHECK(std::any_of(column.begin(), column.end(), [&](const drawings::Block& block) {
          const auto* paragraph = std::get_if<drawings::Paragraph>(&block);
          return paragraph && paragraph->text == question.in(language);
        }));
      }
    }
  }
  CHECK(seen.size() > 200);
}

// Circles that z and m alone tell; where the second wheel lies is asked when they are shifted.
TEST_CASE("Of gears a student gets the line of centres and the circles that roll on each other") {
  const DrawnSheet mesh = blank_sheet_of("gear-pair", "pitch-point"),
                   shifted = blank_sheet_of("gear-pair", "pitch-point", {"x1=0.4"}),
                   wheels = blank_sheet_of("gear-pair", "wheels"),
                   shifted_wheels = blank_sheet_of("gear-pair", "wheels", {"x1=0.4"}),
                   rack = blank_sheet_of("gear-pair", "pitch-point", {"kind=rack"});
  CHECK(has_label(mesh, "$r_{1}$"));
  CHECK(has_label(mesh, "to $O_{1}$"));
  CHECK(has_label(mesh, "to $O_{2}$"));
  CHECK(has_label(mesh, "$r_{2}$"));
  CHECK(has_label(shifted, "$r_{1}$"));
  CHECK_FALSE(has_label(shifted, "$r_{2}$"));
  CHECK(has_label(rack, "$r_{1}$"));
  CHECK(has_label(wheels, "$O_{1}$"));
  CHECK(has_label(wheels, "$O_{2}$"));
  CHECK(has_label(shifted_wheels, "$O_{1}$"));
  CHECK_FALSE(has_label(shifted_wheels, "$O_{2}$"));
  for (const DrawnSheet* each : {&mesh, &shifted, &wheels, &shifted_wheels, &rack})
    for (const char* sought : {"$r_{a1}$", "$r_{b1}$", "$r_{f1}$", "$P_{0}$", "$T_{1}$", "$A$", "$O$"})
      CHECK_FALSE(has_label(*each, sought));
  const auto lines = [](const DrawnSheet& drawn) { return outlines_of_figure(drawn.sheet).size(); };
  CHECK(lines(mesh) == lines(rack));
  CHECK(lines(mesh) == lines(shifted) + 1);
  CHECK(lines(wheels) > lines(shifted_wheels) + 2);
}

TEST_CASE("A teacher's own titles stand in the title block, a dollar sign as itself") {
  const auto& exercise = *catalogue().front();
  const Givens stated(exercise.about().givens);
  SheetRequest request;
  request.titles = {"Mechanics 1", "Sheet for $5", "3b", "A. Rossi"};
  request.solver = {"Ada", "123"};
  const auto sheet = exercise.draw(exercise.about().sheets.front().name, stated, request).sheet;
  CHECK(sheet.title_block.heading == "Mechanics 1, A. Rossi, 123, Ada");
  CHECK(sheet.title_block.exercise == "Sheet for \\$5");
  CHECK(sheet.title_block.number == "3b");
  request.blank = true;
  const auto blank = exercise.draw(exercise.about().sheets.front().name, stated, request).sheet;
  const drawings::Table who = tables_of(blank).back();
  CHECK(who.rows == std::vector<std::vector<std::string>>{{"name", "Ada"}, {"number", "123"}, {"date", ""}});
  CHECK(drawings::svg(sheet).find("Sheet for $5") != std::string::npos);
}
