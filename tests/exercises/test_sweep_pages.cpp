// Sweeps as pages for a browser, on which the mechanism moves.
#include <cmath>
#include <sstream>

#include "tests/exercises/run.h"
#include "tests/exercises/web_page.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

using Typed = std::vector<std::string>;

const Typed turn{"sweep", "slider-crank-velocity", "--over", "phi=0..360/13", "--quantity", "v_B,P0_x"};

std::string page_of(Typed words, int exit = 0) {
  words.insert(words.end(), {"--format", "html"});
  const Ran ran = run_on_all(words);
  CAPTURE(words, ran.err);
  REQUIRE(ran.exit == exit);
  return ran.out;
}

std::vector<pugi::xml_node> nodes(const WebPage& page, const std::string& path) {
  std::vector<pugi::xml_node> all;
  for (const pugi::xpath_node each : page.xml.select_nodes(path.c_str())) all.push_back(each.node());
  return all;
}

std::vector<pugi::xml_node> rows_of(const WebPage& page) { return nodes(page, "//details//tbody/tr"); }

// Of the CSV of the same sweep, without its header.
std::vector<std::vector<std::string>> csv_of(const Typed& words) {
  std::vector<std::vector<std::string>> table;
  std::istringstream lines(run_on_all(words).out);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    table.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) table.back().push_back(cell);
  }
  return table;
}

std::string with_true_minus_sign(const std::string& number) {
  return std::regex_replace(number, std::regex("^-"), "−");
}

// Where a path begins, in mm: an SVG counts in 1/256 pt.
std::pair<double, double> beginning(const std::string& d) {
  std::smatch found;
  REQUIRE(std::regex_search(d, found, std::regex("^M(-?[0-9]+) ?(-?[0-9]+)")));
  constexpr double mm = 25.4 / 72 / 256;
  return {std::stod(found[1]) * mm, std::stod(found[2]) * mm};
}

}  // namespace

TEST_CASE("a sweep's page has every position with its picture and the values of its CSV") {
  const WebPage page(page_of(turn));
  demand_clear_ids(page);
  demand_self_contained(page);
  const auto rows = rows_of(page);
  const auto csv = csv_of(turn);
  REQUIRE(rows.size() == 13);
  REQUIRE(csv.size() == 13);
  CHECK(nodes(page, "//div[contains(@class,'position')]/svg").size() == 13);
  CHECK(nodes(page, "//div[@class='charts']/svg").size() == 1);
  CHECK(page.xml.select_node("//input").node().attribute("max").as_int() == 12);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CAPTURE(i);
    CHECK(rows[i].attribute("data-name").value() == "φ = " + csv[i][0] + "°");
    const auto cells = rows[i].select_nodes("td[@class='value']");
    REQUIRE(cells.size() == 2);
    std::size_t column = 1;
    for (const pugi::xpath_node cell : cells) {
      const std::string told = text_of(cell.node()), value = csv[i][column], lower = csv[i][column + 1],
                        upper = csv[i][column + 2], reason = csv[i][column + 3];
      CAPTURE(told);
      if (!value.empty() && value.find('e') == std::string::npos) {
        CHECK(told.starts_with(with_true_minus_sign(value) + "\u00A0m"));
        if (lower == upper)
          CHECK(told.ends_with("exactly"));
        else
          CHECK(told.ends_with(with_true_minus_sign(lower) + " … " + with_true_minus_sign(upper)));
      }
      CHECK(value.empty() == !reason.empty());
      column += 4;
    }
  }
}

TEST_CASE("before its slider is moved a sweep's page tells the values of the first position") {
  const WebPage page(
      page_of({"sweep", "slider-crank-velocity", "--over", "phi=10..100/4", "--quantity", "v_B,P0_x"}));
  const auto told = nodes(page, "//section[@class='values']//td[@class='value']"),
             first = nodes(page, "//details//tbody/tr[1]/td[@class='value']");
  REQUIRE(told.size() == 2);
  REQUIRE(first.size() == 2);
  for (std::size_t i = 0; i < told.size(); ++i) CHECK(text_of(told[i]) == text_of(first[i]));
}

TEST_CASE("at every position the vector of a swept quantity has its length at the one scale") {
  const Typed words{"sweep", "slider-crank-velocity", "--over", "phi=10..350/18", "--quantity", "v_B"};
  const WebPage page(page_of(words));
  const auto csv = csv_of(words);
  const std::string bars = text_of(page.xml.select_node("//div[@class='scales']").node());
  std::smatch caption;
  REQUIRE(std::regex_search(bars, caption, std::regex("1 cm ≙ ([0-9.]+) m/s")));
  const double per_mm = std::stod(caption[1]) / 10;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    // Its shaft begins at B, and its head at its tip.
    const std::string id = "//path[@id='slider-crank-velocity-position-" + std::to_string(i + 1) + "-v_B";
    const pugi::xml_node shaft = page.xml.select_node((id + "']").c_str()).node(),
                         head = page.xml.select_node((id + "_head']").c_str()).node();
    CAPTURE(i);
    REQUIRE((shaft && head));
    const auto from = beginning(shaft.attribute("d").value()), to = beginning(head.attribute("d").value());
    CHECK(std::hypot(to.first - from.first, to.second - from.second) * per_mm ==
          Approx(std::abs(std::stod(csv[i][1]))).margin(0.002 * per_mm));
  }
  // All pictures show the same part of the plane.
  std::set<std::string> seen;
  for (const pugi::xml_node& svg : nodes(page, "//div[@class='pictures']//svg"))
    seen.insert(svg.attribute("viewBox").value());
  CHECK(seen.size() == 1);
}

TEST_CASE("where there is nothing, the page says why") {
  // A crank longer than its rod never closes in this position.
  const WebPage page(
      page_of({"sweep", "slider-crank-velocity", "--over", "r=0.2|5", "--quantity", "v_B", "--set", "phi=80deg"}));
  const auto rows = rows_of(page);
  REQUIRE(rows.size() == 2);
  CHECK(text_of(rows[0]).find("m/s") != std::string::npos);
  CHECK(rows[0].child("td").attribute("data-y"));
  CHECK_FALSE(rows[1].child("td").attribute("data-y"));
  const std::string reason = text_of(rows[1].child("td"));
  CHECK(reason.size() > 20);
  const auto pictures = nodes(page, "//div[contains(@class,'position')]");
  REQUIRE(pictures.size() == 2);
  CHECK(text_of(pictures[1]) == reason);
  CHECK_FALSE(pictures[1].child("svg"));
  // In Italian all of it.
  const WebPage italian(page_of({"sweep", "slider-crank-velocity", "--over", "r=0.2|5", "--quantity", "v_B", "--set",
                                 "phi=80deg", "--lang", "it"}));
  CHECK(text_of(rows_of(italian)[1].child("td")) != reason);
  CHECK(italian.xml.child("html").attribute("lang").value() == std::string("it"));
}

TEST_CASE("faults of gears stand beside the values") {
  const WebPage page(page_of({"sweep", "gear-pair", "--over", "z1=8..20/7", "--quantity", "contact_ratio"}));
  const auto faults = nodes(page, "//td[@class='faults']");
  REQUIRE(faults.size() == 7);
  CHECK(text_of(faults.front()).find("undercut") != std::string::npos);
  CHECK(text_of(faults.back()).empty());
  CHECK(text_of(page.xml.select_node("//p[@class='fault']").node()) == text_of(faults.front()));
}

TEST_CASE("several givens: each curve from its first point to its last") {
  const WebPage page(page_of(
      {"sweep", "slider-crank-velocity", "--over", "phi=0..90/3", "--over", "r=0.1|0.2", "--quantity", "v_B"}));
  const auto rows = rows_of(page);
  REQUIRE(rows.size() == 6);
  CHECK(rows[1].attribute("data-name").value() == std::string("φ = 45°, r = 0.1\u00A0m"));
  CHECK(rows[3].attribute("data-name").value() == std::string("φ = 0°, r = 0.2\u00A0m"));
  CHECK(rows[3].attribute("data-curve").as_int() == 1);
  CHECK(nodes(page, "//div[contains(@class,'position')]/svg/title")[4].child_value() ==
        std::string("φ = 45°, r = 0.2\u00A0m"));
}

TEST_CASE("a whole turn in steps of 5° is a page of less than a megabyte, the same each time") {
  const Typed words{"sweep", "slider-crank-velocity", "--over", "phi=0..360/73", "--quantity", "v_B,P0_x,omega_3"};
  const std::string page = page_of(words);
  CHECK(page.size() < 1'000'000);
  CHECK(page == page_of(words));
}

TEST_CASE("what no page can be made of is refused in a sentence, and nothing is written") {
  const Scratch scratch;
  const auto refused = [](Typed words, const std::string& part) {
    words.insert(words.begin(), "sweep");
    words.insert(words.end(), {"-o", "page.html"});
    std::set<std::string> sentences;
    for (const char* language : {"en", "it"}) {
      Typed all = words;
      all.insert(all.end(), {"--lang", language});
      const Ran ran = run_on_all(all);
      CAPTURE(all, ran.err);
      CHECK(ran.exit == 2);
      CHECK(ran.out.empty());
      CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
      if (language == std::string("en")) CHECK(ran.err.find(part) != std::string::npos);
      sentences.insert(ran.err);
    }
    CHECK(sentences.size() == 2);
  };
  const std::string id = "slider-crank-velocity", quantity = "--quantity=v_B";
  refused({id, "--over", "phi=0..360/722", quantity},
          "a page bears 721 positions, and the values of --over make 722");
  refused({id, "--over", "phi=0..360/20", quantity, "--part", "1/2"}, "--part");
  refused({id, "--over", "phi=0..360/20", quantity, "--csv", "excel"}, "--csv");
  refused({"four-bar-analytic", "--over", "branch=left|right", "--quantity=omega_4"}, "words for values");
  refused({id, "--over", "phi=0..360/20", "--over", "r=0.1..0.2/13", quantity}, "--format html would draw 13 curves");
  refused({id, "--over", "r=5|6", quantity, "--set", "phi=80deg"}, "no position of the sweep is possible");
  CHECK(scratch.files().empty());
}

// What no crank of this length has is found once for all, by whoever asks first: here by a sweep of one quantity. (Of
// this program the first that asks.)
TEST_CASE("a linkage without dead centres has such a page") {
  const Ran ran = run_on_all({"sweep", "four-bar", "--over", "phi=0..360/5", "--set", "A0A=0.3", "--quantity",
                              "omega_4", "--format", "html"});
  CAPTURE(ran.err);
  CHECK(ran.exit == 0);
}

TEST_CASE("every exercise has such a page, with or without a mechanism") {
  int with_mechanism = 0;
  for (const Listed& each : catalogue()) {
    const Description& about = each->about();
    const auto given = std::find_if(about.givens.begin(), about.givens.end(),
                                    [](const GivenSpec& one) { return one.choices.empty() && one.stated != "0"; });
    REQUIRE(given != about.givens.end());
    CAPTURE(about.id, given->symbol);
    const Ran ran =
        run_on_all({"sweep", about.id, "--over", given->symbol + "=" + given->stated + "|1.01" + given->unit,
                    "--quantity", about.quantities().front().name, "--format", "html"});
    CAPTURE(ran.err);
    CHECK(ran.exit == 0);
    if (ran.exit != 0) continue;
    const WebPage page(ran.out);
    demand_clear_ids(page);
    demand_self_contained(page);
    with_mechanism += !nodes(page, "//div[@class='pictures']").empty();
  }
  CHECK(with_mechanism > 10);
}

TEST_CASE("in a browser the mechanism moves with its curves") {
  if (!is_at_hand("chromium")) {
    WARN("no chromium: the page was not driven");
    return;
  }
  const Scratch scratch;
  const std::string html = page_of(turn);
  const std::string seen = driven(scratch, html, R"(
    const seen = [], slider = document.querySelector('.slider'), play = document.querySelector('.play');
    const marks = [...document.querySelectorAll('.mark')];
    const state = name => {
      const seen_now = [...document.querySelectorAll('.position')].map((each, i) => [getComputedStyle(each).visibility, i])
        .filter(each => each[0] === 'visible').map(each => each[1]).join('+');
      seen.push(name + ':' + slider.value + ':' + seen_now + ':' + document.querySelector('.name').textContent + ':' +
                document.querySelector('.values .value').textContent + ':' + slider.getAttribute('aria-valuetext') + ':' +
                marks.map(each => each.getAttribute('visibility')).join('+'));
    };
    const press = key => document.dispatchEvent(new KeyboardEvent('keydown', { key: key }));
    const at = () => Number(marks[0].getAttribute('cx'));
    state('first');
    const left = at();
    document.querySelector('.next').click(); state('next');
    press('End'); state('end');
    const right = at();
    press('ArrowRight'); state('beyond');
    press('ArrowLeft'); state('left');
    press('Home'); state('home');
    slider.value = 3; slider.dispatchEvent(new Event('input')); state('slid');
    seen.push('moved:' + (right > left) + ':' + (2 > Math.abs(at() - (left + (right - left) / 4))));
    const drawing = document.querySelector('.charts svg'), box = drawing.getBoundingClientRect();
    const x = box.left + right / drawing.viewBox.baseVal.width * box.width - 3;
    drawing.dispatchEvent(new PointerEvent('pointerdown', { clientX: x, clientY: box.top + 20, bubbles: true })); state('picked');
    const live = () => document.querySelector('.values').getAttribute('aria-live');
    press('Home'); press(' '); seen.push('plays:' + play.textContent + ':' + live());
    setTimeout(() => {
      seen.push('played:' + (Number(slider.value) > 0));
      play.click(); seen.push('paused:' + play.textContent + ':' + live());
      const kept = slider.value;
      setTimeout(() => {
        seen.push('stands:' + (slider.value === kept));
        seen.push('scales:' + [...document.querySelectorAll('.pictures svg')].every(svg =>
          svg.getBoundingClientRect().width === document.querySelector('.pictures svg').getBoundingClientRect().width));
        document.body.innerHTML = '<pre>' + seen.join('\n') + '\n</pre>';
      }, 2000);
    }, 3000);
  )",
                                  "--virtual-time-budget=20000");
  CAPTURE(seen);
  const auto says = [&](const char* line) { return seen.find(line) != std::string::npos; };
  CHECK(says("first:0:0:φ = 0°:0"));
  CHECK(says("next:1:1:φ = 30°:"));
  CHECK(says("end:12:12:φ = 360°:"));
  CHECK(says("beyond:12:12:φ = 360°:"));
  CHECK(says("left:11:11:φ = 330°:"));
  CHECK(says("home:0:0:φ = 0°:"));
  CHECK(says("slid:3:3:φ = 90°:"));
  CHECK(says(":φ = 90°:visible+hidden"));  // the pole is at infinity there
  CHECK(says("moved:true:true"));
  CHECK(says("picked:12:12:"));
  CHECK(says("plays:Pause:off"));
  CHECK(says("played:true"));
  CHECK(says("paused:Play:polite"));
  CHECK(says("stands:true"));
  CHECK(says("scales:true"));

  // Printed, the position is at true scale: the bar of its lengths is as long as it says.
  CHECK(std::abs(paper_of_print(scratch, html).x - 210) < 0.4);
}
