// Givens from files, and names for the files that come of them.
#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/exercises/run.h"
#include "tests/support/catch.h"
#include "tests/support/unpacked.h"

using namespace epure;

namespace {

using Typed = std::vector<std::string>;

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// `text` is the file that --givens names.
void refused(const std::string& text, const Typed& more, const std::string& sentence) {
  for (const std::string verb : {"draw", "check"}) {
    const Scratch scratch;
    write("g.txt", text);
    Typed words{verb, "triangle", "--givens", "g.txt"};
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = run(words);
    CAPTURE(verb, text, more, ran.err);
    CHECK(ran.exit == 2);
    CHECK(ran.out.empty());
    CHECK(count(ran.err, "\n") == 1);
    CHECK(ran.err.find(sentence) != std::string::npos);
    CHECK(scratch.files() == Typed{"g.txt"});
  }
}

void refused_name(const Typed& more, const std::string& sentence) {
  const Scratch scratch;
  write("g.csv", "number,name,a\n1,Anna B,0.3\n2,Anna B,3/7\n");
  Typed words{"draw"};
  words.insert(words.end(), more.begin(), more.end());
  const Ran ran = run(words);
  CAPTURE(more, ran.err);
  CHECK(ran.exit == 2);
  CHECK(count(ran.err, "\n") == 1);
  CHECK(ran.err.find(sentence) != std::string::npos);
  CHECK(scratch.files() == Typed{"g.csv"});
}

}  // namespace

TEST_CASE("givens from lines are what --set says") {
  const Scratch scratch;
  const std::string drawn = run({"draw", "triangle/sides", "-o", "-", "--set", "a=25cm", "--set", "b=0,6"}).out;
  REQUIRE(drawn.starts_with("%PDF"));
  for (const std::string text : {"a = 25 cm\nb=0.6", "# mine\r\n a=25cm \r\n\r\n; more\r\nb = \"0,60\" # m\r\n",
                                 "\xEF\xBB\xBF"
                                 "b = 3/5\na = 1/4\n"}) {
    write("g.ini", text);
    const Ran ran = run({"draw", "triangle/sides", "-o", "-", "--givens", "g.ini"});
    CAPTURE(text, ran.err);
    CHECK(ran.out == drawn);
  }
  write("g.ini", "a = 25 cm");
  CHECK(run({"draw", "triangle/sides", "-o", "-", "--givens", "g.ini", "--set", "b=0.6"}).out == drawn);
  CHECK(run({"check", "triangle", "--givens", "g.ini"}).out == run({"check", "triangle", "--set", "a=25cm"}).out);
  const Typed sweep{"sweep", "triangle", "--over", "b=0.1..0.5/5", "--quantity", "c"};
  Typed with_file = sweep, with_set = sweep;
  with_file.insert(with_file.end(), {"--givens", "g.ini"});
  with_set.insert(with_set.end(), {"--set", "a=25cm"});
  REQUIRE(run(with_set).exit == 0);
  CHECK(run(with_file).out == run(with_set).out);
  CHECK(run_on_two({"draw", "all", "--givens", "g.ini"}).exit == 0);
}

TEST_CASE("of a table each row is drawn and checked") {
  const Scratch scratch;
  write("g.csv", "number;a\n7;0,5\n8;\n");
  CHECK(run({"draw", "triangle", "--givens", "g.csv"}).out ==
        "out/triangle-7.pdf\nout/triangle-sides-7.svg\nout/triangle-small-7.svg\n"
        "out/triangle-8.pdf\nout/triangle-sides-8.svg\nout/triangle-small-8.svg\n");
  REQUIRE(run({"draw", "triangle", "--set", "a=0.5", "--format", "svg", "--bare", "--out", "as-set"}).exit == 0);
  REQUIRE(run({"draw", "triangle", "--givens", "g.csv", "--format", "svg", "--bare", "--out", "of-rows"}).exit == 0);
  CHECK(contents("of-rows/triangle-sides-7.svg") == contents("as-set/triangle-sides.svg"));
  CHECK(contents("of-rows/triangle-sides-8.svg") != contents("as-set/triangle-sides.svg"));

  const std::string report = run({"check", "triangle", "--givens", "g.csv"}).out;
  CHECK(report.find("g.csv, line 2: 7\n") != std::string::npos);
  CHECK(report.find("g.csv, line 3: 8\n") != std::string::npos);
  const auto told = nlohmann::json::parse(run({"check", "triangle", "--givens", "g.csv", "--json"}).out);
  REQUIRE(told["exercises"].size() == 2);
  CHECK(told["exercises"][0]["row"] == nlohmann::json{{"number", "7"}});
  CHECK(told["exercises"][0]["givens"][0]["value"] == "1/2");
  CHECK(told["exercises"][1]["givens"][0]["value"] == "3/10");

  write("sep.csv", "sep=;\r\nnumber;a\r\n7;0,5\r\n");
  CHECK(run({"check", "triangle", "--givens", "sep.csv"}).out.find("sep.csv, line 3: 7\n") != std::string::npos);

  REQUIRE(run({"draw", "triangle", "--givens", "g.csv", "-o", "all.pdf"}).exit == 0);
  CHECK(count(with_packed_objects(contents("all.pdf")), "/Type /Page ") == 4);
}

TEST_CASE("a file of givens with a mistake is named with its line, and nothing is written") {
  refused("a = 0.3\nq = 2", {}, "g.txt, line 2: \"q\" is no given of triangle");
  refused("# two\na = 0.3\n\na = 0.4", {}, "g.txt, line 4: a is given a second time");
  refused("b = 0.3\na = far", {}, "g.txt, line 2: ");
  refused("b = 0.3\na = -1 m", {}, "g.txt, line 2: a");
  refused("b = 0.3\na = 5 kg", {}, "g.txt, line 2: ");
  refused("b = 0.3\na 0.25", {}, "g.txt, line 2: \"a 0.25\" is no given; write symbol = value");
  refused("b = 0.3\na =", {}, "g.txt, line 2: \"a =\" is no given");
  refused("b = 0.3\n= 5", {}, "g.txt, line 2: \"= 5\" is no given");
  refused("[triangle]\na = 0.3", {}, "g.txt, line 1: sections are not for givens");
  refused("a = 0.3\nb = \xff", {}, "g.txt, line 2: is not UTF-8");
  refused("a = 0.3", {"--set", "a=0.3"}, "g.txt: a has a value here, and --set a=0.3 gives it one too");
  refused("a,b\n0.3,0.4\n0.3,far", {}, "g.txt, line 3: ");
  refused("a,b\n0.3,0.4\n0.3", {}, "g.txt, line 3: fields: 1");
  refused("a,q\n0.3,0.4", {}, "the column \"q\" is no given of triangle");
  refused("a\n", {}, "there is no row below its header");
  refused("a\n0.3\n0.4\n", {"--set", "a=0.5"}, "g.txt, line 2: a has a value here");
  refused("", {}, "is empty");
  const Scratch scratch;
  const Ran absent = run({"draw", "triangle", "--givens", "none.csv"});
  CHECK(absent.exit == 2);
  CHECK(absent.err.find("cannot read none.csv") != std::string::npos);
  write("g.csv", "a\n0.3\n0.4\n");
  const Typed sweep{"sweep", "triangle", "--over", "b=0.1..0.5/5", "--quantity", "c", "--givens", "g.csv"};
  CHECK(run(sweep).err.find("g.csv has 2 rows") != std::string::npos);
  CHECK(run({"check", "triangle", "--givens", "g.csv", "--measured", "c=0.5"}).err.find("g.csv has 2 rows") !=
        std::string::npos);
  write("g.csv", "b\n0.3\n");
  CHECK(run(sweep).err.find("b is set, and --over varies it") != std::string::npos);
}

TEST_CASE("files are named by a pattern") {
  const Scratch scratch;
  write("g.csv", "number,name,a\n1,Nicolò d'Alì,0.3\n2,Anna B,3/7\n");
  CHECK(
      run({"draw", "triangle", "--givens", "g.csv", "--name", "{id}-{student}-{sheet}", "--format", "svg,pdf"}).out ==
      "out/triangle-Nicolò_d_Alì-sides.svg\nout/triangle-Nicolò_d_Alì-small.svg\n"
      "out/triangle-Nicolò_d_Alì-sides.pdf\nout/triangle-Nicolò_d_Alì-small.pdf\n"
      "out/triangle-Anna_B-sides.svg\nout/triangle-Anna_B-small.svg\n"
      "out/triangle-Anna_B-sides.pdf\nout/triangle-Anna_B-small.pdf\n");
  CHECK(run({"draw", "triangle", "--givens", "g.csv", "--name", "t{row}_{number}_{a}", "--format", "pdf"}).out ==
        "out/t1_1_0.3.pdf\nout/t2_2_3_7.pdf\n");
  CHECK(run({"draw", "triangle/sides", "--name", "{lang}{a}", "--set", "a=25cm", "--lang", "it", "--out", "o"}).out ==
        "o/it0.25.pdf\no/it0.25.svg\n");
  CHECK(run({"draw", "triangle/sides", "--name", "x", "--blank", "--format", "svg"}).out == "out/x-blank.svg\n");
}

TEST_CASE("a pattern that makes two files one, or none, is refused before anything is written") {
  refused_name(
      {"triangle", "--name", "{id}"},
      "triangle/sides and triangle/small would be one file, out/triangle.svg; tell them apart by --name, such "
      "as {id}-{sheet}\n");
  refused_name({"triangle", "--givens", "g.csv", "--name", "{id}-{student}", "--format", "pdf"},
               "triangle (g.csv, line 2) and triangle (g.csv, line 3) would be one file, out/triangle-Anna_B.pdf");
  refused_name({"triangle/sides", "--format", "pdf,pdf+tex", "--name", "{id}", "--givens", "g.csv"},
               "would be one file");
  refused_name({"triangle", "--name", "{id}-{q}"},
               "{q} is no field for triangle; choose among {id}, {sheet}, {lang}, {row}, {number}, {student}, {a}, "
               "{b}, {load} or {shift}");
  refused_name({"triangle", "--name", "{student}-{sheet}"}, "{student} is told by the rows of a table");
  refused_name({"triangle", "--name", "../{sheet}"}, "names a file and no folder");
  refused_name({"triangle", "--name", "/tmp/{sheet}"}, "names a file and no folder");
  refused_name({"triangle", "--name", "a\\{sheet}"}, "names a file and no folder");
  refused_name({"triangle", "--name", "{sheet"}, "a brace is opened and not closed");
  refused_name({"triangle", "--name", "sheet}"}, "a brace is closed and not opened");
  refused_name({"triangle", "--name", "{}{sheet}"}, "{} is no field");
  refused_name({"triangle", "--name", ""}, "names no file");
  refused_name({"triangle", "--name", ".{sheet}"}, "would begin with \".\"");
  refused_name({"triangle", "--name", "{shift}{sheet}", "--set", "shift=-1"}, "would begin with \"-\"");
  refused_name({"triangle", "--name", "{sheet}\n"}, "printable");
  refused_name({"triangle", "--name", "{sheet}" + std::string(200, 'x')}, "longer than 200 bytes");
  refused_name({"triangle", "--name", "è{sheet}", "--format", "pdf+tex"}, "a file for TeX has a name of");
  refused_name({"triangle/sides", "--name", "x", "-o", "y.pdf"}, "choose one of them");
}
