// Every verb, every exit code.
#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "drawings/output.h"
#include "exercises/cli/symbol.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

using Typed = std::vector<std::string>;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Refused with one sentence that says `part`, on standard error alone.
void refused(const Typed& words, const std::string& part, int exit = 2) {
  const Ran ran = run(words);
  CAPTURE(words, ran.err);
  CHECK(ran.exit == exit);
  CHECK(ran.out.empty());
  CHECK(ran.err.starts_with("epure: "));
  CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
  CHECK(ran.err.ends_with('\n'));
  CHECK(contains(ran.err, part));
}

}  // namespace

TEST_CASE("help and version") {
  const Ran version = run({"--version"});
  CHECK(version.exit == 0);
  CHECK(version.out.starts_with("epure "));
  for (const std::string library : {"FLINT", "MPFR", "CGAL", "Cairo", "HarfBuzz"})
    CHECK(contains(version.out, library));
  for (const Typed& words : {Typed{"--help"},
                             {"list", "--help"},
                             {"draw", "--help"},
                             {"check", "-h"},
                             {"mark", "-h"},
                             {"sweep", "-h"},
                             {"help"},
                             {"help", "draw"}}) {
    const Ran help = run(words);
    CAPTURE(words);
    CHECK(help.exit == 0);
    CHECK(help.err.empty());
    CHECK(contains(help.out, "Examples:"));
    const std::string verb = words.size() == 1 ? "list" : words[0] == "help" ? words[1] : words[0];
    CHECK(contains(help.out, "  epure " + verb));
    CHECK(contains(help.out, "Exit code: 0 good; 1 "));
  }
  CHECK(run({"help"}).out == run({"--help"}).out);
  CHECK(run({"help", "draw"}).out == run({"draw", "--help"}).out);
  CHECK(run({"-V"}).out == version.out);
  const std::string draw = run({"draw", "--help"}).out, check = run({"check", "--help"}).out,
                    sweep = run({"help", "sweep"}).out;
  for (const std::string option : {"--format", "--out", "-o", "--set", "--paper", "--scale", "--lang", "--bare",
                                   "--width", "--height", "--dpi", "--background", "--ink"})
    CHECK(contains(draw, "  " + option));
  for (const std::string option :
       {"--set", "--measured", "--reading", "--sheet", "--scale", "--quiet", "--json", "--arithmetic"})
    CHECK(contains(check, "  " + option));
  for (const std::string option : {"--over", "--quantity", "--set", "--format", "-o", "--part", "--chart", "--lang"})
    CHECK(contains(sweep, "  " + option));
  const std::string mark = run({"mark", "--help"}).out;
  for (const std::string option : {"--answers", "--key", "--set", "--reading", "--sheet", "--scale", "--points",
                                   "--slip-points", "--format", "-o", "--lang"})
    CHECK(contains(mark, "  " + option));
}

TEST_CASE("what is no command is refused in one sentence") {
  refused({}, "list, draw, check, report, booklet, class, mark, sweep, import or bench");
  refused({"chek"}, "did you mean check?");
  refused({"frobnicate", "triangle"}, "known are: list, draw, check");
  refused({"--frob"}, "\"--frob\" is no option of epure; known are: ");
  refused({"--measured", "x=1", "triangle", "check"},
          "\"--measured\" stands before the verb, which comes first: epure check ...");
  refused({"list", "--frob", "-x"}, "\"--frob\" is no option of epure list; known are: ");
  refused({"draw", "triangle", "--formt=pdf"}, "\"--formt\" is no option of epure draw; did you mean --format");
  refused({"bench", "--json", "triangle"}, "\"triangle\" is not expected after epure bench");
  refused({"draw", "triangle", "--set"}, "--set needs a value: --set SYMBOL=VALUE[UNIT]");
  refused({"draw", "triangle", "--paper", "a4", "--paper", "a3"}, "--paper is given twice");
  refused({"draw", "triangle", "--out"}, "--out needs a value: --out DIR");  // not -o
  refused({"draw", "triangle", "--out", "a", "--out", "b"}, "--out is given twice");
  refused({"check", "triangle", "--json=x"}, "--json takes no value");
  refused({"draw", "triangle", "--bare=3"}, "--bare takes no value");
  refused({"--version=x"}, "--version takes no value");
  refused({"--help=x"}, "--help takes no value");
  refused({"all"}, "\"all\" stands after a verb: epure draw all, or epure check all");
  const std::string after = " stands after a verb: epure list triangle, epure draw ";
  refused({"triangle"}, "\"triangle\"" + after + "triangle, or epure check triangle");
  refused({"help", "triangle"}, "\"triangle\"" + after + "triangle, or epure check triangle");
  refused({"triangle/sides"}, "\"triangle/sides\"" + after + "triangle/sides, or epure check triangle");
  for (const std::string given : {"a=1", "a=0.5", "a=1/2"})
    refused({"draw", "triangle", given}, "is no exercise; to set a given write --set a=");
  refused({""}, "\"\" is nothing epure can do");
  refused({"draw", ""}, "there is no exercise \"\"");
  for (const std::string file : {"folder/file", "./triangle", "press.txt", "/tmp/press"})
    refused({"draw", file}, "\"" + file +
                                "\" is no exercise nor a sheet of one, and the file of a mechanism has a name "
                                "that ends in .yaml or .yml");
  refused({"draw", "triangel/sides"}, "did you mean triangle?");
  refused({"--lang", "it", "help"}, "--lang segue il verbo: epure VERBO --lang");
  refused({"help", "dra"}, "\"dra\" is nothing epure can do; did you mean draw?");
  refused({"list", "--lang"}, "--lang needs a value");
  refused({"list", "triangle", "triangle"}, "one exercise at a time");
  refused({"draw"}, "no exercise named");
  refused({"check"}, "no exercise named");
  refused({"sweep"}, "sweep takes one exercise");
  refused({"sweep", "triangle", "--over"}, "--over needs a value: --over SYMBOL=FROM..TO/N");
  refused({"sweep", "triangle", "--ovr", "a=0..1/3"}, "\"--ovr\" is no option of epure sweep; did you mean --over?");
  refused({"check", "tri\nangle"}, "tri?angle");
}

TEST_CASE("unknown names are refused with a suggestion") {
  refused({"list", "triangel"}, "did you mean triangle?");
  refused({"draw", "triangel"}, "did you mean triangle?");
  refused({"check", "triangel"}, "did you mean triangle?");
  refused({"draw", "triangle/side"}, "did you mean sides?");
  refused({"draw", "triangle/"}, "has no sheet \"\"");
  refused({"check", "triangle/sides"}, "is a sheet");
  refused({"draw", "triangle", "--format", "gif"}, "\"gif\" is no format");
  refused({"draw", "triangle", "--format", "pdf,"}, "is no format");
  refused({"draw", "triangle", "--paper", "a5"}, "\"a5\" is no paper");
  refused({"draw", "triangle", "--lang", "fr"}, "\"fr\" is no language");
  refused({"draw", "triangle", "--scale", "0", "--lang", "IT"}, "non è una scala");
  refused({"list", "--lang", "fr"}, "\"fr\" is no language");
  refused({"check", "triangle", "--arithmetic", "magic"}, "\"magic\" is no arithmetic");
}

TEST_CASE("nothing to check is no success") {
  std::ostringstream out, err;
  CHECK(run_cli({}, {"check", "all"}, out, err) == 2);
  CHECK(run_cli({}, {"draw", "all"}, out, err) == 2);
}

TEST_CASE("impossible givens are refused by every verb that takes them") {
  const Scratch scratch;
  for (const std::string verb : {"draw", "check"}) {
    refused({verb, "triangle", "--set", "a=-1"}, "a = -1: must be positive");
    refused({verb, "triangle", "--set", "a=0"}, "must be positive");
    refused({verb, "triangle", "--set", "a=nan"}, "\"nan\"");
    refused({verb, "triangle", "--set", "a=inf"}, "\"inf\"");
    refused({verb, "triangle", "--set", "a=1e308"}, "must lie between 1e-12 and 1e12 m");
    refused({verb, "triangle", "--set", "a=1.234,5"}, "point or comma");
    refused({verb, "triangle", "--set", "a="}, "a: \"\" is empty");
    refused({verb, "triangle", "--set", "=3"}, "no symbol");
    refused({verb, "triangle", "--set", "a"}, "write symbol=value");
    refused({verb, "triangle", "--set", "a=3s"}, "time where a length");
    refused({verb, "triangle", "--set", "x=3"}, "\"x\" is no given");
    refused({verb, "triangle", "--set", "a=1", "--set", "a=2"}, "a is set twice");
  }
  refused({"draw", "triangle", "--set", "a=100"}, "does not fit");
  CHECK(scratch.files().empty());
}

TEST_CASE("numbers are checked though no picture can be drawn of them, and the exit code says so") {
  const Ran ran = run({"check", "triangle", "--set", "a=100"});
  CHECK(ran.exit == 2);
  CHECK(ran.err == "epure: triangle: sheet sides: the triangle does not fit the paper at this scale\n");
  CHECK(contains(ran.out, "c         100.001 m   ab"));
  CHECK(contains(ran.out, "\n  NOT DRAWN sheet sides: the triangle does not fit the paper at this scale\n"));
  CHECK(ran.out.ends_with("\nNOT DRAWN: 2 sheets; 5 quantities\n"));
  const nlohmann::json report =
      nlohmann::json::parse(run({"check", "triangle", "--json", "--set", "a=100"}).out).at("exercises").at(0);
  CHECK(report.at("not_drawn").at(1) == "sheet small: the triangle does not fit the paper at this scale");
  CHECK(report.at("passed") == false);
}

TEST_CASE("what is wrong with the mechanism itself fails its check, though all numbers are right") {
  Triangle flawed;
  flawed.flaws_of_it = {{{"$T_{1}$ is too sharp", "$T_{1}$ è troppo aguzzo"}}, {{"is it flat?", "è piatto?"}, true}};
  const Ran ran = run_on(flawed, {"check", "triangle"});
  CHECK(ran.exit == 1);
  CHECK(contains(ran.out, "\n  FAILED T_1 is too sharp\n"));
  CHECK(contains(ran.out, "\n  UNDECIDED is it flat?\n"));
  CHECK(contains(ran.out, "\nFAILED: 1 fault; 5 quantities, 1 undecided; printed: "));
  CHECK(contains(run_on(flawed, {"check", "triangle", "--lang", "it"}).out, "  FALLITO T_1 è troppo aguzzo\n"));
  const nlohmann::json report =
      nlohmann::json::parse(run_on(flawed, {"check", "triangle", "--json"}).out).at("exercises").at(0);
  CHECK(report.at("failures") == nlohmann::json{"T_1 is too sharp"});
  CHECK(report.at("undecided") == nlohmann::json{"is it flat?"});
  flawed.flaws_of_it.erase(flawed.flaws_of_it.begin());
  CHECK(run_on(flawed, {"check", "triangle"}).exit == 4);
}

TEST_CASE("doubles alone compare nothing, and the totals say so") {
  const Ran fast = run({"check", "triangle", "--arithmetic", "fast"});
  CHECK(fast.exit == 0);
  CHECK(contains(fast.out, "\nnot compared: 5 quantities; printed: "));
}

TEST_CASE("a name may follow a repeatable option") {
  CHECK(run({"check", "--set", "a=0.2", "--measured", "c_x=0.2", "triangle"}).exit == 0);
}

TEST_CASE("a given applies to the exercises that have it, and to at least one") {
  CHECK(run_on_two({"check", "all", "--set", "k=2"}).exit == 0);
  CHECK(run_on_two({"check", "other", "triangle", "--set", "k=2"}).exit == 0);
  const Ran unknown = run_on_two({"check", "all", "--set", "q=2"});
  CHECK(unknown.exit == 2);
  CHECK(contains(unknown.err, "\"q\" is no given of any exercise named; known are: a, b, load, shift, k"));
  CHECK(run_on_two({"check", "triangle", "--set", "k=2"}).exit == 2);
  CHECK(run_on_two({"check", "all", "--set", "k"}).exit == 2);
  CHECK(run_on_two({"check", "all", "--set", "a=-2"}).exit == 2);
}

TEST_CASE("list shows the exercises, and one exercise") {
  const Ran all = run_on_two({"list"});
  CHECK(all.exit == 0);
  const std::string exercises =
      "other     A right triangle (euclid, I.47)\n"
      "triangle  A right triangle (euclid, I.47)\n";
  CHECK(all.out.starts_with(exercises + "\nMechanisms from files (docs/scenes;"));
  CHECK(run_on_two({"list", "all"}).out == exercises);
  CHECK(contains(run({"list", "--lang", "it"}).out, "Un triangolo rettangolo"));
  const std::string one = run({"list", "triangle"}).out;
  CHECK(contains(one, "  triangle/sides  The sides\n"));
  CHECK(contains(one, "  load   0     N  load\n"));
  CHECK(contains(one, "  c      c₀    m      hypotenuse\n"));
  CHECK(contains(one, "  c_x    c_AB  m      its abscissa\n"));
  CHECK(contains(one, "  c_y    c₃₁   m      its ordinate\n"));
  CHECK(contains(run({"list", "triangle", "--lang", "it"}).out, "Grandezze\n"));
}

TEST_CASE("draw writes a document an exercise and a picture a sheet, and says so") {
  const Scratch scratch;
  const Ran ran = run({"draw", "triangle"});
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  CHECK(ran.out == "out/triangle.pdf\nout/triangle-sides.svg\nout/triangle-small.svg\n");
  CHECK(scratch.files() == Typed{"out/triangle-sides.svg", "out/triangle-small.svg", "out/triangle.pdf"});
  CHECK(contents("out/triangle.pdf").starts_with("%PDF-"));
  CHECK(contains(contents("out/triangle-small.svg"), "<svg"));
}

TEST_CASE("draw ID/SHEET writes that sheet alone in both formats") {
  const Scratch scratch;
  CHECK(run({"draw", "triangle/small", "--out", "deep/er"}).out ==
        "deep/er/triangle-small.pdf\ndeep/er/triangle-small.svg\n");
  CHECK(scratch.files() == Typed{"deep/er/triangle-small.pdf", "deep/er/triangle-small.svg"});
}

TEST_CASE("a file asked for twice is made once") {
  const Scratch scratch;
  CHECK(run({"draw", "triangle", "triangle/small", "all"}).out ==
        "out/triangle.pdf\nout/triangle-sides.svg\nout/triangle-small.svg\nout/triangle-small.pdf\n");
  CHECK(run({"draw", "triangle", "triangle", "--format", "svg,svg"}).out ==
        "out/triangle-sides.svg\nout/triangle-small.svg\n");
}

TEST_CASE("draw all draws all, each in its files") {
  const Scratch scratch;
  CHECK(run_on_two({"draw", "all", "--format", "pdf", "--set", "k=3"}).out == "out/other.pdf\nout/triangle.pdf\n");
}

TEST_CASE("-o writes one file, in the format of its ending or of --format") {
  const Scratch scratch;
  CHECK(run({"draw", "triangle", "-o", "t.pdf"}).out == "t.pdf\n");
  CHECK(run({"draw", "triangle/small", "-o", "t.svg"}).out == "t.svg\n");
  CHECK(run({"draw", "triangle/small", "-o", "T.SVG", "--paper", "A4"}).out == "T.SVG\n");
  CHECK(run({"draw", "triangle/small", "-o", "T.Pdf", "--format", "PDF"}).out == "T.Pdf\n");
  CHECK(run({"draw", "triangle", "--format", "pdf", "-o", "plain"}).exit == 0);
  CHECK(contents("plain") == contents("t.pdf"));
  CHECK(scratch.files() == Typed{"T.Pdf", "T.SVG", "plain", "t.pdf", "t.svg"});
  CHECK(contents("T.SVG") == contents("t.svg"));
  refused({"draw", "triangle", "-o", "t2.svg"},
          "holds one sheet, and 2 are asked for; name one, such as triangle/sides");
  refused({"draw", "triangle", "-o", "t2"}, "tells no format");
  refused({"draw", "triangle", "-o", "t2.gif"}, "tells no format");
  refused({"draw", "triangle", "-o", "t2.pdf", "--format", "svg"}, "is not the ending");
  refused({"draw", "triangle", "-o", "t2", "--format", "pdf,svg"}, "choose one format");
  refused({"draw", "triangle", "-o", "t2.pdf", "--out", "x"}, "choose one of them");
  refused({"draw", "triangle", "-o", ""}, "tells no format");
  refused({"draw", "triangle", "-o", "new/"}, "\"new/\" is a folder; for files in a folder use --out \"new/\"");
  refused({"draw", "triangle", "-o", ".", "--format", "pdf"}, "for files in a folder use --out");
  CHECK(scratch.files().size() == 5);
}

TEST_CASE("-o - writes the bytes of the file to standard output, and nothing else") {
  const Scratch scratch;
  run({"draw", "triangle/small", "-o", "t.pdf"});
  run({"draw", "triangle/small", "-o", "t.svg"});
  CHECK(run({"draw", "triangle/small", "-o", "-"}).out == contents("t.pdf"));
  CHECK(run({"draw", "triangle/small", "-o", "-", "--format", "svg"}).out == contents("t.svg"));
  CHECK(run({"draw", "triangle/small", "-o", "/dev/stdout"}).out == contents("t.pdf"));
  refused({"draw", "triangle", "-o", "-", "--format", "svg"}, "holds one sheet");
  CHECK(scratch.files().size() == 2);
}

TEST_CASE("two runs write the same bytes, also after other drawings") {
  const Scratch scratch;
  run_on_two({"draw", "triangle", "--out", "a"});
  run_on_two({"draw", "all", "--out", "b", "--lang", "it"});
  run_on_two({"draw", "triangle", "--out", "c"});
  for (const std::string file : {"triangle.pdf", "triangle-sides.svg", "triangle-small.svg"}) {
    CHECK(contents("a/" + file) == contents("c/" + file));
    CHECK_FALSE(contents("a/" + file).empty());
  }
  CHECK(contents("a/triangle.pdf") != contents("b/triangle.pdf"));  // the language is in it
}

TEST_CASE("a scale is one number over another, and reaches the sheet") {
  const Scratch scratch;
  const auto svg = [](const std::string& scale) {
    return run({"draw", "triangle/sides", "-o", "-", "--format", "svg", "--scale", scale}).out;
  };
  CHECK(svg("1:10") == svg("1/10"));
  CHECK(svg("1:10") == svg("0.1"));
  CHECK(svg("1:10") == svg("0,1"));
  CHECK(svg("1:10") != svg("1:20"));
  CHECK_FALSE(svg("1:10").empty());
  refused({"draw", "triangle", "--scale", "2:1"}, "does not fit");
  for (const std::string bad : {"0", "-1:5", "1:0", "big", "1:5:2", "", "1,5,5"})
    refused({"draw", "triangle", "--scale", bad}, "\"" + bad + "\" is no scale; write 1:5");
}

TEST_CASE("paper, language and bareness reach the sheet") {
  Triangle triangle;
  std::vector<SheetRequest> seen;
  triangle.spoil_sheet = [&](DrawnSheet& drawn) {
    seen.push_back({drawn.sheet.paper, drawn.sheet.language, drawn.sheet.bare});
  };
  run_on(triangle, {"draw", "triangle/sides", "-o", "-"});
  run_on(triangle, {"draw", "triangle/sides", "-o", "-", "--paper", "a3", "--lang", "it", "--bare"});
  REQUIRE(seen.size() == 2);
  CHECK(seen[0].paper == drawings::Paper::a4);
  CHECK(seen[0].language == Language::english);
  CHECK_FALSE(seen[0].bare);
  CHECK(seen[1].paper == drawings::Paper::a3);
  CHECK(seen[1].language == Language::italian);
  CHECK(seen[1].bare);
}

TEST_CASE("what cannot be written is said, and nothing is left behind") {
  const Scratch scratch;
  std::ofstream("file") << "old";
  refused({"draw", "triangle", "-o", "/dev/full", "--format", "pdf"}, "No space left on device", 3);
  refused({"draw", "triangle", "--out", "file"}, "file", 3);
  refused({"draw", "triangle", "-o", "file/t.pdf"}, "file/t.pdf", 3);
  refused({"draw", "triangle", "--out", "/proc/nowhere"}, "/proc/nowhere", 3);
  CHECK(scratch.files() == Typed{"file"});
  CHECK(contents("file") == "old");
}

TEST_CASE("an older file survives a drawing that fails") {
  const Scratch scratch;
  CHECK(run({"draw", "triangle", "-o", "t.pdf"}).exit == 0);
  const std::string before = contents("t.pdf");
  refused({"draw", "triangle", "-o", "t.pdf", "--set", "a=100"}, "does not fit");
  // The second of two sheets cannot be drawn: the first is not written either.
  Triangle broken;
  int drawn_sheets = 0;
  broken.spoil_sheet = [&](DrawnSheet&) {
    if (++drawn_sheets == 2) throw BadGivens("no room");
  };
  CHECK(run_on(broken, {"draw", "triangle"}).exit == 2);
  // A sheet no file can hold.
  Triangle wild;
  wild.spoil_sheet = [](DrawnSheet& drawn) {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    drawn.sheet.figure.marks.push_back(drawings::Dot{{nothing, 0}, drawings::Meaning::link, "nowhere"});
  };
  const Ran ran = run_on(wild, {"draw", "triangle", "-o", "t.pdf"});
  CHECK(ran.exit == 70);
  CHECK(ran.err.starts_with("epure: internal error: "));
  CHECK(contents("t.pdf") == before);
  CHECK(scratch.files() == Typed{"t.pdf"});
}

TEST_CASE("what the machine lacks is no internal error") {
  const Scratch scratch;
  Triangle lacking;
  lacking.spoil_sheet = [](DrawnSheet&) { throw std::bad_alloc(); };
  const Ran memory = run_on(lacking, {"draw", "triangle"});
  CHECK(memory.exit == 3);
  CHECK(memory.err == "epure: there is not enough memory for this\n");
  lacking.spoil_sheet = [](DrawnSheet&) { throw drawings::Unavailable("the font x.otf is missing", "manca x.otf"); };
  const Ran font = run_on(lacking, {"draw", "triangle", "--lang", "it"});
  CHECK(font.exit == 3);
  CHECK(font.err == "epure: manca x.otf\n");
  CHECK(scratch.files().empty());
}

TEST_CASE("a full standard output is exit 3 for every verb") {
  for (const Typed& words : {Typed{"list"},
                             {"list", "triangle"},
                             {"check", "triangle"},
                             {"check", "triangle", "--json"},
                             {"draw", "triangle", "-o", "-"},
                             {"--help"},
                             {"--version"}}) {
    CAPTURE(words);
    std::ofstream full("/dev/full");
    REQUIRE(full);
    std::ostringstream err;
    Catalogue catalogue;
    catalogue.emplace_back(std::make_unique<Triangle>());
    CHECK(run_cli(catalogue, words, full, err) == 3);
    CHECK(err.str() == "epure: cannot write to standard output: No space left on device\n");
  }
}

TEST_CASE("check prints tables and ends with one line of totals") {
  const Ran ran = run({"check", "triangle"});
  CHECK(ran.exit == 0);
  CHECK(ran.out ==
        "triangle: A right triangle (euclid, I.47)\n"
        "  a = 0.3 m, b = 0.4 m, load = 0 N, shift = 0 m\n"
        "  Routes: a ruler, b analytic\n"
        "  Sheets: 1 sides, 2 small\n"
        "\n"
        "  quantity  value       routes  on sheet\n"
        "  c         0.5 m       ab      0.500002 ± 2e-05 (1)\n"
        "                                0.499991 ± 4e-05 (2)\n"
        "  c_x       0.3 m       ab      0.299999 ± 1e-05 (1)\n"
        "  c_y       -0.4 m      ab      -0.400003 ± 1e-05 (1)\n"
        "  omega     -2.5 rad/s  ab\n"
        "  angle     0.75 rad    ab\n"
        "\n"
        "  quantity  printed  by      value  difference  verdict\n"
        "  c         0.5      ruler   0.5    0 %         rounding\n"
        "            0.51     ruler   0.5    +2 %        reading\n"
        "  c_y       0.7      adding  -0.4   +75 %       disagrees\n"
        "\n"
        "  c_y printed 0.7: the catheti were added\n"
        "\n"
        "passed: 5 quantities; printed: 1 rounding, 1 reading, 1 disagree\n");
  const std::string both = run_on_two({"check", "all"}).out;
  CHECK(contains(both, "\nother: 4 quantities, 2 routes, passed\n"));
  CHECK(contains(both, "\ntriangle: 5 quantities, 2 routes, passed\n"));
  CHECK(both.ends_with("\npassed: 9 quantities; printed: 2 rounding, 2 reading, 2 disagree\n"));
}

TEST_CASE("what does not exist is said once, with the reason") {
  Triangle still;
  still.spoil_values = [](auto& values) {
    for (const std::string quantity : {"omega", "angle"})
      for (const std::string route : {"ruler", "analytic"})
        value_of(values, quantity, route) = absent("it is at rest");
  };
  const Ran ran = run_on(still, {"check", "triangle"});
  CHECK(ran.exit == 0);
  CHECK(contains(ran.out, "omega     absent"));
  CHECK(contains(ran.out, "\n  omega, angle: it is at rest\n"));
}

TEST_CASE("a check that fails says why, and exits with 1") {
  Triangle wrong;
  wrong.spoil_values = [](auto& values) { value_of(values, "c", "analytic") = certain(0.6); };
  const Ran ran = run_on(wrong, {"check", "triangle"});
  CHECK(ran.exit == 1);
  CHECK(ran.err.empty());
  CHECK(contains(ran.out, "FAILED c: in [0.5, 0.5] by ruler, but in [0.6, 0.6] by analytic"));
  CHECK(ran.out.ends_with("\nFAILED: 1 of 5 quantities; printed: 1 rounding, 1 reading, 1 disagree\n"));
  CHECK(contains(run_on(wrong, {"check", "triangle", "--lang", "it"}).out,
                 "FALLITO c: in [0,5; 0,5] (ruler), ma in [0,6; 0,6] (analitica)"));
}

TEST_CASE("what is undecided, and nothing worse, is exit 4") {
  Triangle open;
  open.spoil_values = [](auto& values) { value_of(values, "omega", "analytic") = undecided("whether it turns"); };
  const Ran ran = run_on(open, {"check", "triangle"});
  CHECK(ran.exit == 4);
  CHECK(contains(ran.out, "omega     -2.5 rad/s  ab?"));
  CHECK(contains(ran.out, "  UNDECIDED omega: undecided by analytic (whether it turns)\n"));
  CHECK(ran.out.ends_with("\nUNDECIDED: 1 of 5 quantities; printed: 1 rounding, 1 reading, 1 disagree\n"));
  Triangle worse = open;
  worse.spoil_values = [](auto& values) {
    value_of(values, "omega", "analytic") = undecided("whether it turns");
    value_of(values, "omega", "ruler") = undecided("whether it turns");
    value_of(values, "c", "analytic") = certain(0.6);
  };
  const Ran both = run_on(worse, {"check", "triangle"});
  CHECK(both.exit == 1);
  CHECK(contains(both.out, "omega     undecided"));
  CHECK(contains(both.out, "  UNDECIDED omega: undecided by ruler, analytic (whether it turns)\n"));
  worse.spoil_values = [](auto& values) {
    for (const std::string name : {"omega", "angle"})
      value_of(values, name, "analytic") = undecided("whether it turns");
  };
  CHECK(contains(run_on(worse, {"check", "triangle"}).out,
                 "  UNDECIDED omega, angle: undecided by analytic (whether it turns)\n"));
  CHECK(contains(both.out, "FAILED: 1 of 5 quantities, 1 undecided; printed: "));
}

TEST_CASE("a sheet that cannot be decided does not sink the others") {
  const Scratch scratch;
  Triangle open;
  open.spoil_sheet = [](DrawnSheet& drawn) {
    if (drawn.sheet.id == "triangle-small") throw geometry::Undecided("whether it is small");
  };
  const Ran drawn = run_on(open, {"draw", "triangle"});
  CHECK(drawn.exit == 4);
  CHECK(drawn.out == "out/triangle.pdf\nout/triangle-sides.svg\n");
  CHECK(drawn.err == "epure: triangle/small cannot be drawn, as it cannot be decided: whether it is small\n");
  CHECK(scratch.files() == Typed{"out/triangle-sides.svg", "out/triangle.pdf"});
  const Ran one = run_on(open, {"draw", "triangle/small"});
  CHECK(one.exit == 4);
  CHECK(one.err == "epure: cannot be decided: whether it is small\n");
  CHECK(one.out.empty());
  CHECK(scratch.files().size() == 2);
  const Ran checked = run_on(open, {"check", "triangle"});
  CHECK(checked.exit == 4);
  CHECK(contains(checked.out, "  UNDECIDED sheet small: whether it is small\n"));
  CHECK(contains(checked.out, "c         0.5 m       ab      0.500002 ± 2e-05 (1)"));
  CHECK(checked.out.ends_with("\nUNDECIDED: 1 sheet; 5 quantities; printed: 1 rounding, 1 reading, 1 disagree\n"));
}

TEST_CASE("one of several exercises that fails makes the whole check fail") {
  const auto spoilt = [](const std::string& id) {
    auto triangle = std::make_unique<Triangle>();
    triangle->description.id = id;
    if (id == "wrong")
      triangle->spoil_values = [](auto& values) { value_of(values, "c", "analytic") = certain(0.6); };
    return triangle;
  };
  for (const Typed& order : {Typed{"right", "wrong"}, Typed{"wrong", "right"}}) {
    Catalogue catalogue;
    for (const std::string& id : order) catalogue.emplace_back(spoilt(id));
    std::ostringstream out, err;
    CHECK(run_cli(catalogue, {"check", "all"}, out, err) == 1);
  }
}

TEST_CASE("a rung that can say nothing is undecided, in one sentence") {
  Triangle open;
  open.spoil_values = [](auto&) { throw geometry::Undecided("whether it closes"); };
  const Ran ran = run_on(open, {"check", "triangle", "--arithmetic", "bounded"});
  CHECK(ran.exit == 4);
  CHECK(ran.err == "epure: cannot be decided: whether it closes\n");
}

TEST_CASE("measured numbers decide the exit code") {
  CHECK(run({"check", "triangle", "--measured", "c=0.51m"}).exit == 0);
  const Ran beyond = run({"check", "triangle", "--measured", "c=0.52", "--measured", "c_x=300mm"});
  CHECK(beyond.exit == 1);
  CHECK(contains(beyond.out,
                 "  c measured 0.52: computed 0.5 m, difference +0.02 (+4 %), allowed 0.01 (0.5 mm\n"
                 "    on sheet small): beyond reading\n"));
  CHECK(contains(beyond.out, "c_x measured 300mm: computed 0.3 m, difference +0 (0 %)"));
  CHECK(contains(beyond.out, "\nFAILED: 1 of 5 quantities; measured: 1 of 2 within reading\n"));
  CHECK(run({"check", "triangle", "--measured", "c=0.52", "--reading", "1mm"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "c=0.52", "--reading", "1"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "omega=-2.5rad/s"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "omega=+2.5"}).exit == 1);
  CHECK(run({"check", "triangle", "--measured", "angle=0.76rad"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "angle=0.8rad"}).exit == 1);  // one digit
  CHECK(run({"check", "triangle", "--set", "a=0.2", "--measured", "c_x=0.2"}).exit == 0);
  CHECK(run_on_two({"check", "all", "--measured", "omega=2.5"}).exit == 0);  // one of the two has it
  refused({"check", "triangle", "--measured", "omga=1"}, "did you mean omega?");
  refused({"check", "triangle", "--measured", "omega"}, "write name=value");
  refused({"check", "triangle", "--measured", "=1"}, "write name=value");
  CHECK(run({"check", "triangle", "--measured", "c=0,5"}).exit == 0);
  refused({"check", "triangle", "--measured", "c=1,234.5"}, "point or comma");
  refused({"check", "triangle", "--measured", "c="}, "--measured c: \"\" is empty");
  refused({"check", "triangle", "--measured", "c=1s"}, "time where a length");
  for (const std::string bad : {"0", "-1mm", "1s", "2m", "x", ""})
    refused({"check", "triangle", "--reading", bad}, "--reading");
}

TEST_CASE("an internal error is not called the user's, and stays one line") {
  Triangle broken;
  broken.spoil_values = [](auto&) { throw std::logic_error("assertion\nviolated"); };
  const Ran ran = run_on(broken, {"check", "triangle"});
  CHECK(ran.exit == 70);
  CHECK(ran.out.empty());
  CHECK(ran.err == "epure: internal error: assertion?violated; please report it with the command that led to it\n");
}

TEST_CASE("a measured number no ruler gives is refused") {
  for (const std::string size : {"1e400", "-1e400", "1.1e60", "0e400"})
    refused({"check", "triangle", "--measured", "c=" + size},
            "--measured c: \"" + size + "\" must lie between -1e60 and 1e60 m");
  CHECK(run({"check", "triangle", "--measured", "c=1e12"}).exit == 1);
  CHECK(run({"check", "triangle", "--measured", "c=1e-400"}).exit == 1);
}

TEST_CASE("angles may be measured in degrees, and angular velocities in turns") {
  CHECK(run({"check", "triangle", "--measured", "angle=43deg"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "angle=42 °"}).exit == 1);
  CHECK(run({"check", "triangle", "--measured", "omega=24rpm"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "omega=-23.9 giri/min"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "omega=25rpm"}).exit == 1);
  refused({"check", "triangle", "--measured", "c=30deg"}, "is an angle where a length is asked");
  refused({"check", "triangle", "--measured", "c=3rad/s"}, "is an angular velocity");
}

TEST_CASE("a scale beyond all sense is refused with the bounds") {
  for (const std::string scale : {"1:1000000000000", "1:1e400", "1e400", "1000001:1", "1:1000001"})
    refused({"draw", "triangle", "--scale", scale}, scale + ": a scale must lie between 1:1000000 and 1000000:1");
  CHECK(run({"draw", "triangle", "-o", "-", "--scale", "1:1000000"}).exit == 0);
}

TEST_CASE("a folder without a name is refused") {
  const Scratch scratch;
  refused({"draw", "triangle", "--out", ""}, "--out \"\" names no folder");
  CHECK(scratch.files().empty());
}

TEST_CASE("list knows all, and says what is a sheet") {
  CHECK(run_on_two({"list"}).out.starts_with(run_on_two({"list", "all"}).out));
  refused({"list", "triangle/sides"}, "\"triangle/sides\" is a sheet; epure list triangle shows its exercise");
  refused({"list", "triangle/sides", "--json"},
          "\"triangle/sides\" is a sheet; epure list triangle shows its exercise");
  refused({"list", "triangel", "--json"}, "there is no exercise \"triangel\"");
}

TEST_CASE("letters on a terminal bear no markup") {
  CHECK(unicode_symbol("$\\it{M}_{12}$") == "M₁₂");
  CHECK(unicode_symbol("d$\\it{E}_{k}$/d$t$") == "dE_k/dt");
  CHECK(unicode_symbol("$\\vec{v}_{BA}$") == "v_BA");
  CHECK(unicode_symbol("$x_{G_{3'}}$, $x_{G_{3B}}$, $x_{}$, $x_{A") == "x_G₃', x_G_3B, x_, x_A");
}

TEST_CASE("a symbol may be typed as the sheet writes it") {
  Triangle greek;
  greek.description.givens.push_back(
      {.symbol = "alpha_2", .meaning = {}, .unit = "1", .stated = "1", .letters = "$α_{2}$"});
  CHECK(run_on(greek, {"check", "triangle", "--set", "α₂=2"}).exit == 0);
  CHECK(contains(run_on(greek, {"check", "triangle", "--set", "α₂=2"}).out, "alpha_2 = 2"));
  CHECK(contains(run_on(greek, {"check", "triangle", "--set", "α₂=2", "--set", "alpha_2=3"}).err, "set twice"));
  CHECK(run({"check", "triangle", "--measured", "ω=2.5"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "c₀=0.52"}).exit == 1);
  CHECK(run_on_two({"check", "all", "--measured", "φ=0.75"}).exit == 0);
  greek.change_quantities([](auto& all) { all[4].symbol = "$ω$"; });
  const Ran several = run_on(greek, {"check", "triangle", "--measured", "ω=2.5"});
  CHECK(several.exit == 2);
  CHECK(contains(several.err, "\"ω\" may mean several; write omega or angle"));
}

TEST_CASE("the report shows nothing finer than a sheet can hold") {
  Triangle noisy;  // c_y is zero, and drawn a breath beside it
  noisy.spoil_values = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) value_of(values, "c_y", route) = certain(1e-13);
  };
  noisy.spoil_sheet = [](DrawnSheet& drawn) {
    for (Measurement& each : drawn.measurements)
      if (each.quantity == "c_y") each.to.y = each.from.y + 1e-11;
  };
  const std::string out = run_on(noisy, {"check", "triangle"}).out;
  CAPTURE(out);
  CHECK(contains(out, "  c_y       1e-13 m     ab      0 ± 1e-05 (1)"));
}
