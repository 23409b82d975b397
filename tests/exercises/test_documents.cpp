// Figures made for documents: their width, their formats, their ground.
#include <poppler-document.h>
#include <poppler-toc.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "drawings/output.h"
#include "drawings/page.h"
#include "exercises/kit/panels/scale.h"
#include "exercises/kit/proof/solution.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"
#include "tests/support/read_svg.h"

using namespace epure;

namespace {

using Typed = std::vector<std::string>;

void refused(const Typed& words, const std::string& part) {
  const Scratch scratch;
  const Ran ran = run_on_all(words);
  CAPTURE(words, ran.err);
  CHECK(ran.exit == 2);
  CHECK(ran.out.empty());
  CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
  CHECK(ran.err.find(part) != std::string::npos);
  CHECK(scratch.files().empty());
}

std::string svg_of(const Typed& options) {
  Typed words{"draw", "-o", "-", "--format", "svg"};
  words.insert(words.end(), options.begin(), options.end());
  const Ran ran = run_on_all(words);
  CAPTURE(words, ran.err);
  REQUIRE(ran.exit == 0);
  return ran.out;
}

// "123.4mm"
double width_of(const std::string& svg) {
  const drawings::SvgFile file(svg);
  const std::string width = file.root().attribute("width").value();
  REQUIRE(width.ends_with("mm"));
  return std::stod(width);
}

double height_of(const std::string& svg) {
  const drawings::SvgFile file(svg);
  const std::string height = file.root().attribute("height").value();
  REQUIRE(height.ends_with("mm"));
  return std::stod(height);
}

// Of lengths, as its first scale bar says: one fifth for "1 : 5".
double scale_of(const std::string& svg) {
  const std::regex ratio(R"(>(\d+) : (\d+)<)");
  std::smatch found;
  REQUIRE(std::regex_search(svg, found, ratio));
  return std::stod(found[1]) / std::stod(found[2]);
}

std::string as_typed(double scale) {
  return scale >= 1 ? std::to_string(std::lround(scale)) + ":1" : "1:" + std::to_string(std::lround(1 / scale));
}

// ISO 5455: 1, 2 and 5 times a power of ten.
double next_larger(double scale) {
  const double decade = std::pow(10, std::floor(std::log10(scale) + 1e-9)), leading = std::round(scale / decade);
  return decade * (leading == 1 ? 2 : leading == 2 ? 5 : 10);
}

}  // namespace

TEST_CASE("a figure of a width is the largest standard scale that is not wider") {
  struct Case {
    std::string sheet;
    std::vector<std::string> widths;
  };
  // Sheets of one figure of lengths, so that its scale alone decides.
  for (const Case& c : {Case{"slider-crank-velocity/poles", {"160mm", "122mm", "9cm", "3in"}},
                        Case{"slider-crank-velocity/coupler-curve", {"160mm", "122mm", "80mm"}},
                        Case{"slider-crank-velocity/polodes", {"150mm", "100mm"}}})
    for (const std::string& width : c.widths) {
      CAPTURE(c.sheet, width);
      const double mm = width.ends_with("in")   ? 25.4 * std::stod(width)
                        : width.ends_with("cm") ? 10 * std::stod(width)
                                                : std::stod(width);
      const std::string figure = svg_of({c.sheet, "--width", width});
      CHECK(width_of(figure) <= mm);
      const double scale = scale_of(figure);
      CAPTURE(scale, width_of(figure));
      const Ran larger = run_on_all(
          {"draw", c.sheet, "--bare", "--scale", as_typed(next_larger(scale)), "-o", "-", "--format", "svg"});
      if (larger.exit == 0)  // else it is too large for the paper
        CHECK(width_of(larger.out) > mm);
    }
}

TEST_CASE("a figure of a width is bare, and the same when it is said so") {
  const std::string figure = svg_of({"slider-crank-velocity/poles", "--width", "120mm"});
  CHECK(svg_of({"slider-crank-velocity/poles", "--width", "120mm", "--bare"}) == figure);
  CHECK(svg_of({"slider-crank-velocity/poles", "--width", "12cm"}) == figure);
  CHECK(svg_of({"slider-crank-velocity/poles", "--width", "120"}) == figure);
  CHECK(figure.find("Construction") == std::string::npos);
}

// The number before "mm" that a sentence names as an option: "--width 84mm".
int millimetres_told(const std::string& sentence, const std::string& option) {
  std::smatch found;
  CAPTURE(sentence);
  REQUIRE(std::regex_search(sentence, found, std::regex(option + " (\\d+)mm")));
  return std::stoi(found[1]);
}

TEST_CASE("a figure of a height is no higher, and of both no larger") {
  const std::string sheet = "slider-crank-velocity/poles";
  const std::string low = svg_of({sheet, "--height", "70mm"}),
                    both = svg_of({sheet, "--height", "70mm", "--width", "80mm"});
  CHECK(height_of(low) <= 70);
  CHECK(height_of(low) < height_of(svg_of({sheet, "--bare"})));
  CHECK(height_of(both) <= 70);
  CHECK(width_of(both) <= 80);
  CHECK(svg_of({sheet, "--height", "70mm", "--bare"}) == low);
  for (int height = 66; height <= 140; height += 3) {
    CAPTURE(height);
    CHECK(height_of(svg_of({sheet, "--height", std::to_string(height)})) <= height);
  }
  refused({"draw", sheet, "--height", "10mm"}, "higher than 10 mm at every standard scale");
  refused({"draw", sheet, "--height", "10mm", "--lang", "it"}, "più alta di 10 mm in ogni scala normalizzata");
  refused({"draw", sheet, "--height", "10mm", "--width", "150mm"}, "larger than 150 x 10 mm at every standard scale");
  refused({"draw", sheet, "--height", "0"}, "--height 0: ");
  refused({"draw", sheet, "--height", "70mm", "--scale", "1:5"}, "choose one of them");
}

TEST_CASE("a figure that is too wide is told the least width that would do") {
  for (const std::string sheet : {"slider-crank-velocity/poles", "friction-efficiency/efficiencies"}) {
    const Ran refusal = run_on_all({"draw", sheet, "--width", "15mm", "-o", "-", "--format", "svg"});
    CAPTURE(sheet, refusal.err);
    REQUIRE(refusal.exit == 2);
    const int least = millimetres_told(refusal.err, "--width");
    CHECK(run_on_all({"draw", sheet, "-o", "-", "--format", "svg", "--width", std::to_string(least)}).exit == 0);
    CHECK(run_on_all({"draw", sheet, "-o", "-", "--format", "svg", "--width", std::to_string(least - 1)}).exit == 2);
  }
}

TEST_CASE("a figure as large as its room to the last bit is drawn or refused") {
  // At this width two panels just fit beside each other, and rounding leaves -1e-14 mm between them.
  refused({"draw", "friction-efficiency/double-slider", "--width", "57mm"},
          "wider than 57 mm at every standard scale");
}

TEST_CASE("a figure that is hard to read is drawn, and the least width that reads well is told") {
  const Typed wanted{"draw", "slider-crank-velocity/poles", "-o", "-", "--format", "svg", "--width"};
  const auto drawn = [&](const std::string& width) {
    Typed words = wanted;
    words.push_back(width);
    return run_on_all(words);
  };
  const Ran small = drawn("60mm");
  CAPTURE(small.err);
  CHECK(small.exit == 0);
  CHECK(width_of(small.out) <= 60);
  CHECK(small.err.find("hard to read") != std::string::npos);
  CHECK(std::count(small.err.begin(), small.err.end(), '\n') == 1);
  const int least = millimetres_told(small.err, "--width");
  CHECK(drawn(std::to_string(least)).err.empty());
  CHECK_FALSE(drawn(std::to_string(least - 1)).err.empty());
  CHECK(drawn("122mm").err.empty());
}

TEST_CASE("every sheet is a figure of 160 mm or says that it is wider", "[slow]") {
  std::size_t figures = 0, wider = 0;
  for (const Listed& exercise : catalogue())
    for (const SheetSpec& sheet : exercise->about().sheets) {
      const std::string name = exercise.id() + "/" + sheet.name;
      CAPTURE(name);
      const Ran ran = run_on_all({"draw", name, "--width", "160mm", "-o", "-", "--format", "svg"});
      CAPTURE(ran.err);
      if (ran.exit == 0) {
        ++figures;
        CHECK(width_of(ran.out) <= 160);
      } else {
        ++wider;
        CHECK(ran.exit == 2);
        CHECK(ran.err.find("wider than 160 mm at every standard scale") != std::string::npos);
      }
    }
  CHECK(figures > 10 * wider);
}

TEST_CASE("a width that cannot be is one sentence, and nothing is written") {
  const std::string sheet = "slider-crank-velocity/poles";
  refused({"draw", sheet, "--width", "15mm"}, "wider than 15 mm at every standard scale");
  refused({"draw", sheet, "--width", "15,5mm", "--lang", "it"}, "più larga di 15,5 mm in ogni scala normalizzata");
  refused({"draw", "slider-crank-velocity", "--width", "15mm"}, "slider-crank-velocity/");
  for (const std::string bad : {"0", "-5mm", "2m"}) refused({"draw", sheet, "--width", bad}, "--width " + bad + ": ");
  refused({"draw", sheet, "--width", "wide"}, "--width: ");
  refused({"draw", sheet, "--width", "5kg"}, "--width: ");
  refused({"draw", sheet, "--width", "120mm", "--scale", "1:5"}, "choose one of them");
}

TEST_CASE("a bare figure has its scale bars right under it, on every sheet", "[slow]") {
  std::size_t with_bars = 0;
  for (const Listed& exercise : catalogue()) {
    const Solution solution = exercise->solution(Givens(exercise->about().givens));
    for (const SheetSpec& spec : exercise->about().sheets) {
      CAPTURE(exercise.id(), spec.name);
      drawings::Sheet sheet = exercise->draw(spec.name, solution, {.bare = true}).sheet;
      const drawings::Box all = drawings::compose(sheet).extent;
      double bars = 0, widest = 0;
      auto& marks = sheet.figure.marks;
      while (!marks.empty() && std::holds_alternative<drawings::ScaleBar>(marks.back())) {
        widest = std::max(widest, std::get<drawings::ScaleBar>(marks.back()).length);
        marks.pop_back();
        ++bars;
      }
      if (bars == 0) continue;
      ++with_bars;
      const drawings::Box figure = drawings::compose(sheet).extent;
      CHECK(all.high.y == figure.high.y);
      CHECK(figure.low.y - all.low.y < 12 * bars);  // a row is 10 mm high
      CHECK(all.width() <= std::max(figure.width(), widest + 25) + 1e-9);
    }
  }
  CHECK(with_bars > 60);
}

TEST_CASE("pictures and PostScript of sheets, beside PDF and SVG") {
  const Scratch scratch;
  CHECK(run({"draw", "triangle", "--format", "png,eps,svg"}).out ==
        "out/triangle-sides.png\nout/triangle-small.png\nout/triangle-sides.eps\nout/triangle-small.eps\n"
        "out/triangle-sides.svg\nout/triangle-small.svg\n");
  CHECK(contents("out/triangle-sides.png").starts_with("\x89PNG"));
  CHECK(contents("out/triangle-sides.eps").starts_with("%!PS-Adobe-3.0 EPSF"));
  CHECK(run({"draw", "triangle/sides", "-o", "-", "--format", "png"}).out == contents("out/triangle-sides.png"));
  CHECK(run({"draw", "triangle/sides", "-o", "t.png", "--dpi", "150"}).exit == 0);
  CHECK(contents("t.png") == contents("out/triangle-sides.png"));
  // An A4 sheet at 100 dpi has 1169 x 827 pixels.
  const std::string small = run({"draw", "triangle/sides", "-o", "-", "--format", "png", "--dpi", "100"}).out;
  CHECK(small.substr(16, 8) == std::string({0, 0, 4, '\x91', 0, 0, 3, '\x3b'}));
}

TEST_CASE("a resolution that makes no sense is refused") {
  const std::string sheet = "slider-crank-velocity/poles";
  for (const std::string bad : {"0", "19", "1201", "-300"})
    refused({"draw", sheet, "--format", "png", "--dpi", bad}, "--dpi " + bad + ": must lie between 20 and 1200");
  refused({"draw", sheet, "--format", "png", "--dpi", "fine"}, "--dpi: ");
  refused({"draw", sheet, "--dpi", "300"}, "add --format png");
  refused({"draw", sheet, "--format", "png", "--dpi", "1200"},
          "14031 x 9921 pixels, and epure paints at most 80 million");
}

TEST_CASE("a background and its inks reach every format") {
  const std::string sheet = "slider-crank-velocity/poles";
  const std::string plain = svg_of({sheet}), dark = svg_of({sheet, "--background", "#1E1E2E"});
  CHECK(plain.find("#1e1e2e") == std::string::npos);
  CHECK(dark.find("fill=\"#1e1e2e\"") != std::string::npos);
  CHECK(dark.find("#f2f2f2") != std::string::npos);  // letters
  CHECK(svg_of({sheet, "--background", "#1e1e2e", "--ink", "light"}) == dark);
  CHECK(svg_of({sheet, "--background", "white"}).find("fill=\"#fff\"") != std::string::npos);
  CHECK(svg_of({sheet, "--ink", "light"}).find("fill=\"#1a1a1a\"") != std::string::npos);  // a dark sheet
  const std::string clear = svg_of({sheet, "--background", "none"});
  CHECK(clear.find("width=\"100%\"") == std::string::npos);
  CHECK(svg_of({sheet, "--bare", "--background", "none"}) == svg_of({sheet, "--bare"}));
  for (const std::string format : {"pdf", "png", "eps"}) {
    CAPTURE(format);
    const auto drawn = [&](const std::string& colour) {
      return run_on_all({"draw", sheet, "-o", "-", "--format", format, "--background", colour}).out;
    };
    CHECK_FALSE(drawn("#1e1e2e").empty());
    CHECK(drawn("#1e1e2e") != drawn("white"));
  }
}

TEST_CASE("colours that are none, or cannot be read, are refused") {
  const std::string sheet = "slider-crank-velocity/poles";
  for (const std::string bad : {"", "black", "#12345", "#1234567", "#12345g", "1e1e2e", "#-12345"})
    refused({"draw", sheet, "--background", bad}, "--background " + bad + ": write white, none or a colour");
  refused({"draw", sheet, "--ink", "red"}, "--ink red: choose dark or light");
  refused({"draw", sheet, "--ink", "dark", "--background", "#000000"}, "its contrast there is at most 1.0");
  refused({"draw", sheet, "--ink", "light", "--background", "white"}, "choose --ink dark");
  refused({"draw", sheet, "--ink", "light", "--background", "#ffffff", "--lang", "it"}, "le lettere ne vogliono 4,5");
}

TEST_CASE("a PDF of several sheets has bookmarks, and says what it is") {
  const auto opened = [](const Typed& words) {
    const std::string bytes = run_on_all(words).out;
    poppler::byte_array data(bytes.begin(), bytes.end());
    return std::unique_ptr<poppler::document>(poppler::document::load_from_data(&data));
  };
  const auto info = [](const poppler::document& of, const std::string& key) {
    const poppler::byte_array utf8 = of.info_key(key).to_utf8();
    return std::string(utf8.begin(), utf8.end());
  };
  const auto one = opened({"draw", "slider-crank-velocity", "-o", "-", "--author", "M. Rossi"});
  REQUIRE(one);
  CHECK(info(*one, "Author") == "M. Rossi");
  CHECK(info(*one, "Subject").find("N.1") != std::string::npos);
  CHECK(std::unique_ptr<poppler::toc>(one->create_toc()));
  const auto single = opened({"draw", "slider-crank-velocity/poles", "-o", "-"});
  REQUIRE(single);
  CHECK_FALSE(std::unique_ptr<poppler::toc>(single->create_toc()));
  CHECK(info(*single, "Author").empty());
}

TEST_CASE("a figure for TeX is two files, one of which names the other") {
  const Scratch scratch;
  CHECK(run({"draw", "triangle/sides", "-o", "figure.tex"}).out == "figure.tex\nfigure-art.pdf\n");
  CHECK(contents("figure.tex").find("\\includegraphics{figure-art.pdf}") != std::string::npos);
  CHECK(contents("figure-art.pdf").starts_with("%PDF"));
  CHECK(run({"draw", "triangle", "--format", "pdf+tex"}).out ==
        "out/triangle-sides.tex\nout/triangle-sides-art.pdf\nout/triangle-small.tex\nout/triangle-small-art.pdf\n");
  refused({"draw", "slider-crank-velocity/poles", "--format", "pdf+tex", "-o", "-"}, "writes two files");
  refused({"draw", "slider-crank-velocity/poles", "-o", "my%figure.tex"}, "my%figure.tex");
}
