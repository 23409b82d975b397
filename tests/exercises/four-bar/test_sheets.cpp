// The four-bar's sheets: all are drawn whatever is given, letters find room, and a ruler on the file reads the
// quantities.
#include "drawings/paths/vectors.h"
#include "tests/exercises/four-bar/cases.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Assignments> handful{
    {},
    {"branch=left"},
    {"n=-50"},
    {"C_side=left", "alpha_2=3"},
    {"t=0.35"},
    {"t=0.42"},  // crank and rocker all but parallel
    {"A0A=0.15", "B0B=0.15", "AB=0.3", "x_B0=0.3", "y_B0=0", "AC=0.2", "branch=left"},
    {"A0A=0.2", "B0B=0.4", "AB=0.74", "x_B0=0.5", "y_B0=0.24", "AC=0.5", "t=0"},  // parallel, of different length
    // drag-link, and a double rocker
    {"A0A=0.3", "AB=0.35", "B0B=0.32", "x_B0=0.1", "y_B0=0.05", "AC=0.21"},
    {"A0A=0.5", "AB=0.2", "B0B=0.6", "x_B0=0.7", "y_B0=0", "AC=0.12", "t=0.2", "branch=left"}};

// Where the first of these letters belongs.
drawings::Point four_bar_label(const DrawnSheet& drawn, const std::string& text) {
  for (const drawings::Label& label : drawn.sheet.figure.labels)
    if (label.text == text) return label.at;
  throw std::logic_error("no label " + text);
}

}  // namespace

TEST_CASE("four-bar: every sheet is drawn, whatever is given", "[four-bar][sheets]") {
  for (const CorpusCase& c : four_bar_corpus())
    for (const SheetSpec& sheet : four_bar().about().sheets) {
      CAPTURE(c.name, sheet.name);
      std::string bytes;
      CHECK_NOTHROW(bytes = drawings::svg(four_bar().draw(sheet.name, assignments_of(c)).sheet));
      CHECK(bytes.find("<svg") != std::string::npos);
      for (const char* word : {"-nan", "=\"nan", "=\"inf", " nan ", " inf "})
        CHECK(bytes.find(word) == std::string::npos);
    }
}

TEST_CASE("four-bar: letters find room", "[four-bar][sheets]") { letters_find_room(four_bar(), handful); }

TEST_CASE("four-bar: a ruler on the file reads the value of every vector", "[four-bar][sheets]") {
  for (const Assignments& assignments : {Assignments{}, {"n=-50"}, {"t=0.35"}}) {
    ruler_reads(four_bar(), {"poles", {"v_A", "v_B", "v_C"}}, assignments);
    ruler_reads(four_bar(), {"velocity-diagram", {"v_A", "v_B", "v_BA", "v_C"}}, assignments);
    ruler_reads(four_bar(), {"acceleration-diagram", {"a_A", "a_B_n", "a_B_t", "a_BA_n", "a_BA_t", "a_C"}},
                assignments);
    ruler_reads(four_bar(), {"acceleration-pole", {"a_A", "a_B", "a_C"}}, assignments);
  }
}

TEST_CASE("four-bar: with crank and rocker parallel each position has its polygon of accelerations, with c'",
          "[four-bar][sheets]") {
  for (const auto& [sheet, sense] : {std::pair{"parallel-links", "same"}, {"parallel-links-opposite", "opposite"}}) {
    std::vector<std::string> vectors;
    for (const char* name : {"v_A", "v_B", "v_C", "a_A", "a_B_t", "a_BA_t", "a_B", "a_C"})
      vectors.push_back(std::string("parallel_links.") + sense + "_sense_main_branch_" + name);
    for (const Assignments& assignments : {Assignments{}, {"alpha_2=3", "C_side=left"}})
      ruler_reads(four_bar(), {sheet, vectors}, assignments);
    for (const char* letters : {"$C$", "$O_{a}$", "$c'$"})
      CHECK_NOTHROW(four_bar_label(four_bar().draw(sheet, {}), letters));
  }
}

// A crank longer than the coupler, which can be folded over the rocker's arc but not stretched to it.
TEST_CASE("four-bar: a dead centre without another is drawn", "[four-bar][sheets]") {
  const DrawnSheet drawn = four_bar().draw("dead-centres", {"A0A=0.5", "AB=0.37", "B0B=0.2", "phi=150"});
  for (const char* letters : {"$A_{2}$", "$B_{2}$", "$C_{2}$"}) CHECK_NOTHROW(four_bar_label(drawn, letters));
  CHECK_THROWS(four_bar_label(drawn, "$B_{1}$"));
}

TEST_CASE("four-bar: the pole stands on its sheet, or its rays say where it is", "[four-bar][sheets]") {
  const auto rays_to_pole = [](const Assignments& assignments) {
    int rays = 0;
    for (const drawings::Label& label : four_bar().draw("poles", assignments).sheet.figure.labels)
      rays += label.text == "to $P_{31}$" ? 1 : 0;
    return rays;
  };
  CHECK(rays_to_pole({}) == 0);
  CHECK(rays_to_pole({"t=0.35"}) == 0);
  CHECK(rays_to_pole({"t=0.42"}) == 2);  // 17 m away
  CHECK(rays_to_pole({"A0A=0.15", "B0B=0.15", "AB=0.3", "x_B0=0.3", "y_B0=0", "AC=0.2", "branch=left"}) == 2);
}

TEST_CASE("four-bar: two angles at one hinge have each an arc of its own", "[four-bar][sheets]") {
  std::vector<drawings::AngleMark> arcs;
  for (const drawings::Mark& mark : four_bar().draw("dead-centres", {}).sheet.figure.marks)
    if (const auto* arc = std::get_if<drawings::AngleMark>(&mark)) arcs.push_back(*arc);
  REQUIRE(arcs.size() == 3);  // φ₁ and φ₂ at A₀, Δθ₄ at B₀
  CHECK(arcs[0].at.x == arcs[1].at.x);
  CHECK(std::abs(arcs[0].radius - arcs[1].radius) > 2);
}

TEST_CASE("four-bar: no leg of an angle hides the dashes of a link in another position", "[four-bar][sheets]") {
  const DrawnSheet drawn = four_bar().draw("dead-centres", {});
  const drawings::Point B0 = four_bar_label(drawn, "$B_{0}$");
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark);
        line && line->meaning == drawings::Meaning::construction)
      CHECK(drawings::distance(line->path.start, B0) > 0.01);
}

TEST_CASE("four-bar: supports stand behind the links", "[four-bar][sheets]") {
  const drawings::Figure figure = four_bar().draw("dead-centre-folded", {}).sheet.figure;
  std::size_t last_support = 0, first_link = figure.marks.size();
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    if (std::holds_alternative<drawings::FixedHinge>(figure.marks[i])) last_support = i;
    if (const auto* line = std::get_if<drawings::Line>(&figure.marks[i]);
        line && line->meaning == drawings::Meaning::link)
      first_link = std::min(first_link, i);
  }
  CHECK(last_support > 0);
  CHECK(last_support < first_link);
}

// The tracer finds more of the path than the piece at C that belongs to the osculating circle.
TEST_CASE("four-bar: of the path of C no more than a piece at C is seen", "[four-bar][sheets]") {
  const drawings::Figure figure = four_bar().draw("curvature", {}).sheet.figure;
  int pieces = 0;
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    const auto* line = std::get_if<drawings::Line>(&figure.marks[i]);
    if (!line || line->name != "path_of_C") continue;
    ++pieces;
    const drawings::Box seen = figure.windows[static_cast<std::size_t>(figure.window_of[i])];
    CHECK(seen.width() <= 36.001);
    CHECK(seen.height() <= 36.001);
  }
  CHECK(pieces > 0);
}

TEST_CASE("four-bar: B and C are found by arcs that are drawn", "[four-bar][sheets]") {
  const DrawnSheet drawn = four_bar().draw("poles", {});
  int arcs = 0;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* line = std::get_if<drawings::Line>(&mark))
      arcs += line->meaning == drawings::Meaning::construction && !line->path.pieces.empty() &&
                      !line->path.pieces.front().straight
                  ? 1
                  : 0;
  CHECK(arcs == 4);
}

// a_A points from A to A0, all along the crank.
TEST_CASE("four-bar: a vector along a link stands beside it, as long as it is", "[four-bar][sheets]") {
  const DrawnSheet drawn = four_bar().draw("acceleration-pole", {});
  const auto& marks = drawn.sheet.figure.marks;
  const auto a_A = std::find_if(marks.begin(), marks.end(), [](const drawings::Mark& mark) {
    const auto* arrow = std::get_if<drawings::Arrow>(&mark);
    return arrow && arrow->name == "a_A";
  });
  REQUIRE(a_A != marks.end());
  const auto& arrow = std::get<drawings::Arrow>(*a_A);
  const drawings::Point along = drawings::unit(arrow.from, arrow.to);
  int links = 0;
  for (const drawings::Mark& mark : marks) {
    const auto* line = std::get_if<drawings::Line>(&mark);
    if (!line || line->meaning != drawings::Meaning::link || line->path.pieces.size() != 1) continue;
    const drawings::Point link = drawings::unit(line->path.start, line->path.pieces.front().end);
    if (std::abs(drawings::dot(link, along)) < 0.9999) continue;  // BC is two degrees off
    ++links;
    CHECK(std::abs(drawings::dot(line->path.start - arrow.from, drawings::left_of(along))) > 1);
  }
  CHECK(links == 1);  // the crank
  // A thin line joins it to A.
  const drawings::Point A = four_bar_label(drawn, "$A$");
  CHECK(std::any_of(marks.begin(), marks.end(), [&](const drawings::Mark& mark) {
    const auto* line = std::get_if<drawings::Line>(&mark);
    return line && line->meaning == drawings::Meaning::dimension && line->path.pieces.size() == 1 &&
           drawings::distance(line->path.start, A) < 0.01 &&
           drawings::distance(line->path.pieces.front().end, arrow.from) < 0.01;
  }));
}

// Through the support of A₀ it would be lost: past the hinge it keeps clear of it, on the other side.
TEST_CASE("four-bar: a vector that runs past a hinge keeps clear of it and of its support", "[four-bar][sheets]") {
  const DrawnSheet drawn = four_bar().draw("acceleration-pole", {});
  const auto& marks = drawn.sheet.figure.marks;
  const drawings::Arrow a_A = arrow(drawn, "a_A");
  const drawings::Point along = drawings::unit(a_A.from, a_A.to);
  int passed = 0;
  for (const drawings::Mark& mark : marks) {
    const auto* hinge = std::get_if<drawings::FixedHinge>(&mark);
    if (!hinge) continue;
    const double there = drawings::dot(hinge->at - a_A.from, along),
                 aside = drawings::dot(hinge->at - a_A.from, drawings::left_of(along));
    if (there < 0 || there > drawings::distance(a_A.from, a_A.to) || std::abs(aside) > 5) continue;
    ++passed;
    CHECK(std::abs(aside) > 2);
    CHECK(aside * drawings::dot(drawings::direction(hinge->down), drawings::left_of(along)) > 0);
  }
  CHECK(passed == 1);
}

TEST_CASE("four-bar: parallel links bear as many arrow heads, and none across another link", "[four-bar][sheets]") {
  for (const char* sheet : {"parallel-links", "parallel-links-opposite"}) {
    int heads = 0;
    for (const drawings::Mark& mark : four_bar().draw(sheet, {}).sheet.figure.marks)
      if (const auto* parallel = std::get_if<drawings::ParallelMark>(&mark)) heads += parallel->heads;
    CHECK(heads == 2 + 2 + 1 + 1);
  }
}

// In one picture with the linkage it would be cut.
TEST_CASE("four-bar: an inflection circle larger than the linkage is whole in a picture of its own",
          "[four-bar][sheets]") {
  const DrawnSheet drawn = four_bar().draw("curvature", {});
  CHECK(drawn.sheet.title_block.scales == std::vector<std::string>{"1 : 10", "1 : 5"});
  bool names_sheet = false, leaves_out = false;
  for (const drawings::Block& block : drawn.sheet.column) {
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      names_sheet = names_sheet || steps->lines.front().find("sheet\u00a04") != std::string::npos;
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block))
      leaves_out = leaves_out || paragraph->text.starts_with("Off the sheet");
  }
  CHECK(names_sheet);
  CHECK_FALSE(leaves_out);
}

// Found by its shape: c' needs no vector from b', whose letters had no place beside it.
TEST_CASE("four-bar: the triangle of the accelerations is closed by a line", "[four-bar][sheets]") {
  const DrawnSheet drawn = four_bar().draw("acceleration-diagram", {});
  const drawings::Point b = four_bar_label(drawn, "$b'$"), c = four_bar_label(drawn, "$c'$");
  int lines = 0, vectors = 0;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
    const auto runs = [&](drawings::Point from, drawings::Point to) {
      return drawings::distance(from, b) < 0.01 && drawings::distance(to, c) < 0.01;
    };
    if (const auto* line = std::get_if<drawings::Line>(&mark); line && line->path.pieces.size() == 1)
      lines += runs(line->path.start, line->path.pieces.front().end) ? 1 : 0;
    if (const auto* arrow = std::get_if<drawings::Arrow>(&mark)) vectors += runs(arrow->from, arrow->to) ? 1 : 0;
  }
  CHECK(lines == 1);
  CHECK(vectors == 0);
}

// At 250° the crank runs down where the support would stand.
TEST_CASE("four-bar: a support is upside down only where there is no room beside the hinge", "[four-bar][sheets]") {
  std::vector<double> supports;
  for (const drawings::Mark& mark : four_bar().draw("acceleration-diagram", {"phi=250"}).sheet.figure.marks)
    if (const auto* hinge = std::get_if<drawings::FixedHinge>(&mark)) supports.push_back(hinge->down);
  REQUIRE(supports.size() == 2);
  for (const double down : supports) CHECK(std::sin(down) < 0.5);
}

// The steps say on which side of A₀ → B₀ the point Q lies that is drawn, and where A is from it.
TEST_CASE("four-bar: the steps to parallel links fit what is drawn", "[four-bar][sheets]") {
  int seen = 0;
  const auto look_at = [&](const Assignments& assignments, const char* sheet) {
    const DrawnSheet drawn = four_bar().draw(sheet, assignments);
    std::vector<std::string> told;
    for (const drawings::Block& block : drawn.sheet.column)
      if (const auto* steps = std::get_if<drawings::Steps>(&block)) told = steps->lines;
    drawings::Point A0, A, B0;
    for (const drawings::Label& label : drawn.sheet.figure.labels) {
      if (label.text == "$A_{0}$") A0 = label.at;
      if (label.text == "$B_{0}$") B0 = label.at;
      if (label.text == "$A$") A = label.at;
      if (label.text != "$Q$") continue;
      const auto step = std::find_if(told.begin(), told.end(),
                                     [&](const std::string& line) { return line.starts_with(label.text + ":"); });
      CAPTURE(assignments, label.text, told);
      REQUIRE(step != told.end());
      const drawings::Point Q = label.at, base = B0 - A0;
      const bool is_left = dot(drawings::left_of(base), Q - A0) > 0;
      CHECK(step->find(is_left ? "on the left of" : "on the right of") != std::string::npos);
      const double share = dot(A - A0, Q - A0) / dot(Q - A0, Q - A0);
      const std::string& to_A = *(step + 1);
      CHECK(to_A.find(share < 0   ? "beyond $A_{0}$, seen from"
                      : share < 1 ? "between $A_{0}$ and"
                                  : "beyond $Q$") != std::string::npos);
      ++seen;
    }
  };
  for (const Assignments& assignments : handful)
    for (const char* sheet : {"parallel-links", "parallel-links-opposite"}) look_at(assignments, sheet);
  CHECK(seen >= 10);
}

TEST_CASE("four-bar: beside a far larger inflection circle the linkage has a picture of its own",
          "[four-bar][sheets]") {
  CHECK(four_bar().draw("circles-folded", {}).sheet.title_block.scales ==
        std::vector<std::string>{"1 : 50", "1 : 5"});  // the construction is done in the first
  CHECK(four_bar().draw("circles", {}).sheet.title_block.scales.size() == 1);
}
