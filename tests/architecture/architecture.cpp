// Who may include whom. Arrows go exercises -> geometry and exercises -> drawings, and nowhere else, but that all may
// include words, which knows no room; the bench stands above them all; within drawings and within what exercises
// share the rooms stand one upon the other; the analytic route shares no code with the constructions it checks; one
// file sees Cairo; CGAL is used only where it is LGPL.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/catch.h"

namespace {

namespace fs = std::filesystem;

const fs::path root = EPURE_SOURCE_DIR;

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](auto beginning) { return text.starts_with(beginning); });
}

// "exercises/gear-pair/figure.cpp" is in the folder "gear-pair" of exercises; "exercises/main.cpp" in none, "".
std::string exercise_folder(std::string_view path) {
  constexpr std::string_view room = "exercises/";
  if (!path.starts_with(room)) return "";
  path.remove_prefix(room.size());
  const auto slash = path.find('/');
  return slash == path.npos ? "" : std::string(path.substr(0, slash));
}

// The rooms within a room, from the lowest; what lies beside them is lower still.
const std::vector<std::string> drawings_rooms{"paths", "text", "labels", "marks", "charts", "sheet", "files"};
const std::vector<std::string> kit_rooms{"statement", "proof", "panels", "linkages", "rolling", "crane", "trusses"};

// How high the file stands among the rooms of `below`, which ends with a slash: -1 beside them, none elsewhere.
std::optional<std::ptrdiff_t> storey(std::string_view path, std::string_view below,
                                     const std::vector<std::string>& rooms) {
  if (!path.starts_with(below)) return {};
  path.remove_prefix(below.size());
  const auto slash = path.find('/');
  if (slash == path.npos) return -1;
  const auto found = std::find(rooms.begin(), rooms.end(), path.substr(0, slash));
  return found == rooms.end() ? std::nullopt : std::optional(found - rooms.begin());
}

bool runs_upwards(std::string_view file, std::string_view header, std::string_view below,
                  const std::vector<std::string>& rooms) {
  const auto from = storey(file, below, rooms), to = storey(header, below, rooms);
  return from && to && *from >= 0 && *to > *from;
}

bool is_cairo(std::string_view header) { return header.starts_with("cairo"); }

bool is_flint(std::string_view header) {
  return starts_with_any(header, {"flint", "arb", "arf", "acb", "mag.h", "fmp", "antic/", "calcium/", "ca.h"});
}

// Why `file` may not include `header`, both as paths from the root where they are ours; empty when it may.
std::string objection(std::string_view file, std::string_view header) {
  if (header.starts_with("CGAL/Circular_kernel_2")) return "CGAL's circular kernel is GPL";
  if (header.starts_with("catch2/") && file != "tests/support/catch.h")
    return "tests/support/catch.h includes Catch2, whichever of its versions is there";
  if (is_flint(header) && file != "geometry/numbers/flint.h")
    return "geometry/numbers/flint.h includes FLINT, Arb and Calcium, wherever their headers are";

  if (file.starts_with("geometry/")) {
    if (starts_with_any(header, {"drawings/", "exercises/"})) return "geometry knows neither drawings nor exercises";
    if (is_cairo(header) || starts_with_any(header, {"hb", "CLI/", "nlohmann/"}))
      return "geometry draws nothing and reads no files";
    if (header == "fstream" || header == "filesystem") return "geometry reads and writes no files";
  }
  // Whatever may be included from both routes (numbers) must not lead from one to the other.
  if (file.starts_with("geometry/numbers/") && header.starts_with("geometry/") &&
      !header.starts_with("geometry/numbers/"))
    return "numbers stand below everything else in geometry";
  if (file.starts_with("geometry/analytic/") && header.starts_with("geometry/") &&
      !starts_with_any(header, {"geometry/numbers/", "geometry/analytic/", "geometry/linkages/linkage.h",
                                "geometry/linkages/loads.h", "geometry/linkages/friction"}))
    return "the analytic route shares nothing but numbers, and what a linkage is and bears, with the constructions";
  // Coulomb's law too: which forces go with it either route finds by itself, from its own equilibrium.
  if (starts_with_any(file,
                      {"geometry/linkages/linkage.", "geometry/linkages/loads.", "geometry/linkages/friction"}) &&
      header.starts_with("geometry/") &&
      !starts_with_any(header, {"geometry/numbers/", "geometry/linkages/linkage.h", "geometry/linkages/loads.h",
                                "geometry/linkages/friction"}))
    return "what a linkage is and bears says nothing of how it is placed: both routes read it";
  if (file.starts_with("geometry/") && !file.starts_with("geometry/analytic/") &&
      header.starts_with("geometry/analytic/"))
    return "the constructions share nothing with the analytic route";

  if (file.starts_with("words/") && header.find('/') != header.npos) return "words stand below every room";

  if (header.starts_with("package/") && !starts_with_any(file, {"package/", "tests/"}))
    return "what is installed beside the program stands above all";
  if (header.starts_with("bench/") && !starts_with_any(file, {"bench/", "tests/"}))
    return "the bench stands above all";
  if (file.starts_with("bench/floor/") && starts_with_any(header, {"geometry/", "drawings/", "exercises/"}))
    return "the floor is what Cairo and Pango cost alone";
  if (file.starts_with("drawings/")) {
    if (starts_with_any(header, {"geometry/", "exercises/"})) return "drawings know neither geometry nor exercises";
    if (starts_with_any(header, {"CGAL/", "Eigen/", "gmp", "mpfr"}))
      return "drawings are plain data: no exact numbers, no linear algebra";
    if (runs_upwards(file, header, "drawings/", drawings_rooms))
      return "the rooms of drawings stand one upon the other";
  }

  if (const auto from = exercise_folder(file); !from.empty()) {
    const auto to = exercise_folder(header);
    if (!to.empty() && to != from && to != "kit" && !(from == "cli" && to == "scenes"))
      return "an exercise includes no other; what they share is in kit";
    if (runs_upwards(file, header, "exercises/kit/", kit_rooms)) return "the rooms of kit stand one upon the other";
  }
  return "";
}

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) FAIL("cannot read " << path);
  return text.str();
}

// The headers of a text, in order, as written between quotes or angle brackets.
std::vector<std::string> included(const std::string& text) {
  std::vector<std::string> headers;
  std::istringstream lines(text);
  const auto skip_blanks = [](std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  };
  for (std::string line; std::getline(lines, line);) {
    std::string_view rest = line;
    skip_blanks(rest);
    if (!rest.starts_with('#')) continue;
    rest.remove_prefix(1);
    skip_blanks(rest);
    if (!rest.starts_with("include")) continue;
    rest.remove_prefix(std::string_view("include").size());
    skip_blanks(rest);
    if (rest.empty() || (rest.front() != '"' && rest.front() != '<')) continue;
    const auto end = rest.find(rest.front() == '"' ? '"' : '>', 1);
    if (end != rest.npos) headers.emplace_back(rest.substr(1, end - 1));
  }
  return headers;
}

struct Include {
  std::string file, header;
};

std::string from_root(const fs::path& path) { return path.lexically_relative(root).generic_string(); }

std::vector<fs::path> sources(const std::string& room) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
    const auto extension = entry.path().extension();
    if (entry.is_regular_file() && (extension == ".h" || extension == ".cpp" || extension == ".c"))
      found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Every include of a room. A header named relative to its file ("../analytic/x.h") is given from the root.
std::vector<Include> includes(const std::string& room) {
  std::vector<Include> all;
  for (const auto& path : sources(room))
    for (const auto& header : included(contents(path))) {
      const auto beside = (path.parent_path() / header).lexically_normal();
      all.push_back({from_root(path), fs::exists(beside) ? from_root(beside) : header});
    }
  return all;
}

// The first of the words left behind for later that stands alone in the text, or nothing.
std::string reminder(const std::string& text) {
  const auto in_word = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  for (const std::string word : {"TO"
                                 "DO",
                                 "FIX"
                                 "ME",
                                 "XX"
                                 "X"})
    for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1))
      if (!in_word(at - 1) && !in_word(at + word.size())) return word;
  return "";
}

}  // namespace

TEST_CASE("includes follow the arrows between the rooms") {
  for (const std::string room : {"geometry", "drawings", "exercises", "bench", "package", "tests", "words"}) {
    const auto all = includes(room);
    {
      INFO(room << " reads nearly empty");
      REQUIRE(all.size() >= 3);
    }
    for (const auto& [file, header] : all) {
      INFO(file << " includes " << header);
      CHECK(objection(file, header) == "");
    }
  }
}

TEST_CASE("one file includes Cairo") {
  std::vector<std::string> files;
  const std::string apart = "bench/floor/floor.cpp";  // a program of its own, which shares no code with the rest
  for (const std::string room : {"geometry", "drawings", "exercises", "bench"})
    for (const auto& [file, header] : includes(room))
      if (file != apart && is_cairo(header) && (files.empty() || files.back() != file)) files.push_back(file);
  CAPTURE(files);
  CHECK(files.size() == 1);
}

TEST_CASE("every CGAL header in use is under the LGPL") {
  int seen = 0;
  for (const std::string room : {"geometry", "drawings", "exercises", "bench", "tests"})
    for (const auto& [file, header] : includes(room)) {
      if (!header.starts_with("CGAL/")) continue;
      ++seen;
      INFO(file << " includes " << header);
      CHECK(contents(fs::path(CGAL_HEADERS) / header).find("SPDX-License-Identifier: LGPL") != std::string::npos);
    }
  CHECK(seen > 0);
}

TEST_CASE("nothing is left for later") {
  int seen = 0;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
    const auto name = entry->path().filename().string();
    const bool top = entry.depth() == 0;
    if (top && (name == ".git" || name == "out" || name.starts_with("build"))) {
      entry.disable_recursion_pending();
      continue;
    }
    if (!entry->is_regular_file()) continue;
    const auto text = contents(entry->path());
    if (text.find('\0') != text.npos) continue;  // a font, a picture
    ++seen;
    INFO(from_root(entry->path()));
    CHECK(reminder(text) == "");
  }
  CHECK(seen >= 20);
}

TEST_CASE("each rule objects to what it forbids and to nothing else") {
  struct Example {
    std::string file, header;
    bool allowed;
  };
  const std::vector<Example> examples = {
      {"geometry/motion/pole.h", "geometry/constructions/line.h", true},
      {"geometry/motion/pole.h", "CGAL/Interval_nt.h", true},
      {"geometry/motion/pole.h", "drawings/picture.h", false},
      {"geometry/motion/pole.h", "exercises/kit/quantity.h", false},
      {"geometry/motion/pole.h", "cairo.h", false},
      {"geometry/motion/pole.h", "fstream", false},
      {"geometry/motion/pole.h", "geometry/numbers/flint.h", true},
      {"geometry/motion/pole.h", "arb.h", false},
      {"geometry/numbers/flint.h", "flint/arb.h", true},
      {"geometry/numbers/number.h", "geometry/numbers/given.h", true},
      {"geometry/numbers/number.h", "geometry/constructions/line.h", false},
      {"geometry/analytic/linkage.cpp", "geometry/analytic/newton.h", true},
      {"geometry/analytic/linkage.cpp", "geometry/numbers/number.h", true},
      {"geometry/analytic/linkage.cpp", "geometry/constructions/line.h", false},
      {"geometry/analytic/linkage.cpp", "geometry/motion/pole.h", false},
      {"geometry/analytic/linkage.cpp", "geometry/curves/trace.h", false},
      {"geometry/constructions/line.h", "geometry/analytic/newton.h", false},
      {"geometry/motion/pole.h", "geometry/analytic/newton.h", false},
      {"geometry/curves/trace.cpp", "geometry/analytic/newton.h", false},
      {"drawings/pdf.cpp", "cairo-pdf.h", true},
      {"drawings/pdf.cpp", "drawings/page.h", true},
      {"drawings/pdf.cpp", "geometry/numbers/number.h", false},
      {"drawings/pdf.cpp", "exercises/kit/quantity.h", false},
      {"drawings/pdf.cpp", "CGAL/Gmpq.h", false},
      {"drawings/pdf.cpp", "arb.h", false},
      {"drawings/pdf.cpp", "flint/arb.h", false},
      {"drawings/pdf.cpp", "calcium/ca.h", false},
      {"drawings/pdf.cpp", "Eigen/Dense", false},
      {"drawings/pdf.cpp", "words/words.h", true},
      {"geometry/motion/pole.h", "words/words.h", true},
      {"words/words.h", "string", true},
      {"words/words.h", "geometry/numbers/number.h", false},
      {"words/words.h", "drawings/picture.h", false},
      {"bench/floor/floor.cpp", "cairo-pdf.h", true},
      {"bench/floor/floor.cpp", "drawings/page.h", false},
      {"exercises/four-bar/figure.cpp", "exercises/four-bar/givens.h", true},
      {"exercises/four-bar/figure.cpp", "exercises/kit/quantity.h", true},
      {"exercises/four-bar/figure.cpp", "geometry/analytic/newton.h", true},
      {"exercises/four-bar/figure.cpp", "drawings/picture.h", true},
      {"exercises/four-bar/figure.cpp", "exercises/slider-crank/givens.h", false},
      {"exercises/kit/quantity.h", "exercises/slider-crank/givens.h", false},
      {"bench/benchmark.cpp", "bench/families.h", true},
      {"bench/benchmark.cpp", "exercises/cli/request.h", true},
      {"tests/bench/test_report.cpp", "bench/results.h", true},
      {"exercises/cli/run.cpp", "bench/benchmark.h", false},
      {"package/documents.cpp", "package/completion.h", true},
      {"package/completion.cpp", "exercises/cli/options.h", true},
      {"exercises/cli/options.cpp", "package/completion.h", false},
      {"drawings/marks/canvas.h", "drawings/page.h", true},
      {"drawings/marks/canvas.h", "drawings/labels/obstacles.h", true},
      {"drawings/labels/labels.cpp", "drawings/marks/canvas.h", false},
      {"exercises/kit/panels/plot.h", "exercises/kit/proof/exercise.h", true},
      {"exercises/kit/panels/plot.h", "exercises/kit/linkages/driving_crank.h", false},
      {"exercises/four-bar/figure.cpp", "bench/families.h", false},
      {"exercises/main.cpp", "exercises/cli.h", true},
      {"tests/geometry/pole.cpp", "CGAL/Circular_kernel_2.h", false},
      {"tests/geometry/pole.cpp", "tests/support/catch.h", true},
      {"tests/geometry/pole.cpp", "catch2/catch.hpp", false},
      {"tests/support/catch.h", "catch2/catch_all.hpp", true},
      {"geometry/constructions/circle.h", "CGAL/Circular_kernel_2/Circle_2.h", false},
  };
  for (const auto& [file, header, allowed] : examples) {
    INFO(file << " includes " << header);
    CHECK(objection(file, header).empty() == allowed);
  }
  CHECK(included("#include <a>\n  #  include \"b/c.h\"  // why\n// #include <d>\nint include;\n#include<e>") ==
        std::vector<std::string>{"a", "b/c.h", "e"});
  CHECK(reminder("// TO"
                 "DO: more") ==
        "TO"
        "DO");
  CHECK(reminder("FIX"
                 "ME") ==
        "FIX"
        "ME");
  CHECK(reminder("/tmp/XX"
                 "XXXX and TO"
                 "DOS") == "");
}
