// Sweeps: how values are written, what each line holds, parts, files, charts. The triangle is small enough to know
// every number of it; of the real exercises `check` says what is true.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "exercises/cli/csv_reader.h"
#include "exercises/cli/in_order.h"
#include "exercises/cli/variation.h"
#include "exercises/kit/proof/agreement.h"
#include "exercises/kit/proof/asked.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

using Typed = std::vector<std::string>;
using Json = nlohmann::json;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Typed operator+(Typed words, const Typed& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const GivenSpec length{.symbol = "r", .meaning = {}, .unit = "m", .stated = "0.2"};
const GivenSpec any_length{.symbol = "e", .meaning = {}, .unit = "m", .stated = "0", .range = Range::any};
const GivenSpec angle{.symbol = "phi", .meaning = {}, .unit = "deg", .stated = "30", .range = Range::any};
const GivenSpec speed{.symbol = "n", .meaning = {}, .unit = "rpm", .stated = "360", .range = Range::any};
const GivenSpec pure{.symbol = "z", .meaning = {}, .unit = "1", .stated = "20"};
const GivenSpec side{.symbol = "branch",
                     .meaning = {},
                     .unit = "1",
                     .stated = "left",
                     .choices = {{"left", {"left", "sinistra"}}, {"right", {"right", "destra"}}}};

Typed values(const GivenSpec& given, const std::string& text) {
  const Variation of(given, text);
  Typed all;
  for (std::uint64_t i = 0; i < of.size(); ++i) all.push_back(of.text(i));
  return all;
}

void refused_values(const GivenSpec& given, const std::string& text, const std::string& part) {
  CAPTURE(text);
  try {
    const Variation of(given, text);
    FAIL("read as " << of.size() << " values");
  } catch (const WrongUsage& why) {
    CAPTURE(why.words().english);
    CHECK(why.words().english.starts_with(given.symbol));
    CHECK(contains(why.words().english, part));
    CHECK(why.words().italian != why.words().english);
  }
}

// Refused with one sentence that says `part`, on standard error alone.
void refused(const Typed& words, const std::string& part) {
  const Ran ran = run(words);
  CAPTURE(words, ran.err);
  CHECK(ran.exit == 2);
  CHECK(ran.out.empty());
  CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
  CHECK(contains(ran.err, part));
}

Typed lines(const std::string& text) {
  Typed all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    all.push_back(line);
  }
  return all;
}

// Of a line none of whose fields is in quotes.
Typed fields(const std::string& line) {
  Typed all{""};
  for (const char c : line)
    if (c == ',')
      all.emplace_back();
    else
      all.back() += c;
  return all;
}

}  // namespace

TEST_CASE("a count, a step and a list are told apart as the issue writes them") {
  const Variation turn(angle, "0deg..360deg/361");
  CHECK(turn.size() == 361);
  CHECK(turn.text(0) == "0");
  CHECK(turn.text(37) == "37");
  CHECK(turn.text(360) == "360");
  CHECK(turn.assignment(37) == "phi=37deg");
  CHECK(values(length, "0.18..0.22/0.01") == Typed{"0.18", "0.19", "0.2", "0.21", "0.22"});
  CHECK(values(speed, "300|360|400") == Typed{"300", "360", "400"});
  CHECK(values(side, "right|left") == Typed{"right", "left"});
}

TEST_CASE("a whole number alone counts, anything else is a step") {
  CHECK(values(pure, "10..20/5") == Typed{"10", "12.5", "15", "17.5", "20"});
  CHECK(values(pure, "10..20/5.0") == Typed{"10", "15", "20"});
  CHECK(values(pure, "10..20/5,0") == Typed{"10", "15", "20"});
  CHECK(values(pure, "10..20/5e0") == Typed{"10", "15", "20"});
  CHECK(values(angle, "10..20/5deg") == Typed{"10", "15", "20"});
  CHECK(values(pure, "0..1/4/2") == Typed{"0", "0.25"});
  CHECK(values(length, "1/3..2/3/3") == Typed{"1/3", "0.5", "2/3"});
  CHECK(values(any_length, "1..0/3") == Typed{"1", "0.5", "0"});
  CHECK(values(any_length, "-1..-0.5/0.25") == Typed{"-1", "-0.75", "-0.5"});
  CHECK(values(any_length, "-0.5..-1/0.25") == Typed{"-0.5", "-0.75", "-1"});
  CHECK(values(any_length, "−1 .. 1/3") == Typed{"-1", "0", "1"});  // with a true minus, and with blanks
  CHECK(Variation(any_length, "0..1/1000000000").size() == most_values);
  CHECK(Variation(any_length, "0..1/1000000000").text(most_values - 1) == "1");
}

TEST_CASE("a unit on one value is the unit of all that have none") {
  CHECK(Variation(length, "10..50cm/5").unit() == "cm");
  CHECK(Variation(length, "10cm..50/5").unit() == "cm");
  CHECK(values(length, "10cm..50/5") == Typed{"10", "20", "30", "40", "50"});
  CHECK(values(length, "0.1m..50cm/0.1m") == Typed{"10", "20", "30", "40", "50"});
  CHECK(values(length, "100mm|20cm|30") == Typed{"10", "20", "30"});
  CHECK(Variation(length, "0.1..0.5/5").unit() == "m");
  const Variation in_radians(speed, "30rad/s..40rad/s/0.5rad/s");
  CHECK(in_radians.size() == 21);
  CHECK(in_radians.unit() == "rad/s");
  CHECK(in_radians.assignment(1) == "n=30.5rad/s");
  CHECK(Variation(speed, "30rad/s..40/11").assignment(1) == "n=31rad/s");
  CHECK(Variation(speed, "1 rev/s..600rpm/2").text(0) == "60");
  const Variation a_minute(speed, "300 1/min..400/2");
  CHECK(a_minute.assignment(1) == "n=400 1/min");
  Givens givens({speed});
  givens.set(a_minute.assignment(1));
  CHECK(givens["n"] == 400);
}

TEST_CASE("what gives no values is refused in a sentence") {
  refused_values(length, "0.2", "one value");
  refused_values(length, "", "one value");
  refused_values(length, "0.1..0.2", "how many values");
  refused_values(length, "0.1..0.2/", "how many values");
  refused_values(length, "0.1..", "how many values");
  refused_values(length, "../3", "is empty");
  refused_values(length, "0.1../3", "is empty");
  refused_values(length, "0.1..x/3", "does not begin with a finite number");
  refused_values(length, "0...5/3", "three points");
  refused_values(length, "0.1s..0.2/3", "is a time where a length is asked");
  refused_values(length, "0.1..0.2/3s", "is a time where a length is asked");
  refused_values(length, "0.2m..20cm/3", "both ends are 20 cm");
  refused_values(length, "0.1..0.2/1", "/1.0");
  refused_values(length, "0.1..0.2/0", "fewer values than the two ends");
  refused_values(length, "0.1..0.2/-0.1", "must be positive");
  refused_values(length, "0.1..0.2/0.0", "must be positive");
  refused_values(length, "0.18..0.22/0.03",
                 "a step of 0.03 m does not lead from 0.18 to 0.22 m: 0.04 m would, or an end "
                 "at 0.21 m");
  refused_values(length, "0.22..0.18/0.015", "0.02 m would, or an end at 0.19 m");
  refused_values(length, "0.18..0.22/0.05", "0.04 m would");
  refused_values(length, "0.1..0.2/1000000001", "more than 1000000000 values");
  refused_values(length, "0.1..0.2/99999999999999999999999", "more than 1000000000 values");
  refused_values(length, "0.1..0.2/1e-12", "more than 1000000000 values");
  refused_values(angle, "0deg..6rad/7", "π");
  refused_values(angle, "0deg..6deg/1rad", "π");
  refused_values(speed, "300rpm|30rad/s", "π");
  refused_values(length, "0.2m|20cm", "stands in its list twice");
  refused_values(length, "0.2|", "is empty");
  refused_values(side, "left|left", "twice");
  refused_values(side, "left", "no list of words");
  refused_values(side, "left|up", "must be left or right");
}

TEST_CASE("a sweep of known numbers, to the byte") {
  const Ran ran = run({"sweep", "triangle", "--over", "a=0.3|0.6", "--over", "b=0.4|0.8", "--quantity", "c,c_y"});
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  CHECK(ran.out ==
        "a (m),b (m),c (m),c_lower (m),c_upper (m),c_reason,c_y (m),c_y_lower (m),c_y_upper (m),c_y_reason,faults\r\n"
        "0.3,0.4,0.5,0.5,0.5,,-0.4,-0.4,-0.4,,\r\n"
        "0.3,0.8,0.8544003745317531,0.8544003745317531,0.8544003745317531,,-0.8,-0.8,-0.8,,\r\n"
        "0.6,0.4,0.7211102550927978,0.7211102550927978,0.7211102550927978,,-0.4,-0.4,-0.4,,\r\n"
        "0.6,0.8,1,1,1,,-0.8,-0.8,-0.8,,\r\n");
  const Typed commas{"sweep",
                     "triangle",
                     "--over=a=0,3|0,6",
                     "--over=b=0,4|0,8",
                     "--quantity=c",
                     "--quantity=c₃₁",
                     "--format",
                     "CSV",
                     "--lang",
                     "it"};
  CHECK(run(commas).out == ran.out);  // letters stand for the name, and a decimal comma for the point
}

TEST_CASE("no two columns of a sweep have one name") {
  Triangle triangle;
  triangle.change_quantities([](auto& all) { all.push_back({"b", "$b$", "m", {"height", "altezza"}}); });
  triangle.spoil_values = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) values.push_back({"b", route, certain(0.4)});
  };
  const std::string header =
      lines(run_on(triangle, {"sweep", "triangle", "--over", "b=0.4..0.5/2", "--quantity", "b,c"}).out).front();
  const Typed heads = fields(header);
  CHECK(header.starts_with("b_given (m),b (m),b_lower (m)"));
  CHECK(std::set<std::string>(heads.begin(), heads.end()).size() == heads.size());
}

TEST_CASE("a sweep for a spreadsheet with decimal commas") {
  const Typed words{"sweep", "triangle", "--over", "a=0.1..0.3/4", "--quantity", "c_x", "--csv", "excel"};
  const Ran ran = run(words);
  CHECK(ran.exit == 0);
  // 1/6 as a spreadsheet would not take it for a day in June.
  CHECK(
      ran.out.starts_with("\xEF\xBB\xBF"
                          "a (m);c_x (m);c_x_lower (m);c_x_upper (m);c_x_reason;faults\r\n"
                          "0,1;0,1;0,1;0,1;;\r\n"
                          "0,16666666666666666;"));
  CHECK(run(words + Typed{"--part", "2/2"}).out.starts_with("0,2333"));
  CHECK(run(words + Typed{"--format", "json"}).err ==
        "epure: --csv says how CSV is written, and --format json is none; leave one of them out\n");
}

TEST_CASE("an angle that moves with its speed is told, with what keeps it") {
  const Typed words{"sweep", "slider-crank-velocity", "--over", "n=300|360", "--quantity", "omega_2"};
  const Ran ran = run_on_all(words);
  CHECK(ran.exit == 0);
  CHECK(ran.err == "epure: phi changes with n, as the instant t is what is stated; --set phi=30deg keeps it\n");
  CHECK(run_on_all(words + Typed{"--set", "phi=30deg"}).err.empty());
  CHECK(run_on_all(words + Typed{"--over", "phi=10|20"}).err.empty());
}

TEST_CASE("each line of JSON is an object by itself") {
  const Ran ran = run({"sweep", "triangle", "--over", "a=10cm..30cm/4", "--quantity", "c_x", "--format", "json"});
  CHECK(ran.exit == 0);
  const Typed all = lines(ran.out);
  REQUIRE(all.size() == 4);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Json row = Json::parse(all[i]);
    CHECK(row["schema"] == "epure.sweep/1");
    CHECK(row["id"] == "triangle");
    CHECK(row["row"] == i);
    CHECK(row["givens"]["a"]["unit"] == "cm");
    CHECK(row["quantities"]["c_x"]["unit"] == "m");
    CHECK(row["quantities"]["c_x"]["lower"] == row["quantities"]["c_x"]["value"]);
  }
  const Json second = Json::parse(all[1]);
  CHECK(second["givens"]["a"]["value"] == "50/3");
  CHECK(second["givens"]["a"]["number"] == 50.0 / 3);
  CHECK(second["quantities"]["c_x"]["value"] == 0.5 / 3);
}

TEST_CASE("what has no value has its reason, and the exit code says of the worst") {
  const Typed words{"sweep", "triangle", "--over", "a=0.3|0.6", "--quantity", "c,c_x"};
  Triangle spoilt;
  const auto spoil = [&](const geometry::Settled& ruler, const geometry::Settled& analytic) {
    spoilt.spoil_values = [=](std::vector<RouteValue>& all) {
      value_of(all, "c", "ruler") = ruler;
      value_of(all, "c", "analytic") = analytic;
    };
  };
  spoil(absent("it is \"gone\", all of it"), absent("elsewhere"));
  Ran ran = run_on(spoilt, words);
  CHECK(ran.exit == 0);
  CHECK(contains(ran.out, "\r\n0.3,,,,\"it is \"\"gone\"\", all of it\",0.3,0.3,0.3,,\r\n"));
  CHECK(Json::parse(lines(run_on(spoilt, words + Typed{"--format", "json"}).out)[0])["quantities"]["c"] ==
        Json{{"unit", "m"},
             {"value", nullptr},
             {"lower", nullptr},
             {"upper", nullptr},
             {"absent", "it is \"gone\", all of it"}});

  spoil(undecided("too near"), undecided("too near"));
  ran = run_on(spoilt, words);
  CHECK(ran.exit == 4);
  CHECK(contains(ran.out, "\r\n0.3,,,,undecided: too near,0.3,0.3,0.3,,\r\n"));
  CHECK(contains(ran.err, "in 2 positions something could not be decided"));

  spoil(undecided("too near"), certain(0.5));  // one route suffices
  ran = run_on(spoilt, words);
  CHECK(ran.exit == 0);
  CHECK(contains(ran.out, "\r\n0.3,0.5,0.5,0.5,,0.3,"));

  spoil(enclosed(0.4, 0.5, 0.6), undecided("too near"));
  ran = run_on(spoilt, words);
  CHECK(ran.exit == 4);
  CHECK(contains(ran.out,
                 "\r\n0.3,0.5,0.4,0.6,\"no more is known than that it lies in [0.4, 0.6] (one rung alone)\",0.3,"));

  spoil(certain(0.5), certain(0.75));
  ran = run_on(spoilt, words);
  CHECK(ran.exit == 1);
  CHECK(contains(ran.out,
                 "\r\n0.3,,,,\"the routes disagree: in [0.5, 0.5] by ruler, but in [0.75, 0.75] by analytic\",0.3,"));
  CHECK(contains(ran.err, "in 2 positions the routes disagree"));
  CHECK(run_on(spoilt, words + Typed{"--lang", "it"}).out == ran.out);  // for programs, in every language
  CHECK(contains(run_on(spoilt, words + Typed{"--lang", "it", "--csv", "excel"}).out,
                 "le vie discordano: in [0,5; 0,5] ("));

  spoil(certain(0.5), absent("gone"));
  CHECK(run_on(spoilt, words).exit == 1);

  spoilt.spoil_values = [](std::vector<RouteValue>& all) { all.clear(); };
  CHECK(run_on(spoilt, words).exit == 1);
}

TEST_CASE("impossible givens are the reason of every quantity of their line") {
  const Ran ran = run({"sweep", "triangle", "--over", "a=-1..1/3", "--quantity", "c_x,c_y"});
  CHECK(ran.exit == 0);
  CHECK(lines(ran.out).at(1) == "-1,,,,a = -1m: must be positive,,,,a = -1m: must be positive,");
  CHECK(lines(ran.out).at(2) == "0,,,,a = 0m: must be positive,,,,a = 0m: must be positive,");
  CHECK(lines(ran.out).at(3) == "1,1,1,1,,-0.4,-0.4,-0.4,,");
  const Ran none = run({"sweep", "triangle", "--over", "a=-2..-1/2", "--quantity", "c_x", "--format=json"});
  CHECK(none.exit == 2);
  CHECK(lines(none.out).size() == 2);
  CHECK(Json::parse(lines(none.out)[0])["quantities"]["c_x"]["impossible"] == "a = -2m: must be positive");
  CHECK(contains(none.err, "no position of the sweep is possible: a = -2m: must be positive"));
  // A part may lie where nothing is possible, while the whole is good.
  CHECK(run({"sweep", "triangle", "--over", "a=-2..2/5", "--quantity", "c_x", "--part", "1/5"}).exit == 0);
}

TEST_CASE("what cannot be swept is refused in a sentence") {
  const Typed over{"--over", "a=0.1..0.2/3"}, sought{"--quantity", "c"};
  refused(Typed{"sweep"} + over + sought, "sweep takes one exercise");
  refused(Typed{"sweep", "all"} + over + sought, "\"all\" is not one exercise");
  refused(Typed{"sweep", "triangle/sides"} + over + sought, "\"triangle/sides\" is not one exercise");
  refused(Typed{"sweep", "triangle", "triangle"} + over + sought, "sweep takes one exercise");
  refused(Typed{"sweep", "triangel"} + over + sought, "did you mean triangle?");
  const Typed here{"sweep", "triangle"};
  refused(here + sought, "say what to sweep over, such as --over a=FROM..TO/COUNT");
  refused(here + over, "say which quantities, such as --quantity c,c_x (epure list triangle shows all 5)");
  refused(here + over + Typed{"--quantity", "omgea"}, "there is no quantity \"omgea\"; did you mean omega?");
  refused(here + over + Typed{"--quantity", "c,"}, "there is no quantity \"\"");
  refused(here + sought + Typed{"--over", "x=0..1/3"}, "--over: \"x\" is no given here; known are: a, b");
  refused(here + sought + Typed{"--over", "a"}, "--over a: write a symbol, =");
  refused(here + sought + Typed{"--over", "=0..1/3"}, "write a symbol, =");
  refused(here + sought + Typed{"--over", "a=0s..1/3"}, "a: \"0s\" is a time where a length is asked");
  refused(here + sought + over + over, "a stands in --over twice");
  refused(here + sought + over + Typed{"--set", "a=1"}, "a is set, and --over varies it");
  refused(here + sought + over + Typed{"--set", "y=1"}, "\"y\" is no given here");
  refused(here + sought + Typed{"--over", "a=0..1/100000", "--over", "b=0..1/100000"},
          "more than 1000000000 positions together");
  refused(here + sought + over + Typed{"--format", "pdf"},
          "\"pdf\" is no format of a sweep; choose csv, json or html");
  refused(here + sought + over + Typed{"--format", "json", "-o", "x.csv"},
          "\"x.csv\" is not the ending of --format json");
  for (const std::string name : {"f.svg", "f.PDF", "f.md"})
    for (const Typed& format : {Typed{}, Typed{"--format", "csv"}})
      refused(here + sought + over + Typed{"-o", name} + format,
              "\"" + name + "\" ends as another format does; what is written here is csv, json or html");
  for (const std::string part : {"0/3", "4/3", "3", "1/0", "a/3", "1/x", "-1/3", "1/3/5", ""})
    refused(here + sought + over + Typed{"--part", part}, "is no part; write 3/40");
  refused(here + sought + over + Typed{"--chart", "x.png"}, "must end in .pdf or .svg");
  refused(here + sought + over + Typed{"--chart", "x.pdf", "--part", "1/2"}, "--chart draws a whole sweep");
  refused(here + sought + over + Typed{"--chart", "x.pdf", "--over", "b=1..2/13"}, "13 curves");
  refused(here + sought + over + Typed{"--lang", "fr"}, "is no language");
  const Ran two_ways = run_on_all(
      {"sweep", "slider-crank-velocity", "--over", "phi=0..90/3", "--set", "t=1/60s", "--quantity", "v_B"});
  CHECK(two_ways.exit == 2);
  CHECK(contains(two_ways.err, "phi and t are two ways to state one thing"));
}

TEST_CASE("faults of gears stand in a column of their own, as check tells them") {
  // Pointed teeth, interference with undercut, none; wheels that cannot be.
  const Typed words{"sweep", "gear-pair", "--over",     "x1=0|0.9|-0.3|9",
                    "--set", "z1=8",      "--quantity", "contact_ratio"};
  const Ran ran = run_on_all(words);
  CAPTURE(ran.err, ran.out);
  CHECK(ran.exit == 0);
  const Typed rows = lines(ran.out), objects = lines(run_on_all(words + Typed{"--format", "json"}).out);
  REQUIRE(rows.size() == 5);
  REQUIRE(objects.size() == 4);
  CHECK(rows[0].ends_with(",contact_ratio_reason,faults"));
  std::size_t told = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Json row = Json::parse(objects[i]);
    const std::string x1 = row["givens"]["x1"]["value"];
    CAPTURE(x1, rows[i + 1]);
    const Ran check = run_on_all({"check", "gear-pair", "--json", "--set", "z1=8", "--set", "x1=" + x1});
    if (check.exit == 2) {
      CHECK_FALSE(row.contains("faults"));
      CHECK(rows[i + 1].ends_with(","));
      continue;
    }
    const Json checked = Json::parse(check.out)["exercises"][0];
    Json sentences = Json::array();
    for (const Json& failure : checked["failures"]) sentences.push_back(failure);
    CHECK(row.value("faults", Json::array()) == sentences);
    for (const Json& each : sentences) {
      CHECK(contains(rows[i + 1], each.get<std::string>()));
      ++told;
    }
  }
  CHECK(told >= 2);
  const Ran italian = run_on_all(words + Typed{"--lang", "it", "--csv", "excel"});
  CHECK(contains(italian.out, "I denti della ruota 1"));
}

TEST_CASE("a fault that cannot be decided says so") {
  Triangle faulty;
  faulty.flaws_of_it = {{{"it may break", "può rompersi"}, true}, {{"it $creaks$", "cigola"}, false}};
  const Typed words{"sweep", "triangle", "--over", "a=0.1..0.2/2", "--quantity", "c_x"};
  const Ran ran = run_on(faulty, words);
  CHECK(ran.exit == 4);
  CHECK(contains(ran.err, "in 2 positions something could not be decided"));
  CHECK(lines(ran.out).at(1).ends_with(",undecided: it may break it creaks"));
  const Json row = Json::parse(lines(run_on(faulty, words + Typed{"--format", "json"}).out).at(0));
  CHECK(row["faults"] == Json{"undecided: it may break", "it creaks"});
  faulty.flaws_of_it.erase(faulty.flaws_of_it.begin());
  CHECK(run_on(faulty, words).exit == 0);
}

TEST_CASE("the parts one after the other are the whole") {
  const Typed words{"sweep", "triangle", "--over", "a=0.1..2/7", "--over", "b=0.1..2/6", "--quantity", "c,c_x"};
  for (const Typed& format : {Typed{}, Typed{"--format", "json"}}) {
    const std::string whole = run(words + format).out;
    CHECK(lines(whole).size() == (format.empty() ? 43 : 42));
    for (const std::size_t parts : {1, 2, 3, 5, 41, 42, 43, 100}) {
      std::string together;
      std::size_t most = 0, least = 1000;
      for (std::size_t k = 1; k <= parts; ++k) {
        const std::string part = run(words + format + Typed{"--part", fmt::format("{}/{}", k, parts)}).out;
        const std::size_t rows = lines(part).size() - (k == 1 && format.empty() ? 1 : 0);
        most = std::max(most, rows);
        least = std::min(least, rows);
        together += part;
      }
      CAPTURE(parts);
      CHECK(together == whole);
      CHECK(most - least <= 1);
    }
  }
}

TEST_CASE("a file appears when the sweep is done, and not otherwise") {
  const Scratch scratch;
  const Typed words{"sweep", "triangle", "--over", "a=0.1..0.3/3", "--quantity", "c"};
  const std::string shown = run(words).out;
  const Ran ran = run(words + Typed{"-o", "new/rows.csv"});
  CHECK(ran.exit == 0);
  CHECK(ran.out.empty());
  CHECK(contents("new/rows.csv") == shown);
  CHECK(run(words + Typed{"-o", "rows.json"}).exit == 0);
  CHECK(Json::parse(lines(contents("rows.json"))[2])["row"] == 2);
  CHECK(run(words + Typed{"-o", "-"}).out == shown);

  std::ofstream("kept.csv") << "kept";
  CHECK(run({"sweep", "triangle", "--over", "a=-2..-1/2", "--quantity", "c", "-o", "kept.csv"}).exit == 2);
  CHECK(contents("kept.csv") == "kept");
  Triangle broken;
  broken.spoil_values = [](auto&) { throw std::logic_error("broken"); };
  CHECK(run_on(broken, words + Typed{"-o", "kept.csv"}).exit == 70);
  CHECK(contents("kept.csv") == "kept");
  const Ran full = run(words + Typed{"-o", "/dev/full"});
  CHECK(full.exit == 3);
  CHECK(contains(full.err, "cannot write /dev/full: "));
  CHECK(run(words + Typed{"-o", "kept.csv/rows.csv"}).exit == 3);
  CHECK(run(words + Typed{"-o", "none.csv", "--chart", "kept.csv/x.pdf"}).exit == 3);
  CHECK(scratch.files() == Typed{"kept.csv", "new/rows.csv", "rows.json"});
}

TEST_CASE("a sweep shows what check shows, at every position looked at") {
  const std::map<std::string, Typed> sought{
      {"slider-crank-velocity", {"v_B", "omega_3", "P0_x"}},
      {"slider-crank-acceleration", {"a_B", "alpha_3", "K_x"}},
      {"four-bar-analytic", {"omega_4", "alpha_4"}},
      {"rivals-polygons", {}},
  };
  for (const auto& [id, wished] : sought) {
    Typed names = wished;
    for (const Listed& each : catalogue())
      if (each.id() == id && names.empty())
        for (std::size_t i = 0; i < 4; ++i) names.push_back(each->about().quantities().at(i).name);
    Typed words{"sweep", id, "--over", "phi=0deg..360deg/73", "--format", "json"};
    for (const std::string& name : names) words = words + Typed{"--quantity", name};
    const Ran ran = run_on_all(words);
    CAPTURE(id, ran.err);
    CHECK(ran.exit == 0);
    const Typed rows = lines(ran.out);
    REQUIRE(rows.size() == 73);
    Typed as_csv = words;
    as_csv[5] = "csv";
    const CsvTable table = read_csv(run_on_all(as_csv).out, "rows");
    const auto column = [&](const std::string& of) {
      const auto& head = table.header;
      const auto found = std::find_if(head.begin(), head.end(), [&](const std::string& each) {
        return each == of || each.starts_with(of + " (");
      });
      return static_cast<std::size_t>(found - head.begin());
    };
    for (const std::size_t i : {0U, 1U, 7U, 18U, 36U, 50U, 72U}) {
      const Json row = Json::parse(rows[i]);
      for (const std::string& name : names)
        for (const char* const bound : {"lower", "upper"})
          if (const Json& of_object = row["quantities"][name][bound]; !of_object.is_null())
            CHECK(of_object == std::stod(table.rows.at(i).cells.at(column(name + "_" + bound))));
      const Ran check = run_on_all({"check", id, "--set", fmt::format("phi={}deg", 5 * i), "--json"});
      CAPTURE(i);
      REQUIRE(check.exit != 2);
      std::size_t compared = 0;
      const Json checked = Json::parse(check.out);
      for (const Json& quantity : checked["exercises"][0]["quantities"]) {
        const std::string name = quantity["name"];
        if (std::find(names.begin(), names.end(), name) == names.end()) continue;
        const Json& swept = row["quantities"][name];
        CAPTURE(name, swept.dump(), quantity.dump());
        CHECK(swept["value"] == quantity["value"]);
        CHECK(swept["unit"] == quantity["unit"]);
        CHECK(swept.contains("absent") == quantity.contains("absent"));
        if (!swept["value"].is_null()) {
          CHECK(swept["lower"] <= swept["value"]);
          CHECK(swept["value"] <= swept["upper"]);
        }
        ++compared;
      }
      CHECK(compared == names.size());
    }
  }
}

TEST_CASE("over part of a turn the linkage does not close, and a pole is at infinity") {
  // With l = 0.15 m under r = 0.2 m: |sin φ| <= 3/4, which 48° is within and 49° is not.
  const Ran ran = run_on_all({"sweep", "slider-crank-velocity", "--over", "phi=0..90/91", "--set", "l=0.15", "--set",
                              "AC=0.1", "--set", "BC=0.1", "--quantity", "v_B"});
  CHECK(ran.exit == 0);
  const Typed rows = lines(ran.out);
  REQUIRE(rows.size() == 92);
  for (std::size_t degrees = 0; degrees <= 90; ++degrees) {
    CAPTURE(rows[degrees + 1]);
    CHECK(contains(rows[degrees + 1], "the linkage does not close: at crank angle") == (degrees > 48));
    CHECK((fields(rows[degrees + 1]).at(1) == "") == (degrees > 48));
  }
  const Ran at_infinity =
      run_on_all({"sweep", "slider-crank-velocity", "--over", "phi=89..91/3", "--quantity", "P0_y,v_B"});
  CHECK(at_infinity.exit == 0);
  const Typed around = lines(at_infinity.out);
  CHECK(fields(around.at(1)).at(4) == "");
  CHECK(contains(around.at(2), "the pole P₀ is at infinity"));
  CHECK(std::stod(fields(around.at(1)).at(1)) * std::stod(fields(around.at(3)).at(1)) < 0);
}

TEST_CASE("what is asked alone is what is found among all") {
  for (const Listed& exercise : catalogue()) {
    if (exercise.id() == "oscillator-pendulum") continue;  // a second and more for each run
    const Givens givens(exercise->about().givens);
    const std::vector<RouteValue> all = exercise->solve(givens, Rung::climb);
    const auto& quantities = exercise->about().quantities();
    const Typed names{quantities.front().name, quantities[quantities.size() / 2].name, quantities.back().name};
    const Asked asked(names);
    const std::vector<RouteValue> few = exercise->solve(givens, Rung::climb);
    CHECK(few.size() < all.size());
    for (const std::string& name : names) {
      const auto by_name = [&](const std::vector<RouteValue>& values) {
        std::vector<RouteValue> found;
        std::copy_if(values.begin(), values.end(), std::back_inserter(found),
                     [&](const RouteValue& value) { return value.quantity == name; });
        return found;
      };
      CAPTURE(exercise.id(), name);
      REQUIRE(by_name(few).size() == by_name(all).size());
      CHECK(best_known(by_name(few)).kind == best_known(by_name(all)).kind);
      CHECK(best_known(by_name(few)).enclosure.value == best_known(by_name(all)).enclosure.value);
    }
  }
}

TEST_CASE("thousands of rows, in order") {
  const Ran ran = run_on_all({"sweep", "rivals-polygons", "--over", "phi=0..360/7201", "--quantity", "omega_3"});
  CAPTURE(ran.err);
  REQUIRE(ran.exit == 0);
  const Typed rows = lines(ran.out);
  REQUIRE(rows.size() == 7202);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)  // 0.05° apart
    REQUIRE(std::lround(20 * std::stod(fields(rows[i + 1]).front())) == static_cast<long>(i));
}

TEST_CASE("jobs in order") {
  const auto make = [](std::uint64_t i) { return i; };
  for (const std::uint64_t count : {0U, 1U, 5U, 5000U}) {
    std::vector<std::uint64_t> taken;
    in_order(count, make, [&](std::uint64_t i) {
      taken.push_back(i);
      return true;
    });
    REQUIRE(taken.size() == count);
    for (std::uint64_t i = 0; i < count; ++i) REQUIRE(taken[i] == i);
  }
  std::atomic<std::uint64_t> made = 0;
  std::uint64_t taken = 0;
  const auto count_made = [&](std::uint64_t i) { return ++made, i; };
  in_order(100'000, count_made, [&](std::uint64_t) { return ++taken < 10; });
  CHECK(taken == 10);
  CHECK(made < 10 + 64 * std::max(std::thread::hardware_concurrency(), 1U));

  taken = 0;
  const auto fails = [](std::uint64_t i) {
    if (i == 77) throw std::runtime_error("seventy-seven");
    if (i > 77) throw std::runtime_error("later");
    return i;
  };
  const auto take = [&](std::uint64_t) { return ++taken, true; };
  CHECK_THROWS_WITH(in_order(1000, fails, take), "seventy-seven");
  CHECK(taken == 77);
  const auto no_room = [](std::uint64_t) -> bool { throw std::runtime_error("no room"); };
  CHECK_THROWS_WITH(in_order(1000, make, no_room), "no room");
}

TEST_CASE("progress is for a terminal, and leaves nothing on it") {
  const Typed quick{"sweep", "rivals-polygons", "--over", "phi=0..360/3601", "--quantity", "omega_3"};
  CHECK(run_on_all(quick, {.out_is_terminal = true, .err_is_terminal = true}).err.find('%') == std::string::npos);
  CHECK(run_on_all(quick, {.out_is_terminal = false, .err_is_terminal = false}).err.empty());
  const std::string told = run_on_all(quick, {.out_is_terminal = false, .err_is_terminal = true}).err;
  CHECK(contains(told, " %, "));
  CHECK(contains(told, " s left"));
  CHECK(told.ends_with("\r\x1b[K"));
}

TEST_CASE("charts: one for each unit, with gaps") {
  const Scratch scratch;
  const Typed words{"sweep",      "slider-crank-velocity",
                    "--over",     "phi=0..360/361",
                    "--set",      "l=0.15",
                    "--set",      "AC=0.1",
                    "--set",      "BC=0.1",
                    "--quantity", "v_B,omega_3,v_B_x"};
  CHECK(run_on_all(words + Typed{"--chart", "c.svg", "-o", "rows.csv"}).exit == 0);
  const std::string svg = contents("c.svg");
  CHECK(contains(svg, "<svg"));
  CHECK(contains(svg, "(m/s)"));
  CHECK(contains(svg, "(rad/s)"));
  CHECK(contains(svg, "from 0° to 360°, 361 values"));
  CHECK(contains(svg, "-sweep-v_B-3\""));  // three ranges of the crank, a line for each
  CHECK(!contains(svg, "-sweep-v_B-4\""));
  CHECK(run_on_all(words + Typed{"--chart", "c.pdf", "-o", "rows.csv", "--lang", "it"}).exit == 0);
  CHECK(contents("c.pdf").starts_with("%PDF-"));
}

// A crank's direction over the end of its turn; P₀ over infinity, where the crank is upright.
TEST_CASE("a chart has no line where nothing runs") {
  const Scratch scratch;
  const auto svg = [](const std::string& of, const std::string& over, const std::string& quantity) {
    CHECK(run_on_all({"sweep", of, "--over", over, "--quantity", quantity, "--chart", "c.svg", "-o", "c.csv"}).exit ==
          0);
    return contents("c.svg");
  };
  const std::string crank = svg("quick-return", "theta=0..360/73", "theta_2"),
                    pole = svg("slider-crank-velocity", "phi=0..360/74", "P0_y");
  CHECK(contains(crank, "-sweep-theta_2-2\""));
  CHECK(!contains(crank, "-sweep-theta_2-3\""));
  CHECK(contains(pole, "-sweep-P0_y-3\""));
  CHECK(!contains(pole, "-sweep-P0_y-4\""));
}

TEST_CASE("a chart over the wrong given says which to name first") {
  const Scratch scratch;
  const Typed words{
      "sweep",  "slider-crank-velocity", "--quantity", "v_B", "--chart", "c.svg", "--over", "r=0.18|0.2",
      "--over", "phi=0..360/37"};
  CHECK(run_on_all(words).err ==
        "epure: --chart would draw 37 curves over r, and a sheet bears 12; the axis is the first --over: name phi "
        "first, as it has 37 values\n");
}

// Attacked: "0 .. 360 / 5" did not say how many values, and "left " was no word.
TEST_CASE("blanks about what parts an option's text are nothing") {
  const auto swept = [](const std::string& over, const std::string& set = "b=0.4") {
    const Ran ran = run({"sweep", "triangle", "--over", over, "--set", set, "--quantity", "c"});
    CAPTURE(over, set, ran.err);
    CHECK(ran.exit == 0);
    return ran.out;
  };
  const std::string plain = swept("a=0.3..0.5/3");
  CHECK(plain == swept(" a = 0.3 .. 0.5 / 3 ", "b = 0.4 "));
  CHECK(plain == swept("a\u00a0=\t0.3\u2009..\u00a00.5/3"));
  CHECK(swept("a=0.3|0.4|0.5") == swept("a = 0.3 | 0.4 |0.5"));
}
