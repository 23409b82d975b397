// The sheets of cycloid and involute, whatever is given.
#include <map>

#include "drawings/paths/vectors.h"
#include "tests/exercises/cycloid-involute/cases.h"
#include "tests/exercises/told_words.h"

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
  for (const char* name : {"cycloid.v_M", "cycloid.a_M", "cycloid.a_n", "cycloid.a_t", "cycloid.P0M",
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
  for (const char* label : {"I", "VI", "XI", "XII ≡ 12", "1", "11", "1′", "9′", "11′", "IV", "4′"}) {
    CAPTURE(label);
    CHECK(has_label(drawn, label));
  }
  CHECK(shows(drawn, "cycloid.arch_base"));
  CHECK(words_of(drawn).find("proved") == std::string::npos);  // a word of ours, not of a sheet's
  CHECK(drawn.sheet.title_block.scales == std::vector<std::string>{"1 : 20", "1 : 10"});
  // On a small wheel the quarters only.
  const DrawnSheet small = both().draw("cycloid", {"d=1.4"});
  CHECK(has_label(small, "9′"));
  CHECK_FALSE(has_label(small, "8′"));
}

TEST_CASE("involute: twelve divisions, and the slip of the source is said", "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("involute", {});
  for (const char* label : {"I", "V", "XII", "1", "12", "1′", "12′", "$λ$", "$l$", "$ω$"}) {
    CAPTURE(label);
    CHECK(has_label(drawn, label));
  }
  CHECK(words_of(drawn).find("prints $x$ with − for +") != std::string::npos);
  CHECK(words_of(drawn).find("more than twice as fast") != std::string::npos);
}

TEST_CASE("cycloid: the cusp is drawn from both sides, another instant as the first", "[cycloid-involute][sheets]") {
  const DrawnSheet cusp = both().draw("cycloid-instants", {}), none = both().draw("cycloid-instants", {"s=3"});
  CHECK(words_of(cusp).find("has a cusp") != std::string::npos);
  CHECK(words_of(none).find("has a cusp") == std::string::npos);
  // M rests: what tells the directions of the path is no velocity.
  int directions = 0;
  for (const drawings::Mark& mark : cusp.sheet.figure.marks)
    if (const auto* arrow = std::get_if<drawings::Arrow>(&mark))
      directions += arrow->meaning == drawings::Meaning::dimension ? 1 : 0;
  CHECK(directions == 2);
  for (const char* label : {"$\\vec{t}^{−}$", "$\\vec{t}^{+}$"}) {
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
  CHECK(words_of(both().draw("cycloid-instants", {})).find("belongs to 90°") != std::string::npos);
  CHECK(words_of(both().draw("cycloid-instants", {"phi=134"})).find("belongs to 90°") == std::string::npos);
}

TEST_CASE("cycloid: the inflection circle is solid, the stationarity circle a dashed line",
          "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("cycloid-instants", {});
  int circles = 0, lines = 0;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
    const auto* line = std::get_if<drawings::Line>(&mark);
    if (!line) continue;
    if (line->name == "inflection_circle") circles += line->meaning == drawings::Meaning::locus ? 1 : 0;
    if (line->meaning == drawings::Meaning::second_locus) ++lines;
  }
  CHECK(circles == 2);
  CHECK(lines == 2);
}

TEST_CASE("involute: the sheets say in which sense the line rolls, and the text of the source",
          "[cycloid-involute][sheets]") {
  for (const char* sheet : {"involute", "involute-instants"}) {
    const DrawnSheet drawn = both().draw(sheet, {});
    const auto& marks = drawn.sheet.figure.marks;
    const auto turned = std::count_if(marks.begin(), marks.end(), [](const drawings::Mark& mark) {
      const auto* arc = std::get_if<drawings::Rotation>(&mark);
      return arc && arc->to > arc->from;
    });
    CHECK(turned == (std::string(sheet) == "involute" ? 1 : 2));
    CHECK_THAT(words_of(drawn), Contains("counter-clockwise") && Contains("Clockwise, as its text says"));
  }
}

TEST_CASE("involute: the contact is seen beside a line many times as long", "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("involute-instants", {"t1=0.42", "t2=0.5"});
  const auto all = labels(drawn);
  CHECK(std::count(all.begin(), all.end(), "$P_{0}$ ≡ $M'$ ≡ $Ω$") == 2);
  double largest = 0;  // mm, of the base circle
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->name == "fixed_polode") {
      double low = line->path.start.x, high = low;
      for (const drawings::Piece& piece : line->path.pieces) {
        low = std::min(low, piece.end.x);
        high = std::max(high, piece.end.x);
      }
      largest = std::max(largest, high - low);
    }
  CHECK(largest >= 30);  // 6 mm before
}

// In one picture, as large as the line permits: the circle is 30 mm wide in the first and not 6.
TEST_CASE("involute: each instant has a scale of its own", "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("involute-instants", {});
  const auto& scales = drawn.sheet.title_block.scales;
  REQUIRE(scales.size() >= 2);
  CHECK(scales[0] == "1 : 20");
  CHECK(scales[1] == "1 : 50");
  const drawings::Arrow a = arrow(drawn, "involute.a_M_t1"), a_n = arrow(drawn, "involute.a_n_t1");
  CHECK(std::hypot(a.to.x - a_n.to.x, a.to.y - a_n.to.y) > 3.5);  // the tangential part
}

TEST_CASE("involute: the pictures of an instant follow each other", "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("involute-instants", {"t1=0.42", "t2=0.5"});
  std::vector<std::string> titles;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* title = std::get_if<drawings::Writing>(&mark); title && title->text.starts_with("$t_"))
      titles.push_back(title->text.substr(0, 7));
  CHECK(titles == std::vector<std::string>{"$t_{1}$", "$t_{1}$", "$t_{2}$", "$t_{2}$"});
}

TEST_CASE("cycloid and involute: a chart has no scale, a sheet with vectors all of its",
          "[cycloid-involute][sheets]") {
  for (const char* sheet : {"cycloid-travel", "involute-travel"})
    CHECK(both().draw(sheet, {}).sheet.title_block.scales == std::vector<std::string>{"–"});
  for (const char* sheet : {"cycloid-instants", "involute-instants"}) {
    const auto& scales = both().draw(sheet, {}).sheet.title_block.scales;
    CHECK(std::count_if(scales.begin(), scales.end(),
                        [](const std::string& scale) { return scale.find("m/s") != std::string::npos; }) == 2);
  }
}

TEST_CASE("involute: letters for which there is no room are left out, and cost no time",
          "[cycloid-involute][sheets]") {
  const DrawnSheet blot =
      both().draw("involute", {"d_0=0.6810"}, {.paper = drawings::Paper::a3, .scale = Rational(1, 1000000)});
  CHECK_FALSE(has_label(blot, "V"));
  CHECK(has_label(both().draw("involute", {"d_0=0.6810"}), "V"));
}

TEST_CASE("involute: too many turns to be drawn are refused in one sentence", "[cycloid-involute][sheets]") {
  CHECK_THROWS_WITH(both().draw("involute-instants", {"t2=1000000000"}), Contains("it can be drawn up to"));
  CHECK(both().checked({"t2=10000000"}).passed());
}

TEST_CASE("cycloid and involute: no side of the accelerations' triangle lies on the body",
          "[cycloid-involute][sheets]") {
  const auto starts = [](const char* sheet) {
    std::map<std::string, drawings::Point> all;
    const DrawnSheet drawn = both().draw(sheet, {});
    for (const drawings::Mark& mark : drawn.sheet.figure.marks)
      if (const auto* arrow = std::get_if<drawings::Arrow>(&mark)) all[arrow->name] = arrow->from;
    return all;
  };
  const auto cycloid = starts("cycloid-instants"), involute = starts("involute-instants");
  CHECK(drawings::distance(cycloid.at("cycloid.a_M"), cycloid.at("cycloid.a_n")) > 1);
  for (const std::string t : {"_t1", "_t2"})
    CHECK(drawings::distance(involute.at("involute.a_M" + t), involute.at("involute.a_n" + t)) > 1);
}

TEST_CASE("involute: its instants can be set out from the sheet", "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("involute-instants", {});
  for (const char* letters : {"$x$", "$M_{0}$", "$φ$"}) CHECK(has_label(drawn, letters));
  CHECK_THAT(words_of(drawn), Contains("$OP_{0}$ at $φ$ (less whole turns) from $x$, counter-clockwise") &&
                                  Contains("$P_{0}M = ½d_{0}φ$"));
  CHECK_THAT(words_of(both().draw("involute-instants", {"t1=0.06"})), !Contains("whole turns"));
  // M has not left its start: the second instant tells it.
  const DrawnSheet from_start = both().draw("involute-instants", {"t1=0"});
  CHECK_THAT(words_of(from_start), Contains("$P_{0}M = ½d_{0}φ$"));
  const auto all = labels(from_start);
  CHECK(std::count(all.begin(), all.end(), "$M_{0}$") == 1);
}

TEST_CASE("involute: the line is drawn once, and its contact seen on it", "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("involute-instants", {});
  std::vector<const drawings::Path*> bodies, constructions;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->path.pieces.size() == 1) {
      if (line->name == "moving_polode") bodies.push_back(&line->path);
      if (line->meaning == drawings::Meaning::construction) constructions.push_back(&line->path);
    }
  REQUIRE(bodies.size() == 2);
  for (const drawings::Path* body : bodies) {
    const drawings::Point from = body->start, along = drawings::unit(from, body->pieces[0].end);
    const auto off = [&](drawings::Point p) { return std::abs(dot(p - from, drawings::left_of(along))); };
    for (const drawings::Path* line : constructions)
      CHECK((off(line->start) > 0.01 || off(line->pieces[0].end) > 0.01));
  }
}

TEST_CASE("cycloid and involute: the angular velocity has the letters it is given under",
          "[cycloid-involute][sheets]") {
  const DrawnSheet cycloid = both().draw("cycloid-instants", {}), involute = both().draw("involute-instants", {});
  CHECK(has_label(cycloid, "$ω_{1}$"));
  CHECK(has_label(involute, "$ω_{2}$"));
  CHECK_THAT(words_of(involute), Contains("ω_{2}^{2}") && !Contains("ω^{2}"));
  CHECK(involute.sheet.title_block.scales.at(2) == "1 cm ≙ 100 m/s");  // 5 mm of v_M before
}

TEST_CASE(
    "cycloid and involute: the instant with the steps is larger than the cusp, its centre of curvature off the sheet",
    "[cycloid-involute][sheets]") {
  const DrawnSheet drawn = both().draw("cycloid-instants", {});
  CHECK(drawn.sheet.title_block.scales.at(0) == "1 : 10");
  CHECK(drawn.sheet.title_block.scales.at(1) == "1 : 20");
  CHECK(has_label(drawn, "to $Ω$"));
}
