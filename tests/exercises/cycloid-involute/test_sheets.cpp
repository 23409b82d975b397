// The sheets of cycloid and involute, whatever is given.
#include "tests/exercises/cycloid-involute/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

// Angles and arcs around the arch, wheels and circles large and small, quick and slow.
const std::vector<Assignments> usual{{},
                                     {"phi=0", "s=0", "t1=0"},
                                     {"phi=20", "s=0.3", "t1=0.02", "t2=0.05"},
                                     {"phi=90", "s=1"},
                                     {"phi=180", "s=2"},
                                     {"phi=270", "s=3"},
                                     {"phi=350", "s=3.9"},
                                     {"phi=360", "s=4.000000001"},
                                     {"phi=500", "s=6", "t1=0.2", "t2=0.1"},
                                     {"phi=1000000000", "s=1000.7", "t2=100"},
                                     {"d=0.5", "d_0=0.2", "omega_1=1", "omega_2=5"},
                                     {"d=1.4", "d_0=3", "omega_1=3000", "t1=0"},
                                     {"d=40", "s=1000", "d_0=0.05"},
                                     {"d=0.002"}};

bool shows(const DrawnSheet& drawn, const std::string& quantity) {
  return std::any_of(drawn.measurements.begin(), drawn.measurements.end(),
                     [&](const Measurement& m) { return m.quantity == quantity; });
}

std::string text_of(const DrawnSheet& drawn) {
  std::string text;
  for (const drawings::Block& block : drawn.sheet.column) {
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) text += line + "\n";
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) text += paragraph->text + "\n";
  }
  return text;
}

std::vector<std::string> labels(const DrawnSheet& drawn) {
  std::vector<std::string> all;
  for (const drawings::Label& label : drawn.sheet.figure.labels) all.push_back(label.text);
  return all;
}
bool has_label(const DrawnSheet& drawn, const std::string& text) {
  const std::vector<std::string> all = labels(drawn);
  return std::find(all.begin(), all.end(), text) != all.end();
}

}  // namespace

TEST_CASE("cycloid and involute: every sheet is drawn, whatever is given", "[cycloid-involute][sheets]") {
  draws_every_sheet(both(), read_corpus(EPURE_CORPUS "/cycloid_involute.txt"));
}

TEST_CASE("cycloid and involute: letters find room", "[cycloid-involute][sheets]") {
  letters_find_room(both(), usual);
}

TEST_CASE("cycloid and involute: what the sheets show is right, whatever is given", "[cycloid-involute][sheets]") {
  for (const Assignments& assignments : usual) {
    const CheckedExercise result = both().checked(assignments);
    CAPTURE(assignments, complaints(result));
    CHECK(result.passed());
  }
}

TEST_CASE("cycloid and involute: a ruler on the file reads the value of every vector", "[cycloid-involute][sheets]") {
  const CheckedExercise result = both().checked({});
  for (const char* name : {"cycloid.v_M", "cycloid.a_M", "cycloid.a_n", "cycloid.a_t", "cycloid.rho_M", "cycloid.P0M",
                           "cycloid.a_M_at_s4", "involute.v_M_t1", "involute.a_n_t2", "involute.a_t_t2",
                           "involute.P0M_t1", "involute.arc_length_t2", "cycloid.t_at_s4"}) {
    CAPTURE(name);
    REQUIRE_FALSE(find(result, name).on_sheets.empty());
    for (const OnSheet& shown : find(result, name).on_sheets) CHECK(is_within_resolution(shown, value(result, name)));
  }
}

TEST_CASE("cycloid and involute: the polygons of accelerations close", "[cycloid-involute][sheets]") {
  for (const Assignments& assignments : {Assignments{}, {"phi=200", "s=1"}, {"phi=330", "s=3.5"}, {"t1=0.01"}}) {
    const auto parts = [](const std::string& before, const std::string& after) {
      return std::vector<std::string>{before + "a_n" + after, before + "a_t" + after, before + "a_M" + after};
    };
    polygon_closes(both(), {"cycloid-instants", parts("cycloid.", "")}, assignments);
    polygon_closes(both(), {"involute-instants", parts("involute.", "_t1")}, assignments);
    polygon_closes(both(), {"involute-instants", parts("involute.", "_t2")}, assignments);
  }
}

TEST_CASE("cycloid: twelve divisions are there to be seen", "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("cycloid", {});
  for (const char* label : {"I", "VI", "XI", "XII ≡ 12", "1", "11", "1'", "9'", "11'", "IV", "4'"}) {
    CAPTURE(label);
    CHECK(has_label(drawn, label));
  }
  CHECK(shows(drawn, "cycloid.arch_base"));
  CHECK(text_of(drawn).find("proved") != std::string::npos);
  CHECK(drawn.sheet.title_block.scales == std::vector<std::string>{"1 : 20 above", "1 : 10 below"});
  // On a small wheel the quarters only.
  const DrawnSheet small = both().draw("cycloid", {"d=1.4"});
  CHECK(has_label(small, "9'"));
  CHECK_FALSE(has_label(small, "8'"));
}

TEST_CASE("involute: twelve divisions, and the slip of the source is said", "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("involute", {});
  for (const char* label : {"I", "V", "XII", "1", "12", "1'", "12'", "λ", "l"}) {
    CAPTURE(label);
    CHECK(has_label(drawn, label));
  }
  CHECK(text_of(drawn).find("prints $x$ with − for +") != std::string::npos);
  CHECK(text_of(drawn).find("2.38 times") != std::string::npos);
}

TEST_CASE("cycloid: the cusp is drawn from both sides, another instant as the first", "[cycloid-involute][sheets]") {
  const DrawnSheet cusp = both().draw("cycloid-instants", {}), none = both().draw("cycloid-instants", {"s=3"});
  CHECK(text_of(cusp).find("At a cusp") != std::string::npos);
  CHECK(text_of(none).find("At a cusp") == std::string::npos);
  for (const char* label : {"$\\vec{a}_{M}$ = $\\vec{a}^{t−}_{M}$", "$\\vec{a}_{M}$ = $\\vec{a}^{t+}_{M}$"}) {
    CHECK(has_label(cusp, label));
    CHECK_FALSE(has_label(none, label));
  }
  CHECK(shows(none, "cycloid.v_M_at_s4"));
  CHECK_FALSE(shows(cusp, "cycloid.v_M_at_s4"));
  // At a cusp a lies along the tangent, up.
  const drawings::Arrow a = arrow(cusp, "cycloid.a_M_at_s4");
  CHECK(a.from.x == a.to.x);
  CHECK(a.to.y > a.from.y);
}

TEST_CASE("cycloid: the source's quarter turn is said where its numbers stand", "[cycloid-involute][sheets]") {
  CHECK(text_of(both().draw("cycloid-instants", {})).find("belongs to 90°") != std::string::npos);
  CHECK(text_of(both().draw("cycloid-instants", {"phi=134"})).find("belongs to 90°") == std::string::npos);
}

TEST_CASE("involute: too many turns to be drawn are refused in one sentence", "[cycloid-involute][sheets]") {
  CHECK_THROWS_WITH(both().draw("involute-instants", {"t2=1000000000"}), Contains("it can be drawn up to"));
  CHECK(both().checked({"t2=10000000"}).passed());
}
