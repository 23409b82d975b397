// The sheets of the roulettes, whatever rolls on whatever.
#include "drawings/paths/flatten.h"
#include "exercises/kit/panels/sheet.h"
#include "tests/exercises/roulette/cases.h"
#include "tests/exercises/told_words.h"

using namespace epure;
using namespace epure::tests;

namespace {

const std::vector<Assignments> usual{{},
                                     {"how=circle_on_line", "phi=140"},
                                     {"how=circle_on_line", "d=0.3", "alpha=3"},
                                     {"how=circle_on_line", "d=0.05", "phi=-200"},
                                     {"how=circle_inside_circle", "R=0.6"},
                                     {"how=circle_inside_circle", "R=0.3"},
                                     {"how=line_on_circle", "d=0"},
                                     {"how=line_on_circle", "d=-0.2", "phi=-100", "omega=-2"},
                                     {"how=circle_inside_circle"},
                                     {"how=circle_on_line", "d=0.075", "phi=60"},
                                     {"phi=480"}};

bool draws(const DrawnSheet& drawn) {
  const std::string bytes = drawings::svg(drawn.sheet);
  for (const char* word : {"-nan", "=\"nan", "=\"inf", " nan ", " inf "})
    if (bytes.find(word) != std::string::npos) return false;
  return bytes.find("<svg") != std::string::npos;
}

// From one place and in one direction, within a hair's breadth on the paper: the longer hides the shorter.
bool one_hides_the_other(const drawings::Arrow& a, const drawings::Arrow& b) {
  const double ax = a.to.x - a.from.x, ay = a.to.y - a.from.y, bx = b.to.x - b.from.x, by = b.to.y - b.from.y;
  const double apart = std::hypot(b.from.x - a.from.x, b.from.y - a.from.y);
  const double shorter = std::min(std::hypot(ax, ay), std::hypot(bx, by));
  const double across = std::abs(ax * by - ay * bx) / std::max(std::hypot(ax, ay), std::hypot(bx, by));
  return apart < 0.5 && shorter > 1 && across < 0.5 && ax * bx + ay * by > 0;
}

std::vector<drawings::Arrow> arrows(const DrawnSheet& drawn) {
  std::vector<drawings::Arrow> found;
  for (const drawings::Mark& mark : drawn.sheet.figure.marks)
    if (const auto* arrow = std::get_if<drawings::Arrow>(&mark)) found.push_back(*arrow);
  return found;
}

bool is_written(const DrawnSheet& drawn, const std::string& text) {
  const auto& labels = drawn.sheet.figure.labels;
  return std::any_of(labels.begin(), labels.end(), [&](const drawings::Label& label) { return label.text == text; });
}

double path_misses_M_by(const DrawnSheet& drawn) {
  const auto& labels = drawn.sheet.figure.labels;
  const auto of_M = std::find_if(labels.begin(), labels.end(), [](const auto& label) { return label.text == "$M$"; });
  REQUIRE(of_M != labels.end());
  const drawings::Point M = of_M->at;
  double least = std::numeric_limits<double>::infinity();
  for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
    const auto* line = std::get_if<drawings::Line>(&mark);
    if (!line || line->name != "path") continue;
    const std::vector<drawings::Point> chain = drawings::flatten(line->path, 0.001);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const double x = chain[i].x - chain[i - 1].x, y = chain[i].y - chain[i - 1].y, square = x * x + y * y;
      const double along = (M.x - chain[i - 1].x) * x + (M.y - chain[i - 1].y) * y;
      const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
      least = std::min(least, std::hypot(chain[i - 1].x + t * x - M.x, chain[i - 1].y + t * y - M.y));
    }
  }
  return least;
}

}  // namespace

TEST_CASE("roulette: letters find room", "[roulette][sheets]") { letters_find_room(roulette(), usual); }

TEST_CASE("roulette: every sheet is drawn, whatever is given", "[roulette][sheets]") {
  std::vector<Assignments> hard{{"omega=0"},
                                {"omega=0", "alpha=0", "phi=0"},
                                {"d=0"},
                                {"r=1e-6", "d=1e-6"},
                                {"r=1e6", "d=1e6"},
                                {"phi=1e9"},
                                {"d=1000"},
                                {"r=0.449", "d=0.449"},
                                {"R=0.000001"},
                                {"phi=0"},
                                {"phi_rad=1e-12", "phi=0"},
                                {"omega=1e6", "alpha=-1e9"},
                                {"r=1", "R=1e12"},
                                {"r=1e-12", "R=1e12", "d=1e-12", "phi=40"},
                                {"r=1", "R=1.000000000001", "d=1"},
                                {"phi_rad=1e12", "d=0.1"},
                                {"r=0.45000001", "R=0.8", "d=0.6", "phi_rad=758251919006.9353"}};
  for (const char* how : {"circle_on_line", "circle_outside_circle", "circle_inside_circle", "line_on_circle"})
    for (Assignments assignments : hard) {
      assignments.push_back(std::string("how=") + how);
      CAPTURE(assignments);
      for (const SheetSpec& sheet : roulette().about().sheets) {
        CAPTURE(sheet.name);
        const Givens givens = roulette().givens(assignments);
        if (std::string(how) == "circle_inside_circle" && givens["r"] >= givens["R"])
          CHECK_THROWS_AS(roulette().draw(sheet.name, assignments), BadGivens);
        else
          CHECK(draws(roulette().draw(sheet.name, assignments)));
      }
    }
}

TEST_CASE("roulette: a ruler on the file reads speed, acceleration and its normal part", "[roulette][sheets]") {
  for (const Assignments& assignments :
       {Assignments{}, {"how=circle_on_line", "d=0.3", "alpha=3"}, {"how=line_on_circle", "d=-0.2"}}) {
    ruler_reads(roulette(), {"instant", {"a_M", "a_M_n"}}, assignments);
    const CheckedExercise numbers = roulette().checked(assignments);
    for (const char* name : {"v_M", "inflection_diameter", "rho_M", "Mprime_M", "P0M"})
      CHECK_FALSE(find(numbers, name).on_sheets.empty());
  }
}

TEST_CASE("roulette: the tangential acceleration told is that after, where before is no other",
          "[roulette][sheets]") {
  for (const Assignments& assignments : {Assignments{}, {"how=circle_on_line", "d=0.3", "alpha=3"}}) {
    const double a_M_t = find(roulette().checked(assignments), "a_M_t_after").settled.enclosure.value;
    CHECK_THAT(words_of(roulette().draw("instant", assignments)),
               Contains("$a^{t}_{M}$ = " + figures(a_M_t, 4, Language::english) + " m/s²"));
  }
}

TEST_CASE("roulette: the sheets say what is special", "[roulette][sheets]") {
  CHECK_THAT(words_of(roulette().draw("instant", {"phi=480"})), Contains("has a cusp") && Contains("before"));
  CHECK_THAT(words_of(roulette().draw("instant", {"how=circle_inside_circle", "R=0.3"})), Contains("a diameter"));
  CHECK_THAT(words_of(roulette().draw("instant", {"how=circle_on_line", "d=0.075", "phi=60"})),
             Contains("at infinity"));
  CHECK_THAT(words_of(roulette().draw("path", {"d=0.1"})), Contains("curtate epicycloid"));
  CHECK_THAT(words_of(roulette().draw("path", {"d=0.2"}, {.language = Language::italian})),
             Contains("epicicloide allungata"));
}

TEST_CASE("roulette: far from the fixed centre, or after many turns, the path passes through M and has its cusps",
          "[roulette][sheets]") {
  // Cusps on the sheet: both ends of the first arch; later those of M's arch and of its neighbours; all three of a
  // path that closes.
  for (const auto& [assignments, cusps] : std::vector<std::pair<Assignments, std::size_t>>{
           {{"r=1", "R=1e12", "d=1"}, 2},
           {{"r=1", "R=1e12", "d=1", "phi=4000"}, 4},
           {{"how=circle_on_line", "phi_rad=1e12"}, 4},
           {{"how=circle_inside_circle", "r=1", "d=1", "R=1.000000000001"}, 4},
           {{"phi=1e9"}, 3}}) {
    CAPTURE(assignments);
    const DrawnSheet drawn = roulette().draw("path", assignments);
    CHECK(path_misses_M_by(drawn) < 0.02);  // mm
    const auto& marks = drawn.sheet.figure.marks;
    const auto crosses = std::count_if(marks.begin(), marks.end(), [](const drawings::Mark& mark) {
      return std::holds_alternative<drawings::Cross>(mark);
    });
    CHECK(static_cast<std::size_t>(crosses) == cusps + 1);  // P0 has one too
    CHECK(path_misses_M_by(roulette().draw("instant", assignments)) < 0.02);
  }
}

TEST_CASE("roulette: no vector hides another", "[roulette][sheets]") {
  // The fourth: M on the inflection circle, a_M in the sense of v_M. The last: on a diameter.
  for (const Assignments& assignments : std::vector<Assignments>{{},
                                                                 {"alpha=5"},
                                                                 {"how=circle_on_line", "phi=180"},
                                                                 {"how=circle_on_line", "d=0.075", "phi=60"},
                                                                 {"how=line_on_circle", "d=0"},
                                                                 {"how=circle_inside_circle"},
                                                                 {"how=circle_inside_circle", "R=0.3", "phi=60"}}) {
    const auto all = arrows(roulette().draw("instant", assignments));
    CAPTURE(assignments);
    CHECK(all.size() >= 2);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(one_hides_the_other(all[i], all[j]));
  }
}

TEST_CASE("roulette: the parts of the acceleration end at its tip, each step where it happens",
          "[roulette][sheets]") {
  // Three steps at a cusp, five elsewhere: each has its number on the figure.
  CHECK(roulette().draw("instant", {"phi=480"}).sheet.figure.steps.size() == 3);
  const DrawnSheet drawn = roulette().draw("instant", {"alpha=3"});
  CHECK(drawn.sheet.figure.steps.size() == 5);
  const auto meet = [](drawings::Point p, drawings::Point q) { return std::hypot(p.x - q.x, p.y - q.y) < 1e-9; };
  const auto step = [&](int number) {
    for (const drawings::StepNumber& s : drawn.sheet.figure.steps)
      if (s.number == number) return s.at;
    throw std::logic_error("no such step");
  };
  CHECK(meet(step(2), arrow(drawn, "v_M").to));
  // On the vector, not at its tip: that may be J, where the first step is.
  const drawings::Arrow a_M = arrow(drawn, "a_M");
  CHECK(meet(step(4), {(a_M.from.x + a_M.to.x) / 2, (a_M.from.y + a_M.to.y) / 2}));
  const auto all = arrows(drawn);
  CHECK(std::any_of(all.begin(), all.end(), [&](const drawings::Arrow& part) {
    return meet(part.from, arrow(drawn, "a_M_n").to) && meet(part.to, arrow(drawn, "a_M").to);
  }));
}

TEST_CASE("roulette: the sheet says how the acceleration comes about", "[roulette][sheets]") {
  CHECK_THAT(words_of(roulette().draw("instant", {})), Contains("points at $J$") && Contains("M'J$"));
  CHECK_THAT(words_of(roulette().draw("instant", {"alpha=3"})), Contains("|$α$|·$P_{0}M$") && !Contains("points at"));
  CHECK_THAT(words_of(roulette().draw("instant", {"omega=0", "alpha=3"}, {.language = Language::italian})),
             Contains("$ω = 0$: $a_{M}$ = |$α$|·$P_{0}M$"));
}

TEST_CASE("roulette: the ray to a centre off the sheet says so", "[roulette][sheets]") {
  const Assignments far{"how=circle_inside_circle"};
  CHECK(is_written(roulette().draw("instant", far), "to $Ω$"));
  CHECK(is_written(roulette().draw("instant", far, {.language = Language::italian}), "verso $Ω$"));
  CHECK_FALSE(is_written(roulette().draw("instant", {}), "to $Ω$"));
}

TEST_CASE("roulette: the osculating circle lies below the path", "[roulette][sheets]") {
  const DrawnSheet drawn = roulette().draw("instant", {});
  const auto& marks = drawn.sheet.figure.marks;
  const auto place = [&](const std::string& name) {
    return std::find_if(marks.begin(), marks.end(), [&](const drawings::Mark& mark) {
      const auto* line = std::get_if<drawings::Line>(&mark);
      return line && line->name == name;
    });
  };
  REQUIRE(place("osculating_circle") != marks.end());
  CHECK(place("osculating_circle") < place("path"));
  CHECK(std::get<drawings::Line>(*place("inflection_circle")).meaning == drawings::Meaning::locus);  // solid
}

TEST_CASE("roulette: where a line rolls the title says so", "[roulette][sheets]") {
  CHECK_THAT(roulette().draw("path", {"how=line_on_circle"}).sheet.title, Contains("rolling line"));
  CHECK_THAT(roulette().draw("path", {}).sheet.title, Contains("rolling circle"));
}

TEST_CASE("roulette: an inflection circle many times the bodies runs off the sheet, which says so",
          "[roulette][sheets]") {
  const DrawnSheet drawn = roulette().draw("instant", {"how=circle_inside_circle", "r=0.4"});
  CHECK_THAT(words_of(drawn), Contains("Off the sheet: $J$, $M'$, part of the inflection circle"));
  CHECK(drawn.sheet.title_block.scales.front() == "1 : 10");
  CHECK_THAT(words_of(roulette().draw("instant", {"how=circle_inside_circle"})), Contains("Off the sheet: $Ω$"));
  CHECK_THAT(words_of(roulette().draw("instant", {})), Contains("Off the sheet: part of $p$."));
  CHECK(is_written(roulette().draw("instant", {}), "$p$"));
}

TEST_CASE("roulette: the points of M's arch have the numbers of their contacts", "[roulette][sheets]") {
  const auto times = [](const Assignments& assignments, const std::string& number) {
    const auto& labels = roulette().draw("path", assignments).sheet.figure.labels;
    return std::count_if(labels.begin(), labels.end(), [&](const auto& label) { return label.text == number; });
  };
  for (int n = 1; n < 12; ++n) {
    CAPTURE(n);
    CHECK(times({}, std::to_string(n)) == 2);
    CHECK(times({"how=circle_on_line"}, std::to_string(n)) == 2);
    CHECK(times({"r=0.31", "R=0.19", "d=0.5", "phi=1000"}, std::to_string(n)) == 0);  // more than once round p
  }
  CHECK_THAT(words_of(roulette().draw("path", {})), Contains("the number of their contact on $p$"));
  CHECK_THAT(words_of(roulette().draw("path", {"how=line_on_circle"})), !Contains("the number of their contact"));
}
