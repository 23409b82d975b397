// The mechanisms of docs/scenes are within the program, and named as exercises are.
#include "exercises/scenes/shipped.h"

#include <filesystem>
#include <sstream>

#include "exercises/cli/catalogue.h"
#include "exercises/cli/run.h"
#include "exercises/scenes/file/file_head.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

struct Ran {
  int exit;
  std::string out, err;
};
Ran run(const std::vector<std::string>& words) {
  std::ostringstream out, err;
  const int exit = run_cli(catalogue(), words, out, err);
  return {exit, out.str(), err.str()};
}

}  // namespace

TEST_CASE("each file of docs/scenes is within the program, whole, with a title and a book of its own", "[scenes]") {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(EPURE_SCENES)) {
    if (entry.path().extension() != ".yaml") continue;
    ++files;
    const std::string text = scenes::bytes_of(entry.path()),
                      id = scenes::read_head(scenes::File(entry.path()), scenes::read_text_tree(entry.path(), text))
                               .id;
    CAPTURE(id);
    REQUIRE(scenes::shipped_scene(id));
    CHECK(scenes::shipped_scene(id)->text == text);
    const scenes::FileHead head = scenes::head_of(*scenes::shipped_scene(id));
    CHECK(head.title.english != id);
    CHECK(head.source.english != head.source.italian);  // "after", "da"
    CHECK_THAT(text, StartsWith("# "));
    for (const Listed& exercise : catalogue()) CHECK(exercise.id() != id);
  }
  CHECK(files == scenes::shipped_scenes().size());
  CHECK(files >= 24);
}

TEST_CASE("a shipped mechanism is named by its id", "[scenes]") {
  const std::string file = EPURE_SCENES "/watt.yaml";
  for (const std::string sheet : {"velocities", "accelerations"}) {
    const Ran by_id = run({"draw", "watt-six-bar/" + sheet, "--format", "svg", "-o", "-"});
    CHECK(by_id.exit == 0);
    CHECK(by_id.out == run({"draw", file + "/" + sheet, "--format", "svg", "-o", "-"}).out);
  }
  CHECK(run({"list", "watt-six-bar"}).out == run({"list", file}).out);
  CHECK(run({"check", "watt-six-bar", "--set", "nothing=1"}).exit == 2);
  CHECK_THAT(run({"draw", "watt-six-bar/velocitis"}).err, Contains("did you mean velocities?"));
  CHECK_THAT(run({"check", "watt-six"}).err, Contains("did you mean watt-six-bar?"));
  CHECK_THAT(run({"check", "four-bar", "watt-six-bar"}).err, Contains("exercises alone"));
}

TEST_CASE("scenes stands for all shipped mechanisms, and list names them", "[scenes]") {
  const std::string listed = run({"list"}).out, all = run({"list", "scenes"}).out;
  for (const std::string& id : scenes::shipped_ids()) {
    CHECK_THAT(listed, Contains("\n" + id + " "));
    CHECK_THAT("\n" + all, Contains("\n" + id + " "));
  }
  CHECK_THAT(all, !Contains("velocity-centre"));
  const Ran checked = run({"check", "scenes", "--quiet"});
  CHECK(checked.exit == 0);
  CHECK_THAT(checked.out, StartsWith("passed: "));
  CHECK_THAT(run({"check", "all", "--quiet"}).out, !Contains(checked.out));
}

// Where everybody looks first, and where points coincide and links rest: what does not close is refused, nothing is
// left open.
TEST_CASE("shipped mechanisms are known where the link that drives them lies along an axis", "[scenes]") {
  int passed = 0;
  for (const char* angle : {"phi", "theta"})
    for (const std::string& id : scenes::shipped_ids()) {
      if (run({"list", id}).out.find("\n  " + std::string(angle) + " ") == std::string::npos) continue;
      for (const char* place : {"0", "90deg", "180deg", "270deg"}) {
        const Ran checked = run({"check", id, "--quiet", "--set", std::string(angle) + "=" + place});
        CAPTURE(id, place, checked.out, checked.err);
        CHECK((checked.exit == 0 || checked.exit == 2));
        passed += checked.exit == 0;
      }
    }
  CHECK(passed > 60);
}
