// The sheets of the bar on a translating body, whatever is given.
#include "tests/exercises/velocity-centre/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Assignments> usual{
    {},           {"omega=0"},    {"omega=-3"},  {"V=-12"},     {"V=0"},       {"omega=0", "V=0"},
    {"angle=0"},  {"angle=90"},   {"angle=180"}, {"angle=200"}, {"angle=270"}, {"a=-4.5", "omega_dot=2"},
    {"omega=30"}, {"omega=1/100"}};

bool shows(const DrawnSheet& drawn, const std::string& quantity) {
  for (const Measurement& m : drawn.measurements)
    if (m.quantity == quantity) return true;
  return false;
}

bool has_label(const DrawnSheet& drawn, const std::string& text) {
  const auto& labels = drawn.sheet.figure.labels;
  return std::any_of(labels.begin(), labels.end(), [&](const drawings::Label& label) { return label.text == text; });
}

std::string construction(const DrawnSheet& drawn) {
  std::string text;
  for (const drawings::Block& block : drawn.sheet.column)
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) text += line + "\n";
    else if (const auto* decided = std::get_if<drawings::Paragraph>(&block))
      text += decided->text + "\n";
  return text;
}

}  // namespace

TEST_CASE("velocity centre: every sheet is drawn, whatever is given", "[velocity-centre][sheets]") {
  draws_every_sheet(bar(), read_corpus(EPURE_CORPUS "/carried_bar.txt"));
}

TEST_CASE("velocity centre: letters find room", "[velocity-centre][sheets]") { letters_find_room(bar(), usual); }

TEST_CASE("velocity centre: a ruler on the file reads the value of every vector", "[velocity-centre][sheets]") {
  for (const Assignments& assignments : {Assignments{}, {"angle=200"}, {"omega=-2", "V=5"}}) {
    ruler_reads(bar(), {"velocities", {"v_O", "v_AO", "v_A"}}, assignments);
    ruler_reads(bar(), {"accelerations", {"a_O", "a_AO_n", "a_AO_t", "a_A"}}, assignments);
  }
}

TEST_CASE("velocity centre: it is on its sheet also where it is far", "[velocity-centre][sheets]") {
  CHECK(has_label(bar().draw("velocities", {"phi=190", "omega=-0.3", "V=-4"}), "$P_{0}$"));
}

TEST_CASE("velocity centre: the polygons close", "[velocity-centre][sheets]") {
  for (const Assignments& assignments : usual) {
    polygon_closes(bar(), {"velocities", {"v_O", "v_AO", "v_A"}}, assignments);
    polygon_closes(bar(), {"accelerations", {"a_O", "a_AO_n", "a_AO_t", "a_A"}}, assignments);
  }
}

TEST_CASE("velocity centre: a scale that is asked for is the bar's", "[velocity-centre][sheets]") {
  const auto scales = [](const SheetRequest& request) {
    return bar().draw("velocities", {}, request).sheet.title_block.scales;
  };
  CHECK(scales({}) == std::vector<std::string>{"1 : 10", "1 : 50", "1 cm ≙ 2 m/s"});
  CHECK(scales({.scale = Rational(1, 20)}).front() == "1 : 20");
  CHECK_THROWS_WITH(scales({.scale = Rational(1)}), Contains("would fit"));
}

TEST_CASE("velocity centre: no given is parted from its unit", "[velocity-centre][sheets]") {
  const DrawnSheet drawn = bar().draw("velocities", {});
  CHECK(std::get<drawings::Paragraph>(drawn.sheet.column.at(1)).text ==
        "$\\it{L}$\u00a0=\u00a00.8\u00a0m, $θ$\u00a0=\u00a045°, $ω$\u00a0=\u00a03\u00a0rad/s, "
        "$\\it{V}$\u00a0=\u00a012\u00a0m/s");  // accelerations have no part in it
}

TEST_CASE("velocity centre: θ and ω are drawn in their senses", "[velocity-centre][sheets]") {
  const auto mark = [](const DrawnSheet& drawn, auto kind) {
    for (const drawings::Mark& each : drawn.sheet.figure.marks)
      if (const auto* found = std::get_if<decltype(kind)>(&each)) return *found;
    throw std::logic_error("no such mark");
  };
  const auto counter_clockwise = bar().draw("accelerations", {"angle=200"});
  CHECK(mark(counter_clockwise, drawings::Rotation{}).from < mark(counter_clockwise, drawings::Rotation{}).to);
  CHECK(mark(counter_clockwise, drawings::AngleMark{}).to == Approx(200 * std::numbers::pi / 180));
  const auto clockwise = bar().draw("accelerations", {"angle=-30", "omega=-3"});
  CHECK(mark(clockwise, drawings::Rotation{}).from > mark(clockwise, drawings::Rotation{}).to);
  CHECK(mark(clockwise, drawings::AngleMark{}).from == Approx(-30 * std::numbers::pi / 180));
}

TEST_CASE("velocity centre: it is shown where there is one, and the steps say why where not",
          "[velocity-centre][sheets]") {
  for (const Assignments& shown : {Assignments{}, {"V=0"}, {"angle=90"}, {"angle=270", "omega=-3"}}) {
    CAPTURE(shown);
    CHECK(shows(bar().draw("velocities", shown), "P0O"));
    CHECK(shows(bar().draw("velocities", shown), "P0A"));
  }
  const DrawnSheet translating = bar().draw("velocities", {"omega=0"}),
                   far = bar().draw("velocities", {"omega=1/1000"});
  CHECK_FALSE(shows(translating, "P0O"));
  CHECK(construction(translating).find("at infinity") != std::string::npos);
  CHECK_FALSE(shows(far, "P0O"));
  CHECK(has_label(far, "to $P_{0}$"));
  CHECK_FALSE(has_label(bar().draw("velocities", {}), "to $P_{0}$"));
  CHECK(construction(bar().draw("velocities", {"omega=0", "V=0"})).find("the bar rests") != std::string::npos);
  CHECK(construction(bar().draw("velocities", {"angle=90"})).find("tips") != std::string::npos);
  CHECK(construction(bar().draw("velocities", {})).find("−6.071") != std::string::npos);
}
