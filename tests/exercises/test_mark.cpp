// Marking, on the triangle: c = 0.5 m, c_x = 0.3 m, c_y = -0.4 m, drawn at 1:10 on sheet sides and c at 1:20 on sheet
// small; omega = -2.5 rad/s and angle = 0.75 rad, not drawn.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "exercises/cli/csv_reader.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

using Typed = std::vector<std::string>;

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void write_file(const std::string& name, const std::string& text) { std::ofstream(name, std::ios::binary) << text; }

// Marks what is in answers.csv, to standard output as CSV or as text.
Ran marked(const std::string& answers, Typed options = {}) {
  write_file("answers.csv", answers);
  Typed words = {"mark", "triangle", "--answers", "answers.csv"};
  words.insert(words.end(), options.begin(), options.end());
  return run(words);
}

// The one row of marks, read back: by the names of its columns.
std::string cell_of(const std::string& answers, const std::string& column, Typed options = {}) {
  options.insert(options.end(), {"--format", "csv"});
  const Ran ran = marked(answers, options);
  CAPTURE(ran.err, ran.out);
  REQUIRE(ran.exit == 0);
  const CsvTable table = read_csv(ran.out, "marks");
  return table.rows.at(0).cells.at(table.needed_column(column));
}
std::string remark_of(const std::string& quantity, const std::string& answer, const Typed& options = {}) {
  return cell_of(quantity + "\n\"" + answer + "\"\n", "remarks", options);
}

void refused_marking(const std::string& answers, const std::string& why, const Typed& options = {}, int exit = 2) {
  const Ran ran = marked(answers, options);
  CAPTURE(answers, ran.err);
  CHECK(ran.exit == exit);
  CHECK(ran.out.empty());
  CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
  CHECK(tells(ran.err, why));
}

// Of one column that is asked; the verdict on an answer to it.
std::string judged(const std::string& quantity, const std::string& answer, const Typed& options = {}) {
  return cell_of(quantity + "\n\"" + answer + "\"\n", quantity + " verdict", options);
}

}  // namespace

TEST_CASE("a class is marked: a line a student, points, and why not") {
  const Scratch scratch;
  const Ran ran = marked(
      "number;name;c;c_x;omega\n"
      "101;Anna Rossi;0,51;0,3;-2,5\n"
      "102;Bruno;1,0;0,3;abc\n"
      "103;Carla;;0,4;+2,5\n");
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  CHECK(ran.out ==
        "triangle: A right triangle\n"
        "\n"
        "  number  name        c  c_x  omega  points\n"
        "  101     Anna Rossi  ✓  ✓    ✓      3\n"
        "  102     Bruno       ½  ✓    ✗      1.5\n"
        "  103     Carla       –  ½    ½      1\n"
        "\n"
        "  ✓ right, ½ slip, ✗ wrong, – no answer, ? not marked\n"
        "\n"
        "  102 c: 1 m, true 0.5 ± 0.01: twice too large (factor 2)\n"
        "  102 omega: \"abc\" does not begin with a finite number; write a number such as\n"
        "    0.25rad/s or 1/4rad/s\n"
        "  103 c_x: 0.4 m, true 0.3 ± 0.005: this is c_y\n"
        "  103 omega: 2.5 rad/s, true -2.5 ± 0.025: the opposite sense\n"
        "\n"
        "  Tolerances, as for 101:\n"
        "    c: 0.5 ± 0.01 (0.5 mm on sheet small)\n"
        "    c_x: 0.3 ± 0.005 (0.5 mm on sheet sides)\n"
        "    omega: -2.5 ± 0.025 (0.5 mm in each of two lines of 100 mm)\n"
        "\n"
        "3 students, 5.5 points of 9, mean 1.83 of 3 (61 %); answers: right 4, slips 3,\n"
        "  wrong 1, missing 1, not marked 0\n");
}

TEST_CASE("the same in Italian") {
  const Scratch scratch;
  const Ran ran = marked("number,c\n7,\"1,0\"\n", {"--lang", "it"});
  CHECK(tells(ran.out, "  7 c: 1 m, vero 0,5 ± 0,01: doppia del vero (fattore 2)\n"));
  CHECK(tells(ran.out, "1 studente, 0,5 punti su 1, media 0,5 su 1 (50 %)"));
  CHECK(tells(ran.out, "numero  nome  c  punti"));
  CHECK(tells(ran.out, "Tolleranze, come per 7:\n    c: 0,5 ± 0,01 (0,5 mm sulla tavola small)"));
}

TEST_CASE("marks as CSV, and into a file") {
  const Scratch scratch;
  const std::string answers = "number;name;c;c_y\n1;\"Rossi, \"\"Nina\"\"\";0,5;0,7\n2;B;x;\n";
  const std::string expected =
      "number,name,c points,c verdict,c_y points,c_y verdict,total,remarks\r\n"
      "1,\"Rossi, \"\"Nina\"\"\",1,right,0.5,slip,1.5,\"c_y: 0.7 m, true -0.4 ± 0.005: the number that the source "
      "printed\"\r\n"
      "2,B,0,wrong,0,no answer,0,\"c: \"\"x\"\" does not begin with a finite number; write a number such as 0.25m or "
      "1/4m\"\r\n";
  CHECK(marked(answers, {"--format", "csv"}).out == expected);
  CHECK(marked(answers, {"--format", "CSV", "-o", "-"}).out == expected);
  const Ran into_file = marked(answers, {"-o", "marks.csv"});
  CHECK(into_file.exit == 0);
  CHECK(into_file.out == "marks.csv\n");
  CHECK(contents("marks.csv") == expected);
  CHECK(marked(answers, {"-o", "marks.txt"}).exit == 0);
  CHECK(contents("marks.txt") == marked(answers).out);
  refused_marking(answers, "cannot write", {"-o", "answers.csv/marks.csv"}, 3);
  refused_marking(answers, "\"pdf\" is no format of marks", {"--format", "pdf"});
  refused_marking(answers, "is not the ending of --format text", {"-o", "marks.csv", "--format", "text"});
  for (const char* name : {"f.pdf", "f.SVG", "f.html"}) {
    refused_marking(answers, "ends as another format does; what is written here is text or csv", {"-o", name});
    CHECK_FALSE(std::filesystem::exists(name));
  }
}

TEST_CASE("the tolerance is that of the sheet, of the scale said, of the student's own") {
  const Scratch scratch;
  CHECK(judged("c", "0.51") == "right");  // 1:20
  CHECK(judged("c", "0.511") == "wrong");
  CHECK(judged("c", "0.505", {"--sheet", "sides"}) == "right");  // 1:10
  CHECK(judged("c", "0.506", {"--sheet", "sides"}) == "wrong");
  CHECK(judged("c", "0.5025", {"--scale", "1:5"}) == "right");
  CHECK(judged("c", "0.503", {"--scale", "1:5"}) == "wrong");
  CHECK(judged("c", "0.503", {"--scale", "1:5", "--reading", "1mm"}) == "right");
  for (const std::string own :
       {"1:5", "1 : 5", "1/5", "1 cm = 5 cm", "1 cm ≙ 0,05 m", "50 mm per cm", "0.1 m al 2 cm"}) {
    CAPTURE(own);
    CHECK(cell_of("c;scale\n0,5025;" + own + "\n", "c verdict", {"--scale", "1:50"}) == "right");
    CHECK(cell_of("c;scale\n0,503;" + own + "\n", "c verdict", {"--scale", "1:50"}) == "wrong");
  }
  for (const char* head : {"Scale", "SCALA", "Scala lunghezze"})
    CHECK(cell_of("c;" + std::string(head) + "\n0,5025;1:5\n", "c verdict", {"--scale", "1:50"}) == "right");
  // A scale of velocities is none of lengths; one that cannot be read is said, and left out.
  CHECK(cell_of("c;scale_velocity\n0,51;1 cm = 2 m/s\n", "c verdict") == "right");
  CHECK(cell_of("c;scale_velocity\n0,53;1 cm = 2 m/s\n", "c verdict") == "wrong");
  const Ran two = marked("number;c;scale\n1;0,503;1:5\n2;0,503;1:10\n3;0,503;\n4;0,503;1:5\n", {"--format", "csv"});
  CHECK(tells(two.out, "1,,0,wrong,0,"));
  CHECK(tells(two.out, "2,,1,right,1,"));
  CHECK(tells(two.out, "3,,1,right,1,"));
  CHECK(tells(two.out, "4,,0,wrong,0,"));
  CHECK(cell_of("c;scale\n0,51;about 1:5\n", "c verdict") == "right");
  CHECK(tells(cell_of("c;scale\n0,51;about 1:5\n", "remarks"), "scale \"about 1:5\" is left out: "));
  CHECK(tells(cell_of("c;scale\n0,51;1 cm = 2 parsec\n", "remarks"), "\"2 parsec\" has no unit that is known"));
  CHECK(tells(cell_of("c;scale\n0,51;1 cm = -2 m\n", "remarks"), "is left out"));
}

TEST_CASE("more digits are never worth less than the reading, fewer no more than they say") {
  const Scratch scratch;
  for (const std::string right : {"0.5", "0.50", "0.5099999999", "0.49000000001", "51cm", "0.49e0"})
    CHECK(judged("c", right) == "right");
  // Half a unit of the last digit counts when the number has two: 2.6 ± 0.05 does not reach 2.5, 2.5 does 2.53.
  CHECK(judged("omega", "-2.5", {"--reading", "0.0001mm"}) == "right");
  CHECK(judged("angle", "0.75", {"--reading", "0.0001mm"}) == "right");
  CHECK(judged("omega", "-2.53", {"--reading", "0.0001mm"}) == "wrong");
  CHECK(judged("omega", "-2.45", {"--reading", "0.0001mm"}) == "wrong");
  CHECK(judged("c", "5.05e-1", {"--reading", "0.0001mm"}) == "wrong");
  CHECK(judged("c", "50.4 cm", {"--reading", "0.0001mm"}) == "wrong");
  CHECK(judged("c", "50 cm", {"--reading", "0.0001mm"}) == "right");
  for (const char* power : {"5.0·10^-1", "5.0×10^-1 m", "50.0*10^1 mm"}) CHECK(judged("c", power) == "right");
  for (const std::string empty_words : {"0", "1", "0e0", "1e0", "0.6"}) {  // 0.6 ± 0.05 would not reach 0.5 anyway
    CAPTURE(empty_words);
    CHECK(judged("c", empty_words) != "right");
  }
}

TEST_CASE("slips are named") {
  const Scratch scratch;
  const auto slip = [](const std::string& quantity, const std::string& answer, const std::string& why) {
    CAPTURE(quantity, answer);
    CHECK(judged(quantity, answer) == "slip");
    CHECK(remark_of(quantity, answer).ends_with(": " + why));
  };
  slip("c", "1", "twice too large (factor 2)");
  slip("c", "0.25", "half of it (factor 1/2)");
  slip("c", "5.01", "10 times too large (factor 10)");
  slip("c", "500", "10^3 times too large (factor 10^3)");
  slip("c", "0.005", "10^2 times too small (factor 1/10^2)");
  slip("c_x", "-0.3", "the opposite sense");
  slip("c_y", "+0.4", "the opposite sense");
  slip("c_x", "0.4", "this is c_y");
  slip("c_y", "0.7", "the number that the source printed");
  slip("omega", "23.87", "rpm taken for rad/s (factor 30/π)");
  slip("omega", "-0.2618", "rad/s taken for rpm (factor π/30)");
  slip("omega", "143.2", "degrees taken for radians (factor 180/π)");
  // sqrt(0.6^2 + 0.4^2), sqrt(0.3^2 + 0.2^2): by hand
  slip("c", "0.7211", "a doubled (diameter for radius)");
  slip("c", "0.3606", "b halved (radius for diameter)");
  CHECK(judged("c", "0.62") == "wrong");
  CHECK(judged("c_x", "-0.31") == "wrong");
}

TEST_CASE("the source's number is a slip only where its givens are") {
  const Scratch scratch;
  CHECK(judged("c_y", "0.7", {"--set", "a=0.2"}) == "wrong");
  CHECK(judged("c_y", "0.7") == "slip");
}

TEST_CASE("points and the share of a slip") {
  const Scratch scratch;
  const std::string answers = "c;c_x\n1,0;0,3\n";
  CHECK(cell_of(answers, "total") == "1.5");
  CHECK(cell_of(answers, "total", {"--slip-points", "0,25"}) == "1.25");
  CHECK(cell_of(answers, "total", {"--slip-points", "0"}) == "1");
  CHECK(cell_of(answers, "total", {"--points", "c=4"}) == "3");
  CHECK(cell_of(answers, "total", {"--points", "c=4,c_x=0.1"}) == "2.1");
  CHECK(cell_of(answers, "c points", {"--points", "c=4,c_x=0.1"}) == "2");
  refused_marking(answers, "--slip-points 2: must lie between 0 and 1", {"--slip-points", "2"});
  refused_marking(answers, "--points c -1: must lie between 0 and 1000", {"--points", "c=-1"});
  refused_marking(answers, "\"c\" gives no points; write v_B=2,omega_3=1.5", {"--points", "c"});
  refused_marking(answers, "the answers have no column \"omega\"", {"--points", "omega=2"});
  refused_marking(answers, "c is given twice", {"--points", "c=1,c=2"});
}

TEST_CASE("each student's own givens, from the key or the answers") {
  const Scratch scratch;
  write_file(
      "key.csv",
      "number,name,date,a,c,c_x\n1,A,,0.6m,0.7211102550927978,0.6\n2,B,,30cm,0.5,0.3\n3,C,,0.2,0.4472135955,0.2\n"
      "9,Late,,0.3,0.5,0.3\n");
  const std::string answers = "number,c,c_x\n1,0.72,0.6\n2,0.50,0.6\n3,0.447,0.2\n4,0.5,0.3\n";
  const Ran ran = marked(answers, {"--key", "key.csv", "--format", "csv"});
  CHECK(ran.exit == 0);
  // Nothing of values: 0.4472135955 is the value as far as it goes.
  CHECK(ran.err == "epure: answers.csv: not in key.csv: 4 (1 of 4 students)\n");
  CHECK(tells(ran.out, "1,,1,right,1,right,2,\r\n2,,1,right,0.5,slip,1.5,"));
  CHECK(tells(ran.out, "3,,1,right,1,right,2,\r\n"));
  CHECK(tells(ran.out, "4,,,not marked,,not marked,0,not marked: the key has no such number\r\n"));
  CHECK(tells(ran.out, "\n9,Late,,,,,,\"absent: in the key, and without answers\"\r\n"));
  CHECK(tells(marked(answers, {"--key", "key.csv"}).out, "In the key, and without answers: 9 Late\n"));
  CHECK(tells(marked(answers, {"--key", "key.csv"}).out,
              "4 students, 5.5 points of 6,"));  // the absent are not among them
  // More than half of them missing is another class, half of them is not.
  write_file("key.csv", "number,a\n1,0.6m\n");
  CHECK(marked("number,c\n1,0.72\n2,0.5\n", {"--key", "key.csv"}).err ==
        "epure: answers.csv: not in key.csv: 2 (1 of 2 students)\n");
  CHECK(marked("number,c\n1,0.72\n2,0.5\n3,1\n", {"--key", "key.csv"}).err ==
        "epure: answers.csv: not in key.csv: 2, 3 (2 of 3 students); is it the key of another class?\n");
  // A slip in a key is told; a key that is nobody's marks nobody.
  write_file("key.csv", "number,a,c\n1,0.6m,0.73\n2,0.3,0.5\n");
  const Ran other = marked("number,c\n1,0.72\n2,0.5\n", {"--key", "key.csv"});
  CHECK(other.exit == 0);
  CHECK(other.err ==
        "epure: 1 c: 0.73 in the key's line 2, but 0.72111 is true: is it the key of another version, or of other "
        "--set?\n");
  write_file("key.csv", "number,a,c\n1,0.6m,0.73\n2,0.3,0.6\n");
  refused_marking(
      "number,c\n1,0.72\n2,0.5\n",
      "epure: 1 c: 0.73 in the key's line 2, but 0.72111 is true: is it the key of another version, or of "
      "other --set? (1 more like it)\n",
      {"--key", "key.csv"});
  // Without a key: the answers' own givens, else --set.
  CHECK(cell_of("a,c\n0.6m,0.72\n", "c verdict") == "right");
  CHECK(cell_of("a [cm],c [cm]\n60,72\n", "c verdict") == "right");
  CHECK(cell_of("a,c\n,0.72\n", "c verdict", {"--set", "a=0.6"}) == "right");
  CHECK(cell_of("c\n0.72\n", "c verdict", {"--set", "a=0.6"}) == "right");
  CHECK(tells(cell_of("a,c\n-1,0.72\n", "remarks"), "not marked, because of the givens: a = -1: must be positive"));
  CHECK(tells(cell_of("a,c\nx,0.72\n", "remarks"), "not marked, because of the givens: a: \"x\""));
}

TEST_CASE("a name that a given and a quantity have") {
  const Scratch scratch;
  Triangle triangle;
  triangle.change_quantities([](auto& all) { all.push_back({"b", "$b$", "m", {"height", "altezza"}}); });
  triangle.spoil_values = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) values.push_back({"b", route, certain(0.4)});
  };
  write_file("answers.csv", "number,b,c\n1,0.4,0.5\n");
  const auto marks = [&](const std::string& key) {
    write_file("key.csv", key);
    return run_on(triangle, {"mark", "triangle", "--answers", "answers.csv", "--key", "key.csv", "--format", "csv"});
  };
  // To the right of a quantity it is the quantity, which differs; left of all of them the given.
  const Ran as_quantity = marks("number,c,b\n1,0.5,0.7\n");
  CHECK(tells(as_quantity.err, "1 b: 0.7 in the key's line 2, but 0.4 is true"));
  CHECK(as_quantity.exit == 2);
  const Ran as_given = marks("number,b,c\n1,0.6m,0.6708203932499369\n");
  CHECK(as_given.err.empty());
  CHECK(tells(as_given.out, "1,,1,right,0,wrong,1,"));
  const Ran as_both = marks("number,b,b,c\n1,0.6m,0.4,0.6708203932499369\n");
  CHECK(as_both.err.empty());
  CHECK(tells(as_both.out, "1,,1,right,0,wrong,1,"));
  CHECK(marks("number,b,b,b\n1,0.6m,0.4,0.4\n").err == "epure: key.csv: there are two columns for b\n");
  write_file("answers.csv", "b,b,c\n0.6,0.4,0.67\n");
  const Ran own = run_on(triangle, {"mark", "triangle", "--answers", "answers.csv", "--format", "csv"});
  CHECK(tells(own.out, ",,1,right,1,right,2,"));
}

TEST_CASE("columns are told by name or letters, with a unit or none") {
  const Scratch scratch;
  CHECK(cell_of("c [cm]\n51\n", "c verdict") == "right");
  CHECK(cell_of("c[mm]\n510 mm\n", "c verdict") == "right");
  CHECK(cell_of("c [cm]\n0.51 m\n", "c verdict") == "right");
  CHECK(cell_of("ω;number\n-2,5;1\n", "omega verdict") == "right");
  CHECK(cell_of("omega [rpm]\n-23.9\n", "omega verdict") == "right");
  CHECK(cell_of("angle [deg]\n43\n", "angle verdict") == "right");
  refused_marking("c [s]\n1\n", "answers.csv, column \"c [s]\": \"1 s\" is a time where a length is asked");
  refused_marking("q\n1\n", "answers.csv: no column is a quantity of triangle");
  refused_marking("c,c [cm]\n1,1\n", "answers.csv: there are two columns for c");
  refused_marking("number\n1\n", "answers.csv: no column is a quantity of triangle");
  refused_marking("c\n", "a header and no row");
  refused_marking("c\n1\n2\n", "answers.csv: a column \"number\" (or \"matricola\") is missing; there are c");
  refused_marking("number,c\n1,1\n1,2\n", "answers.csv, line 3: number 1 stands in line 2 already");
  refused_marking("number,c\n1,1,2\n", "answers.csv, line 2: fields: 3");
  write_file("key.csv", "name,a\nx,1\n");
  refused_marking("number,c\n1,1\n", "key.csv: a column \"number\" (or \"matricola\") is missing",
                  {"--key", "key.csv"});
  refused_marking("c\n1\n", "cannot read none.csv", {"--key", "none.csv"});
  refused_marking("c\n1\n", "--sheet: there is no sheet \"side\"; did you mean sides?", {"--sheet", "side"});
  CHECK(run({"mark", "triangle"}).err == "epure: say where the answers are: epure mark ID --answers FILE\n");
  CHECK(run({"mark", "--answers", "answers.csv"}).exit == 2);
  CHECK(run({"mark", "all", "--answers", "answers.csv"}).exit == 2);
}

TEST_CASE("a column that is no quantity costs itself, one that nearly is one is refused") {
  const Scratch scratch;
  const std::string answers = "Email;number;c;Note (max 20);Voto;Data\nx@y;1;0,5;late;;3/6\n";
  const Ran ran = marked(answers, {"--format", "csv"});
  CHECK(ran.exit == 0);
  CHECK(tells(ran.out, "1,,1,right,1,"));
  CHECK(ran.err ==
        "epure: answers.csv: the columns \"Email\", \"Note (max 20)\", \"Voto\" are no quantities and no givens of "
        "triangle and are left out\n");
  CHECK(tells(marked("c;Voto\n0,5;\n", {"--lang", "it"}).err,
              "answers.csv: la colonna \"Voto\" non è una grandezza né un dato di triangle ed è tralasciata"));
  for (const auto& [head, meant] : {std::pair{"omgea", "omega"},
                                    {"C_X", "c_x"},
                                    {"cx", "c_x"},
                                    {"angel (rad)", "angle"},
                                    {"omega misurata", "omega"},
                                    {"velocità omega letta", "omega"},
                                    {"c (letto) e poi", "c"}})
    refused_marking("c_y;" + std::string(head) + "\n1;1\n",
                    "is no quantity and no given of triangle; did you mean " + std::string(meant) + "?");
  // Units in parentheses, as sweep writes them.
  CHECK(cell_of("c (cm)\n51\n", "c verdict") == "right");
  CHECK(cell_of("c;;\n0,51;;\n", "c verdict") == "right");  // columns that a spreadsheet adds
}

TEST_CASE("a number of which the student was not sure counts, and that is told") {
  const Scratch scratch;
  for (const char* doubtful : {"circa 0,5", "Circa 0,5 m", "ca. 50 cm", "ca 0.5", "c.a 0.5", "about 0.5 m",
                               "approx. 0.5", "approx 0.5", "approximately 0.5", "≈ 0.5", "~0.5", "∼ 0.5", "0.5?",
                               "0.5 m ?", "0.5? m", "0,5 circa", "circa ~0.5 ± 0.1"}) {
    CAPTURE(doubtful);
    CHECK(judged("c", doubtful) == "right");
    const std::string told = remark_of("c", doubtful);
    CHECK(told.starts_with("c: \"" + std::string(doubtful) + "\" is read as "));
    CHECK(told.find_first_of("?~", told.find("read as")) == std::string::npos);
  }
  CHECK(cell_of("c\n\"circa 0,5 m\"\n", "osservazioni", {"--lang", "it", "--csv", "excel"}) ==
        "c: \"circa 0,5 m\" è letto come 0,5 m");
  CHECK(remark_of("c", "0.5 ± 0.1").empty());
  CHECK(remark_of("c", "circa 0.7") == "c: \"circa 0.7\" is read as 0.7; c: 0.7 m, true 0.5 ± 0.01");
  // Of what holds no number nothing is made.
  CHECK(judged("c", "circa boh") == "wrong");
  CHECK(judged("c", "che cosa?") == "wrong");
}

TEST_CASE("marks out of thirty") {
  const Scratch scratch;
  const std::string answers = "number,c,c_x,omega\n1,0.5,0.3,-2.5\n2,0.5,0.6,\n3,0.5,,7\n";
  const Ran ran = marked(answers, {"--out-of", "30", "--format", "csv"});
  const CsvTable marks = read_csv(ran.out, "marks");
  const std::size_t column = marks.needed_column("out of 30");
  CHECK(marks.header.at(column - 1) == "total");
  CHECK(marks.rows.at(0).cells.at(column) == "30");
  CHECK(marks.rows.at(1).cells.at(column) == "15");  // 1 + a slip of 3
  CHECK(marks.rows.at(2).cells.at(column) == "10");
  const Ran table = marked(answers, {"--out-of", "30"});
  CHECK(tells(table.out, "points  /30\n"));
  CHECK(tells(table.out, "1.5     15\n"));
  // To a tenth, a half upwards.
  CHECK(cell_of("c,c_x,omega\n0.5,,\n", "out of 10", {"--out-of", "10"}) == "3.3");
  CHECK(cell_of("c,c_x,omega\n0.5,0.3,\n", "out of 10", {"--out-of", "10"}) == "6.7");
  CHECK(cell_of("c,c_x\n0.5,\n", "out of 0.5", {"--out-of", "0.5"}) == "0.3");
  // What is not marked costs nothing.
  write_file("key.csv", "number,a\n1,0.3m\n");
  const Ran none = marked("number,c\n1,0.5\n2,0.5\n", {"--key", "key.csv", "--out-of", "30", "--format", "csv"});
  CHECK(tells(none.out, "\n1,,1,right,1,30,\r\n2,,,not marked,0,,"));
  CHECK(cell_of("number;c\n1;0,5\n", "su 30", {"--out-of", "30", "--lang", "it", "--csv", "excel"}) == "30");
  refused_marking(answers, "--out-of 0: must be more than 0", {"--out-of", "0"});
  refused_marking(answers, "--out-of -1: must lie between 0 and 1000", {"--out-of", "-1"});
  refused_marking(answers, "--out-of", {"--out-of", "trenta"});
}

TEST_CASE("what stands for no answer is none") {
  const Scratch scratch;
  for (const char* nothing : {"-", " — ", "/", "?", "n.d.", "Non so", "don't know"})
    CHECK(cell_of("c;omega\n" + std::string(nothing) + ";-2,5\n", "c verdict") == "no answer");
  CHECK(cell_of("c;omega\nboh;-2,5\n", "c verdict") == "wrong");
}

// Whose answers are mostly wrong has other givens, by all appearance; a few wrong ones say nothing.
TEST_CASE("a class that is mostly wrong is told of") {
  const Scratch scratch;
  const auto of = [](int right, int wrong) {
    std::string answers = "number;c\n";
    for (int i = 0; i < right + wrong; ++i) answers += std::to_string(i + 1) + (i < right ? ";0,5\n" : ";0,3\n");
    return marked(answers);
  };
  CHECK(of(9, 11).err ==
        "epure: only 9 of 20 answers are right: are the givens those of the sheets that were handed out (--key, "
        "--set)?\n");
  CHECK(of(10, 10).err.empty());
  CHECK(of(0, 19).err.empty());
}

TEST_CASE("numbers and units as people write them") {
  const Scratch scratch;
  for (const std::string right : {"0,50 ± 0,01", "0,50 ± 0,01 m", "0,50 m ± 1 cm", "(50 ± 1) cm", "50 +/- 1 cm",
                                  "≈ 0,5", "~0.5 m", "5.0e-1", "0,5\u202Fm"}) {
    CAPTURE(right);
    CHECK(judged("c", right) == "right");
  }
  for (const std::string right : {"−2,5", "–2,5", "-2.5 rad·s⁻¹", "-2.5 rad s^-1", "-2,5 rad s-1", "-2.5 rad/sec"}) {
    CAPTURE(right);
    CHECK(judged("omega", right) == "right");
  }
  // The unit of the cell counts before that of the column, also when a digit ends it.
  CHECK(cell_of("omega [rpm]\n\"-2,5 rad s-1\"\n", "omega verdict") == "right");
  CHECK(cell_of("c [cm]\n\"50 ± 1\"\n", "c verdict") == "right");
  CHECK(cell_of("c [cm]\n\"0,50 m ± 0,01\"\n", "c verdict") == "right");
  // What may be thousands is told, not guessed.
  CHECK(tells(remark_of("c", "1'234.5"), "more than a decimal point or comma"));
  CHECK(tells(remark_of("c", "1.234,5"), "more than a decimal point or comma"));
  CHECK(judged("c", "0,50 ±") == "wrong");
  CHECK(judged("c", "etwa 0.5") == "wrong");
  CHECK(cell_of("c [cm]\n≈ 50\n", "c verdict") == "right");
  Triangle large;
  large.spoil_values = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) value_of(values, "omega", route) = certain(1234);
  };
  write_file("answers.csv", "omega\n1.234\n");
  const Ran thousands = run_on(large, {"mark", "triangle", "--answers", "answers.csv", "--format", "csv"});
  CHECK(tells(thousands.out, "too small (factor 1/10^3); or is its \"\".\"\" a separator of thousands?"));
}

TEST_CASE("a calculated quantity that is zero may be off, too") {
  const Scratch scratch;
  Triangle still;
  still.spoil_values = [](auto& values) {
    for (const std::string route : {"ruler", "analytic"}) value_of(values, "omega", route) = certain(0);
  };
  const auto verdict = [&](const std::string& answer) {
    write_file("answers.csv", "omega\n" + answer + "\n");
    return run_on(still, {"mark", "triangle", "--answers", "answers.csv", "--format", "csv"}).out;
  };
  // Nothing drawn is of its kind: a hundredth of the unit.
  CHECK(tells(verdict("0.009"), ",right,"));
  CHECK(tells(verdict("0.011"), ",wrong,"));
}

TEST_CASE("numbers that lost their zeros are found where only one is meant") {
  const Scratch scratch;
  write_file("key.csv", "number,a\n0123456,0.6m\n0123457,0.3m\n00123458,0.3m\n0123458,0.3m\n");
  const Ran ran = marked("number,c\n123456,0.72\n123457,0.5\n123458,0.5\n", {"--key", "key.csv", "--format", "csv"});
  CHECK(ran.exit == 0);
  CHECK(tells(ran.out, "\n0123456,,1,right,1,\r\n0123457,,1,right,1,\r\n"));
  CHECK(tells(ran.out, "123458,,,not marked,0,\"not marked: the key has no such number; "));
  CHECK(tells(ran.out, "0123458 or 00123458 stands there, without answers"));
  CHECK(tells(ran.err,
              "answers.csv: numbers found in key.csv with zeros before them, which a spreadsheet takes away: "
              "123456, 123457\n"));
  CHECK(tells(ran.err, "answers.csv: not in key.csv: 123458 (1 of 3 students)\n"));
  // The other way round, and what is written twice.
  write_file("key.csv", "number,a\n7,0.6m\n8,0.3m\n");
  CHECK(
      tells(marked("number,c\n007,0.72\n8,0.5\n", {"--key", "key.csv", "--format", "csv"}).out, "\n007,,1,right,1,"));
  CHECK(tells(marked("number,c\n007,0.72\n07,0.5\n8,0.5\n", {"--key", "key.csv", "--format", "csv"}).out,
              "007,,,not marked,0,"));
  CHECK(
      tells(marked("number,c\n7,0.72\n07,0.5\n", {"--key", "key.csv", "--format", "csv"}).out, "07,,,not marked,0,"));
  write_file("key.csv", "number,a\n000,0.6m\n8,0.3m\n");
  CHECK(tells(marked("number,c\n0,0.72\n8,0.5\n", {"--key", "key.csv", "--format", "csv"}).out, "\n000,,1,right,1,"));
  // Near, and not it.
  write_file("key.csv", "number,a\n123465,0.6m\n999,0.3m\n");
  const Ran near = marked("number,c\n123456,0.72\n999,0.5\n", {"--key", "key.csv", "--format", "csv"});
  CHECK(tells(near.out, "not marked: the key has no such number; 123465 stands there, without answers"));
}

TEST_CASE("a key that is none of theirs is told, and one that is of no use refused") {
  const Scratch scratch;
  const auto refused_key = [](const std::string& key, const std::string& why) {
    write_file("key.csv", key);
    refused_marking("number,c\n1,0.5\n2,0.5\n3,0.5\n", why, {"--key", "key.csv"});
  };
  refused_key("number,a\n11,0.3m\n12,0.3m\n",
              "none of the 3 numbers in answers.csv, such as 1, stands in key.csv: is it the key of another class?");
  refused_key("number,name\n1,A\n2,B\n3,C\n", "key.csv is no key: no column is a given or a quantity of triangle");
  refused_key("number,a,v_B,P0A,v_BA\n1,0.3m,1,1,1\n",
              "key.csv is no key of triangle: 3 of its columns are no given and no quantity of it, such as \"v_B\"");
  refused_key(
      "number,a,c_\n1,0.3m,0.5\n",
      "key.csv: column \"c_\" is no quantity and no given of triangle; did you mean c? Or is it the key of another ");
  refused_key("number,a\n1,-1m\n2,-2m\n3,x\n",
              "nothing can be marked by this key; 1: not marked, because of the givens");
  refused_key("number,c\n1,0.7\n2,0.7\n3,0.5\n", "1 c: 0.7 in the key's line 2, but 0.5 is true");
  const std::string one = "number,a\n1,0.3m\n";
  write_file("key.csv", one);
  const Ran few = marked("number,c\n1,0.5\n2,0.5\n3,0.5\n", {"--key", "key.csv"});
  CHECK(few.exit == 0);
  CHECK(few.err == "epure: answers.csv: not in key.csv: 2, 3 (2 of 3 students); is it the key of another class?\n");
  write_file("key.csv", "number,a,Note\n1,0.3m,x\n");
  const Ran own = marked("number,a,c\n1,0.6,0.5\n", {"--key", "key.csv"});
  CHECK(own.exit == 0);
  CHECK(tells(own.err, "key.csv: the column \"Note\" is no quantity and no given of triangle and is left out\n"));
  CHECK(tells(own.err, "answers.csv states other givens than key.csv, which count: 1\n"));
  CHECK_FALSE(tells(marked("number,a,c\n1,30cm,0.5\n", {"--key", "key.csv"}).err, "other givens"));
}

TEST_CASE("surname and name in two columns are one name") {
  const Scratch scratch;
  const auto name_of = [](const std::string& head) {
    return cell_of(head + ";c;number\nDe Rossi;Anna;0,5;1\n", "name");
  };
  for (const std::string head : {"Cognome;Nome", "surname;name", "Last name;First name", "LAST_NAME;FIRST_NAME",
                                 "Family Name;Given Name", "cognome;nome proprio"}) {
    CAPTURE(head);
    CHECK(name_of(head) == "De Rossi Anna");
  }
  CHECK(cell_of("Nome;Cognome;c\nAnna;De Rossi;0,5\n", "name") == "Anna De Rossi");
  CHECK(cell_of("Cognome e Nome;c\nDe Rossi Anna;0,5\n", "name") == "De Rossi Anna");
  CHECK(cell_of("cognome;c\nDe Rossi;0,5\n", "name") == "De Rossi");
  CHECK(cell_of("N. Matricola;c\n7;0,5\n", "number") == "7");
  refused_marking("cognome;surname;c\na;b;0,5\n", "\"cognome\" and \"surname\" mean the same; keep one of them");
}

TEST_CASE("marks for programs and for a spreadsheet with decimal commas") {
  const Scratch scratch;
  const std::string answers = "number;name;c;c_y\n1;Anna;0,5;0,7\n2;B;1,0;\n";
  // For programs nothing depends on the language.
  CHECK(marked(answers, {"--format", "csv", "--lang", "it"}).out == marked(answers, {"--format", "csv"}).out);
  const Ran excel = marked(answers, {"--csv", "excel", "--lang", "it"});
  CHECK(excel.out ==
        "\xEF\xBB\xBFmatricola;nome;c punti;c giudizio;c_y punti;c_y giudizio;totale;osservazioni\r\n"
        "1;Anna;1;giusta;0,5;svista;1,5;c_y: 0,7 m, vero -0,4 ± 0,005: il numero stampato dalla fonte\r\n"
        "2;B;0,5;svista;0;nessuna risposta;0,5;c: 1 m, vero 0,5 ± 0,01: doppia del vero (fattore 2)\r\n");
  const CsvTable back = read_csv(excel.out, "marks");
  CHECK(back.rows.at(1).cells.at(back.needed_column("totale")) == "0,5");
  CHECK(tells(marked(answers, {"--csv", "excel"}).out, ";c points;c verdict;"));
  refused_marking(answers, "--csv: \"it\" is no style of epure's; choose plain or excel", {"--csv", "it"});
  refused_marking(answers, "--csv says how CSV is written", {"--csv", "excel", "--format", "text"});
}

TEST_CASE("what others wrote into names harms neither terminal nor spreadsheet") {
  const Scratch scratch;
  const std::string answers =
      "number;name;c\n=1+1;\x1b[31m@x;0,5\n-2;\xE2\x80\xAEgnp;0,5\n3;+39 06;0,5\n4;../../x;0,5\n";
  const Ran csv = marked(answers, {"--format", "csv"});
  CHECK(tells(csv.out, "'=1+1,?[31m@x,1,"));
  CHECK(tells(csv.out, "'-2,?gnp,1,"));
  CHECK(tells(csv.out, "3,'+39 06,1,"));
  CHECK(tells(csv.out, "4,../../x,1,"));
  const Ran text = marked(answers);
  CHECK_FALSE(tells(text.out, "\x1b"));
  CHECK(scratch.files() == Typed{"answers.csv"});
  // What would be mathematics on a sheet is none in an answer.
  CHECK(tells(cell_of("number,c\n$x,$\\vec{\n", "remarks"), "c: \"$\\vec{\" does not begin with a finite number"));
}

TEST_CASE("what is absent or undecided is not marked; the undecided is exit code 4") {
  const Scratch scratch;
  write_file("answers.csv", "number,c,omega\n1,0.5,2.5\n");
  Triangle triangle;
  const auto spoil = [&](const geometry::Settled& settled) {
    triangle.spoil_values = [settled](auto& values) {
      for (const std::string route : {"ruler", "analytic"}) value_of(values, "omega", route) = settled;
    };
    return run_on(triangle, {"mark", "triangle", "--answers", "answers.csv", "--format", "csv"});
  };
  const Ran gone = spoil(absent("no turning"));
  CHECK(gone.exit == 0);
  CHECK(tells(gone.out, "1,,1,right,,not marked,1,omega: not marked: it does not exist (no turning)\r\n"));
  const Ran open = spoil(undecided("whether it turns"));
  CHECK(open.exit == 4);
  CHECK(open.err == "epure: cannot be decided: 1 omega: whether it turns\n");
  CHECK(tells(open.out, "1,,1,right,,not marked,1,omega: not marked: undecided (whether it turns)\r\n"));
  triangle.spoil_values = [](auto&) { throw geometry::Undecided("whether it closes"); };
  const Ran all_open = run_on(triangle, {"mark", "triangle", "--answers", "answers.csv"});
  CHECK(all_open.exit == 4);
  CHECK(all_open.err == "epure: cannot be decided: 1: whether it closes\n");
}

TEST_CASE("many quantities and long names stay within 80 columns") {
  const Scratch scratch;
  Triangle triangle;
  std::string header = "number;name;c", row = "12345678901234567890;Maria Antonietta Guglielmina dei Conti;0,5";
  for (int i = 1; i <= 12; ++i) {
    triangle.change_quantities([i](auto& all) {
      all.push_back({"side_" + std::to_string(i), "$s$", "m", {"side", "lato"}});
    });
    header += ";side_" + std::to_string(i);
    row += ";2";
  }
  triangle.spoil_values = [](auto& values) {
    for (int i = 1; i <= 12; ++i)
      for (const std::string route : {"ruler", "analytic"})
        values.push_back({"side_" + std::to_string(i), route, certain(2)});
  };
  write_file("answers.csv", header + "\n" + row + "\n");
  const Ran ran = run_on(triangle, {"mark", "triangle", "--answers", "answers.csv"});
  CHECK(tells(ran.out,
              "  number          name                    a  b  c  d  e  f  g  h  i  j  points\n"
              "  1234567890123…  Maria Antonietta Gugl…  ✓  ✓  ✓  ✓  ✓  ✓  ✓  ✓  ✓  ✓  13\n"));
  CHECK(tells(ran.out,
              "  a c, b side_1, c side_2, d side_3, e side_4, f side_5, g side_6, h side_7,\n"
              "    i side_8, j side_9 (3 more: --format csv has all)\n"));
}

TEST_CASE("ten thousand students of one set of givens") {
  const Scratch scratch;
  std::string answers = "number;c;omega\n";
  for (int i = 0; i < 10000; ++i) answers += std::to_string(i) + ";0,5" + std::to_string(i % 3) + ";2,4\n";
  const Ran ran = marked(answers, {"--format", "csv"});
  CHECK(ran.exit == 0);
  CHECK(std::count(ran.out.begin(), ran.out.end(), '\n') == 10001);
  CHECK(tells(ran.out, "\r\n9998,,0,wrong,0,wrong,0,"));
  CHECK(tells(ran.out, "\r\n9999,,1,right,0,wrong,1,"));
}

TEST_CASE("check --measured has the same rules, and --quiet") {
  CHECK(run({"check", "triangle", "--measured", "c=0.503", "--scale", "1:5"}).exit == 1);
  CHECK(run({"check", "triangle", "--measured", "c=0.5025", "--scale", "1:5"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "c=0.506", "--sheet", "sides"}).exit == 1);
  CHECK(run({"check", "triangle", "--measured", "c=0.505", "--sheet", "sides"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "omega=-2.52"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "omega=-2.5199999"}).exit == 0);
  CHECK(run({"check", "triangle", "--measured", "omega=-2.53"}).exit == 1);
  CHECK(run({"check", "triangle", "--measured", "c=0.52", "--measured", "c_x=0.3", "--quiet"}).out ==
        "  c measured 0.52: computed 0.5 m, difference +0.02 (+4 %), allowed 0.01 (0.5 mm\n"
        "    on sheet small): beyond reading\n"
        "  c_x measured 0.3: computed 0.3 m, difference +0 (0 %), allowed 0.005 (0.5 mm\n"
        "    on sheet sides): within reading\n"
        "FAILED: 1 of 5 quantities; measured: 1 of 2 within reading\n");
  CHECK(run({"check", "triangle", "--quiet"}).out ==
        "passed: 5 quantities; printed: 1 rounding, 1 reading, 1 disagree\n");
}
