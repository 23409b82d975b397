// Sheets as pages for a browser, and sheets in their steps.
#include <poppler-document.h>
#include <poppler-page.h>
#include <poppler-toc.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "drawings/files/xml.h"
#include "drawings/page.h"
#include "exercises/kit/proof/solution.h"
#include "tests/exercises/run.h"
#include "tests/exercises/web_page.h"
#include "tests/support/catch.h"

using namespace epure;
namespace fs = std::filesystem;

namespace {

using Typed = std::vector<std::string>;

std::string drawn(Typed words) {
  words.insert(words.begin(), "draw");
  words.insert(words.end(), {"-o", "-"});
  const Ran ran = run_on_all(words);
  CAPTURE(words, ran.err);
  REQUIRE(ran.exit == 0);
  return ran.out;
}

bool is_off_the_sheet(const std::string& line) {
  return line.ends_with("(Off the sheet.)") || line.ends_with("(Fuori del foglio.)");
}

}  // namespace

TEST_CASE("every sheet is a page of its own in both languages, and each of its steps draws something") {
  for (const std::string language : {"en", "it"}) {
    const Scratch scratch;
    REQUIRE(run_on_all({"draw", "all", "--format", "html", "--lang", language, "--out", "."}).exit == 0);
    int with_steps = 0, told = 0;
    for (const std::string& file : scratch.files()) {
      CAPTURE(language, file);
      const WebPage page(contents(file));
      demand_clear_ids(page);
      demand_self_contained(page);
      CHECK(page.xml.child("html").attribute("lang").value() == language);
      CHECK(page.count("//figure/*") >= 1);
      CHECK(page.count("//script") == 1);
      const std::map<int, int> marks = page.marks_of_steps();
      const int steps = page.steps();
      CHECK((marks.empty() || marks.rbegin()->first <= steps));
      CHECK(page.count("//input[@type='range']") == (steps > 0 ? 1 : 0));
      if (steps > 0) {
        CHECK(page.xml.select_node("//input").node().attribute("max").as_int() == steps + 1);
        const auto button = [&](const char* name) {
          return text_of(page.xml.select_node(("//button[@class='" + std::string(name) + "']").c_str()).node());
        };
        CHECK(button("previous") == (language == "en" ? "Previous" : "Indietro"));
        CHECK(button("next") == (language == "en" ? "Next" : "Avanti"));
      }
      int number = 0;
      for (const pugi::xpath_node line : page.xml.select_nodes("//ol/li")) {
        const int step = number++;
        if (step == 0 || step > steps) continue;
        // Its words in the column are a circle, a number and lines; the sheet shows its number and a mark besides.
        const auto found = marks.find(step);
        const int least = is_off_the_sheet(text_of(line.node())) ? 1 : 4;
        CAPTURE(step, text_of(line.node()));
        CHECK((found != marks.end() && found->second >= least));
      }
      with_steps += steps > 0;
      page.each([&](const pugi::xml_node& node) { told += node.attribute("tabindex") ? 1 : 0; });
    }
    CHECK(with_steps > 80);
    CHECK(told > 400);
  }
}

TEST_CASE("a mark tells the quantity that it shows") {
  const std::string page = drawn({"slider-crank-velocity/polar-diagram", "--format", "html"});
  CHECK(page.find("id=\"slider-crank-velocity-polar-diagram-v_B\" class=\"step-3\" tabindex=\"0\" role=\"img\" "
                  "aria-label=\"v_B = 5.103 m/s, speed of B\"") != std::string::npos);
  const std::string italian = drawn({"slider-crank-velocity/polar-diagram", "--format", "html", "--lang", "it"});
  CHECK(italian.find("aria-label=\"v_B = 5,103 m/s, velocità di B\"") != std::string::npos);
  // A point by its coordinates, which the mark itself has no name for.
  const std::string poles = drawn({"four-bar/poles", "--format", "html"});
  CHECK(poles.find("aria-label=\"P31 = (−0.1789; −0.1033) m\"") != std::string::npos);
}

TEST_CASE("a mark comes with the step that constructs it") {
  const auto comes = [](const std::string& page, const std::string& id, int step) {
    CAPTURE(id, step);
    const auto at = page.find("id=\"" + id + "\"");
    REQUIRE(at != std::string::npos);
    const std::string mark = page.substr(at, page.find('>', at) - at), in_step = "class=\"step-";
    if (step == 0)
      CHECK(mark.find(in_step) == std::string::npos);
    else
      CHECK(mark.find(in_step + std::to_string(step) + "\"") != std::string::npos);
  };
  const std::string poles = drawn({"four-bar/poles", "--format", "html"});
  comes(poles, "four-bar-poles-P31", 3);  // where the second of its lines crosses the first
  comes(poles, "four-bar-poles-v_A", 4);
  const std::string plan = drawn({"truss/plan", "--format", "html"});
  comes(plan, "truss-plan-bar_1", 0);  // pulled: thin as all are at first
  const std::string pressed = drawn({"truss/plan", "--format", "html", "--set", "P=-1000N"});
  comes(pressed, "truss-plan-bar_1", 2);
  comes(plan, "truss-plan-N_1", 2);
  comes(plan, "truss-plan-N_2", 2);
  const std::string polodes = drawn({"slider-crank-velocity/polodes", "--format", "html"});
  comes(polodes, "slider-crank-velocity-polodes-fixed_polode", 3);
  comes(polodes, "slider-crank-velocity-polodes-moving_polode", 3);
  comes(drawn({"slider-crank-velocity/coupler-curve", "--format", "html"}),
        "slider-crank-velocity-coupler-curve-path_of_C", 4);
}

// What is found in a step is not there before, and steps are numbered so that each has what it begins with.
TEST_CASE("what a step finds comes with it") {
  const auto drawn_in = [](const std::string& id, const std::string& sheet, const auto& is_sought) {
    const Exercise& exercise = find_exercise(catalogue(), id);
    const drawings::Figure figure =
        exercise.draw(sheet, exercise.solution(Givens(exercise.about().givens)), {}).sheet.figure;
    std::map<int, int> marks;  // by step
    for (std::size_t i = 0; i < figure.marks.size(); ++i)
      if (is_sought(figure.marks[i])) ++marks[figure.known_of_marks.at(i).number.value_or(-1)];
    return marks;
  };
  const auto is_dashed = [](const drawings::Mark& mark) {
    const auto* line = std::get_if<drawings::Line>(&mark);
    return line && line->meaning == drawings::Meaning::alternative;
  };
  CHECK(drawn_in("four-bar", "dead-centres", is_dashed) ==
        std::map<int, int>{{2, 1}, {3, 4}});  // rocker; crank, plate
  CHECK(drawn_in("four-bar-analytic", "configurations", is_dashed) == std::map<int, int>{{3, 2}});
  const auto is_force = [](const drawings::Mark& mark) {
    const auto* arrow = std::get_if<drawings::Arrow>(&mark);
    return arrow && arrow->meaning == drawings::Meaning::force;
  };
  CHECK(drawn_in("pin-in-slot", "power-balance", is_force) == std::map<int, int>{{1, 4}, {2, 4}});
  CHECK(drawn_in("frame-deflection", "shares", is_force) == std::map<int, int>{{1, 6}, {2, 6}});
  const auto is_reaction = [](const drawings::Mark& mark) {
    const auto* arrow = std::get_if<drawings::Arrow>(&mark);
    return arrow && arrow->name.starts_with("R_");
  };
  CHECK(drawn_in("truss", "reactions", is_reaction) == std::map<int, int>{{4, 2}});
}

TEST_CASE("a panel is not there before its steps, and results come with the last") {
  int later_panels = 0, with_results = 0;
  for (const Listed& exercise : catalogue()) {
    const Solution solution = exercise->solution(Givens(exercise->about().givens));
    for (const SheetSpec& spec : exercise->about().sheets) {
      CAPTURE(exercise.id(), spec.name);
      const drawings::Sheet sheet = exercise->draw(spec.name, solution, {}).sheet;
      for (const drawings::KnownStep& known : sheet.figure.known_of_marks) later_panels += known.earliest > 1;
      const drawings::Page page = drawings::compose_in_steps(sheet);
      const int last = static_cast<int>(page.steps.size());
      for (const drawings::Primitive& primitive : page.primitives)
        if (const auto* text = std::get_if<drawings::PlacedText>(&primitive); text && text->text == "Results") {
          CHECK(text->step == last);
          ++with_results;
        }
    }
  }
  CHECK(later_panels > 100);
  CHECK(with_results > 60);
}

TEST_CASE("what a user types is text in the page, whatever it looks like") {
  const std::string hostile = "</title></script><script>alert(1)</script>\"'&amp;<img src=x> 5 $";
  CHECK(drawings::escaped_for_attribute("\"<&>'") == "&quot;&lt;&amp;&gt;'");
  const Scratch scratch;
  write("students.csv", "number,name,r\n7,\"<b onload=x>\"\"&\",0.2\n");
  REQUIRE(run_on_all({"draw", "slider-crank-velocity/poles", "--format", "html", "--title", hostile, "--givens",
                      "students.csv", "--out", "."})
              .exit == 0);
  for (const std::string& file : scratch.files()) {
    if (!file.ends_with(".html")) continue;
    const WebPage page(contents(file));
    demand_self_contained(page);
    CHECK(page.count("//script") == 1);
    CHECK(page.count("//img") == 0);
    CHECK(page.count("//b") == 0);
    CHECK(text_of(page.xml.select_node("//head/title").node()).starts_with(hostile));
    CHECK(text_of(page.xml.select_node("//h1").node()).starts_with(hostile));
  }
}

TEST_CASE("a page prints on paper of its sheet's size, at true scale") {
  const std::string a4 = drawn({"slider-crank-velocity/poles", "--format", "html"}),
                    a3 = drawn({"slider-crank-velocity/poles", "--format", "html", "--paper", "a3"}),
                    bare = drawn({"slider-crank-velocity/poles", "--format", "html", "--bare"});
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  CHECK(has(a4, "@page { size: 297mm 210mm; margin: 0; }"));
  CHECK(has(a4, ".sheet svg { width: 297.00000mm; height: 210.00000mm; }"));
  CHECK(has(a4, ".sheet [aria-label]:focus-visible { filter: none; }"));  // the mark that a key has reached
  CHECK(has(a3, "@page { size: 420mm 297mm; margin: 0; }"));
  CHECK(has(bare, "@page { size: A4 landscape; margin: 10mm; }"));
  CHECK(has(drawn({"gear-pair/wheels", "--format", "html", "--bare", "--paper", "a3"}),  // too high for A4
            "@page { size: A3 landscape; margin: 10mm; }"));
  // With a ground of its own it keeps it, light and dark.
  CHECK(has(a4, "prefers-color-scheme: dark"));
  CHECK_FALSE(has(drawn({"slider-crank-velocity/poles", "--format", "html", "--background", "white"}),
                  "prefers-color-scheme: dark"));
}

TEST_CASE("a PDF in steps has a page for each, and the last is the sheet") {
  for (const std::string sheet : {"slider-crank-velocity/polar-diagram", "four-bar/circles"}) {
    const auto pages = [](const std::string& pdf) {
      return std::unique_ptr<poppler::document>(
          poppler::document::load_from_raw_data(pdf.data(), static_cast<int>(pdf.size())));
    };
    const std::string in_steps = drawn({sheet, "--format", "pdf", "--steps"}),
                      whole = drawn({sheet, "--format", "pdf"});
    const auto steps = pages(in_steps), alone = pages(whole);
    const auto text = [](const poppler::document& of, int page) {
      const auto utf8 = std::unique_ptr<poppler::page>(of.create_page(page))->text().to_utf8();
      return std::string(utf8.begin(), utf8.end());
    };
    REQUIRE(steps->pages() == 5);
    const std::unique_ptr<poppler::toc> toc(steps->create_toc());
    REQUIRE(toc);
    REQUIRE(toc->root()->children().size() == 1);
    const std::vector<poppler::toc_item*> bookmarks = toc->root()->children().front()->children();
    REQUIRE(bookmarks.size() == 5);
    const auto fourth = bookmarks[3]->title().to_utf8();
    CHECK(std::string(fourth.begin(), fourth.end()).starts_with("4. "));
    CHECK(text(*steps, 4) == text(*alone, 0));
    CHECK(text(*steps, 0).size() < text(*steps, 1).size());
    for (int i = 0; i < 5; ++i)
      CHECK(std::unique_ptr<poppler::page>(steps->create_page(i))->page_rect().width() ==
            std::unique_ptr<poppler::page>(alone->create_page(0))->page_rect().width());
  }
}

TEST_CASE("an SVG in steps is the same drawing with their classes") {
  const std::string plain = drawn({"four-bar/velocity-diagram", "--format", "svg"}),
                    staged = drawn({"four-bar/velocity-diagram", "--format", "svg", "--steps"});
  CHECK(plain.find("class=") == std::string::npos);
  for (int step = 1; step <= 4; ++step)
    CHECK(staged.find("class=\"step-" + std::to_string(step) + "\"") != std::string::npos);
  CHECK(staged.find("class=\"step-5\"") == std::string::npos);
  CHECK(staged.find("aria-label") == std::string::npos);
  CHECK(staged.find("role=\"img\"") != std::string::npos);
}

TEST_CASE("steps where there can be none are refused, and nothing is written") {
  for (const char* format : {"png", "eps", "pdf+tex", "csv", "svg,png"}) {
    const Scratch scratch;
    for (const char* language : {"en", "it"}) {
      const Ran ran = run_on_all({"draw", "four-bar", "--steps", "--format", format, "--lang", language});
      CAPTURE(format, ran.err);
      CHECK(ran.exit == 2);
      CHECK(ran.err.find("--steps") != std::string::npos);
      CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
    }
    CHECK(scratch.files().empty());
  }
  CHECK(run_on_all({"draw", "four-bar", "--steps", "--blank", "--format", "pdf", "-o", "-"}).exit == 2);
  // A sheet to be solved is a page without steps.
  CHECK(WebPage(drawn({"four-bar/poles", "--blank", "--format", "html"})).steps() == 0);
}

TEST_CASE("a page that cannot be written leaves no file") {
  const Scratch scratch;
  CHECK(run_on_all({"draw", "four-bar/poles", "-o", "/dev/full", "--format", "html"}).exit == 3);
  write("file", "");
  CHECK(run_on_all({"draw", "four-bar/poles", "--format", "html", "--out", "file/in"}).exit == 3);
  write("old.html", "old");
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const rlimit small{10000, before.rlim_max};
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  const int exit = run_on_all({"draw", "four-bar/poles", "-o", "old.html"}).exit;
  REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
  CHECK(exit == 3);
  CHECK(scratch.files() == std::vector<std::string>{"file", "old.html"});
  CHECK(contents("old.html") == "old");
}

TEST_CASE("the figures of a report share what is the same, and no id stands twice") {
  const Scratch scratch;
  for (const char* id : {"four-bar", "gear-pair", "point-mass"}) {
    CAPTURE(id);
    REQUIRE(run_on_all({"report", id, "-o", "report.html"}).exit <= 1);
    demand_clear_ids(WebPage(contents("report.html")));
  }
}

TEST_CASE("in a browser the slider, the keys and the marks do what they say") {
  if (!is_at_hand("chromium")) {
    WARN("no chromium: the page was not driven");
    return;
  }
  const Scratch scratch;
  const std::string html = drawn({"slider-crank-velocity/polar-diagram", "--format", "html"});
  const std::string seen = driven(scratch, html, R"(
    const seen = [], slider = document.querySelector('.slider');
    const later = () => document.querySelectorAll('.later').length, now = () => document.querySelectorAll('.now').length;
    const state = name => seen.push(name + ':' + slider.value + ':' + (later() > 0) + ':' + (now() > 0) + ':' +
                                    document.querySelector('.words').textContent);
    const press = key => document.dispatchEvent(new KeyboardEvent('keydown', { key: key }));
    state('first');
    document.querySelector('.previous').click(); state('previous');
    press('Home'); state('home');
    press('ArrowRight'); state('right');
    slider.value = 3; slider.dispatchEvent(new Event('input')); state('slid');
    const visible = name => getComputedStyle(document.querySelector('#slider-crank-velocity-polar-diagram-' + name)).visibility;
    seen.push('v_B:' + visible('v_B') + ' v_C:' + visible('v_C'));
    const mark = document.querySelector('#slider-crank-velocity-polar-diagram-v_B');
    mark.focus(); seen.push('focus:' + (document.activeElement === mark));
    mark.dispatchEvent(new Event('focus'));  // a window that is not shown has none
    seen.push('tip:' + document.querySelector('.tip').textContent + document.querySelector('.tip').hidden);
    press('Escape'); seen.push('gone:' + document.querySelector('.tip').hidden);
    press('End'); press('ArrowRight'); state('end');
    document.body.innerHTML = '<pre>' + seen.join('\n') + '\n</pre>';
  )");
  CAPTURE(seen);
  const auto says = [&](const char* line) { return seen.find(line) != std::string::npos; };
  CHECK(says("first:6:false:false:The whole sheet."));
  CHECK(says("previous:5:false:true:Step 5/5. "));
  CHECK(says("home:0:true:false:What is given."));
  CHECK(says("right:1:true:true:Step 1/5. From"));
  CHECK(says("slid:3:true:true:Step 3/5. Through"));
  CHECK(says("v_B:visible v_C:hidden"));
  CHECK(says("tip:v_B = 5.103&nbsp;m/s, speed of Bfalse"));
  CHECK(says("focus:true"));
  CHECK(says("gone:true"));
  CHECK(says("end:6:false:false:The whole sheet."));

  const drawings::Point paper = paper_of_print(scratch, html);
  CHECK(std::abs(paper.x - 297) < 0.4);
  CHECK(std::abs(paper.y - 210) < 0.4);
}

TEST_CASE("on a phone pages are no wider than the screen, and a tap tells a value until the next") {
  const std::string sheet = drawn({"slider-crank-velocity/polar-diagram", "--format", "html"});
  CHECK(sheet.find("@media (pointer: coarse)") != std::string::npos);
  if (!is_at_hand("chromium")) {
    WARN("no chromium: the page was not driven");
    return;
  }
  const Scratch scratch;
  const std::string told = driven(scratch, sheet, R"(
    const wide = document.documentElement.scrollWidth - innerWidth, screen = innerWidth;
    const mark = document.querySelector('#slider-crank-velocity-polar-diagram-v_B'), tip = document.querySelector('.tip');
    const tap = where => ['pointerdown', 'pointerup', 'pointerleave', 'click'].forEach(kind =>
      where.dispatchEvent(new PointerEvent(kind, { bubbles: kind !== 'pointerleave', pointerType: 'touch', clientX: 50, clientY: 400 })));
    tap(mark);
    const first = tip.hidden;
    tap(document.querySelector('h1'));
    document.body.innerHTML = '<pre>screen ' + screen + ' wide ' + (wide > 0) + ' told ' + !first + ' gone ' + tip.hidden + '</pre>';
  )",
                                  "--window-size=500,900");
  CAPTURE(told);
  CHECK(told.find("screen 500 wide false told true gone true") != std::string::npos);
  const Ran sweep =
      run_on_all({"sweep", "four-bar", "--over", "phi=0..360/7", "--quantity", "v_B", "--format", "html", "-o", "-"});
  REQUIRE(sweep.exit == 0);
  const std::string seen = driven(scratch, sweep.out, R"(
    const wide = document.documentElement.scrollWidth > innerWidth;
    document.body.innerHTML = '<pre>wide ' + wide + '</pre>';
  )",
                                  "--window-size=500,900");
  CHECK(seen.find("wide false") != std::string::npos);
}
