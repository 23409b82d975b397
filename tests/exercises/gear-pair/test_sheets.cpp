// N.12's sheets: drawn whatever pair is given, letters apart, faults said in both languages, lengths right in the
// file.
#include <algorithm>
#include <cmath>

#include "tests/exercises/gear-pair/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Assignments source{}, shifted{"x1=0.5", "x2=0.3", "z1=17", "z2=35"}, eight{"z1=8", "z2=20", "alpha=20"},
    five{"z1=5", "z2=30", "alpha=20"}, ring{"kind=internal", "z1=20", "z2=60"}, rack{"kind=rack", "alpha=20"},
    thousand{"z2=1000"}, two_thousand{"z1=1000", "z2=1000"}, small{"m=1", "j=0.1"};

// A pair, and what both languages say is wrong with it.
struct Faulty {
  Assignments givens;
  std::vector<Words> said;
};
const std::vector<Faulty>& faulty() {
  static const std::vector<Faulty> all{
      {eight,
       {{"undercuts the teeth of wheel 1", "produce sottotaglio nei denti della ruota 1"},
        {"Interference", "Interferenza"}}},
      {five, {{"z = 5 is less than 17.10", "z = 5 è minore di 17,10"}}},
      {{"x1=0.9", "z1=12", "alpha=25"}, {{"teeth of wheel 1 are pointed", "denti della ruota 1 sono a punta"}}},
      {{"ha=0.5", "alpha=28"},
       {{"contact ratio 0.7248 is below 1", "fattore di ricoprimento 0,7248 è minore di 1"},
        {"No such cutter", "L'utensile non esiste"}}},
      {{"z1=60", "z2=10", "ha=1.2", "hf=1.45", "alpha=15"}, {{"end beyond $T_{2}$", "finirebbe oltre $T_{2}$"}}},
      {{"hf=0.9"}, {{"No clearance", "Manca il gioco in testa"}}},
      {{"kind=internal", "z2=23", "alpha=20"}, {{"lies inside its base circle", "è interna a quella di base"}}},
      {{"kind=internal", "z2=23", "alpha=25", "ha=0.8", "hf=1"},
       {{"The ring is too small", "La corona è troppo piccola"}}}};
  return all;
}

std::string column(const DrawnSheet& drawn) {
  std::string text;
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) text += paragraph->text + "\n";
  return text;
}

std::string steps(const DrawnSheet& drawn) {
  std::string text;
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* lines = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : lines->lines) text += line + "\n";
  return text;
}

bool has_label(const DrawnSheet& drawn, const std::string& text) {
  for (const drawings::Label& label : drawn.sheet.figure.labels)
    if (label.text.find(text) != std::string::npos) return true;
  return false;
}

const drawings::Label& label(const DrawnSheet& drawn, const std::string& text) {
  const auto& labels = drawn.sheet.figure.labels;
  const auto found = std::find_if(labels.begin(), labels.end(), [&](const auto& each) { return each.text == text; });
  REQUIRE(found != labels.end());
  return *found;
}

const drawings::Line* line(const DrawnSheet& drawn, const std::string& name) {
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* found = std::get_if<drawings::Line>(&mark); found && found->name == name) return found;
  return nullptr;
}

std::size_t pieces(const DrawnSheet& drawn, const std::string& name) {
  const drawings::Line* found = line(drawn, name);
  return found ? found->path.pieces.size() : 0;
}

}  // namespace

TEST_CASE("a pair that fails by little is told with figures that part what there is from what is needed") {
  const DrawnSheet sheet = gear_pair().draw("wheels", {"kind=internal", "z1=18", "z2=80"});
  const std::string text = column(sheet), needed = "down to the radius ", begins = "but it begins at ";
  REQUIRE(text.find(needed) != std::string::npos);
  const auto after = [&](const std::string& words) {
    return std::stod(text.substr(text.find(words) + words.size()));
  };
  CHECK(after(needed) < after(begins));
}

TEST_CASE("gear-pair: every sheet is drawn, and letters find room", "[gear-pair][sheets]") {
  std::vector<Assignments> all{source, shifted, eight, five, ring, rack, thousand, two_thousand, small};
  for (const Faulty& each : faulty()) all.push_back(each.givens);
  letters_find_room(gear_pair(), all);
}

TEST_CASE("gear-pair: both languages say what is wrong, on every sheet", "[gear-pair][sheets]") {
  for (const Faulty& each : faulty())
    for (const char* sheet : {"pitch-point", "wheels", "sliding"})
      for (const Words& sentence : each.said) {
        CAPTURE(each.givens, sheet, sentence.english);
        CHECK(column(gear_pair().draw(sheet, each.givens)).find(sentence.english) != std::string::npos);
        CHECK(column(gear_pair().draw(sheet, each.givens, {.language = Language::italian})).find(sentence.italian) !=
              std::string::npos);
      }
  CHECK(column(gear_pair().draw("wheels", source)).find("undercut") == std::string::npos);
}

TEST_CASE("gear-pair: faults are marked where they lie", "[gear-pair][sheets]") {
  CHECK(has_label(gear_pair().draw("pitch-point", eight), "undercut"));
  CHECK(has_label(gear_pair().draw("pitch-point", eight), "interference"));
  CHECK(has_label(gear_pair().draw("pitch-point", {"x1=0.9", "z1=12", "alpha=25"}), "pointed"));
  CHECK(has_label(gear_pair().draw("pitch-point", {"ha=0.5", "alpha=28"}), "no continuous contact"));
  CHECK(has_label(gear_pair().draw("pitch-point", {"hf=0.9"}), "no clearance"));
  CHECK(has_label(gear_pair().draw("wheels", {"kind=internal", "z2=23", "alpha=25", "ha=0.8", "hf=1"}),
                  "tips collide"));
  CHECK_FALSE(has_label(gear_pair().draw("pitch-point", source), "interference"));
}

// check compares every mark that is measured with its quantity, as the file holds it.
TEST_CASE("gear-pair: what is drawn has its length", "[gear-pair][sheets]") {
  for (const Assignments& givens : {source, shifted, eight, five, ring, rack, thousand, two_thousand, small}) {
    const CheckedExercise result = gear_pair().checked(givens);
    CAPTURE(givens, complaints(result));
    CHECK(numbers_pass(result));
  }
  const CheckedExercise stated = gear_pair().checked(source);
  for (const char* name : {"r1",
                           "r2",
                           "r_tip_1",
                           "r_tip_2",
                           "r_root_1",
                           "r_root_2",
                           "r_base_1",
                           "r_base_2",
                           "addendum",
                           "dedendum",
                           "tooth_height",
                           "clearance",
                           "base_pitch",
                           "path_of_approach",
                           "path_of_recess",
                           "path_of_contact",
                           "interference_limit_approach",
                           "interference_limit_recess",
                           "sliding_velocity_approach",
                           "sliding_velocity_recess"}) {
    CAPTURE(name);
    CHECK_FALSE(find(stated, name).on_sheets.empty());
  }
}

TEST_CASE("gear-pair: ring and rack show what they have", "[gear-pair][sheets]") {
  const CheckedExercise of_ring = gear_pair().checked(ring), of_rack = gear_pair().checked(rack);
  for (const char* name : {"clearance", "clearance_2", "centre_distance", "r_tip_2", "path_of_contact"}) {
    CAPTURE(name);
    CHECK_FALSE(find(of_ring, name).on_sheets.empty());
  }
  for (const char* name : {"clearance", "clearance_2", "arc_of_approach", "arc_of_recess", "arc_of_action"}) {
    CAPTURE(name);
    CHECK_FALSE(find(of_rack, name).on_sheets.empty());
  }
}

TEST_CASE("gear-pair: the path of contact in the file is 45.36 mm long at 1 : 1", "[gear-pair][sheets]") {
  const DrawnSheet drawn = gear_pair().draw("pitch-point", source);
  REQUIRE(drawn.sheet.title_block.scales == std::vector<std::string>{"1 : 1"});
  const drawings::SvgFile svg(drawings::svg(drawn.sheet));
  // 23.6343 + 21.7280 mm by the source's own formulas.
  CHECK(svg.length(drawn.sheet.id + "-AE") == Approx(45.3623).margin(2e-3));
}

TEST_CASE("gear-pair: whole wheels have all their teeth, a large one as many as fit", "[gear-pair][sheets]") {
  const DrawnSheet drawn = gear_pair().draw("wheels", source);
  REQUIRE(pieces(drawn, "wheel_1") % 20 == 0);
  REQUIRE(pieces(drawn, "wheel_2") % 40 == 0);
  CHECK(pieces(drawn, "wheel_1") >= 20 * 7);  // root, fillet, flank on both sides, and the tip
  const DrawnSheet large = gear_pair().draw("wheels", thousand);
  CHECK(large.sheet.title_block.scales == std::vector<std::string>{"1 : 2"});
  CHECK(pieces(large, "wheel_2") > 0);
  CHECK(pieces(large, "wheel_2") < 200 * 20);
  // Teeth too small to be seen: circles.
  const DrawnSheet both_large = gear_pair().draw("wheels", two_thousand);
  CHECK(pieces(both_large, "wheel_1") == 0);
  CHECK(column(both_large).find("ISO 2203") != std::string::npos);
}

TEST_CASE("gear-pair: the source's scale can be asked for", "[gear-pair][sheets]") {
  CHECK(gear_pair().draw("wheels", source, {.scale = Rational(1, 4)}).sheet.title_block.scales ==
        std::vector<std::string>{"1 : 4"});
  CHECK_THROWS_WITH(gear_pair().draw("wheels", five, {.scale = Rational(10)}), Contains("would fit"));
}

// W over 3 teeth of z = 20, m = 10, α = 22°, x = 0: m cos α (2.5 π + 20 inv α) with inv 22° = 0.0200538 (tables of
// the involute function), 76.540 mm; over 5 of z = 40: 138.515 mm.
TEST_CASE("gear-pair: the workshop's data", "[gear-pair][sheets]") {
  const DrawnSheet drawn = gear_pair().draw("wheels", source);
  std::vector<std::vector<std::string>> rows;
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* table = std::get_if<drawings::Table>(&block)) rows = table->rows;
  const auto row = [&](const std::string& name) {
    for (const auto& each : rows)
      if (each.front() == name) return each;
    throw std::logic_error("no row " + name);
  };
  CHECK(row("$𝑊_{k}$") == std::vector<std::string>{"$𝑊_{k}$", "76.540", "138.515"});
  CHECK(row("$k$") == std::vector<std::string>{"$k$", "3", "5"});
  CHECK(row("$d_{a}$") == std::vector<std::string>{"$d_{a}$", "220.000", "420.000"});
}

TEST_CASE("gear-pair: the source's differences stand on its own sheets only", "[gear-pair][sheets]") {
  CHECK(column(gear_pair().draw("sliding", source)).find("0.186") != std::string::npos);
  CHECK(column(gear_pair().draw("pitch-point", source)).find("0.02364") != std::string::npos);
  CHECK(column(gear_pair().draw("sliding", {"n1=151"})).find("0.186") == std::string::npos);
}

TEST_CASE("gear-pair: a rack has no number of teeth among the givens", "[gear-pair][sheets]") {
  CHECK(column(gear_pair().draw("pitch-point", source)).find("$z_{2}$") != std::string::npos);
  CHECK(column(gear_pair().draw("pitch-point", rack)).find("$z_{2}$") == std::string::npos);
}

TEST_CASE("gear-pair: the steps tell of two, one or no tangent points on the sheet", "[gear-pair][sheets]") {
  CHECK(steps(gear_pair().draw("pitch-point", source)).find("off the sheet") == std::string::npos);
  CHECK(steps(gear_pair().draw("pitch-point", thousand)).find("$T_{2}$ off the sheet") != std::string::npos);
  CHECK(steps(gear_pair().draw("pitch-point", rack)).find("$T_{2}$") == std::string::npos);
}

// F1 of z1 = 8, z2 = 40, α = 22°: the cutter's trochoid and the involute crossed with mpmath, apart from this
// program.
TEST_CASE("gear-pair: where flanks are cut away every sheet says how far they touch", "[gear-pair][sheets]") {
  const Words left{
      "flank 1 begins only in $F_{1}$, 9.329\u00a0mm before $P_{0}$: contact $F_{1}E$ = 27.88\u00a0mm, "
      "$f$ = $F_{1}E$/$p_{b}$ = 0.9571, below 1",
      "il fianco 1 inizia solo in $F_{1}$, 9,329\u00a0mm prima di $P_{0}$: contatto $F_{1}E$ = "
      "27,88\u00a0mm, $f$ = $F_{1}E$/$p_{b}$ = 0,9571, minore di 1"};
  const Assignments cut{"z1=8"};
  for (const char* sheet : {"pitch-point", "sliding"}) {
    CAPTURE(sheet);
    CHECK(column(gear_pair().draw(sheet, cut)).find(left.english) != std::string::npos);
    CHECK(column(gear_pair().draw(sheet, cut, {.language = Language::italian})).find(left.italian) !=
          std::string::npos);
  }
  CHECK(column(gear_pair().draw("wheels", cut)).find("0.9571, below 1 (1.448 of whole flanks)") != std::string::npos);
  CHECK(has_label(gear_pair().draw("pitch-point", cut), "no continuous contact"));
  CHECK(gear_pair().draw("pitch-point", cut).sheet.description.find("true_contact_ratio = 0.957") !=
        std::string::npos);
  CHECK(gear_pair().draw("sliding", cut).sheet.description.find("v_s_F1 = 0.1758") != std::string::npos);
}

TEST_CASE("gear-pair: undercut and pointed teeth that shorten no contact, or its end", "[gear-pair][sheets]") {
  // The mate's tips, cut short, touch flank 1 only above what is cut away.
  const Assignments spared{"z1=14", "alpha=20", "k=0.4"};
  CHECK(column(gear_pair().draw("pitch-point", spared)).find("undercuts") != std::string::npos);
  for (const char* sheet : {"pitch-point", "wheels", "sliding"}) {
    CAPTURE(sheet);
    CHECK(column(gear_pair().draw(sheet, spared)).find("whole flanks") == std::string::npos);
    CHECK(column(gear_pair().draw(sheet, source)).find("whole flanks") == std::string::npos);
  }
  CHECK(column(gear_pair().draw("sliding", {"x1=0.9", "z1=12", "alpha=25"})).find("touches only to $V_{1}$") !=
        std::string::npos);
  const Assignments apart{"z1=4", "z2=12", "alpha=20", "x1=-0.3", "ha=0.8", "hf=1", "rho=0"};
  CHECK(column(gear_pair().draw("pitch-point", apart)).find("they never touch") != std::string::npos);
  CHECK(column(gear_pair().draw("sliding", apart)).find("no sliding") != std::string::npos);
  CHECK(column(gear_pair().draw("sliding", apart)).find("they never touch") != std::string::npos);
}

TEST_CASE("gear-pair: sliding ends where the flanks do, and is dashed grey beyond", "[gear-pair][sheets]") {
  const DrawnSheet drawn = gear_pair().draw("sliding", {"z1=8"});
  const drawings::Line *sliding = line(drawn, "v_s"), *beyond = line(drawn, "of_whole_flanks");
  REQUIRE(sliding != nullptr);
  REQUIRE(beyond != nullptr);
  CHECK(beyond->meaning == drawings::Meaning::construction);
  const double from = sliding->path.start.x, to = sliding->path.pieces.back().end.x, A = beyond->path.start.x;
  CHECK((to - from) / (to - A) == Approx(27.8785 / 42.1841).epsilon(1e-3));
  for (const char* name : {"T_{1}", "F_{1}"}) CHECK(has_label(drawn, name));
  CHECK(line(gear_pair().draw("sliding", source), "of_whole_flanks") == nullptr);
}

// Both wheels' points lie close together: a letter between them could be that of either.
TEST_CASE("gear-pair: the ends of the arcs have their letters outside", "[gear-pair][sheets]") {
  for (const Assignments& givens : {source, eight, five, ring, rack}) {
    const DrawnSheet drawn = gear_pair().draw("pitch-point", givens);
    for (const std::string index : {"_{1}$", "_{2}$"}) {
      CAPTURE(givens, index);
      const drawings::Label &of_1 = label(drawn, "$N" + index), &of_2 = label(drawn, "$N'" + index);
      REQUIRE(of_1.away_from);
      REQUIRE(of_2.away_from);
      CHECK(std::hypot(of_1.away_from->x - of_2.at.x, of_1.away_from->y - of_2.at.y) == Approx(0).margin(1e-9));
      CHECK(std::hypot(of_2.away_from->x - of_1.at.x, of_2.away_from->y - of_1.at.y) == Approx(0).margin(1e-9));
      CHECK(of_1.at.y <= of_2.at.y);
    }
  }
}

TEST_CASE("gear-pair: the sense of rotation stands clear of the teeth, however small a wheel is",
          "[gear-pair][sheets]") {
  const Assignments six{"z1=6"}, tiny_in_ring{"kind=internal", "z1=5", "z2=60", "alpha=28"}, driven{"z1=40", "z2=6"};
  for (const Assignments& givens : {source, eight, five, six, tiny_in_ring, driven}) {
    const DrawnSheet drawn = gear_pair().draw("wheels", givens);
    const auto radius = [&](const std::string& name) {
      for (const Measurement& each : drawn.measurements)
        if (each.quantity == name) return std::hypot(each.to.x - each.from.x, each.to.y - each.from.y);
      return 0.0;
    };
    int wheel = 0;
    for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
      const auto* sense = std::get_if<drawings::Rotation>(&mark);
      if (!sense) continue;
      const std::string number = std::to_string(++wheel);
      CAPTURE(givens, wheel, sense->radius);
      const double inner = std::min(radius("r_root_" + number), radius("r_tip_" + number)),
                   outer = std::max(radius("r_root_" + number), radius("r_tip_" + number));
      REQUIRE(inner > 0);
      CHECK((sense->radius < inner || sense->radius > outer));
    }
    CHECK(wheel == 2);
  }
}

TEST_CASE("gear-pair: the sliding velocity told is the reported one, and a sheet without sliding says so",
          "[gear-pair][sheets]") {
  // The source's own 23.634 mm times 23.562 rad/s; check reports magnitudes.
  CHECK(gear_pair().draw("sliding", source).sheet.description.find("sliding_velocity_approach = 0.5569 m/s") !=
        std::string::npos);
  CHECK(gear_pair().draw("sliding", {"kind=internal", "z2=23", "alpha=20"}).sheet.description.find("no contact") !=
        std::string::npos);
}

TEST_CASE("gear-pair: wheels are told apart, show how they turn, and their bar is in millimetres",
          "[gear-pair][sheets]") {
  const DrawnSheet drawn = gear_pair().draw("pitch-point", source);
  std::set<drawings::Meaning> tints;
  int senses = 0;
  std::string unit;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
    if (const auto* area = std::get_if<drawings::Area>(&mark)) tints.insert(area->meaning);
    if (std::holds_alternative<drawings::Rotation>(mark)) ++senses;
    if (const auto* bar = std::get_if<drawings::ScaleBar>(&mark)) unit = bar->ticks.back();
  }
  CHECK(tints.size() == 2);
  CHECK(senses == 2);
  CHECK(unit.find("mm") != std::string::npos);
  CHECK(column(drawn).find("the motion is continuous") != std::string::npos);
  CHECK(column(gear_pair().draw("pitch-point", {"z1=8"})).find("the motion is continuous") == std::string::npos);
}

TEST_CASE("gear-pair: the source's data lead to the givens, on its own sheet only", "[gear-pair][sheets]") {
  CHECK(column(gear_pair().draw("wheels", source)).find("centre distance $i$ = 300.0") != std::string::npos);
  CHECK(column(gear_pair().draw("wheels", {"n1=151"})).find("centre distance $i$") == std::string::npos);
}
