// The sheets of the pin in a slot: all are drawn whatever is given, letters find room, and a ruler on the file reads
// the quantities.
#include <cmath>
#include <numbers>

#include "drawings/output.h"
#include "exercises/kit/panels/results.h"
#include "tests/exercises/pin-in-slot/cases.h"
#include "tests/support/catch.h"
#include "tests/support/read_svg.h"

using namespace epure;
using namespace epure::tests;
using drawings::Language;
using drawings::Paper;

namespace {

DrawnSheet draw(const std::string& sheet, const std::vector<std::string>& assignments,
                const SheetRequest& request = {}) {
  return pin_in_slot().draw(sheet, givens_of(assignments), request);
}

// An arrow in the file, in mm of paper.
struct Arrow {
  drawings::Point from, to;
  double length() const { return std::hypot(to.x - from.x, to.y - from.y); }
};
Arrow arrow(const drawings::SvgFile& svg, const std::string& id) {
  return {svg.points(id).front(), svg.points(id + "_head").front()};
}

// "1 cm ≙ 2.5 m/s" of the title block, in units a millimetre.
double per_mm(const std::string& caption) {
  const auto equals = caption.find("≙");
  REQUIRE(equals != std::string::npos);
  return std::stod(caption.substr(equals + std::string("≙").size())) / 10;
}

struct Diagram {
  std::string sheet;
  std::vector<std::string> vectors;
};
const std::vector<Diagram> diagrams{
    {"kinematics", {"v_B", "v_Bstar", "b_dot"}},
    {"acceleration", {"a_B", "a_cor", "b_ddot"}},
    {"forces", {"slot_force_on_pin", "ground_normal_force", "ground_friction_force", "pivot_force"}}};

const std::vector<std::vector<std::string>> usual{
    {},         {"OB=0.25"},      {"OB=0.9"},        {"omega=-1"}, {"omega_dot=0"},
    {"R=0.3"},  {"omega_dot=-2"}, {"omega_dot=-20"}, {"OB=0.2"},   {"AO=1"},
    {"omega=0"}};

}  // namespace

TEST_CASE("every sheet is drawn, whatever is given", "[pin-in-slot][sheets]") {
  for (const CorpusCase& c : corpus())
    for (const SheetSpec& sheet : pin_in_slot().about().sheets)
      for (const bool bare : {false, true}) {
        CAPTURE(c.name, sheet.name, bare);
        const std::string bytes = drawings::svg(draw(sheet.name, assignments_of(c), {.bare = bare}).sheet);
        CHECK(bytes.find("<svg") != std::string::npos);
        for (const char* word : {"-nan", "=\"nan", "=\"inf", " nan ", " inf "})
          CHECK(bytes.find(word) == std::string::npos);
      }
}

TEST_CASE("a slot nearly along the guide: relative pole and disc in one point on paper", "[pin-in-slot][sheets]") {
  for (const char* given : {"OB=110", "OB=1e8", "R=1e-9", "AO=1e5"}) {
    CAPTURE(given);
    const DrawnSheet sheet = draw("kinematics", {given});
    for (const drawings::Block& block : sheet.sheet.column)
      CHECK_FALSE(std::holds_alternative<drawings::Table>(block));
  }
  const DrawnSheet usual_sheet = draw("kinematics", {});
  CHECK(std::any_of(usual_sheet.sheet.column.begin(), usual_sheet.sheet.column.end(),
                    [](const drawings::Block& block) { return std::holds_alternative<drawings::Table>(block); }));
}

TEST_CASE("letters find room on all sheets", "[pin-in-slot][sheets]") {
  for (const auto& assignments : usual)
    for (const SheetSpec& sheet : pin_in_slot().about().sheets)
      for (const Paper paper : {Paper::a4, Paper::a3})
        for (const Language language : {Language::english, Language::italian}) {
          CAPTURE(assignments, sheet.name, paper == Paper::a4, language == Language::english);
          CHECK(drawings::overlaps(draw(sheet.name, assignments, {.paper = paper, .language = language}).sheet)
                    .empty());
        }
}

TEST_CASE("a ruler on the file reads the value of every vector", "[pin-in-slot][sheets]") {
  for (const std::vector<std::string>& assignments :
       {std::vector<std::string>{}, {"OB=0.25"}, {"omega=-1", "omega_dot=1"}})
    for (const auto& [sheet, vectors] : diagrams) {
      const CheckedExercise numbers = checked(assignments);
      const DrawnSheet drawn = draw(sheet, assignments);
      const drawings::SvgFile svg(drawings::svg(drawn.sheet));
      std::vector<double> units;  // of the vectors; then of those in a close-up
      for (const std::string& scale : drawn.sheet.title_block.scales)
        if (scale.find("≙") != std::string::npos) units.push_back(per_mm(scale));
      for (const std::string& name : vectors) {
        CAPTURE(assignments, sheet, name);
        if (std::abs(value(numbers, name)) / units.front() < 3.1) continue;  // shorter than its head, so a dot
        const double length = arrow(svg, drawn.sheet.id + "-" + name).length();
        // Both ends are moved to the file's grid.
        CHECK(std::any_of(units.begin(), units.end(), [&](double unit) {
          return std::abs(length * unit - std::abs(value(numbers, name))) <=
                 1.001 * std::numbers::sqrt2 * drawings::file_resolution * unit;
        }));
      }
    }
}

// Head to tail: the last force of each polygon ends where the first one starts.
TEST_CASE("the polygons of forces are closed on paper", "[pin-in-slot][sheets]") {
  const DrawnSheet drawn = draw("forces", {});
  const drawings::SvgFile svg(drawings::svg(drawn.sheet));
  const auto of = [&](const char* name) { return arrow(svg, drawn.sheet.id + "-" + name); };
  const double apart = 1.5 * drawings::file_resolution;
  const Arrow first = of("ground_friction_force"), slot = of("slot_force_on_pin"), last = of("ground_normal_force");
  CHECK(std::hypot(last.to.x - first.from.x, last.to.y - first.from.y) <= apart);
  CHECK(std::hypot(slot.to.x - last.from.x, slot.to.y - last.from.y) <= apart);
  // y runs downwards in the file: N points up, T to the left, S to the right and down.
  CHECK(last.to.y < last.from.y);
  CHECK(first.to.x < first.from.x);
  CHECK(slot.to.x > slot.from.x);
  CHECK(slot.to.y > slot.from.y);
}

TEST_CASE("the balance shows the right couple and the mistaken one", "[pin-in-slot][sheets]") {
  const auto& labels = draw("power-balance", {}).sheet.figure.labels;
  for (const char* shown : {"188.8", "138.9", "111.3", "61.40"}) {
    CAPTURE(shown);
    const std::string with_unit = shown + unit_after_number("N m", Language::english);
    CHECK(std::any_of(labels.begin(), labels.end(),
                      [&](const drawings::Label& label) { return label.text == with_unit; }));
  }
}

// Two links, the frame, and no letter d; the disc's couple of inertia against α₃, which is clockwise.
TEST_CASE("links are numbered, and the couple of inertia has its sign", "[pin-in-slot][sheets]") {
  const auto has = [](const DrawnSheet& drawn, const std::string& text) {
    const auto& labels = drawn.sheet.figure.labels;
    return std::any_of(labels.begin(), labels.end(),
                       [&](const drawings::Label& label) { return label.text == text; });
  };
  for (const char* sheet : {"kinematics", "acceleration"})
    for (const char* number : {"1", "2", "3"}) CHECK(has(draw(sheet, {}), number));
  const DrawnSheet forces = draw("forces", {});
  CHECK(has(forces, "−$\\it{J}_{B}α_{3}$"));
  CHECK(has(forces, "$\\it{F}_{A}$ = 9.69 N"));  // 30·0.3·√(1 + 0.4²), too short for an arrow
  bool found = false;
  for (const drawings::Mark& mark : forces.sheet.figure.marks)
    if (const auto* arc = std::get_if<drawings::Rotation>(&mark); arc && !found) {
      found = true;
      CHECK(arc->to > arc->from);
    }
  CHECK(found);
}

TEST_CASE("pin in slot: no quantity is written as a point of the polygons is", "[pin-in-slot][sheets]") {
  for (const char* sheet : {"kinematics", "acceleration"}) {
    const auto corners = [](const drawings::Label& label) { return label.text.starts_with("$b"); };
    const DrawnSheet drawn = draw(sheet, {});
    const auto& labels = drawn.sheet.figure.labels;
    CHECK(std::count_if(labels.begin(), labels.end(), corners) == 2);  // b* and b'
    for (const drawings::Label& label : labels)
      for (const Quantity& quantity : pin_in_slot().about().quantities())
        if (corners(label)) CHECK_FALSE(quantity.symbol.starts_with(label.text.substr(0, label.text.size() - 1)));
  }
}
