// Class sets: the same lots for the same seed, files whole and where they belong, keys that say what the sheets show.
#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "exercises/cli/csv_reader.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/exercise.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> lots{"--vary", "r=0.18..0.22/0.01", "--vary", "n=300|360|400", "--seed", "june"};

Ran make(std::vector<std::string> words, const std::vector<std::string>& more = lots) {
  words.insert(words.begin(), "class");
  words.insert(words.end(), more.begin(), more.end());
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), words, out, err);
  return {exit, out.str(), err.str()};
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

constexpr const char* folder = "out/slider-crank-velocity-poles-class";

CsvTable key_in(const fs::path& path) { return read_csv_file((path / folder / "key.csv").string()); }
std::string cell(const CsvTable& table, std::size_t row, const std::string& column) {
  return table.rows.at(row).cells.at(table.needed_column(column));
}

}  // namespace

TEST_CASE("class: a sheet to be solved, a solution and a line of the key for each student", "[class]") {
  const Scratch scratch;
  write("roster.csv", "number;name\r\n77;Ada Lovelace\r\n78;\"Rossi; Anna\"\r\n79;Babbage\r\n");
  const Ran ran = make({"slider-crank-velocity/poles", "--students", "roster.csv"});
  CAPTURE(ran.err);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("3 students") != std::string::npos);
  std::set<std::string> files;
  for (const std::string& file : scratch.files()) files.insert(file);
  const std::string in = std::string(folder) + "/";
  CHECK(files == std::set<std::string>{"roster.csv", in + "key.csv", in + "77-blank.pdf", in + "77-solution.pdf",
                                       in + "78-blank.pdf", in + "78-solution.pdf", in + "79-blank.pdf",
                                       in + "79-solution.pdf"});
  const CsvTable key = key_in(scratch.path());
  CHECK(cell(key, 1, "name") == "Rossi; Anna");
  for (std::size_t row = 0; row < 3; ++row) {
    // What check says of the same givens.
    std::ostringstream out, err;
    REQUIRE(run_cli(catalogue(),
                    {"check", "slider-crank-velocity", "--json", "--set", "r=" + cell(key, row, "r"), "--set",
                     "n=" + cell(key, row, "n")},
                    out, err) == 0);
    const auto report = nlohmann::json::parse(out.str()).at("exercises").at(0).at("quantities");
    for (const auto& quantity : report) {
      const std::string name = quantity.at("name"), value = cell(key, row, name);
      INFO(name);
      if (quantity.at("value").is_null()) continue;
      CHECK(std::stod(value) == Approx(quantity.at("value").get<double>()).epsilon(1e-14).margin(1e-300));
    }
  }
}

TEST_CASE("class: a student's givens depend on the seed and on the number alone", "[class]") {
  const Scratch scratch;
  write("all.csv", "number,name\n1,A\n2,B\n3,C\n");
  write("one.csv", "matricola\n3\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "all.csv", "--out", "all"}).exit == 0);
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "all.csv", "--out", "again"}).exit == 0);
  const std::string in = "/slider-crank-velocity-poles-class/";
  for (const char* file : {"key.csv", "1-blank.pdf", "2-solution.pdf"})
    CHECK(contents("all" + in + file) == contents("again" + in + file));
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "one.csv", "--out", "one"}).exit == 0);
  const CsvTable all = read_csv_file("all" + in + "key.csv"), one = read_csv_file("one" + in + "key.csv");
  for (const char* given : {"r", "n"}) CHECK(cell(all, 2, given) == cell(one, 0, given));
  std::set<std::string> drawn;
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "40", "--out", "many"}).exit == 0);
  const CsvTable many = read_csv_file("many" + in + "key.csv");
  for (std::size_t row = 0; row < 40; ++row) drawn.insert(cell(many, row, "r"));
  CHECK(drawn == std::set<std::string>{"0.18m", "0.19m", "0.2m", "0.21m", "0.22m"});
}

TEST_CASE("class: what cannot be drawn well is drawn again, and counted", "[class]") {
  const Scratch scratch;
  // Near its dead centres, and at them, the crank's circle leaves vectors too short or lines too flat.
  const Ran ran =
      make({"slider-crank-velocity/poles", "--count", "20"}, {"--vary", "phi=0deg..180deg/61", "--seed", "1"});
  CAPTURE(ran.out, ran.err);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("drawn again") != std::string::npos);
  const Ran none = make({"slider-crank-velocity/poles", "--count", "2"}, {"--vary", "r=5|6", "--seed", "1"});
  CHECK(none.exit == 2);
  CHECK(none.err.find("none of 200 variants") != std::string::npos);
}

TEST_CASE("class: a run that was stopped goes on where it stood", "[class]") {
  const Scratch scratch;
  const std::vector<std::string> words{"slider-crank-velocity/poles", "--count", "6"};
  REQUIRE(make(words).exit == 0);
  const std::string key = contents(std::string(folder) + "/key.csv");
  // As a run leaves it that was stopped after the third student, in the middle of a line.
  fs::remove(std::string(folder) + "/key.csv");
  for (const char* number : {"4", "5", "6"}) {
    fs::remove(std::string(folder) + "/" + number + "-blank.pdf");
    fs::remove(std::string(folder) + "/" + number + "-solution.pdf");
  }
  write(std::string(folder) + "/unfinished.jsonl", "{\"cut");
  const auto before = fs::last_write_time(std::string(folder) + "/1-blank.pdf");
  REQUIRE(make(words).exit == 0);
  CHECK(contents(std::string(folder) + "/key.csv") == key);
  CHECK_FALSE(fs::exists(std::string(folder) + "/unfinished.jsonl"));
  CHECK(fs::last_write_time(std::string(folder) + "/1-blank.pdf") > before);  // the journal knew nothing of it
}

TEST_CASE("class: no name of a student leaves the folder", "[class]") {
  const Scratch scratch;
  write("roster.csv", "number,name\n../../evil,=1+1\n\"a/b\",\"$(id)\"\n.hidden,\"x\"\"y\"\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "roster.csv"}).exit == 0);
  for (const std::string& file : scratch.files())
    CHECK((file == "roster.csv" || file.starts_with(std::string(folder) + "/")));
  CHECK(contents(std::string(folder) + "/key.csv").find(",=1+1") == std::string::npos);
  write("roster.csv", "number,name\na/b,A\na?b,B\n");
  CHECK(make({"slider-crank-velocity/poles", "--students", "roster.csv"}).exit == 2);
}

TEST_CASE("class: givens as a table states them", "[class]") {
  const Scratch scratch;
  write("variants.csv", "number;r;n\n1;0,25;\n2;20cm;400rpm\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {}).exit == 0);
  const CsvTable key = key_in(scratch.path());
  CHECK(cell(key, 0, "r") == "0,25");
  CHECK(std::stod(cell(key, 1, "omega_2")) == Approx(400 * 2 * M_PI / 60).epsilon(1e-15));
}

TEST_CASE("class --format moodle: a bank of cloze questions with figures inside", "[class]") {
  const Scratch scratch;
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "3", "--format", "moodle"}).exit == 0);
  pugi::xml_document quiz;
  REQUIRE(quiz.load_file((std::string(folder) + "/questions.xml").c_str()));
  const CsvTable key = key_in(scratch.path());
  std::size_t row = 0;
  for (const pugi::xml_node question : quiz.child("quiz").children("question")) {
    CHECK(std::string(question.attribute("type").value()) == "cloze");
    const std::string text = question.child("questiontext").child_value("text");
    CHECK(text.find("{1:NUMERICAL:=" + cell(key, row, "v_B") + ":") != std::string::npos);
    const pugi::xml_node figure = question.child("questiontext").child("file");
    CHECK(text.find(std::string("@@PLUGINFILE@@/") + figure.attribute("name").value()) != std::string::npos);
    CHECK(std::string(figure.child_value()).starts_with("PD94bWwg"));  // "<?xml "
    ++row;
  }
  CHECK(row == 3);
}

TEST_CASE("class: refusals are one sentence, and nothing is written", "[class]") {
  const Scratch scratch;
  const auto refused = [&](std::vector<std::string> words, const std::string& part) {
    const Ran ran = make(std::move(words), {});
    CAPTURE(ran.err);
    CHECK(ran.exit == 2);
    CHECK(ran.err.find(part) != std::string::npos);
    CHECK_FALSE(fs::exists("out"));
  };
  refused({"slider-crank-velocity"}, "--students");
  refused({"slider-crank-velocity", "--count", "0"}, "whole number");
  refused({"slider-crank-velocity", "--count", "3", "--students", "x.csv"}, "one of");
  refused({"slider-crank-velocity", "--students", "missing.csv"}, "missing.csv");
  refused({"slider-crank-velocity", "--count", "3", "--vary", "q=1|2"}, "no given \"q\"");
  refused({"slider-crank-velocity", "--count", "3", "--vary", "r"}, "write it as");
  refused({"slider-crank-velocity", "gear-pair", "--count", "3"}, "one exercise");
  write("twice.csv", "number\n1\n1\n");
  refused({"slider-crank-velocity", "--students", "twice.csv"}, "1");
  write("column.csv", "nummer\n1\n");
  refused({"slider-crank-velocity", "--students", "column.csv"}, "number");
}
