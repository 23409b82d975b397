#include <fmt/format.h>
#include <poppler-font.h>
#include <poppler-page.h>
#include <poppler-toc.h>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <fstream>
#include <locale>
#include <map>
#include <random>
#include <regex>
#include <set>
#include <sstream>

#include "drawings/files/pdf_language.h"
#include "drawings/page.h"
#include "drawings/paths/grid.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/typeset.h"
#include "drawings/text/unicode.h"
#include "read_pdf.h"
#include "tests/support/catch.h"
#include "tests/support/read_svg.h"
#include "tests/support/unpacked.h"

using namespace epure::drawings;

namespace {

const Colour blue{0, 0x72 / 255.0, 0xB2 / 255.0, 1};

Page page(std::vector<Primitive> primitives, Box extent = {{0, 0}, {297, 210}}) {
  return {"demo", "Velocities: è ω <&\">", "Crank & rocker, v_B = 2.45 m/s",
          extent, Language::english,       std::move(primitives)};
}
Stroke line(Point from, Point to, std::string name = {}) {
  return {segment(from, to), 0.25, {}, blue, {}, std::move(name)};
}
PlacedText text(std::string rich, Point at) { return {std::move(rich), at, 3.5, {}, Weight::regular}; }
Fill square(Point corner, double side, Colour colour, std::string name = {}) {
  return {polyline({corner, corner + Point{side, 0}, corner + Point{side, side}, corner + Point{0, side}}, true),
          colour,
          {},
          std::move(name)};
}

Page rich_page(const std::string& id = "demo") {
  Page all = page({line({20, 30}, {120, 90}, "v_B"), line({20, 30}, {60, 10}, "v_A"),
                   square({40, 40}, 20, {0, 0, 0, 0.06}, "plate"), text("$\\vec{v}_{BA}$ ⊥ BA", {30, 100}),
                   text("1 cm ≙ 2.5 m/s", {30, 110}), text("$v_{B}$ = 2.45 m/s, $ω_3$ = $-13.2$ rad/s", {30, 120})});
  all.id = id;
  Stroke dashed{circle({100, 60}, 30), 0.18, {6, 1, 0.5, 1}, {}, Box{{80, 40}, {200, 80}}, "path_A"};
  all.primitives.push_back(dashed);
  all.primitives.emplace_back(PlacedText{"Slider-crank", {30, 150}, 5, blue, Weight::bold});
  return all;
}

std::string complaint(const Page& bad) {
  std::string message;
  try {
    write_svg(bad);
  } catch (const std::invalid_argument& error) {
    message = error.what();
  }
  // Both writers refuse the same things.
  if (!message.empty()) CHECK_THROWS_WITH(write_pdf({bad}, {"t"}), message);
  return message;
}

// Where the origin of an element's coordinates is on the page, and how large its unit is there: from the groups
// around it and its own place, in units of the page.
struct Placement {
  double x = 0, y = 0, scale = 1;
};
Placement placement(pugi::xml_node element) {
  Placement at{element.attribute("x").as_double(), element.attribute("y").as_double(), 1};
  for (pugi::xml_node node = element; node; node = node.parent()) {
    const pugi::xml_attribute transform = node.attribute("transform");
    if (!transform) continue;
    double x = 0, y = 0, scale = 1;
    const int numbers = std::sscanf(transform.value(), "translate(%lf %lf) scale(%lf)", &x, &y, &scale);
    REQUIRE((numbers == 3 || transform.value() == fmt::format("translate({:.0f})", x)));
    at = {x + scale * at.x, y + scale * at.y, scale * at.scale};
  }
  return at;
}

Point in_points_from_top(Point filed, Box extent) {
  return {filed.x * points_per_mm - on_grid_in_points(extent.low.x),
          on_grid_in_points(extent.high.y) - filed.y * points_per_mm};
}

}  // namespace

TEST_CASE("a closed path is closed in the SVG, and no other") {
  Sheet sheet;
  sheet.id = "paths";
  sheet.bare = true;
  const std::vector<Point> corners{{60, 60}, {90, 60}, {70, 90}};
  sheet.figure.marks = {Line{polyline(corners, true), Meaning::link, "closed"},
                        Line{polyline(corners, false), Meaning::link, "open"}};
  const SvgFile written(svg(sheet));
  const auto path = [&](const char* id) { return std::string(written.element(id).attribute("d").value()); };
  CHECK(path("paths-closed").ends_with('z'));
  CHECK_FALSE(path("paths-open").ends_with('z'));
}

TEST_CASE("a drawn length is found in the SVG by its name, as long as it was asked for") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0, 297), y(0, 210);
  double worst = 0;
  for (int round = 0; round < 300; ++round) {
    const Point a{x(random), y(random)}, b{x(random), y(random)};
    const SvgFile svg(write_svg(page({line({1, 1}, {2, 2}), line(a, b, "v_B"), square(b, 3, blue)})));
    const double found = svg.length("demo-v_B");
    const double filed = distance(as_filed(a, Paper::a4), as_filed(b, Paper::a4));
    CHECK(std::abs(found - filed) < 2e-6);  // the decimals of the file
    CHECK(std::abs(found - distance(a, b)) < file_resolution * std::sqrt(2) + 2e-6);
    worst = std::max(worst, std::abs(found - distance(a, b)));
  }
  CHECK(worst > file_resolution / 10);  // rounding is really there, and as_filed tells it
}

TEST_CASE("PDF and SVG hold each position where as_filed says, on whole pages and crops") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> x(60, 180), y(40, 150);
  for (const Box extent : {Box{{0, 0}, {297, 210}}, Box{{0, 0}, {420, 297}}, Box{{50.123, 33.333}, {200.777, 160.1}}})
    for (int round = 0; round < 50; ++round) {
      const Point a{x(random), y(random)}, b{x(random), y(random)};
      const Page drawn = page({line(a, b, "v")}, extent);
      const Point a_filed = as_filed(a, Paper::a4), b_filed = as_filed(b, Paper::a4);

      const auto lines = drawn_lines(commands_of(write_pdf({drawn}, {"t"})));
      REQUIRE(lines.size() == 1);
      // Three decimals of a point are printed.
      CHECK(distance(lines[0].from, in_points_from_top(a_filed, extent)) < 0.0005 * std::sqrt(2) + 1e-9);
      CHECK(distance(lines[0].to, in_points_from_top(b_filed, extent)) < 0.0005 * std::sqrt(2) + 1e-9);

      const auto corners = SvgFile(write_svg(drawn)).points("demo-v");
      const Point corner{on_grid(extent.low.x), on_grid(extent.high.y)};
      CHECK(corners[0].x == Approx(a_filed.x - corner.x).margin(1e-6));
      CHECK(corners[0].y == Approx(corner.y - a_filed.y).margin(1e-6));
      CHECK(corners[1].x == Approx(b_filed.x - corner.x).margin(1e-6));
      CHECK(corners[1].y == Approx(corner.y - b_filed.y).margin(1e-6));
    }
}

TEST_CASE("as_filed moves a point by at most half a step and then leaves it") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-500, 500);
  for (int round = 0; round < 1000; ++round) {
    const Point p{x(random), x(random)}, once = as_filed(p, Paper::a3);
    CHECK(std::abs(once.x - p.x) <= file_resolution / 2 * (1 + 1e-9));
    CHECK(std::abs(once.y - p.y) <= file_resolution / 2 * (1 + 1e-9));
    const Point twice = as_filed(once, Paper::a3);
    CHECK((twice.x == once.x && twice.y == once.y));
  }
}

TEST_CASE("the PDF has pages of the right size, its title, no author and no dates") {
  const std::string bytes =
      write_pdf({page({line({1, 1}, {9, 9})}), page({}, {{10, 20}, {110, 70}}), page({}, {{0, 0}, {420, 297}})},
                {"Slider-crank – è <title>"});
  const auto document = open_pdf(bytes);
  REQUIRE(document->pages() == 3);
  const double sizes[3][2] = {{297, 210}, {100, 50}, {420, 297}};
  for (int i = 0; i < 3; ++i) {
    const std::unique_ptr<poppler::page> opened(document->create_page(i));
    CHECK(opened->page_rect().width() == Approx(sizes[i][0] / 25.4 * 72).margin(1e-3));
    CHECK(opened->page_rect().height() == Approx(sizes[i][1] / 25.4 * 72).margin(1e-3));
  }
  const poppler::byte_array title = document->info_key("Title").to_utf8();
  CHECK(std::string(title.begin(), title.end()) == "Slider-crank – è <title>");
  CHECK_THAT(document->info_key("Creator").to_latin1(), StartsWith("epure "));
  CHECK(document->info_key("Author").empty());
  CHECK(bytes.find("CreationDate") == bytes.npos);
  CHECK(bytes.find("ModDate") == bytes.npos);
}

TEST_CASE("a PDF names its author and subject, and has bookmarks to its pages, in two levels") {
  const std::vector<Page> pages{page({}, {{0, 0}, {100, 50}}), page({}, {{0, 0}, {100, 50}}),
                                page({}, {{0, 0}, {100, 50}})};
  const std::string bytes = write_pdf(
      pages,
      {.title = "t",
       .author = "Müller, (A) \\ B",
       .subject = "N.1",
       .bookmarks = {
           {"Slider-crank", 0}, {"Poles", 0, true}, {"Polodes – ω", 1, true}, {"Four-bar", 2}, {"Poles", 2, true}}});
  const auto document = open_pdf(bytes);
  const auto info = [&](const std::string& key) {
    const poppler::byte_array utf8 = document->info_key(key).to_utf8();
    return std::string(utf8.begin(), utf8.end());
  };
  CHECK(info("Author") == "Müller, (A) \\ B");
  CHECK(info("Subject") == "N.1");
  const std::unique_ptr<poppler::toc> outline(document->create_toc());
  REQUIRE(outline);
  std::vector<std::string> titles;
  for (const poppler::toc_item* above : outline->root()->children()) {
    const auto add = [&](const std::string& indent, const poppler::toc_item& item) {
      const poppler::byte_array utf8 = item.title().to_utf8();
      titles.push_back(indent + std::string(utf8.begin(), utf8.end()));
    };
    add("", *above);
    for (const poppler::toc_item* within : above->children()) add("  ", *within);
  }
  CHECK(titles == std::vector<std::string>{"Slider-crank", "  Poles", "  Polodes – ω", "Four-bar", "  Poles"});
  // In the order of the bookmarks' objects: which page each leads to.
  const std::string plain = epure::with_packed_objects(bytes);
  const auto objects = [&](const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator at(plain.begin(), plain.end(), pattern), end; at != end; ++at)
      found.push_back((*at)[1]);
    return found;
  };
  const std::vector<std::string> kids = objects(std::regex(R"(/Kids \[ (.*) \])")),
                                 leads = objects(std::regex(R"(/Dest \[(\d+ 0 R))"));
  REQUIRE(kids.size() == 1);
  REQUIRE(leads.size() == 5);
  CHECK(leads[0] == leads[1]);
  CHECK(leads[3] == leads[4]);
  CHECK(kids[0] == leads[0] + " " + leads[2] + " " + leads[3]);

  CHECK_THROWS_AS(write_pdf(pages, {.title = "t", .bookmarks = {{"beyond", 3}}}), std::invalid_argument);
  CHECK_THROWS_AS(write_pdf(pages, {.title = "t", .author = "\xFF"}), std::invalid_argument);
  CHECK_THROWS_AS(write_pdf(pages, {.title = "t", .bookmarks = {{"\xFF", 0}}}), std::invalid_argument);
}

TEST_CASE("a PDF tells its language in its root, and is whole") {
  for (const Language language : {Language::english, Language::italian})
    for (const std::vector<Bookmark>& bookmarks : {std::vector<Bookmark>{}, {{"Poles", 0}, {"Polodes", 1, true}}}) {
      std::vector<Page> pages{rich_page("a"), rich_page("b")};
      for (Page& each : pages) each.language = language;
      const std::string bytes = write_pdf(pages, {.title = "/Type /Catalog", .bookmarks = bookmarks});
      const std::string told = language == Language::english ? "(en)" : "(it)";
      CHECK_THAT(root_of(bytes), StartsWith("<< /Type /Catalog\n   /Lang " + told + "\n   /Pages "));
      CHECK(complaints_of(bytes).empty());
      CHECK(open_pdf(bytes)->pages() == 2);
    }
}

TEST_CASE("the text of a PDF can be searched and copied") {
  const auto document = open_pdf(write_pdf({rich_page()}, {"t"}));
  const std::string found = text_of(*document, 0);
  CHECK_THAT(found, Contains("v_BA ⊥ BA"));
  CHECK_THAT(found, Contains("1 cm ≙ 2.5 m/s"));
  CHECK_THAT(found, Contains("v_B = 2.45 m/s, ω_3 = −13.2 rad/s"));
  CHECK_THAT(found, Contains("Slider-crank"));
  CHECK_THAT(text_of(*open_pdf(write_pdf({page({text("affine efficiency", {20, 20})})}, {"t"})), 0),
             Contains("affine efficiency"));
}

TEST_CASE("the PDF carries its fonts and no pixels") {
  const std::string bytes = write_pdf({rich_page()}, {"t"});
  const auto document = open_pdf(bytes);
  const auto fonts = document->fonts();
  CHECK(fonts.size() >= 3);
  for (const poppler::font_info& font : fonts) {
    CHECK(font.is_embedded());
    CHECK_THAT(font.name(), Contains("STIXTwo"));
  }
  CHECK(bytes.find("/Image") == bytes.npos);
}

TEST_CASE("a page looks as it was composed: y upwards, colours, clips, order") {
  Fill clipped = square({200, 50}, 40, {1, 0, 0, 1});
  clipped.clip = Box{{200, 50}, {220, 90}};
  Stroke arc{segment({10, 100}, {110, 100}), 2, {}, {0, 0.5, 0, 1}, Box{{50, 90}, {80, 110}}, ""};
  const Page drawn = page({square({10, 180}, 20, blue), square({15, 185}, 10, {1, 1, 1, 1}), clipped, arc,
                           square({100, 10}, 20, {0, 0, 0, 0.5})});
  const auto document = open_pdf(write_pdf({drawn}, {"t"}));
  const Picture seen(*document, 0, 4);
  const auto looks = [&](double x, double y, Colour c) {
    const Colour found = seen.at(x, 210 - y);
    return std::abs(found.red - c.red) + std::abs(found.green - c.green) + std::abs(found.blue - c.blue) < 0.02;
  };
  CHECK(looks(12, 195, blue));
  CHECK(looks(20, 190, {1, 1, 1}));  // drawn over it
  CHECK(looks(12, 15, {1, 1, 1}));   // and not upside down
  CHECK(looks(210, 70, {1, 0, 0}));
  CHECK(looks(230, 70, {1, 1, 1}));  // clipped away
  CHECK(looks(60, 100, {0, 0.5, 0}));
  CHECK(looks(40, 100, {1, 1, 1}));
  CHECK(looks(100.5, 100, {1, 1, 1}));
  CHECK(looks(60, 100.9, {0, 0.5, 0}));  // 2 mm wide
  CHECK(looks(60, 101.2, {1, 1, 1}));
  CHECK(looks(110, 20, {0.5, 0.5, 0.5}));
}

TEST_CASE("the PDF shows dashes in millimetres, and arrows over vectors") {
  Stroke dashed = line({10, 100}, {110, 100});
  dashed.width = 2;
  dashed.dashes = {10, 5};
  const PlacedText vector{"$\\vec{v}$", {150, 50}, 60, {}, Weight::regular};
  const SetText set = typeset(vector.text, vector.size, vector.weight);
  REQUIRE(set.arrows.size() == 1);
  const auto document = open_pdf(write_pdf({page({dashed, vector})}, {"t"}));
  const Picture seen(*document, 0, 4);
  const auto is_inked = [&](Point p) { return seen.at(p.x, 210 - p.y).red < 0.5; };
  for (int i = 0; i < 6; ++i) {
    CHECK(is_inked({10.0 + 15 * i + 0.5, 100}));
    CHECK(is_inked({10.0 + 15 * i + 9.5, 100}));
    CHECK_FALSE(is_inked({10.0 + 15 * i + 10.5, 100}));
    CHECK_FALSE(is_inked({10.0 + 15 * i + 14.5, 100}));
  }
  const Point tail = set.arrows[0].start;  // the lower left corner of its shaft
  CHECK(is_inked(vector.baseline + tail + Point{1, 1}));
  CHECK_FALSE(is_inked(vector.baseline + tail + Point{1, -1}));
  CHECK_FALSE(is_inked(vector.baseline + tail + Point{-1, 1}));
}

TEST_CASE("the SVG has its size in millimetres and says what it shows") {
  Page drawn = rich_page();
  drawn.language = Language::italian;
  const SvgFile svg(write_svg(drawn));
  const pugi::xml_node root = svg.root();
  CHECK(root.attribute("width").value() == std::string("297mm"));
  CHECK(root.attribute("height").value() == std::string("210mm"));
  CHECK(svg.mm() == Approx(file_resolution).epsilon(1e-8));  // one way of measuring, so its height is right as well
  CHECK(root.attribute("role").value() == std::string("img"));
  CHECK(root.attribute("lang").value() == std::string("it"));
  CHECK(root.attribute("xml:lang").value() == std::string("it"));
  CHECK(root.child("title").text().get() == drawn.title);
  CHECK(root.child("desc").text().get() == drawn.description);
  CHECK(root.first_child() == root.child("title"));  // where browsers look for the name of a picture
  const SvgFile english(write_svg(page({}, {{10.5, 20.25}, {110.5, 70}})));
  CHECK(english.root().attribute("lang").value() == std::string("en"));
  CHECK(english.root().attribute("width").value() == std::string("100mm"));
  CHECK(english.root().attribute("height").value() == std::string("49.75mm"));
  CHECK(english.mm() == Approx(file_resolution).epsilon(1e-8));
}

TEST_CASE("a named mark is one element; a name given again is counted") {
  Stroke outline = line({0, 0}, {6, 8}, "plate");
  outline.dashes = {3, 1};
  outline.clip = Box{{1, 2}, {4, 8}};
  const SvgFile svg(
      write_svg(page({square({0, 0}, 10, {0, 0, 0, 0.06}, "plate"), outline, line({0, 0}, {20, 0}, "plate-2"),
                      line({0, 0}, {30, 0}, "plate"), line({0, 0}, {40, 0})})));
  CHECK(style(svg.element("demo-plate"), "fill-opacity") == ".06");
  CHECK(svg.length("demo-plate-2") == Approx(10).margin(2e-3));
  CHECK(svg.length("demo-plate-2-2") == Approx(20).margin(2e-3));
  CHECK(svg.length("demo-plate-3") == Approx(30).margin(2e-3));
  const pugi::xml_node dashed = svg.element("demo-plate-2");
  const Colour stroke = colour(style(dashed, "stroke"));
  CHECK(stroke.red == 0);
  CHECK(stroke.green == Approx(blue.green).epsilon(1e-7));
  CHECK(stroke.blue == Approx(blue.blue).epsilon(1e-7));
  const double half_a_step = svg.mm() / 2 * (1 + 1e-6);
  CHECK(std::stod(style(dashed, "stroke-width")) * svg.mm() == Approx(0.25).margin(half_a_step).epsilon(0));
  const std::string dashes = style(dashed, "stroke-dasharray");
  CHECK(std::stod(dashes) * svg.mm() == Approx(3).margin(half_a_step).epsilon(0));
  CHECK(std::stod(dashes.substr(dashes.find(' ') + 1)) * svg.mm() == Approx(1).margin(half_a_step).epsilon(0));
  const std::string clip = dashed.attribute("clip-path").value();
  const pugi::xml_node window = svg.element(clip.substr(5, clip.size() - 6)).child("rect");
  const auto in_mm = [&](const char* name) { return svg.mm() * window.attribute(name).as_double(); };
  CHECK(in_mm("x") == Approx(1).margin(2e-3));
  CHECK(in_mm("y") == Approx(202).margin(2e-3));
  CHECK(in_mm("width") == Approx(3).margin(3e-3));
  CHECK(in_mm("height") == Approx(6).margin(3e-3));
}

TEST_CASE("an area and its outline stay two elements, each with its own name and paint") {
  const Fill area = square({20, 20}, 10, {1, 0, 0, 1}, "area");
  Stroke outline{area.path, 0.25, {}, blue, {}, "outline"};
  const SvgFile svg(write_svg(page({area, outline, area, outline})));
  for (const std::string count : {"", "-2"}) {
    CHECK(colour(style(svg.element("demo-area" + count), "fill")).red == 1);
    CHECK(style(svg.element("demo-area" + count), "stroke") == "none");
    CHECK(colour(style(svg.element("demo-outline" + count), "stroke")).blue == Approx(blue.blue));
    CHECK(style(svg.element("demo-outline" + count), "fill") == "none");
  }
}

TEST_CASE("marks that cannot be seen are found by their names like all others") {
  Stroke clipped = line({20, 20}, {43, 20}, "clipped");
  clipped.clip = Box{{100, 100}, {120, 120}};
  Stroke clear = line({20, 20}, {43, 20}, "clear");
  clear.colour.opacity = 0;
  const Stroke outside = line({500, 20}, {523, 20}, "outside");
  const Fill thin{segment({60, 60}, {83, 60}), blue, {}, "thin"};
  const std::vector<Primitive> unseen = {clipped, clear, outside, thin};
  const Stroke point = line({50, 50}, {50, 50}, "point");
  const std::vector<Primitive> between = {
      clipped, clear, outside, thin, point, text("", {30, 30}), text("  ", {30, 30})};

  std::vector<Primitive> all = unseen;
  all.push_back(point);
  const SvgFile svg(write_svg(page(all)));
  for (const std::string name : {"clipped", "clear", "outside", "thin"}) {
    CHECK(svg.length("demo-" + name) == Approx(23).margin(2e-3));
  }
  CHECK(svg.length("demo-point") == 0);

  const unsigned seed = 5;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 200; ++round) {
    // Marks of different lengths with anything between them.
    std::vector<Primitive> marks;
    std::vector<double> lengths;
    for (auto count = random() % 6; count > 0; --count) {
      if (random() % 2 == 0) {
        marks.push_back(between[random() % between.size()]);
      } else {
        lengths.push_back(10 + static_cast<double>(lengths.size()));
        Stroke mark = line({20, 20}, {20 + lengths.back(), 20}, "m");
        if (random() % 2 == 0) mark.clip = Box{{25, 10}, {28, 40}};
        marks.push_back(mark);
      }
    }
    const SvgFile mixed(write_svg(page(marks)));
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const std::string id = i == 0 ? "demo-m" : "demo-m-" + std::to_string(i + 1);
      CHECK(mixed.length(id) == Approx(lengths[i]).margin(2e-3));
      CHECK(style(mixed.element(id), "stroke") != "none");
    }
  }
}

TEST_CASE("ids are unique, those of marks begin with the drawing's, and every reference finds its element") {
  const SvgFile svg(write_svg(rich_page("one")));
  const auto ids = svg.ids();
  CHECK(ids.size() > 20);
  const std::set<std::string> distinct(ids.begin(), ids.end());
  CHECK(distinct.size() == ids.size());
  for (const std::string name : {"one", "one-v_A", "one-v_B", "one-plate", "one-path_A"})
    CHECK(distinct.contains(name));
  const auto references = svg.references();
  CHECK(references.size() > 50);
  for (const std::string& reference : references) {
    CHECK(distinct.contains(reference));
    CHECK_FALSE(reference.starts_with("one"));  // or another drawing of that name in the same page would be taken
  }
}

// What an id of one drawing refers to may be taken from another one in the same web page.
TEST_CASE("where two drawings share an id that is referred to, the same stands behind it") {
  Page other = rich_page();
  other.primitives.insert(other.primitives.begin(), text("$r$ = 14.00 mm, vAB", {30, 140}));
  std::get<Stroke>(other.primitives[7]).clip = Box{{80, 40}, {200, 81}};
  const auto content = [](const SvgFile& svg) {
    std::map<std::string, std::string> found;
    for (const std::string& id : svg.references()) {
      std::ostringstream text;
      svg.element(id).print(text);
      found[id] = text.str();
    }
    return found;
  };
  const auto one = content(SvgFile(write_svg(rich_page()))), two = content(SvgFile(write_svg(other)));
  int shared = 0;
  for (const auto& [id, what] : one)
    if (const auto found = two.find(id); found != two.end()) {
      ++shared;
      CHECK(found->second == what);
    }
  CHECK(shared > 15);
  CHECK(two.size() > one.size());
  const auto clips = [](const auto& found) {
    return std::count_if(found.begin(), found.end(),
                         [](const auto& each) { return each.second.starts_with("<clipPath"); });
  };
  CHECK(clips(one) == 1);
  CHECK(clips(two) == 1);
}

// As the ticks along an axis, of which a chart has hundreds.
TEST_CASE("strokes alike, of which nothing is to be known apart, are one path; others are not") {
  const Stroke first = line({10, 10}, {10, 12}), second = line({20, 10}, {20, 13}), third = line({30, 11}, {34, 10});
  const auto paths = [](std::vector<Primitive> strokes) {
    return SvgFile(write_svg(page(std::move(strokes)))).xml().select_nodes("/svg/g//path").size();
  };
  const SvgFile svg(write_svg(page({first, second, third})));
  REQUIRE(paths({first, second, third}) == 1);
  const std::vector<Point> points = svg.points(svg.xml().select_node("/svg/g//path").node());
  const std::vector<Point> drawn{{10, 10}, {10, 12}, {20, 10}, {20, 13}, {30, 11}, {34, 10}};
  REQUIRE(points.size() == drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    CHECK(points[i].x == Approx(drawn[i].x).margin(file_resolution / 2));
    CHECK(points[i].y == Approx(210 - drawn[i].y).margin(file_resolution / 2));
  }
  std::vector<Stroke> others(6, second);
  others[0].name = "v_B";
  others[1].clip = Box{{0, 0}, {100, 100}};
  others[2].colour.opacity = 0.5;
  others[3].step = 2;
  others[4].width = 0.5;
  others[5].dashes = {1, 1};
  for (const Stroke& other : others) CHECK(paths({first, other, third}) == 3);
  others[2].colour = {};
  CHECK(paths({first, others[2], third}) == 3);
}

TEST_CASE("no two outlines of the shipped fonts share an id") {
  std::map<std::string, std::string> seen;
  const auto see = [&](const std::string& letters, Weight weight) {
    const SvgFile svg(write_svg(page({PlacedText{letters, {10, 10}, 3.5, {}, weight}})));
    for (const auto& path : svg.xml().select_nodes("//defs/path")) {
      const std::string outline = path.node().attribute("d").value();
      CHECK(seen.emplace(path.node().attribute("id").value(), outline).first->second == outline);
    }
  };
  for (char32_t c = 0x21; c < 0x20000; ++c) {
    if (c == U'$' || c == U'\\') continue;
    if (has_glyph(Face::regular, c) || has_glyph(Face::mathematics, c)) see(utf8(c), Weight::regular);
    if (has_glyph(Face::bold, c)) see(utf8(c), Weight::bold);
    if (has_glyph(Face::italic, c) && c != U'_' && c != U'^' && c != U'{' && c != U'}')
      see("$" + utf8(c) + "$", Weight::regular);
  }
  for (const std::string ligature : {"ff", "fi", "fl", "ffi", "ffl"})
    for (const Weight weight : {Weight::regular, Weight::bold}) see(ligature, weight);
  CHECK(seen.size() > 5000);
}

TEST_CASE("unseen letters lie over the outlines of the SVG") {
  const SvgFile svg(write_svg(page({text("$\\vec{v}_{BA}$ < & ⊥ BA", {30, 100}), text("   ", {0, 0})})));
  const auto found = svg.xml().select_nodes("//text");
  REQUIRE(found.size() == 1);
  const pugi::xml_node words = found.first().node();
  CHECK(words.text().get() == std::string("v_BA < & ⊥ BA"));
  CHECK(words.attribute("opacity").value() == std::string("0"));
  const Placement at = placement(words);
  CHECK(svg.mm() * at.x == Approx(30).margin(1e-3));
  CHECK(svg.mm() * at.y == Approx(110).margin(1e-3));
  CHECK(svg.mm() * at.scale * std::stod(style(words, "font-size")) == Approx(3.5).epsilon(1e-5));
  CHECK(svg.mm() * at.scale * words.attribute("textLength").as_double() ==
        Approx(measure("$\\vec{v}_{BA}$ < & ⊥ BA", 3.5).width).margin(3.5 / units_per_em));
  CHECK(svg.xml().select_nodes("/svg/g//use").size() == 8);  // v, B, A, <, &, ⊥, B, A; spaces draw nothing
}

TEST_CASE("each font has its own outlines in the SVG, for all sizes, drawn once and all of them used") {
  const auto glyphs = [](std::vector<Primitive> texts) {
    const SvgFile svg(write_svg(page(std::move(texts))));
    std::set<std::string> outlines;
    for (const auto& path : svg.xml().select_nodes("//defs/path"))
      outlines.insert(path.node().attribute("d").value());
    CHECK(outlines.size() == svg.xml().select_nodes("//defs/path").size());
    const auto references = svg.references();
    CHECK(std::set<std::string>(references.begin(), references.end()).size() == outlines.size());
    return outlines.size();
  };
  const PlacedText bold{"AA", {20, 20}, 5, {}, Weight::bold}, larger{"A", {20, 40}, 9, {}, Weight::regular};
  // A has the same number in both fonts.
  CHECK(shape(Face::regular, "A").glyphs[0].index == shape(Face::bold, "A").glyphs[0].index);
  CHECK(glyphs({text("AA", {10, 10})}) == 1);
  CHECK(glyphs({text("A A", {10, 10}), text("A", {10, 30})}) == 1);
  CHECK(glyphs({text("AA", {10, 10}), bold, larger, larger}) == 2);
  const SvgFile vector(write_svg(page({text("$\\vec{v}$", {10, 10})})));
  CHECK(vector.xml().select_nodes("/svg/g/g/path").size() == 1);  // its arrow
}

namespace {

struct PlacedOutline {
  pugi::xml_node path;
  Placement at;
};
// What an element of letters shows, through what it uses: a letter, a smaller one, or two of them.
void follow(const SvgFile& svg, pugi::xml_node element, Placement at, std::vector<PlacedOutline>& found) {
  if (element.name() == std::string("path")) return found.push_back({element, at});
  if (element.name() == std::string("use")) {
    double smaller = 1;
    if (const pugi::xml_attribute transform = element.attribute("transform"))
      REQUIRE(std::sscanf(transform.value(), "scale(%lf)", &smaller) == 1);
    at = {at.x + at.scale * element.attribute("x").as_double(), at.y + at.scale * element.attribute("y").as_double(),
          at.scale * smaller};
    return follow(svg, svg.element(element.attribute("xlink:href").value() + 1), at, found);
  }
  REQUIRE(element.name() == std::string("g"));
  for (const pugi::xml_node child : element.children()) follow(svg, child, at, found);
}

}  // namespace

TEST_CASE("letters are drawn as wide and as high as they are measured, at every size") {
  for (const double size : {1.8, 2.5, 3.5, 7.0, 40.0}) {
    CAPTURE(size);
    // The same words again and again: letters side by side become one element, and not when they stand apart.
    std::string letters;
    for (int i = 0; i < 5; ++i) letters += "$ω_{BA}$ = ≙ÀW NN N N q ";
    const SvgFile svg(write_svg(page({PlacedText{letters, {30, 100}, size, {}, Weight::regular}})));
    const SetText set = typeset(letters, size, Weight::regular);
    std::vector<Box> measured;
    for (const GlyphRun& run : set.runs)
      for (const SetGlyph& glyph : run.glyphs)
        if (const Box drawn = ink(run.face, glyph.index); !is_nothing(drawn)) {
          const double scale = run.size / units_per_em;
          const Point at = Point{30, 100} + glyph.at;
          measured.push_back({at + scale * drawn.low, at + scale * drawn.high});
        }
    std::vector<PlacedOutline> found;
    const auto uses = svg.xml().select_nodes("/svg/g//use");
    CHECK(uses.size() < measured.size());  // so there are pairs
    for (const auto& use : uses) follow(svg, use.node(), placement(use.node().parent()), found);
    REQUIRE(found.size() == measured.size());
    for (std::size_t i = 0; i < measured.size(); ++i) {
      const Placement at = found[i].at;
      Box drawn = nothing();
      for (const Point p : svg.points(found[i].path))
        drawn = include(drawn, Point{svg.mm() * at.x + at.scale * p.x, 210 - svg.mm() * at.y - at.scale * p.y});
      // The place of the text is rounded to the grid, that of the letter to a unit of the font; the scale has five
      // decimals and is more than 1.
      const double step = file_resolution / 2 + 0.51 * size / units_per_em + 5e-6 * (measured[i].high.x - 30);
      CHECK(drawn.low.x == Approx(measured[i].low.x).margin(step));
      CHECK(drawn.low.y == Approx(measured[i].low.y).margin(step));
      CHECK(drawn.high.x == Approx(measured[i].high.x).margin(step));
      CHECK(drawn.high.y == Approx(measured[i].high.y).margin(step));
    }
  }
}

TEST_CASE("the cells of a table are drawn where they would be one by one, and read row by row") {
  constexpr double size = 2.3, right = 60, line = 4.1, apart = 25;
  constexpr int rows = 20;
  std::vector<Primitive> cells, texts;
  std::vector<std::string> read;
  for (int row = 0; row < rows; ++row) {
    read.emplace_back();
    for (int column = 0; column < 4; ++column) {
      const double value = (row - 4) * (row + 7.3) * (column == 0 ? 0.01 : 1.2345);
      const std::string rich = row == 0    ? fmt::format("$v_{{{}}}$", column)
                               : row == 11 ? fmt::format("$1.2{}·10^{{−7}}$", column)
                                           : fmt::format("{:.2f}", value);
      const Point at{right + apart * column - typeset(rich, size, Weight::regular).extent.width, 190 - line * row};
      texts.emplace_back(PlacedText{rich, at, size, blue, Weight::regular});
      cells.emplace_back(PlacedText{rich, at, size, blue, Weight::regular, static_cast<std::size_t>(row)});
      std::string words;
      for (const GlyphRun& run : typeset(rich, size, Weight::regular).runs)
        for (const SetGlyph& glyph : run.glyphs) words += glyph.text;
      read.back() += (column == 0 ? "" : " ") + words;
    }
  }
  const std::string table = write_svg(page(cells)), one_by_one = write_svg(page(texts));
  CHECK(10 * table.size() < 8 * one_by_one.size());
  // Letter by letter, by outline. Of both files the place of a text is rounded to the grid, that of a letter to a
  // unit of the font; the scale has five decimals and is more than 1.
  using Drawn = std::multimap<std::string, Point>;
  const auto drawn = [](const std::string& bytes) {
    const SvgFile svg(bytes);
    std::vector<PlacedOutline> found;
    for (const auto& use : svg.xml().select_nodes("/svg/g//use"))
      follow(svg, use.node(), placement(use.node().parent()), found);
    Drawn all;
    for (const PlacedOutline& each : found)
      all.emplace(fmt::format("{} {:.4f}", each.path.attribute("d").value(), each.at.scale),
                  svg.mm() * Point{each.at.x, each.at.y});
    return all;
  };
  const Drawn in_table = drawn(table), alone = drawn(one_by_one);
  CHECK(in_table.size() == alone.size());
  CHECK(alone.size() > 4 * rows);
  constexpr double step = file_resolution + size / units_per_em + 5e-6 * 4 * apart;
  for (const auto& [outline, at] : in_table) {
    const auto [first, end] = alone.equal_range(outline);
    CHECK(std::count_if(first, end, [&, at = at](const auto& other) {
            return std::abs(other.second.x - at.x) < step && std::abs(other.second.y - at.y) < step;
          }) == 1);
  }
  const SvgFile svg(table);
  std::vector<std::string> words;
  for (const auto& text : svg.xml().select_nodes("//text")) words.emplace_back(text.node().text().get());
  CHECK(words == read);
}

TEST_CASE("a whole sheet is white, a bare one takes the ground it stands on") {
  Page drawn = rich_page();
  const auto grounds = [&] { return SvgFile(write_svg(drawn)).xml().select_nodes("/svg/g/rect"); };
  CHECK(grounds().empty());
  drawn.is_paper = true;
  REQUIRE(grounds().size() == 1);
  const SvgFile svg(write_svg(drawn));
  const pugi::xml_node ground = svg.xml().select_nodes("/svg/g/rect").first().node();
  CHECK(ground == ground.parent().first_child());  // below everything else
  CHECK(ground.attribute("fill").value() == std::string("#fff"));
  CHECK(ground.attribute("width").value() == std::string("100%"));
  CHECK(ground.attribute("height").value() == std::string("100%"));
}

TEST_CASE("an area without a name and the line around it are one element") {
  const Fill area = square({20, 20}, 10, {1, 0, 0, 0.5});
  Stroke outline{area.path, 0.25, {}, blue, {}, "outline"}, other = line({1, 1}, {2, 2});
  const SvgFile svg(write_svg(page({area, outline, area, other})));
  CHECK(svg.xml().select_nodes("/svg/g//path").size() == 3);
  const pugi::xml_node both = svg.element("demo-outline");
  CHECK(style(both, "fill") == "#f00");
  CHECK(style(both, "fill-opacity") == ".5");
  CHECK(style(both, "stroke") == "#0072b2");
}

TEST_CASE("the same page is the same file, whatever was drawn before and in whatever locale") {
  const std::string pdf = write_pdf({rich_page()}, {"Title"}), svg = write_svg(rich_page());
  CHECK(write_pdf({rich_page()}, {"Title"}) == pdf);
  CHECK(write_svg(rich_page()) == svg);
  for (int i = 0; i < 5; ++i) {
    write_svg(rich_page("other"));
    write_pdf({rich_page("other"), page({text("αβγ ①", {20, 20})})}, {"Other"});
  }
  CHECK(write_pdf({rich_page()}, {"Title"}) == pdf);
  CHECK(write_svg(rich_page()) == svg);

  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const char* taken = std::setlocale(LC_ALL, "it_IT.UTF-8");
  if (!taken) taken = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const std::string pdf_comma = write_pdf({rich_page()}, {"Title"}), svg_comma = write_svg(rich_page());
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  CHECK(pdf_comma == pdf);
  CHECK(svg_comma == svg);
  if (!taken) WARN("no C locale with a decimal comma on this machine: only the C++ locale was changed");
}

TEST_CASE("numbers that no file should hold are refused by name") {
  const double inf = INFINITY, nan = NAN;
  CHECK_THAT(complaint(page({line({0, 0}, {nan, 1}, "v_B")})), Contains("'v_B'") && Contains("nan"));
  CHECK_THAT(complaint(page({line({-inf, 0}, {1, 1}, "v_B")})), Contains("'v_B'") && Contains("inf"));
  CHECK_THAT(complaint(page({line({0, 1e9}, {1, 1}, "v_B")})), Contains("'v_B'"));
  CHECK_THAT(complaint(page({Stroke{circle({0, 0}, 20000), 0.2, {}, {}, {}, "big"}})), Contains("'big'"));
  Stroke bad = line({0, 0}, {1, 1}, "k");
  for (const double width : {nan, 0.0, -1.0, 1e6}) {
    bad.width = width;
    CHECK_THAT(complaint(page({bad})), Contains("'k'") && Contains("width"));
  }
  bad.width = 0.2;
  for (const auto& dashes : std::vector<std::vector<double>>{{nan}, {-1, 2}, {0, 0}, {1e-9, 1e-9}, {1e9}}) {
    bad.dashes = dashes;
    CHECK_THAT(complaint(page({bad})), Contains("'k'") && Contains("dash"));
  }
  bad.dashes = {};
  bad.colour.red = 1.5;
  CHECK_THAT(complaint(page({bad})), Contains("'k'") && Contains("red"));
  bad.colour = {0, 0, 0, nan};
  CHECK_THAT(complaint(page({bad})), Contains("opacity"));
  bad.colour = {};
  bad.clip = Box{{5, 5}, {1, nan}};
  CHECK_THAT(complaint(page({bad})), Contains("'k'") && Contains("clip"));
  Fill area = square({0, 0}, nan, blue, "plate");
  CHECK_THAT(complaint(page({area})), Contains("'plate'"));
  Path curve = circle({50, 50}, 10);
  curve.pieces[3].first_control.x = nan;
  CHECK_THAT(complaint(page({Stroke{curve, 0.2, {}, {}, {}, "c"}})), Contains("'c'"));
  PlacedText label = text("$P_0$", {nan, 0});
  CHECK_THAT(complaint(page({label})), Contains("$P_0$"));
  label = text("$P_0$", {1, 1});
  label.size = 1e4;
  CHECK_THAT(complaint(page({label})), Contains("$P_0$") && Contains("size"));
  CHECK_THAT(complaint(page({text("$P_0", {1, 1})})), Contains("$P_0"));
  CHECK_THAT(complaint(page({}, {{0, 0}, {nan, 10}})), Contains("demo"));
  CHECK_THAT(complaint(page({}, {{0, 0}, {0, 10}})), Contains("demo"));
  CHECK_THAT(complaint(page({}, {{0, 0}, {1e5, 10}})), Contains("demo"));
}

TEST_CASE("names and titles that would break a file are refused") {
  for (const std::string name : {"v B", "a\"b", "è", "-v", "a#b", "<x>"})
    CHECK_THAT(complaint(page({line({0, 0}, {1, 1}, name)})), Contains("name"));
  Page bad = page({});
  bad.id = "";
  CHECK_THAT(complaint(bad), Contains("id"));
  bad.id = "a b";
  CHECK_THAT(complaint(bad), Contains("a b"));
  bad = page({});
  bad.title = "a\x01z";
  CHECK_THAT(complaint(bad), Contains("title"));
  bad = page({});
  bad.description = "\xFF";
  CHECK_THAT(complaint(bad), Contains("description"));
  CHECK_THROWS_AS(write_pdf({page({})}, {"\xFF"}), std::invalid_argument);
  CHECK_THROWS_AS(write_pdf({}, {"t"}), std::invalid_argument);
}

TEST_CASE("the largest dashed circle that is accepted stays cheap") {
  const Stroke large{circle({0, 0}, 9990), 0.18, {1, 0.5}, {}, Box{{0, 0}, {297, 210}}, "c"};
  CHECK(write_pdf({page({large})}, {"t"}).size() < 20000);
  CHECK(write_svg(page({large})).size() < 20000);
}
