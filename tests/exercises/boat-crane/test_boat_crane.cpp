// The boat crane: its numbers are those of a corpus that knows finite elements and outlines only; what the source
// printed, and that it computed with twice the mass it states; what cannot be; its sheets.
#include <algorithm>

#include "exercises/kit/proof/verdict.h"
#include "tests/exercises/drawn_marks.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& crane() {
  static const Tried tried("boat-crane");
  return tried;
}

const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/boat_crane.txt");
  return cases;
}

const std::vector<Assignments> usual{{},
                                     {"W_b=600"},
                                     {"L=2", "H_0=1.5", "W_b=2t"},
                                     {"H_2=90mm", "b_2=200", "s_2=8", "H_0=3"},
                                     {"W_b=1370", "H_1=0.2m", "sigma_S=355", "Psi=1.1"},
                                     {"sigma_S=20"}};

std::string refusal(const Assignments& assignments) {
  try {
    crane().checked(assignments);
  } catch (const BadGivens& why) {
    return why.words().english;
  }
  return "";
}

}  // namespace

TEST_CASE("boat crane: what is promised is reported, in its units", "[boat-crane]") {
  const CheckedExercise result = crane().checked({});
  CAPTURE(complaints(result));
  CHECK(result.passed());
  CHECK(result.quantities.size() == 96);
  for (const auto& [name, unit] : std::vector<std::pair<std::string, std::string>>{{"A_1", "m^2"},
                                                                                   {"J_x1", "m^4"},
                                                                                   {"W_x1", "m^3"},
                                                                                   {"M_C", "N*m"},
                                                                                   {"moment_area_BC", "N*m^2"},
                                                                                   {"theta_B", "rad"},
                                                                                   {"v_D", "m"},
                                                                                   {"sigma_eq", "Pa"},
                                                                                   {"slenderness", "1"},
                                                                                   {"mass_600kg.P", "N"}})
    CHECK(find(result, name).spec.unit == unit);
}

TEST_CASE("boat crane: values are the corpus', to the last bit of a double, by every route", "[boat-crane]") {
  CHECK(corpus().size() == 15);
  holds_against(crane(), corpus());
}

TEST_CASE("boat crane: Soderberg's diagram ends where half the stress is the yield stress", "[boat-crane]") {
  const auto kind = [](const std::string& name) {
    for (const CorpusCase& c : corpus())
      if (c.name == name) return find(crane().checked(assignments_of(c)), "Delta_sigma_eff").settled;
    throw std::logic_error("no such case");
  };
  using Kind = geometry::Settled::Kind;
  CHECK(kind("mean_yields").kind == Kind::absent);
  CHECK(kind("mean_yields").reason.english.find("yield stress") != std::string::npos);
  CHECK(kind("hardly_below").kind == Kind::absent);
  CHECK(kind("hardly_above").kind == Kind::certain);
  CHECK(kind("nearly_below").kind == Kind::absent);
  CHECK(kind("nearly_above").kind == Kind::certain);
}

TEST_CASE("boat crane: all that is printed is right with 600 kg, and what hangs on the load wrong with 300",
          "[boat-crane]") {
  int right = 0, explained = 0;
  for (const CheckedQuantity& quantity : crane().checked({}).quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      CHECK(verdict.explanation_holds);
      if (verdict.verdict == Verdict::rounding) {
        ++right;
        continue;
      }
      CHECK(verdict.explanation.has_value());
      const double times = 1 + std::abs(verdict.difference_percent.value()) / 100;
      CHECK(times > 1.95);
      CHECK(times < 2.25);  // Soderberg's range grows faster than the load
      ++explained;
    }
  CHECK(right == 26);
  CHECK(explained == 13);
  for (const CheckedQuantity& quantity : crane().checked({"W_b=600"}).quantities) CHECK(quantity.printed.empty());
}

TEST_CASE("boat crane: what cannot be built is refused in a sentence with the value", "[boat-crane]") {
  CHECK_THAT(refusal({"H_1=10"}), Contains("H_1 = 10 mm leaves no web") && Contains("2 s_1 = 10 mm"));
  CHECK_THAT(refusal({"s_2=95"}), Contains("H_2 = 180 mm leaves no web"));
  CHECK_THAT(refusal({"b_1=4"}), Contains("b_1 = 4 mm is less than the web's thickness s_1 = 5 mm"));
  CHECK(refusal({"b_1=5"}).empty());
  for (const char* given : {"W_b=0", "H_0=-5", "s_1=0", "E=0", "Psi=-1", "sigma_S=0"})
    CHECK_THROWS_WITH(crane().givens({given}), Contains("must be positive"));
  CHECK_THROWS_WITH(crane().givens({"sigma_S=300N"}), Contains("a force where a stress"));
}

TEST_CASE("boat crane: every sheet is drawn, whatever is given", "[boat-crane][sheets]") {
  draws_every_sheet(crane(), corpus());
}

// The state lies far beyond the end of the axis, where nothing may be measured.
TEST_CASE("boat crane: a state off Soderberg's diagram is not read off it", "[boat-crane][sheets]") {
  const CheckedExercise result = crane().checked({"sigma_S=1e-12"});
  CAPTURE(complaints(result));
  CHECK(result.passed());
}

TEST_CASE("boat crane: letters find room", "[boat-crane][sheets]") { letters_find_room(crane(), usual); }

TEST_CASE("boat crane: the diagrams are measured back", "[boat-crane][sheets]") {
  const auto shown = [](const std::string& sheet) {
    std::set<std::string> names;
    for (const Measurement& m : crane().draw(sheet, {}).measurements) names.insert(m.quantity);
    return names;
  };
  const auto shows = [&](const std::string& sheet, const std::vector<std::string>& names) {
    const std::set<std::string> all = shown(sheet);
    for (const std::string& name : names) {
      CAPTURE(sheet, name);
      CHECK(all.contains(name));
    }
  };
  shows("reactions", {"P", "Y_A", "Y_B", "M_C", "M_1_mid_BC", "M_1_mid_CD", "T_1_BC", "T_1_CD"});
  shows("elastic-line",
        {"M_C", "moment_area_BC", "moment_area_CD", "v_max_BC", "v_D_bending", "v_D", "column_shortening"});
  shows("section", {"sigma_z_max", "tau_zy", "tau_max_Jourawsky", "sigma_eq"});
  shows("fatigue", {"sigma_m", "Delta_sigma", "Delta_sigma_eff", "mass_600kg.Delta_sigma_eff"});
  shows("buckling", {"slenderness", "slenderness_limit", "P_cr"});
}

// Bending to the elastic line, the column's share from there, and the sum beside both, each with letters of its own.
TEST_CASE("boat crane: what the boat sinks is put together of two parts", "[boat-crane][sheets]") {
  const DrawnSheet drawn = crane().draw("elastic-line", {"L=1", "H_0=12", "W_b=2000"});
  const auto [beam, bent] = ends_of(line(drawn, "v_D_bending"));
  const auto [level, sunk] = ends_of(line(drawn, "v_D"));
  CHECK(level.y == Approx(beam.y));
  CHECK(level.x > beam.x + 3);
  int carried = 0;
  for (const drawings::Line& each : all_of<drawings::Line>(drawn)) {
    const auto [from, to] = ends_of(each);
    carried +=
        each.meaning == drawings::Meaning::velocity && from.x == bent.x && from.y == bent.y && to.y == Approx(sunk.y);
  }
  CHECK(carried == 1);
  for (const char* letters : {"$nv_{D,f}$", "$nv_{D,r}$", "$nv_{D}$"})
    CHECK(std::count_if(drawn.sheet.figure.labels.begin(), drawn.sheet.figure.labels.end(),
                        [&](const drawings::Label& each) { return each.text == letters; }) == 1);
}

TEST_CASE("boat crane: the ray parallel to the closing line is drawn after it, and the shear last",
          "[boat-crane][sheets]") {
  std::vector<std::string> lines;
  for (const drawings::Block& block : crane().draw("reactions", {}).sheet.column)
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      lines.insert(lines.end(), steps->lines.begin(), steps->lines.end());
  REQUIRE(lines.size() == 5);
  CHECK(lines[2].starts_with("The closing line"));
  CHECK(lines[3].starts_with("The ray parallel to the closing line"));
  CHECK(lines[4].starts_with("The shear"));
}

TEST_CASE("boat crane: a sheet says which checks do not hold, at the limit too", "[boat-crane][sheets]") {
  const auto tells = [](const Assignments& assignments, const std::string& words) {
    for (const drawings::Block& block : crane().draw("checks", assignments).sheet.column)
      if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block);
          paragraph && paragraph->text.find(words) != std::string::npos)
        return true;
    return false;
  };
  CHECK(tells({}, "With 300 kg all checks hold."));
  CHECK(tells({"W_b=1t"}, "With 1000 kg these checks do not hold: fatigue of the beam, buckling of the column."));
  CHECK(tells({"sigma_S=20"}, "yield of the beam, fatigue of the beam"));  // no range is left to the beam
  // |σ_zN| Ψ = σ_S: 3·g·300/752 mm² is 8825.985/752 MPa.
  const std::string limit = "8825985/752000";
  CHECK_FALSE(tells({"Psi=1", "sigma_S=" + limit}, "yield of the column"));
  CHECK(tells({"Psi=1.000000000000000000000000000001", "sigma_S=" + limit}, "yield of the column"));
}

TEST_CASE("boat crane: the column's normal force is drawn, compression to the left", "[boat-crane][sheets]") {
  for (const Assignments& given : {Assignments{}, {"W_b=600"}, {"H_0=2"}}) {
    const CheckedExercise result = crane().checked(given);
    const auto& sheets = find(result, "N_2").on_sheets;
    const auto found =
        std::find_if(sheets.begin(), sheets.end(), [](const OnSheet& each) { return each.sheet == "buckling"; });
    REQUIRE(found != sheets.end());
    CHECK(found->value < 0);
  }
}

TEST_CASE("boat crane: section C shows both masses", "[boat-crane][sheets]") {
  std::vector<std::vector<std::string>> rows;
  for (const drawings::Block& block : crane().draw("section", {}).sheet.column)
    if (const auto* table = std::get_if<drawings::Table>(&block))
      rows.insert(rows.end(), table->rows.begin(), table->rows.end());
  REQUIRE(rows.size() == 2);
  CHECK(rows[0][0] == "300 kg");
  CHECK(rows[1][0] == "600 kg");
  CHECK(std::stod(rows[1][1]) == Approx(98.65).epsilon(1e-3));
  CHECK(std::stod(rows[1][1]) == Approx(2 * std::stod(rows[0][1])).epsilon(1e-3));
}

TEST_CASE("boat crane: the sheet of all checks to be solved asks in two columns, in letters of their size",
          "[boat-crane][sheets]") {
  for (const Language language : {Language::english, Language::italian}) {
    const DrawnSheet blank = crane().draw("checks", {}, {.language = language, .blank = true});
    const auto asked = std::find_if(blank.sheet.column.begin(), blank.sheet.column.end(), [](const auto& block) {
      const auto* table = std::get_if<drawings::Table>(&block);
      return table && table->to_fill_in;
    });
    REQUIRE(asked != blank.sheet.column.end());
    CHECK(std::get<drawings::Table>(*asked).rows.size() == 6);
    CHECK(std::get<drawings::Table>(*asked).rows.front().size() == 4);
  }
}
