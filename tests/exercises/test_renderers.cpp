// Sheets as programs show them: SVG like PDF, and several drawings in one web page as each of them alone. With the
// first program that is at hand; a browser is needed for the web page.
#include <array>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "drawings/output.h"
#include "exercises/kit/proof/exercise.h"
#include "exercises/kit/statement/givens.h"
#include "tests/exercises/picture.h"
#include "tests/support/catch.h"

using namespace epure;
namespace fs = std::filesystem;

namespace {

constexpr double resolution = 288;                                     // dots per inch
constexpr int square = static_cast<int>(2 / 25.4 * resolution + 0.5);  // 2 mm: a letter

class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "epure-renderers-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    folder_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path operator/(const char* name) const { return folder_ / name; }

 private:
  fs::path folder_;
};

bool run(const std::string& command) { return std::system((command + " > /dev/null 2>&1").c_str()) == 0; }
bool is_at_hand(const std::string& program) { return run("command -v " + program); }
std::string in_shell(const fs::path& path) { return "'" + path.string() + "'"; }

void write(const fs::path& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out << bytes;
  REQUIRE(out.flush());
}

// What a browser shows of a page of `width` x `height` CSS pixels, `scale` dots to each.
Picture seen_by_chromium(const Scratch& scratch, const fs::path& page, int width, int height, double scale) {
  const fs::path png = scratch / "browser.png", profile = scratch / "profile";
  fs::remove(png);
  const std::string dots = std::to_string(scale);
  REQUIRE(
      run("timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run"
          " --disable-background-networking --disable-component-update --disable-sync --hide-scrollbars"
          " --user-data-dir=" +
          in_shell(profile) + " --window-size=" + std::to_string(width) + "," + std::to_string(height) +
          " --force-device-scale-factor=" + dots + " --screenshot=" + in_shell(png) + " " +
          in_shell("file://" + page.string())));
  fs::remove_all(profile);
  return Picture(png);
}

enum class Program { librsvg, chromium, inkscape, libreoffice };
constexpr std::array names{"rsvg-convert", "chromium", "inkscape", "soffice"};

Picture seen_by(Program program, const Scratch& scratch, const std::string& svg) {
  const fs::path file = scratch / "sheet.svg", png = scratch / "sheet.png", pdf = scratch / "sheet.pdf";
  write(file, svg);
  const std::string dots = std::to_string(resolution);
  switch (program) {
    case Program::librsvg:
      REQUIRE(run("rsvg-convert -d " + dots + " -p " + dots + " -o " + in_shell(png) + " " + in_shell(file)));
      return Picture(png);
    case Program::chromium:
      return seen_by_chromium(scratch, file, 1123, 794, resolution / 96);
    case Program::inkscape:
      REQUIRE(run("inkscape --export-type=png --export-dpi=" + dots + " -o " + in_shell(png) + " " + in_shell(file)));
      return Picture(png);
    case Program::libreoffice:
      break;
  }
  REQUIRE(run("soffice -env:UserInstallation=file://" + in_shell(scratch / "office") +
              " --headless --convert-to pdf --outdir " + in_shell(pdf.parent_path()) + " " + in_shell(file)));
  REQUIRE(run("pdftocairo -png -singlefile -r " + dots + " " + in_shell(pdf) + " " + in_shell(scratch / "sheet")));
  return Picture(png);
}

Picture seen_as_pdf(const Scratch& scratch, const drawings::Sheet& sheet) {
  const fs::path file = scratch / "drawing.pdf";
  write(file, drawings::pdf({sheet}, "t"));
  REQUIRE(run("pdftocairo -png -singlefile -r " + std::to_string(resolution) + " " + in_shell(file) + " " +
              in_shell(scratch / "drawing")));
  return Picture(scratch / "drawing.png");
}

// "ID/SHEET" with other givens than the stated ones.
drawings::Sheet sheet(const std::string& name, const SheetRequest& request = {},
                      const std::vector<std::string>& other_givens = {}) {
  const auto slash = name.find('/');
  for (const auto& exercise : catalogue())
    if (exercise->about().id == name.substr(0, slash)) {
      Givens givens(exercise->about().givens);
      for (const std::string& each : other_givens) givens.set(each);
      return exercise->draw(name.substr(slash + 1), givens, request).sheet;
    }
  FAIL("no exercise for " << name);
  return {};
}

// By EPURE_RENDERER, or the first that is at hand.
std::optional<Program> renderer() {
  const char* asked = std::getenv("EPURE_RENDERER");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (asked ? asked == std::string(names[i]) : is_at_hand(names[i])) return static_cast<Program>(i);
  return {};
}

}  // namespace

TEST_CASE("an SVG looks like the PDF") {
  const std::optional<Program> program = renderer();
  if (!program || !is_at_hand("pdftocairo")) {
    WARN("not tried: it takes pdftocairo and one of rsvg-convert, chromium, inkscape, soffice");
    return;
  }
  INFO("by " << names[static_cast<std::size_t>(*program)]);
  const Scratch scratch;
  const SheetRequest english, italian{.language = Language::italian};
  for (const drawings::Sheet& each :
       {sheet("slider-crank-velocity/polodes"), sheet("gear-pair/pitch-point", italian), sheet("gear-pair/sliding"),
        sheet("four-bar-analytic/omega-4", italian), sheet("rivals-polygons/acceleration-of-B"),
        sheet("pin-in-slot/forces", italian), sheet("point-mass/table", italian)}) {
    INFO(each.id);
    const Picture svg = seen_by(*program, scratch, drawings::svg(each)), pdf = seen_as_pdf(scratch, each);
    CHECK(std::abs(svg.width() - pdf.width()) <= 1);
    CHECK(std::abs(svg.height() - pdf.height()) <= 1);
    CHECK(worst_difference(svg, pdf, square) < 0.1);
  }
  // What the measure is worth: one letter moved by a tenth of its size (0.3 mm) is seen.
  const drawings::Sheet polodes = sheet("slider-crank-velocity/polodes");
  std::string moved = drawings::svg(polodes);
  const auto place = moved.find("x=\"", moved.rfind("</text>", moved.size() / 2));
  REQUIRE(place != moved.npos);
  const auto end = moved.find('"', place + 3);
  moved.replace(place + 3, end - place - 3, std::to_string(std::stoi(moved.substr(place + 3)) + 100));
  CHECK(worst_difference(seen_by(*program, scratch, moved), seen_as_pdf(scratch, polodes), square) > 0.1);
}

TEST_CASE("in one web page each drawing looks as it does alone") {
  if (!is_at_hand("chromium")) {
    WARN("not tried: it takes chromium");
    return;
  }
  const Scratch scratch;
  const SheetRequest bare{.bare = true};
  // Variants: other givens, languages, bare beside whole.
  std::vector<std::string> drawn;
  for (const drawings::Sheet& each :
       {sheet("slider-crank-velocity/poles"), sheet("slider-crank-velocity/poles", {}, {"r=0.25"}),
        sheet("slider-crank-velocity/poles", {.language = Language::italian}),
        sheet("slider-crank-velocity/poles", bare), sheet("gear-pair/pitch-point", bare),
        sheet("gear-pair/pitch-point", bare, {"z1=12", "z2=31", "x1=0.4", "alpha=20deg"}),
        sheet("gear-pair/pitch-point", {.paper = drawings::Paper::a3})}) {
    const std::string svg = drawings::svg(each);
    drawn.push_back(svg.substr(svg.find("<svg")));
  }
  constexpr int apart = 1200;  // CSS pixels: more than A3 is high
  const int height = apart * static_cast<int>(drawn.size());
  // Those with an empty place take as much room, so that a drawing is at the same place in each page.
  const auto page = [&](const auto& is_shown, bool has_hidden = false) {
    std::string html = "<!DOCTYPE html><meta charset=utf-8><body style='margin:0'>";
    if (has_hidden) html += "<div style='display:none'>" + drawn.back() + drawn.front() + "</div>";
    for (std::size_t i = 0; i < drawn.size(); ++i)
      html += "<div style='height:" + std::to_string(apart) + "px'>" + (is_shown(i) ? drawn[i] : "") + "</div>";
    write(scratch / "page.html", html);
    return seen_by_chromium(scratch, scratch / "page.html", 1600, height, 1);
  };
  // Before them two that are not shown, as behind the tabs of a page: what those define must not be missed.
  const Picture together = page([](std::size_t) { return true; }, true);
  for (std::size_t shown = 0; shown < drawn.size(); ++shown) {
    INFO("drawing " << shown);
    const Picture alone = page([&](std::size_t i) { return i == shown; });
    int differ = 0, inked = 0;
    for (int y = apart * static_cast<int>(shown); y < apart * static_cast<int>(shown + 1); ++y)
      for (int x = 0; x < together.width(); ++x) {
        bool same = true, white = true;
        for (int channel = 0; channel < 3; ++channel) {
          same = same && together.at(x, y, channel) == alone.at(x, y, channel);
          white = white && alone.at(x, y, channel) == 255;
        }
        differ += !same;
        inked += !white;
      }
    CHECK(differ == 0);
    CHECK(inked > 5000);
  }
}
