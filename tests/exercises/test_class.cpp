// Class sets: the same lots for the same seed, files whole and where they belong, keys that say what the sheets show.
#include <poppler-document.h>
#include <poppler-page.h>
#include <poppler-toc.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "drawings/output.h"
#include "exercises/cli/csv_reader.h"
#include "exercises/cli/run.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/scenes/shipped.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> lots{"--vary", "r=0.18..0.22/0.01", "--vary", "n=300|360|400", "--seed", "june"};

Ran make_over(std::vector<std::string> words, const std::vector<std::string>& more = lots) {
  words.insert(words.begin(), "class");
  words.insert(words.end(), more.begin(), more.end());
  return run_on_all(words);
}

// Whatever class the folder holds: as if nothing there told which.
Ran make(const std::vector<std::string>& words, const std::vector<std::string>& more = lots) {
  if (fs::exists("out"))
    for (const fs::directory_entry& each : fs::recursive_directory_iterator("out"))
      if (each.path().filename() == "class.txt" || each.path().filename() == "key.csv") fs::remove(each.path());
  return make_over(words, more);
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

constexpr const char* folder = "out/slider-crank-velocity-poles-class";

CsvTable key_in(const fs::path& path) { return read_csv_file((path / folder / "key.csv").string()); }
std::string cell(const CsvTable& table, std::size_t row, const std::string& column) {
  return table.rows.at(row).cells.at(table.needed_column(column));
}

Ran run_real(const std::vector<std::string>& words) {
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), words, out, err);
  return {exit, out.str(), err.str()};
}

std::string in_class(const std::string& file) { return std::string(folder) + "/" + file; }

std::string out_of_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255);
  }
  return bytes;
}

// "v_B" of the stated slider-crank to "5.10277...:0.125": what stands behind = in the field of this letter.
std::string field_of(const std::string& question, const std::string& letter) {
  const auto row = question.find("<tr><td>" + letter + "</td>"), begin = question.find(":=", row) + 2;
  return row == std::string::npos ? "" : question.substr(begin, question.find('}', begin) - begin);
}
double tolerance_in(const std::string& field) { return std::stod(field.substr(field.find(':') + 1)); }

std::string question_in(const std::string& file) {
  pugi::xml_document quiz;
  REQUIRE(quiz.load_file(file.c_str()));
  return quiz.child("quiz").find_child_by_attribute("type", "cloze").child("questiontext").child_value("text");
}

}  // namespace

TEST_CASE("class: a sheet to be solved, a solution and a line of the key for each student", "[class]") {
  const Scratch scratch;
  write("roster.csv", "number;name\r\n77;Ada Lovelace\r\n78;\"Rossi; Anna\"\r\n79;Babbage\r\n");
  const Ran ran = make({"slider-crank-velocity/poles", "--students", "roster.csv"});
  CAPTURE(ran.err);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("students: 3") != std::string::npos);
  std::set<std::string> files;
  for (const std::string& file : scratch.files()) files.insert(file);
  const std::string in = std::string(folder) + "/";
  CHECK(files == std::set<std::string>{"roster.csv", in + "class.txt", in + "key.csv", in + "77-blank.pdf",
                                       in + "77-solution.pdf", in + "78-blank.pdf", in + "78-solution.pdf",
                                       in + "79-blank.pdf", in + "79-solution.pdf"});
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

TEST_CASE("class: another seed draws other lots", "[class]") {
  const Scratch scratch;
  const auto drawn = [&](const std::string& seed) {
    REQUIRE(make({"slider-crank-velocity/poles", "--count", "12"},
                 {"--vary", "r=0.18..0.22/0.01", "--vary", "phi=25..50/26", "--seed", seed})
                .exit == 0);
    std::vector<std::string> all;
    const CsvTable key = key_in(scratch.path());
    for (std::size_t row = 0; row < 12; ++row) all.push_back(cell(key, row, "r") + cell(key, row, "phi"));
    return all;
  };
  const std::vector<std::string> june = drawn("june"), july = drawn("july");
  std::size_t equal = 0;
  for (std::size_t i = 0; i < 12; ++i) equal += june[i] == july[i] ? 1 : 0;
  CHECK(equal < 4);  // of 130 variants; more once in 10,000,000 seeds
  CHECK(drawn("june") == june);
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
  CHECK(none.err.find("none of 2 variants") != std::string::npos);
}

TEST_CASE("class: what the exercise itself cannot draw well is let pass", "[class]") {
  const Scratch scratch;
  // As stated, several sheets of the four-bar have vectors shorter than 10 mm.
  const Ran ran = make({"four-bar", "--count", "1"}, {"--vary", "phi=30deg|30.001deg", "--seed", "1"});
  CAPTURE(ran.err, ran.out);
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("drawn again") == std::string::npos);
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
  write(std::string(folder) + "/.epure-99999999-1.part", "a draft of a process that is no more");
  const auto before = fs::last_write_time(std::string(folder) + "/1-blank.pdf");
  REQUIRE(make(words).exit == 0);
  CHECK(contents(std::string(folder) + "/key.csv") == key);
  CHECK_FALSE(fs::exists(std::string(folder) + "/unfinished.jsonl"));
  CHECK_FALSE(fs::exists(std::string(folder) + "/.epure-99999999-1.part"));
  CHECK(fs::last_write_time(std::string(folder) + "/1-blank.pdf") > before);  // the journal knew nothing of it
}

TEST_CASE("class: what the journal knows is not drawn again, and nothing else is believed", "[class]") {
  const Scratch scratch;
  const std::vector<std::string> words{"slider-crank-velocity/poles", "--count", "6"};
  REQUIRE(make(words).exit == 0);
  const std::string key = contents(in_class("key.csv"));
  fs::remove_all("out");
  // Stopped for real: the last student's sheet cannot be written.
  fs::create_directories(in_class("6-blank.pdf/in-the-way"));
  REQUIRE(make(words).exit == 3);
  CHECK_FALSE(fs::exists(in_class("key.csv")));
  std::string journal = contents(in_class("unfinished.jsonl"));
  REQUIRE(std::count(journal.begin(), journal.end(), '\n') == 6);  // the inputs, five students
  fs::remove_all(in_class("6-blank.pdf"));
  // Cut short in the middle, as by another program, and at the end, as by a kill.
  const auto second = journal.find('\n', journal.find('\n') + 1);
  journal.insert(second + 1, "{\"student\":\n{}\n[]\nnull\n" + journal.substr(0, journal.find('\n') + 1));
  journal += "{\"student\":\"[";
  // How many of the five are drawn anew.
  const auto drawn_anew = [&](const std::vector<std::string>& with, const std::vector<std::string>& more = lots) {
    write(in_class("unfinished.jsonl"), journal);
    std::map<std::string, fs::file_time_type> before;
    for (const char* number : {"1", "2", "3", "4", "5"}) {
      const std::string file = in_class(number + std::string("-blank.pdf"));
      before[file] = fs::last_write_time(file);
    }
    REQUIRE(make(with, more).exit == 0);
    CHECK_FALSE(fs::exists(in_class("unfinished.jsonl")));
    return std::count_if(before.begin(), before.end(),
                         [](const auto& each) { return fs::last_write_time(each.first) > each.second; });
  };
  CHECK(drawn_anew(words) == 0);
  CHECK(contents(in_class("key.csv")) == key);
  // A bit that turned in what was found.
  const std::string whole = journal;
  const auto digit = journal.find_first_of("123456789", journal.find("\"values\":"));
  journal[digit] = journal[digit] == '1' ? '2' : '1';
  CHECK(drawn_anew(words) == 1);
  CHECK(contents(in_class("key.csv")) == key);
  journal = whole;
  fs::remove(in_class("1-solution.pdf"));
  CHECK(drawn_anew(words) == 1);
  const auto but_for = [&](std::size_t i, const std::string& text) {
    std::vector<std::string> other = lots;
    other[i] = text;
    return other;
  };
  CHECK(drawn_anew(words, but_for(5, "july")) == 5);
  CHECK(drawn_anew(words, but_for(3, "n=300|361|400")) == 5);
  CHECK(drawn_anew({"slider-crank-velocity/poles", "--count", "6", "--lang", "it"}) == 5);
  CHECK(drawn_anew({"slider-crank-velocity/poles", "--count", "6", "--scale", "1:20"}) == 5);
  // Also where both scales were asked for.
  fs::remove_all("out");
  fs::create_directories(in_class("6-blank.pdf/in-the-way"));
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "6", "--scale", "1:20"}).exit == 3);
  journal = contents(in_class("unfinished.jsonl"));
  fs::remove_all(in_class("6-blank.pdf"));
  CHECK(drawn_anew({"slider-crank-velocity/poles", "--count", "6", "--scale", "1:50"}) == 5);
  CHECK(cell(key_in(scratch.path()), 0, "scale poles") == "0.02");
  write("one.csv", "number,l\n1,0.51\n");  // the number of a student who is there, with givens of his own
  CHECK(drawn_anew({"slider-crank-velocity/poles", "--givens", "one.csv"}) == 1);
}

TEST_CASE("class: a mechanism's file that was edited since is drawn anew for all", "[class]") {
  const Scratch scratch;
  const std::vector<std::string> words{"m.yaml/velocities", "--count", "3"}, vary{"--vary", "phi=40..60/3"};
  const std::string made = "out/parallelogram-velocities-class/";
  std::string text(scenes::shipped_scene("parallelogram")->text);
  write("m.yaml", text);
  fs::create_directories(made + "3-blank.pdf/in-the-way");
  REQUIRE(make(words, vary).exit == 3);
  REQUIRE(contents(made + "unfinished.jsonl").find("value: 200 mm") != std::string::npos);
  fs::remove_all(made + "3-blank.pdf");
  text.replace(text.find("value: 200 mm"), 13, "value: 210 mm");
  write("m.yaml", text);
  REQUIRE(make(words, vary).exit == 0);
  const std::string key = contents(made + "key.csv");
  fs::remove_all("out");
  REQUIRE(make(words, vary).exit == 0);
  CHECK(contents(made + "key.csv") == key);
}

TEST_CASE("class: no name of a student leaves the folder", "[class]") {
  const Scratch scratch;
  write("roster.csv", "number,name\n../../evil,=1+1\n\"a/b\",\"$(id)\"\n.hidden,\"x\"\"y\"\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "roster.csv"}).exit == 0);
  for (const std::string& file : scratch.files())
    CHECK((file == "roster.csv" || file.starts_with(std::string(folder) + "/")));
  CHECK(contents(std::string(folder) + "/key.csv").find(",=1+1") == std::string::npos);
  for (const char* file : {"______evil-blank.pdf", "a_b-blank.pdf", "_hidden-blank.pdf"})
    CHECK(fs::exists(in_class(file)));
  for (const char* same_files : {"number,name\na/b,A\na?b,B\n", "number,name\nab,A\nAB,B\n"}) {
    write("roster.csv", same_files);
    CHECK(make({"slider-crank-velocity/poles", "--students", "roster.csv"}).exit == 2);
  }
}

TEST_CASE("class: givens as a table states them", "[class]") {
  const Scratch scratch;
  write("variants.csv", "number;r;n\n1;0,25;\n2;20cm;400rpm\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {}).exit == 0);
  const CsvTable key = key_in(scratch.path());
  CHECK(cell(key, 0, "r") == "0,25");
  CHECK(std::stod(cell(key, 1, "omega_2")) == Approx(400 * 2 * M_PI / 60).epsilon(1e-15));
  CHECK(cell(key, 0, "n").empty());
  CHECK(std::stod(cell(key, 0, "omega_2")) == Approx(12 * M_PI).epsilon(1e-15));  // as stated
  // The same under other names of the givens.
  write("variants.csv", "matricola,φ\n1,40deg\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {}).exit == 0);
  CHECK(cell(key_in(scratch.path()), 0, "phi") == "40deg");
  // What does not exist has no value: the pole at a right angle is at infinity.
  write("variants.csv", "phi\n90deg\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {}).exit == 0);
  CHECK(cell(key_in(scratch.path()), 0, "P0_y").empty());
  CHECK(cell(key_in(scratch.path()), 0, "omega_3") == "0");
  // A table is taken as it stands: 3° leaves a vector shorter than 10 mm, which lots would not.
  write("variants.csv", "phi\n3deg\n");
  const Ran awkward = make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {});
  CHECK(awkward.exit == 0);
  CHECK(awkward.out.find("drawn again") == std::string::npos);
  CHECK(make({"slider-crank-velocity/poles", "--count", "1"}, {"--vary", "phi=3deg|3.5deg"}).exit == 2);
}

TEST_CASE("class: the blank sheet is blank, the solution is solved, both with the student's name", "[class]") {
  const Scratch scratch;
  write("roster.csv", "number,name\n77,Ada Lovelace\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "roster.csv"}, {}).exit == 0);
  for (const auto& exercise : catalogue()) {
    if (exercise.id() != "slider-crank-velocity") continue;
    SheetRequest request{.solver = {"Ada Lovelace", "77"}};
    for (const auto& [file, is_blank] : {std::pair{"77-blank.pdf", true}, {"77-solution.pdf", false}}) {
      request.blank = is_blank;
      const DrawnSheet drawn = exercise->draw("poles", Givens(exercise->about().givens), request);
      CHECK(contents(in_class(file)) == drawings::pdf({drawn.sheet}, exercise->about().title.english));
    }
  }
}

TEST_CASE("class: each student has lots of his own, and every value is drawn", "[class]") {
  const Scratch scratch;
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "60"}).exit == 0);
  const CsvTable key = key_in(scratch.path());
  std::map<std::string, int> crank, speed;
  for (std::size_t row = 0; row < 60; ++row) {
    ++crank[cell(key, row, "r")];
    ++speed[cell(key, row, "n")];
  }
  // Of 12 and 20 expected; a fair lot leaves these bounds once in more than 10,000 seeds.
  CHECK(crank.size() == 5);
  for (const auto& [value, count] : crank) CHECK((1 <= count && count <= 26));
  CHECK(speed.size() == 3);
  for (const auto& [value, count] : speed) CHECK((5 <= count && count <= 37));
}

TEST_CASE("class: why variants were drawn again is added up over the class", "[class]") {
  const Scratch scratch;
  // r = 5 m does not close with l = 0.5 m at 30°: half of all lots.
  const Ran ran = make({"slider-crank-velocity/poles", "--count", "20"}, {"--vary", "r=0.2|5", "--seed", "1"});
  CAPTURE(ran.out);
  REQUIRE(ran.exit == 0);
  const std::string told = "drawn again, impossible: ";
  const auto at = ran.out.find(told);
  REQUIRE(at != std::string::npos);
  const int count = std::stoi(ran.out.substr(at + told.size()));
  CHECK(count > 5);  // as many as heads before a tail, twenty times
  CHECK(count < 60);
}

TEST_CASE("class: a number that begins as a formula stands behind an apostrophe, and mark finds it", "[class]") {
  const Scratch scratch;
  write("roster.csv", "number,name\n-7,Ada\n+8,=1+1\n'-9,'@x\n10,'t Hooft\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "roster.csv"}).exit == 0);
  const std::string key = contents(in_class("key.csv"));
  for (const char* line : {"\r\n'-7,Ada,", "\r\n'+8,'=1+1,", "\r\n'-9,'@x,", "\r\n10,'t Hooft,"})
    CHECK(key.find(line) != std::string::npos);
  CHECK(fs::exists(in_class("_9-blank.pdf")));
  // As the student typed it, and as a spreadsheet hands on the key's cell.
  const CsvTable truth = key_in(scratch.path());
  std::string answers = "number,name,v_B\n";
  const std::vector<std::string> numbers{"'-7", "+8", "-9", "10"};
  for (std::size_t row = 0; row < numbers.size(); ++row)
    answers += numbers[row] + ",'=n," + cell(truth, row, "v_B") + "\n";
  write("answers.csv", answers);
  const Ran marked = run_real(
      {"mark", "slider-crank-velocity", "--answers", "answers.csv", "--key", in_class("key.csv"), "--format", "csv"});
  CAPTURE(marked.err, marked.out);
  REQUIRE(marked.exit == 0);
  CHECK(marked.err.empty());
  const CsvTable marks = read_csv(marked.out, "marks");
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    CHECK(cell(marks, row, "v_B points") == "1");
    CHECK(cell(marks, row, "name") == "'=n");
  }
  CHECK(cell(marks, 2, "number") == "'-9");
  write("answers.csv", "number,v_B\n-7,1\n'-7,1\n");
  const Ran twice = run_real({"mark", "slider-crank-velocity", "--answers", "answers.csv"});
  CHECK(twice.exit == 2);
  CHECK(twice.err.find("line 3: number '-7 stands in line 2 already") != std::string::npos);
}

TEST_CASE("class: a given is not varied that the key's reader would take for something else", "[class]") {
  const fs::path file = "of_names.yaml";
  for (const std::string name : {"date", "remarks", "number", "matricola", "nome", "scale"}) {
    CAPTURE(name);
    write(file, "epure: 1\nid: f\ngivens: {" + name +
                    ": 120 mm}\nlinks:\n  1: {A0: [0, 0], B0: [0.4, 0]}\n  2: {A0 A: " + name +
                    "}\n  3: {A B: 0.35}\n  4: {B0 B: 0.28}\ndrive: {link: 2, angle: 30 deg, speed: 60 rpm}\n"
                    "assembly: {B: left of A B0}\n");
    const Ran ran = run_real({"class", file.string(), "--count", "1", "--vary", name + "=110..130/3"});
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("a column \"" + name + "\" of the key") != std::string::npos);
  }
  fs::remove(file);
}

TEST_CASE("class: --vary takes what --over takes, and refuses what it refuses", "[class]") {
  const Scratch scratch;
  const auto varied = [&](const std::vector<std::string>& more) {
    return make({"slider-crank-velocity/poles", "--count", "1"}, more);
  };
  REQUIRE(varied({"--vary", "φ=40deg..60deg/2"}).exit == 0);
  const std::string phi = cell(key_in(scratch.path()), 0, "phi");
  CHECK((phi == "40deg" || phi == "60deg"));
  REQUIRE(varied({"--vary", "t1=1/80s|1/90s"}).exit == 0);
  const std::string t = cell(key_in(scratch.path()), 0, "t");
  CHECK((t == "0.0125s" || t == "1/90s"));
  fs::remove_all("out");
  write("variants.csv", "number,r\n1,0.2\n");
  const auto refused = [&](const Ran& ran, const std::string& part) {
    CAPTURE(ran.err);
    CHECK(ran.exit == 2);
    CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
    CHECK(ran.err.find(part) != std::string::npos);
    CHECK_FALSE(fs::exists("out"));
  };
  refused(varied({"--vary", "ph=1|2"}), "--vary: \"ph\" is no given here; did you mean phi?");
  refused(varied({"--vary", "r"}), "--vary r: write a symbol, = and its values");
  refused(varied({"--vary", "=1|2"}), "write a symbol");
  refused(varied({"--vary", "r=1|2", "--vary", "r=3|4"}), "r stands in --vary twice");
  refused(varied({"--vary", "φ=30|40", "--set", "phi=50"}), "phi is set, and --vary varies it");
  refused(varied({"--vary", "φ=30|40", "--set", "t=1/60s"}), "phi and t are two ways to state one thing");
  refused(varied({"--vary", "φ=30|40", "--vary", "t=1/60s|1/50s"}), "t and phi are two ways to state one thing");
  refused(varied({"--vary", "r=0.1..0.2/1"}), "r: /1 counts fewer values than the two ends");
  refused(varied({"--vary", "r=0.1..0.2/0"}), "r: /0 counts fewer");
  refused(varied({"--vary", "r=0.1..0.2/0.03"}), "r: a step of 0.03 m does not lead from 0.1 to 0.2 m");
  refused(varied({"--vary", "r=0.1..0.2/-0.1"}), "r: a step of -0.1 m: must be positive");
  refused(varied({"--vary", "r=0.1..0.2/99999999999"}), "r: more than 1000000000 values");
  refused(varied({"--vary", "r=0.1"}), "r: \"0.1\" is one value");
  refused(make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {"--vary", "r=0.2|0.3"}),
          "r is set, and --vary varies it");
  write("variants.csv", "phi,φ\n1,2\n");
  refused(make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {}), "there are two columns for phi");
}

TEST_CASE("class --format moodle: a bank of cloze questions with figures inside", "[class]") {
  const Scratch scratch;
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "3", "--format", "moodle"}).exit == 0);
  pugi::xml_document quiz;
  REQUIRE(quiz.load_file((std::string(folder) + "/questions.xml").c_str()));
  const CsvTable key = key_in(scratch.path());
  std::size_t row = 0;
  const pugi::xml_node category = quiz.child("quiz").child("question");
  CHECK(std::string(category.attribute("type").value()) == "category");
  CHECK(std::string(category.child("category").child_value("text")) == "$course$/top/epure/Slider-crank: velocities");
  for (pugi::xml_node question = category.next_sibling(); question; question = question.next_sibling()) {
    CHECK(std::string(question.attribute("type").value()) == "cloze");
    CHECK(std::string(question.child("name").child_value("text")) ==
          "00" + std::to_string(row + 1) + " slider-crank-velocity");
    const std::string text = question.child("questiontext").child_value("text");
    CHECK(text.find("{1:NUMERICAL:=" + cell(key, row, "v_B") + ":") != std::string::npos);
    const pugi::xml_node figure = question.child("questiontext").child("file");
    CHECK(text.find(std::string("@@PLUGINFILE@@/") + figure.attribute("name").value()) != std::string::npos);
    CHECK(std::string(figure.child_value()).starts_with("PD94bWwg"));  // "<?xml "
    ++row;
  }
  CHECK(row == 3);
}

TEST_CASE("class --format moodle: fields, figure and words of the stated slider-crank", "[class]") {
  const Scratch scratch;
  write("roster.csv", "number,name\nR&D <1>,A\n");
  const std::vector<std::string> words{"slider-crank-velocity/poles", "--students", "roster.csv", "--format",
                                       "moodle"};
  REQUIRE(make(words, {}).exit == 0);
  pugi::xml_document quiz;
  REQUIRE(quiz.load_file(in_class("questions.xml").c_str()));
  const pugi::xml_node question = quiz.child("quiz").find_child_by_attribute("type", "cloze");
  CHECK(std::string(question.child("name").child_value("text")) == "001 slider-crank-velocity R&D <1>");
  const std::string text = question_in(in_class("questions.xml"));
  CAPTURE(text);
  CHECK(text.find("0.2\u00a0m") != std::string::npos);
  CHECK(text.find("360\u00a0rpm") != std::string::npos);
  // What mark allows (test_marked_class.cpp): v_B is read off at 1 cm = 2.5 m/s; ω₃ is v_B / P0B.
  CHECK(field_of(text, "v_B").starts_with("5.10277606575526"));
  CHECK(tolerance_in(field_of(text, "v_B")) == 0.125);
  CHECK(tolerance_in(field_of(text, "ω₃")) == Approx(0.4135422117).epsilon(0.005));  // told to three digits
  // The figure is what draw makes, and holds nothing of what is asked.
  const pugi::xml_node figure = question.child("questiontext").child("file");
  CHECK(std::string(figure.attribute("name").value()) == "slider-crank-velocity-poles-blank.svg");
  const Ran drawn =
      run_real({"draw", "slider-crank-velocity/poles", "--blank", "--bare", "--format", "svg", "-o", "-"});
  CHECK(out_of_base64(figure.child_value()) == drawn.out);
  CHECK(std::string(figure.child_value()).size() % 4 == 0);
  // Of all sheets the one with the coarsest scale counts, as it does for mark: nobody says which was measured.
  REQUIRE(make({"slider-crank-velocity", "--count", "1", "--format", "moodle"}, {}).exit == 0);
  const std::string whole = question_in("out/slider-crank-velocity-class/questions.xml");
  CHECK(tolerance_in(field_of(whole, "v_B")) == 0.125);
  CHECK(whole.find("<td>v_B</td>") == whole.rfind("<td>v_B</td>"));  // asked once, though several sheets ask for it
  // With a coarser ruler everything may be off by twice as much.
  std::vector<std::string> other = words;
  other.insert(other.end(), {"--reading", "1mm"});
  REQUIRE(make(other, {}).exit == 0);
  const std::string coarser = question_in(in_class("questions.xml"));
  for (const char* letter : {"v_B", "ω₃"})
    CHECK(tolerance_in(field_of(coarser, letter)) == Approx(2 * tolerance_in(field_of(text, letter))).epsilon(0.005));
}

TEST_CASE("class --format moodle: which sense is positive is said where it is asked", "[class]") {
  const Scratch scratch;
  const auto told = [&](const std::string& sheet, const std::string& language) {
    REQUIRE(make({sheet, "--count", "1", "--format", "moodle", "--lang", language}, {}).exit == 0);
    std::string folder_of = sheet;
    std::replace(folder_of.begin(), folder_of.end(), '/', '-');
    return question_in("out/" + folder_of + "-class/questions.xml");
  };
  const std::string both = "<p>Positive sense: counter-clockwise; x to the right, y upwards; coordinates from A";
  CHECK(told("slider-crank-velocity", "en").find(both) != std::string::npos);
  CHECK(told("slider-crank-velocity", "it")
            .find("<p>Verso positivo: antiorario; x a destra, y in alto; coordinate da A") != std::string::npos);
  CHECK(told("slider-crank-velocity/polar-diagram", "en").find("Positive sense: counter-clockwise.") !=
        std::string::npos);
  // Of which mechanism a given is stands before it, and the pictures' names are those of the sheets.
  const std::string mechanisms = told("ideal-statics", "it");
  CHECK(mechanisms.find("<p>cuneo e collare: Q =") != std::string::npos);
  CHECK(mechanisms.find("<p>doppio pattino: Q =") != std::string::npos);
  CHECK(mechanisms.find("alt=\"Doppio pattino: lavori virtuali\"") != std::string::npos);
  // Forces in bars have no sense that turns, nor components.
  CHECK(told("michell-bearing", "en").find("counter-clockwise") == std::string::npos);
}

TEST_CASE("class --format moodle: a number without a sign is a magnitude, as for mark; whole turns are right",
          "[class]") {
  const Scratch scratch;
  const auto asked = [&](const std::string& id, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{id, "--count", "1", "--format", "moodle"};
    words.insert(words.end(), more.begin(), more.end());
    REQUIRE(make(words, {}).exit == 0);
    return question_in("out/" + id + "-class/questions.xml");
  };
  const auto alternatives = [](const std::string& field) {
    std::vector<double> all;
    std::istringstream in("=" + field);
    for (std::string each; std::getline(in, each, '~');) {
      CHECK(each.substr(each.find(':')) == field.substr(field.rfind(':')));  // all as far off as the first
      all.push_back(std::stod(each.substr(each.find('=') + 1)));
    }
    return all;
  };
  // Whether the question says which sense is positive (a force "upwards", what turns) or not (a bending moment).
  const std::string crane = asked("boat-crane");
  CHECK(alternatives(field_of(crane, "M_C")) == std::vector<double>{-17651.97, 17651.97});
  CHECK(alternatives(field_of(crane, "Y_B")) == std::vector<double>{-5883.99, 5883.99});
  const std::string analytic = asked("four-bar-analytic");
  CAPTURE(analytic);
  CHECK(alternatives(field_of(analytic, "ω₃")) == std::vector<double>{-18.425284259084822, 18.425284259084822});
  CHECK(alternatives(field_of(analytic, "a_Bx")) == std::vector<double>{-263.8573241560314, 263.8573241560314});
  // A whole turn less and more are the same direction; the magnitude only of what is below zero. 2π - θ₃ = 5.0518 is
  // the mirror image of θ₃, another direction.
  const auto are = [&](const std::vector<double>& found, const std::vector<double>& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).epsilon(1e-14));
  };
  are(alternatives(field_of(analytic, "θ₄")),
      {-0.8807969085934083, -7.163982215772994, 5.402388398586178, 0.8807969085934083});
  are(alternatives(field_of(analytic, "θ₃")), {1.2313431472543472, -5.051842159925239, 7.514528454433934});
  CHECK(field_of(analytic, "x_G₃'").starts_with("-0.4135829"));
  const std::vector<double> in_degrees = alternatives(field_of(asked("slider-crank-acceleration"), "γ"));
  REQUIRE(in_degrees.size() == (in_degrees[0] < 0 ? 4 : 3));
  CHECK(in_degrees[0] - in_degrees[1] == Approx(360).epsilon(1e-14));
  CHECK(in_degrees[2] - in_degrees[0] == Approx(360).epsilon(1e-14));
}

TEST_CASE("class --format moodle: an answer may be off by what mark allows, also where it is zero", "[class]") {
  const Scratch scratch;
  write("variants.csv", "phi\n90deg\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--givens", "variants.csv", "--format", "moodle"}, {}).exit == 0);
  const std::string text = question_in(in_class("questions.xml"));
  CAPTURE(text);
  CHECK(field_of(text, "ω₃").starts_with("0:"));
  CHECK(tolerance_in(field_of(text, "ω₃")) > 0.01);
  CHECK(text.find(":0}") == std::string::npos);
}

TEST_CASE("class: what lies at infinity is no number to be asked", "[class]") {
  const Scratch scratch;
  // The crank stands square to the guide: the rod translates.
  write("variants.csv", "phi\n90deg\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--givens", "variants.csv", "--format", "moodle"}, {}).exit == 0);
  const std::string text = question_in(in_class("questions.xml"));
  CAPTURE(text);
  CHECK(text.find("Not asked, as it lies at infinity or does not exist: ") != std::string::npos);
  for (const char* letters : {"x_P0", "P₀A", "P₀B"})
    CHECK(text.find("<td>" + std::string(letters)) == std::string::npos);
  const CsvTable key = key_in(scratch.path());
  CHECK(cell(key, 0, "P0_y").empty());
  CHECK(cell(key, 0, "remarks").find("P0_x, P0_y, P0A") != std::string::npos);
  // By lot it is drawn again.
  const Ran ran = make({"slider-crank-velocity/poles", "--count", "12"}, {"--vary", "phi=30deg|90deg"});
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("drawn again, something asked that does not exist, or lies at infinity: ") != std::string::npos);
  const CsvTable again = key_in(scratch.path());
  for (std::size_t row = 0; row < 12; ++row) CHECK(cell(again, row, "phi") == "30deg");
}

TEST_CASE("class: a pole off the paper is not asked, and drawn again", "[class]") {
  const Scratch scratch;
  write("variants.csv", "phi\n88deg\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--givens", "variants.csv", "--format", "moodle"}, {}).exit == 0);
  const std::string text = question_in(in_class("questions.xml"));
  CAPTURE(text);
  CHECK(text.find("Not asked, as it lies off the sheet: ") != std::string::npos);
  CHECK(text.find("<td>P₀A") == std::string::npos);
  CHECK(text.find("<td>ω₃") != std::string::npos);
  // Each field says what it asks for.
  CHECK(text.find("<td>rad/s</td><td>angular velocity of link 3, counter-clockwise</td>") != std::string::npos);
  CHECK(cell(key_in(scratch.path()), 0, "remarks").find("P0A, P0B, P0C, P0M: off the sheet, not asked") !=
        std::string::npos);
  const Ran ran = make({"slider-crank-velocity/poles", "--count", "12"}, {"--vary", "phi=30deg|70deg"});
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("drawn again, a step off the sheet: ") != std::string::npos);
}

TEST_CASE("class: a roster of Italian Excel, and a key for it", "[class]") {
  const Scratch scratch;
  write("elenco.csv", "\xEF\xBB\xBFMatricola;Cognome;Nome\r\n0012345;De Rossi;Anna\r\n0012346;Verdi;Bruno\r\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "elenco.csv", "--csv", "excel", "--lang", "it"}).exit ==
          0);
  const std::string key = contents(in_class("key.csv"));
  CHECK(key.starts_with("\xEF\xBB\xBFmatricola;nome;r;n;omega_2;"));
  CHECK(key.find("\r\n0012345;De Rossi Anna;0,") != std::string::npos);
  CHECK(key.find('.') == std::string::npos);
  // Back again, with answers whose zeros a spreadsheet took.
  const CsvTable truth = key_in(scratch.path());
  write("risposte.csv", "\xEF\xBB\xBFMatricola;Cognome;Nome;v_B (m/s)\r\n12345;De Rossi;Anna;" +
                            cell(truth, 0, "v_B") + "\r\n12346;Verdi;Bruno;" + cell(truth, 1, "v_B") + "\r\n");
  const Ran marked = run_real({"mark", "slider-crank-velocity", "--answers", "risposte.csv", "--key",
                               in_class("key.csv"), "--csv", "excel", "--lang", "it", "--set", "phi=30deg"});
  CAPTURE(marked.err, marked.out);
  CHECK(marked.exit == 2);  // the key is of the stated instant, at which another speed turns the crank elsewhere
  const Ran right = run_real({"mark", "slider-crank-velocity", "--answers", "risposte.csv", "--key",
                              in_class("key.csv"), "--csv", "excel", "--lang", "it"});
  CAPTURE(right.err, right.out);
  CHECK(right.exit == 0);
  CHECK(right.out.find("\n0012345;De Rossi Anna;1;giusta;1;\r\n0012346;Verdi Bruno;1;giusta;1;\r\n") !=
        std::string::npos);
  CHECK(right.err.find("numeri trovati") != std::string::npos);
}

TEST_CASE("class: no given in the key is a formula to a spreadsheet, and mark reads it", "[class]") {
  const Scratch scratch;
  for (const std::string style : {"excel", "plain"}) {
    std::vector<std::string> more{"--vary", "phi=-40deg..-50deg/3", "--out", style};
    if (style == "excel") more.insert(more.end(), {"--csv", "excel"});
    REQUIRE(make({"slider-crank-velocity/poles", "--count", "2"}, more).exit == 0);
    const std::string key = style + "/slider-crank-velocity-poles-class/key.csv";
    const CsvTable truth = read_csv_file(key);
    CHECK(cell(truth, 0, "phi").starts_with("'-"));
    write("answers.csv", "number;v_B\r\n1;" + cell(truth, 0, "v_B") + "\r\n2;" + cell(truth, 1, "v_B") + "\r\n");
    const Ran marked = run_real({"mark", "slider-crank-velocity", "--answers", "answers.csv", "--key", key});
    CAPTURE(marked.err, marked.out);
    CHECK(marked.exit == 0);
    CHECK(marked.out.find("right") != std::string::npos);
  }
}

TEST_CASE("class: a roster in Windows-1252 is read, and it is told", "[class]") {
  const Scratch scratch;
  write("elenco.csv", "Matricola;Cognome;Nome\r\n7;Sar\xE0;Niccol\xF2\r\n");
  const Ran ran = make({"slider-crank-velocity/poles", "--students", "elenco.csv"});
  REQUIRE(ran.exit == 0);
  CHECK(ran.err.starts_with("epure: elenco.csv is not UTF-8 and was read as Windows-1252"));
  CHECK(cell(key_in(scratch.path()), 0, "name") == "Sarà Niccolò");
  write("risposte.csv", "Matricola;v_B;Fiche\r\n7;5;\xE8\r\n");
  CHECK(run_real({"mark", "slider-crank-velocity", "--answers", "risposte.csv", "--lang", "it"})
            .err.starts_with("epure: risposte.csv non è UTF-8 ed è stato letto come Windows-1252"));
}

TEST_CASE("class: files of an earlier class are told, and left alone", "[class]") {
  const Scratch scratch;
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "3"}).err.find("earlier class") == std::string::npos);
  write(in_class("notes.txt"), "mine");
  const Ran fewer = make({"slider-crank-velocity/poles", "--count", "2"});
  CHECK(fewer.exit == 0);
  CHECK(fewer.err.find(std::string(folder) + " still holds 2 files of an earlier class, such as 3-blank.pdf") !=
        std::string::npos);
  for (const char* file : {"3-blank.pdf", "3-solution.pdf", "notes.txt"}) CHECK(fs::exists(in_class(file)));
  CHECK(make({"slider-crank-velocity/poles", "--count", "2", "--format", "moodle"}).err.find("holds 6 files") !=
        std::string::npos);
}

TEST_CASE("class: how many have the givens of another is told", "[class]") {
  const Scratch scratch;
  // Three variants for four students: two at least are equal.
  const Ran ran = make({"slider-crank-velocity/poles", "--count", "4"}, {"--vary", "r=0.18|0.2|0.22"});
  CHECK(ran.out.find("students with the same givens as another: ") != std::string::npos);
  const auto told = ran.out.find(" different variants were drawn, of 3; ");
  REQUIRE(told != std::string::npos);
  const CsvTable key = key_in(scratch.path());
  std::set<std::string> drawn;
  for (std::size_t i = 0; i < 4; ++i) drawn.insert(cell(key, i, "r"));
  CHECK(ran.out.substr(told - 1, 1) == std::to_string(drawn.size()));
  CHECK(make({"slider-crank-velocity/poles", "--count", "1"}, {"--vary", "r=0.18|0.2"}).out.find("same givens") ==
        std::string::npos);
  CHECK(make({"slider-crank-velocity/poles", "--count", "3"}, {}).out.find("all students have the same givens") !=
        std::string::npos);
  CHECK(make({"slider-crank-velocity/poles", "--count", "1"}, {}).out.find("same givens") == std::string::npos);
}

TEST_CASE("class: a crank that moves because its speed varies is told", "[class]") {
  const Scratch scratch;
  const auto told = [](const std::vector<std::string>& more) {
    return make({"slider-crank-velocity/poles", "--count", "1"}, more).err;
  };
  CHECK(told({"--vary", "n=300|360"}) ==
        "epure: phi changes with n, as the instant t is what is stated; --set phi=30deg keeps it\n");
  CHECK(told({"--vary", "n=300|360", "--set", "phi=30deg"}).empty());
  CHECK(told({"--vary", "r=0.18|0.2"}).empty());
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
  refused({"slider-crank-velocity", "--count", "3", "--vary", "q=1|2"}, "\"q\" is no given here");
  refused({"slider-crank-velocity", "--count", "3", "--vary", "r"}, "write a symbol");
  refused({"slider-crank-velocity", "gear-pair", "--count", "3"}, "one exercise");
  write("twice.csv", "number\n1\n1\n");
  refused({"slider-crank-velocity", "--students", "twice.csv"}, "1");
  write("column.csv", "nummer\n1\n");
  refused({"slider-crank-velocity", "--students", "column.csv"}, "number");
}

TEST_CASE("class: one scale of lengths for all, that of the lots and not of the roster", "[class]") {
  const Scratch scratch;
  const Ran ran = make({"slider-crank-velocity/poles", "--count", "20"});
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("\nscale of lengths: 1:10\n") != std::string::npos);
  const CsvTable key = key_in(scratch.path());
  for (std::size_t row = 0; row < 20; ++row) CHECK(cell(key, row, "scale poles") == "0.1");
  const std::string of_seven = contents(in_class("7-blank.pdf"));
  // Drawn alone, some of them would have 1:5.
  std::set<std::string> alone;
  for (const auto& exercise : catalogue()) {
    if (exercise.id() != "slider-crank-velocity") continue;
    for (std::size_t row = 0; row < 20; ++row) {
      Givens givens(exercise->about().givens);
      for (const char* given : {"r", "n"}) givens.set(std::string(given) + "=" + cell(key, row, given));
      alone.insert(exercise->draw("poles", givens, {}).sheet.title_block.scales.front());
    }
  }
  CHECK(alone == std::set<std::string>{"1 : 10", "1 : 5"});
  write("one.csv", "number\n7\n");
  REQUIRE(make({"slider-crank-velocity/poles", "--students", "one.csv"}).exit == 0);
  CHECK(contents(in_class("7-blank.pdf")) == of_seven);
  // What is shown is at that scale.
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "5", "--format", "moodle"}).exit == 0);
  pugi::xml_document quiz;
  REQUIRE(quiz.load_file(in_class("questions.xml").c_str()));
  for (const pugi::xml_node question : quiz.child("quiz").children("question"))
    if (const pugi::xml_node figure = question.child("questiontext").child("file"))
      CHECK(out_of_base64(figure.child_value()).find("1 : 10") != std::string::npos);
}

TEST_CASE("class: --scale is kept, and what does not fit at it is drawn again", "[class]") {
  const Scratch scratch;
  const std::vector<std::string> words{"slider-crank-velocity/poles", "--count", "12", "--scale"};
  const auto at = [&](const std::string& scale) {
    std::vector<std::string> all = words;
    all.push_back(scale);
    return make(all);
  };
  const Ran large = at("1:5");
  REQUIRE(large.exit == 0);
  CHECK(large.out.find("drawn again, does not fit the paper: ") != std::string::npos);
  CsvTable key = key_in(scratch.path());
  for (std::size_t row = 0; row < 12; ++row) CHECK(cell(key, row, "scale poles") == "0.2");
  const Ran small = at("1:20");
  REQUIRE(small.exit == 0);
  CHECK(small.out.find("does not fit") == std::string::npos);
  CHECK(cell(key_in(scratch.path()), 3, "scale poles") == "0.05");
  const Ran none = at("1:1");
  CHECK(none.exit == 2);
  CHECK(none.err.find("none of 15 variants can be drawn well; of the last one: at scale 1 : 1 the figure takes") !=
        std::string::npos);
  CHECK(at("five").exit == 2);
}

TEST_CASE("class: no variant is tried twice, and the sheet that none can be drawn of is named", "[class]") {
  const Scratch scratch;
  const Ran none = make({"slider-crank-velocity", "--count", "2", "--scale", "1:1"}, {"--vary", "phi=20|25|30 deg"});
  CHECK(none.exit == 2);
  CHECK(none.err.find("none of 3 variants can be drawn well") != std::string::npos);
  CHECK_FALSE(fs::exists("out/slider-crank-velocity-class"));
  // One place has P0 far off, or a vector too short, on a sheet that is no chart.
  const Ran awkward = make({"slider-crank-velocity", "--count", "1"}, {"--vary", "phi=0.01|0.02 deg"});
  CHECK(awkward.exit == 2);
  CHECK(awkward.err.find("none of 2 variants can be drawn well; of the last one: poles: ") != std::string::npos);
}

TEST_CASE("class: where no one scale fits well each variant has its own, which is told", "[class]") {
  const Scratch scratch;
  const auto made_of = [&](const std::string& times) {
    write("variants.csv", "number,r,l,BC,AC\n1,0.2,0.5,0.4,0.3\n2," + times + "\n");
    return make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {});
  };
  const auto scale = [&](std::size_t row) { return cell(key_in(scratch.path()), row, "scale poles"); };
  const Ran apart = made_of("2,5,4,3");
  REQUIRE(apart.exit == 0);
  CHECK(apart.err.find("poles: no one scale fits all variants well") != std::string::npos);
  CHECK(apart.out.find("scale of lengths") == std::string::npos);
  CHECK(scale(0) == "0.2");
  CHECK(scale(1) == "0.02");
  const Ran near = made_of("0.4,1,0.8,0.6");
  CHECK(near.err.empty());
  CHECK(scale(0) == "0.1");
  CHECK(scale(1) == "0.1");
  CHECK(made_of("0.8,2,1.6,1.2").err.empty());
  CHECK(scale(0) == "0.05");
  // Five times as small as could be is the most.
  write("variants.csv", "number,r,l,BC,AC\n1,0.4,1,0.8,0.6\n2,2,5,4,3\n");
  CHECK(make({"slider-crank-velocity/poles", "--givens", "variants.csv"}, {}).err.empty());
  CHECK(scale(0) == "0.02");
}

TEST_CASE("class: each sheet has its own scale, which the key tells under its name", "[class]") {
  const Scratch scratch;
  const Ran ran = make({"slider-crank-velocity", "--count", "3"}, {});
  REQUIRE(ran.exit == 0);
  const std::string told = "scale of lengths: coupler-curve 1:5, polar-diagram 1:10, poles 1:5, polodes 1:10\n";
  CAPTURE(ran.out);
  CHECK(ran.out.find(told) != std::string::npos);
  const CsvTable key = read_csv_file("out/slider-crank-velocity-class/key.csv");
  for (std::size_t row = 0; row < 3; ++row) {
    CHECK(cell(key, row, "scale coupler-curve") == "0.2");
    CHECK(cell(key, row, "scale polar-diagram") == "0.1");
  }
}

TEST_CASE("class: mark reads what the class's own scale allows", "[class]") {
  const Scratch scratch;
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "1", "--scale", "1:20"}, {}).exit == 0);
  // Half a millimetre at 1:20 is 10 mm.
  const double P0B = std::stod(cell(key_in(scratch.path()), 0, "P0B"));
  const auto verdict = [&](double off) {
    write("answers.csv", "number,P0B\n1," + std::to_string(P0B + off) + "\n");
    const Ran ran = run_real({"mark", "slider-crank-velocity", "--answers", "answers.csv", "--key",
                              in_class("key.csv"), "--format", "csv"});
    CAPTURE(ran.err);
    REQUIRE(ran.exit == 0);
    CHECK(ran.err.empty());
    return cell(read_csv(ran.out, "marks"), 0, "P0B verdict");
  };
  CHECK(verdict(0.0099) == "right");
  CHECK(verdict(0.0101) != "right");
  // And on A3, for which a larger scale was asked.
  REQUIRE(make({"slider-crank-velocity/poles", "--count", "1", "--scale", "1:4", "--paper", "a3"}, {}).exit == 0);
  CHECK(verdict(0.00199) == "right");
  CHECK(verdict(0.00201) != "right");
}

TEST_CASE("class: nobody who is in the key loses it", "[class]") {
  const Scratch scratch;
  REQUIRE(make_over({"slider-crank-velocity/poles", "--count", "4"}).exit == 0);
  const std::string key = contents(in_class("key.csv"));
  const Ran fewer = make_over({"slider-crank-velocity/poles", "--count", "2"});
  CHECK(fewer.exit == 2);
  CHECK(fewer.err.find("key.csv would lose 2 of its 4 students, such as 3, as they are not in this class; choose "
                       "another --out, or delete the folder") != std::string::npos);
  const Ran one = make_over({"slider-crank-velocity/poles", "--count", "3", "--lang", "it"});
  CHECK(one.exit == 2);
  CHECK(one.err.find("key.csv perderebbe 1 dei suoi 4 studenti, come 4, che non sono in questa classe") !=
        std::string::npos);
  CHECK(contents(in_class("key.csv")) == key);
  CHECK(make_over({"slider-crank-velocity/poles", "--count", "5"}).exit == 0);
}

TEST_CASE("class and mark do not write over what they read", "[class]") {
  const Scratch scratch;
  REQUIRE(make_over({"slider-crank-velocity/poles", "--count", "2"}).exit == 0);
  const std::string key = in_class("key.csv"), bytes = contents(key);
  CHECK(make_over({"slider-crank-velocity/poles", "--students", key}).exit == 2);
  CHECK(contents(key) == bytes);
  write("answers.csv", "number,v_B\n1,5.1\n2,5.2\n");
  fs::create_hard_link("answers.csv", "linked.csv");
  fs::create_symlink("answers.csv", "led.csv");
  const auto marks_into = [&](const std::string& file) {
    return run_real({"mark", "slider-crank-velocity", "--answers", "answers.csv", "--key", key, "-o", file});
  };
  for (const std::string& file :
       {std::string("answers.csv"), std::string("./linked.csv"), std::string("led.csv"), key}) {
    const Ran ran = marks_into(file);
    CAPTURE(file, ran.err);
    CHECK(ran.exit == 2);
    CHECK(ran.err == "epure: " + file + " is read by this command, which would write over it; choose another name\n");
  }
  CHECK(contents("answers.csv") == "number,v_B\n1,5.1\n2,5.2\n");
  CHECK(contents(key) == bytes);
  CHECK(marks_into("marks.csv").exit == 0);
}

TEST_CASE("a sheet of a mechanism is not written over the file that the mechanism is read from") {
  const Scratch scratch;
  const std::string scene =
      "epure: 1\nid: f\nlinks:\n  1: {A0: [0, 0]}\n  2: {A0 A: 120 mm}\ndrive: {link: 2, angle: 60 deg, speed: 60 "
      "rpm}\n";
  write("f.yaml", scene);
  for (const std::string name : {"f.yaml", "f.yaml/velocities"}) {
    const Ran ran = run_real({"draw", name, "--format", "svg", "-o", "f.yaml"});
    CAPTURE(name, ran.err);
    CHECK(ran.exit == 2);
    CHECK(contents("f.yaml") == scene);
  }
  CHECK(run_real({"draw", "f.yaml/velocities", "--format", "svg", "-o", "v.svg"}).exit == 0);
}

TEST_CASE("class: another class is not made over one that is there", "[class]") {
  const Scratch scratch;
  const std::vector<std::string> words{"slider-crank-velocity/poles", "--count", "2", "--course", "Rossi's course"};
  REQUIRE(make_over(words).exit == 0);
  CHECK(contents(in_class("class.txt")) ==
        "epure class slider-crank-velocity/poles --seed june --vary r=0.18..0.22/0.01 --vary 'n=300|360|400' --paper "
        "a4 "
        "\\\n  --count 2 --reading 0.5mm --course 'Rossi'\\''s course' --lang en\n");
  const std::string key = contents(in_class("key.csv"));
  const auto refused = [&](std::size_t i, const std::string& text) {
    std::vector<std::string> other = lots;
    other[i] = text;
    const Ran ran = make_over(words, other);
    CHECK(ran.exit == 2);
    CHECK(ran.err.find(std::string(folder) + " holds the class of another command (epure class "
                                             "slider-crank-velocity/poles --seed june --vary ") != std::string::npos);
    CHECK(ran.err.find("; choose another --out, or delete the folder") != std::string::npos);
    CHECK(contents(in_class("key.csv")) == key);
  };
  refused(5, "july");
  refused(1, "r=0.18..0.23/0.01");
  std::vector<std::string> set = lots;
  set.insert(set.end(), {"--set", "phi=30deg"});
  CHECK(make_over(words, set).exit == 2);
  // What does not fit is drawn again, with other lots.
  CHECK(make_over({"slider-crank-velocity/poles", "--count", "2", "--scale", "1:20"}).exit == 2);
  CHECK(make_over({"slider-crank-velocity/poles", "--count", "2", "--paper", "a3"}).exit == 2);
  // More may be in it, and how it looks may change.
  CHECK(make_over({"slider-crank-velocity/poles", "--count", "3", "--lang", "it"}).exit == 0);
  CHECK(contents(in_class("class.txt")).find("--count 3 --reading 0.5mm --lang it") != std::string::npos);
  // Also one that was stopped.
  fs::remove_all("out");
  fs::create_directories(in_class("2-blank.pdf/in-the-way"));
  REQUIRE(make_over(words).exit == 3);
  CHECK(make_over(words, {"--vary", "r=0.18|0.2"}).exit == 2);
}

namespace {

std::vector<std::string> texts_of_pages(const std::string& file) {
  const std::unique_ptr<poppler::document> document(poppler::document::load_from_file(file));
  REQUIRE(document);
  CHECK(std::unique_ptr<poppler::toc>(document->create_toc()));
  std::vector<std::string> all;
  for (int i = 0; i < document->pages(); ++i) {
    const poppler::byte_array utf8 = std::unique_ptr<poppler::page>(document->create_page(i))->text().to_utf8();
    all.emplace_back(utf8.begin(), utf8.end());
  }
  return all;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("class --booklet: all sheets to be solved in one PDF, and all solutions, in the order of the roster",
          "[class]") {
  const Scratch scratch;
  write("roster.csv", "number,name\n88,D'Angelo\n77,Rossi\n");
  const std::vector<std::string> words{"slider-crank-velocity", "--students", "roster.csv", "--booklet"};
  const std::string in = "out/slider-crank-velocity-class/";
  const Ran ran = make(words);
  REQUIRE(ran.exit == 0);
  CHECK(holds(ran.out, in + "blanks.pdf\n" + in + "solutions.pdf\n"));
  const std::vector<std::string> blanks = texts_of_pages(in + "blanks.pdf"),
                                 solutions = texts_of_pages(in + "solutions.pdf");
  REQUIRE(blanks.size() == 8);
  REQUIRE(solutions.size() == 8);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::string own = i < 4 ? "D'Angelo" : "Rossi", other = i < 4 ? "Rossi" : "D'Angelo";
    for (const auto* pages : {&blanks, &solutions}) {
      CHECK(holds((*pages)[i], own));
      CHECK_FALSE(holds((*pages)[i], other));
    }
    CHECK(holds(blanks[i], "Question"));
    CHECK_FALSE(holds(solutions[i], "Question"));
    CHECK(holds(solutions[i], "Construction"));
  }
  // The pages of the files, also where a run goes on.
  const std::unique_ptr<poppler::document> alone(poppler::document::load_from_file(in + "77-solution.pdf"));
  const poppler::byte_array utf8 = std::unique_ptr<poppler::page>(alone->create_page(2))->text().to_utf8();
  CHECK(std::string(utf8.begin(), utf8.end()) == solutions[6]);
  // Of an earlier class they are told.
  const std::vector<std::string> without{"slider-crank-velocity", "--students", "roster.csv"};
  CHECK(holds(make(without).err, "still holds 2 files of an earlier class, such as blanks.pdf"));
  const Ran moodle = make({"slider-crank-velocity", "--count", "1", "--booklet", "--format", "moodle"});
  CHECK(moodle.exit == 2);
  CHECK(holds(moodle.err, "--booklet binds sheets, and --format moodle writes none"));
}

TEST_CASE("class --format moodle: of one sheet its own question is asked, of all the exercise's", "[class]") {
  const Scratch scratch;
  const auto asked = [&](const std::string& name, const std::string& folder_of) {
    REQUIRE(make({name, "--count", "1", "--format", "moodle"}, {}).exit == 0);
    return question_in("out/" + folder_of + "-class/questions.xml");
  };
  const std::string own = "<p>At the given instant find the velocities by the method of poles.</p>";
  CHECK(holds(asked("slider-crank-velocity/poles", "slider-crank-velocity-poles"), own));
  const std::string whole = asked("slider-crank-velocity", "slider-crank-velocity");
  CHECK_FALSE(holds(whole, own));
  CHECK(holds(whole, "by the method of poles and by the polar diagram; draw the fixed"));
}

TEST_CASE("class: of one sheet its own scale counts, in Moodle and for mark by the key", "[class]") {
  const Scratch scratch;
  // On sheet poles, which has not been handed out, 1 cm is 2.5 m/s; on this one 1 m/s.
  const std::string sheet = "slider-crank-velocity/polar-diagram",
                    made = "out/slider-crank-velocity-polar-diagram-class/";
  REQUIRE(make({sheet, "--count", "1", "--format", "moodle"}, {}).exit == 0);
  CHECK(tolerance_in(field_of(question_in(made + "questions.xml"), "v_B")) == 0.05);
  const double v_B = std::stod(cell(read_csv_file(made + "key.csv"), 0, "v_B"));
  const auto verdict = [&](double off) {
    write("answers.csv", "number,v_B\n1," + std::to_string(v_B + off) + "\n");
    const Ran ran = run_real(
        {"mark", "slider-crank-velocity", "--answers", "answers.csv", "--key", made + "key.csv", "--format", "csv"});
    REQUIRE(ran.exit == 0);
    return cell(read_csv(ran.out, "marks"), 0, "v_B verdict");
  };
  CHECK(verdict(0.049) == "right");
  CHECK(verdict(0.051) == "wrong");
}

TEST_CASE("class: one of which nothing could be made leaves nothing", "[class]") {
  const Scratch scratch;
  const Ran none = make_over({"truss/plan", "--count", "2", "--scale", "2:1"}, {});
  CHECK_THAT(none.err, Contains("1 : 100 would fit"));
  CHECK_FALSE(fs::exists("out/truss-plan-class/class.txt"));
  CHECK(make_over({"truss/plan", "--count", "2", "--scale", "1:100"}, {}).exit == 0);
}
