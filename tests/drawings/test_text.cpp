#include <random>

#include "drawings/paths/vectors.h"
#include "drawings/text/rich_text.h"
#include "drawings/text/typeset.h"
#include "tests/support/catch.h"

using namespace epure::drawings;

namespace {

std::string told(const SetText& set) {
  std::string text;
  for (const GlyphRun& run : set.runs)
    for (const SetGlyph& glyph : run.glyphs) text += glyph.text;
  return text;
}

SetText set(const std::string& text) { return typeset(text, 10, Weight::regular); }

Face face_of(const std::string& text) {
  const SetText done = set(text);
  REQUIRE(done.runs.size() == 1);
  return done.runs.front().face;
}

std::string complaint(const std::string& text) {
  try {
    set(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

Box ink_of(const GlyphRun& run) {
  Box box = nothing();
  for (const SetGlyph& glyph : run.glyphs) {
    const Box drawn = ink(run.face, glyph.index);
    const double scale = run.size / units_per_em;
    if (!is_nothing(drawn)) box = include(box, Box{glyph.at + scale * drawn.low, glyph.at + scale * drawn.high});
  }
  return box;
}

}  // namespace

TEST_CASE("plain text says what is set") {
  CHECK(plain("$\\vec{v}_{BA}$ ⊥ BA") == "v_BA ⊥ BA");
  CHECK(plain("$P_{0}$") == "P_0");
  CHECK(plain("$ω_3^2$") == "ω_3^2");
  CHECK(plain("$a^{n}_{BA}$") == "a_BA^n");
  CHECK(plain("m/s$^{2}$") == "m/s^2");
  CHECK(plain("$-3.2$ co-ordinates") == "−3.2 co-ordinates");
  CHECK(plain("$v'_B$") == "v′_B");
  CHECK(plain("\\$ and $\\$$ and \\ alone") == "$ and $ and \\ alone");
  CHECK(plain("") == "");
}

TEST_CASE("glyphs carry the plain text, and nothing is read as markup of another kind") {
  for (const std::string text :
       {"$\\vec{v}_{BA}$ ⊥ BA", "$a^{n}_{BA}$ = $ω_3^2$", "<b>affine</b> &amp; efficiency", "1 cm ≙ 2.5 m/s", "%s {}",
        "Perché è così", "$\\vec{AB}$ → $Ω_C$", "①②⑫", "$a_{P_{0}}$", "q\u0301v"}) {
    CAPTURE(text);
    CHECK(told(set(text)) == plain(text));
  }
}

TEST_CASE("quantities are italic; points, numbers and what names a quantity are upright") {
  for (const auto text : {"$v$", "$a$", "$ω$", "$φ$", "$α$", "$z$"}) CHECK(face_of(text) == Face::italic);
  for (const auto text : {"$A$", "$Ω$", "$Δ$", "$12.5$", "v", "ω", "A", "$−$"}) CHECK(face_of(text) == Face::regular);
  CHECK(face_of("≙") == Face::mathematics);
  for (const auto text : {"$\\it{M}$", "$\\it{TN}$", "$\\it{Ω}$"}) CHECK(face_of(text) == Face::italic);
  CHECK(face_of("$\\it{2}$") == Face::regular);
  const SetText force = set("$\\vec{\\it{R}}_{B}$");
  REQUIRE(force.runs.size() == 2);
  CHECK(force.runs[0].face == Face::italic);
  CHECK(force.runs[1].face == Face::regular);
  CHECK(plain("$\\it{M}_{A}$·$\\vec{\\it{R}}_{23}$") == "M_A·R_23");
  const SetText scripts = set("$v_{a}^{n}$");
  REQUIRE(scripts.runs.size() == 3);
  CHECK(scripts.runs[0].face == Face::italic);
  CHECK(scripts.runs[1].face == Face::regular);
  CHECK(scripts.runs[2].face == Face::regular);
  CHECK(typeset("v", 10, Weight::bold).runs.front().face == Face::bold);
}

TEST_CASE("every symbol of the sheets has a glyph") {
  CHECK_NOTHROW(
      set("≙ ⊥ ∥ → ≅ ≈ ∞ ∠ √ ∑ ≤ ≥ ± × · ° ′ ″ ′ − – — … “” ’ ½ ² ³ αβγδεζηθικλμνξοπρςστυφχψω ΑΒΓΔΘΛΞΠΣΦΨΩ"));
  CHECK_NOTHROW(set("①②③④⑤⑥⑦⑧⑨⑩⑪⑫⑬⑭⑮⑯⑰⑱⑲⑳"));
  CHECK_NOTHROW(typeset("≙ ⊥ ① è ω", 3.5, Weight::bold));
}

TEST_CASE("scripts are small, lowered or raised, and stack") {
  const SetText both = set("$a^{n}_{BA}$");
  REQUIRE(both.runs.size() == 3);
  const GlyphRun &letter = both.runs[0], &below = both.runs[1], &above = both.runs[2];
  CHECK(below.size == Approx(7));
  CHECK(above.size == Approx(7));
  CHECK(below.glyphs[0].at.y < letter.glyphs[0].at.y - 1);
  CHECK(above.glyphs[0].at.y > letter.glyphs[0].at.y + 1);
  CHECK(std::abs(below.glyphs[0].at.x - above.glyphs[0].at.x) < 1);  // one above the other
  CHECK(ink_of(above).low.y > ink_of(below).high.y);
  CHECK(ink_of(above).low.x >= ink_of(letter).high.x);
  const SetText slanted = set("$f^{2}$");
  CHECK(ink_of(slanted.runs[0]).high.x > measure("$f$", 10).width);  // f reaches over its advance
  CHECK(ink_of(slanted.runs[1]).low.x >= ink_of(slanted.runs[0]).high.x);
  const SetText tall = set("$a_{\\vec{F}^{\\vec{F}}}^{n}$");  // the superscript makes way for what is below it
  CHECK(ink_of(tall.runs[3]).low.y > tall.arrows[1].start.y);
  // The order in which they are written does not matter; braces around one character neither.
  CHECK(set("$a_{BA}^n$").extent.width == both.extent.width);
  // What follows stands clear of the longer script, on the line.
  const SetText followed = set("$a^{n}_{BA}A$");
  CHECK(followed.runs.back().glyphs[0].at.y == 0);
  CHECK(ink_of(followed.runs.back()).low.x > ink_of(below).high.x);
  // A script belongs to one letter.
  CHECK(set("$AB_0$").runs.size() == 3);
}

TEST_CASE("a vector's arrow stands above its letters, clear of them, and counts as ink") {
  for (const std::string letters : {"v", "ω", "a", "F", "AB", "f"}) {
    CAPTURE(letters);
    const SetText bare = set("$" + letters + "$"), vector = set("$\\vec{" + letters + "}$");
    CHECK(bare.arrows.empty());
    REQUIRE(vector.arrows.size() == 1);
    Box arrow = include(nothing(), vector.arrows[0].start);
    for (const Piece& piece : vector.arrows[0].pieces) arrow = include(arrow, piece.end);
    const Box letters_ink = ink_of(vector.runs[0]);
    CHECK(arrow.low.y > letters_ink.high.y);
    CHECK(arrow.width() >= letters_ink.width() * (1 - 1e-12));
    CHECK(vector.extent.ascent == Approx(arrow.high.y));
    CHECK(vector.extent.width == bare.extent.width);
    CHECK(std::abs(arrow.low.x + arrow.high.x - letters_ink.low.x - letters_ink.high.x) < 1.5);
  }
}

TEST_CASE("measures are those of the font and grow with the size") {
  // Advance widths of STIX Two Text in thousandths of the size: v italic 429, v upright 481.
  CHECK(measure("$v$", 1000).width == Approx(429));
  CHECK(measure("v", 1000).width == Approx(481));
  const std::string text = "$\\vec{v}_{BA}$ ⊥ BA";
  const TextSize small = measure(text, 2.5), large = measure(text, 5);
  CHECK(large.width == Approx(2 * small.width));
  CHECK(large.ascent == Approx(2 * small.ascent));
  CHECK(large.descent == Approx(2 * small.descent));
  CHECK(measure("p", 10).descent > 1);
  CHECK(measure("A", 10).descent == Approx(0).margin(0.2));
  CHECK(measure("A", 10, Weight::bold).width != measure("A", 10).width);
  CHECK(measure("", 10).width == 0);
  CHECK(measure(" ", 10).ascent == 0);
  CHECK(measure(" ", 10).width > 1);
  CHECK(measure("AV", 10).width < measure("A", 10).width + measure("V", 10).width);  // kerned
}

TEST_CASE("text that cannot be set is refused, and quoted") {
  CHECK_THAT(complaint("$v"), Contains("$v") && Contains("dollar"));
  CHECK_THAT(complaint("$v_{B$"), Contains("brace"));
  CHECK_THAT(complaint("$v}$"), Contains("brace"));
  CHECK_THAT(complaint("$\\hat{v}$"), Contains("\\vec"));
  CHECK_THAT(complaint("$\\"), Contains("\\vec"));
  CHECK_THAT(complaint("$v_$"), Contains("script"));
  CHECK_THAT(complaint("$v_{}$"), Contains("empty"));
  CHECK_THAT(complaint("$v_1_2$"), Contains("twice"));
  CHECK_THAT(complaint("$\\vec{}$"), Contains("nothing"));
  CHECK_THAT(complaint("$a_{b_{c_{d_{e_{f}}}}}$"), Contains("deep"));
  CHECK_THAT(complaint("漢"), Contains("U+6F22"));
  CHECK_THAT(complaint("\xF0\x9F\x98\x80"), Contains("U+1F600"));
  CHECK_THAT(complaint("a\nb"), Contains("U+000A"));
  CHECK_THAT(complaint(std::string("a\0b", 3)), Contains("U+0000"));
  CHECK_THAT(complaint(std::string(longest_label + 1, 'x')), Contains("too long"));
  CHECK(complaint(std::string(longest_label, 'x')).empty());
  for (const std::string broken :
       {"\xC3", "\xC3(", "\xED\xA0\x80", "\xC0\xAF", "\xF5\x80\x80\x80", "\x80", "\xE2\x82"})
    CHECK_THAT(complaint("v" + broken), Contains("not UTF-8"));
  CHECK_THROWS_AS(shape(Face::italic, "v≙"), std::invalid_argument);
  CHECK_THROWS_AS(measure("v", 0), std::invalid_argument);
  CHECK_THROWS_AS(measure("v", NAN), std::invalid_argument);
}

TEST_CASE("any mixture of signs is either set with its plain text or refused") {
  const std::vector<std::string> signs = {"$", "$", "_", "^", "{", "}", "{", "}",    "\\vec{", "\\",  "v",
                                          "A", "ω", "3", "-", " ", "≙", "è", "\xC3", "_{BA}",  "$v$", "$P_0$"};
  const unsigned seed = 20240917;
  CAPTURE(seed);
  std::mt19937 random(seed);
  int accepted = 0, refused = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (auto length = random() % 12; length > 0; --length) text += signs[random() % signs.size()];
    try {
      const SetText done = set(text);
      ++accepted;
      if (told(done) != plain(text) || !std::isfinite(done.extent.width)) FAIL(text);
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }
  CHECK(accepted > 1000);
  CHECK(refused > 1000);
}

TEST_CASE("lines are broken at spaces, never inside mathematics") {
  const std::string text =
      "Through A draw the perpendicular to $A_{0} A$; the pole $P_{0} = A_{0}A ∩ B$ lies where it meets the guide.";
  const auto lines = wrap(text, 2.5, 40);
  CHECK(lines.size() > 2);
  std::string joined;
  for (const std::string& line : lines) {
    CHECK(measure(line, 2.5).width <= 40);
    joined += (joined.empty() ? "" : " ") + line;
  }
  CHECK(joined == text);
  // Each line is as full as it can be: the next word would not fit.
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    std::string word = lines[i + 1].substr(0, lines[i + 1].find(' '));
    if (word.find('$') == word.npos) CHECK(measure(lines[i] + " " + word, 2.5).width > 40);
  }
  CHECK(wrap("incomprehensibilities are", 5, 10) == std::vector<std::string>{"incomprehensibilities", "are"});
  CHECK(wrap("one\ntwo", 5, 100) == std::vector<std::string>{"one two"});
  CHECK(wrap("\\$ 5 \\$ 6", 5, 1) == std::vector<std::string>{"\\$", "5", "\\$", "6"});
  CHECK(wrap("$a\\\\$ b", 5, 1) == std::vector<std::string>{"$a\\\\$", "b"});
  CHECK(wrap("", 5, 10).empty());
}

TEST_CASE("a formula, or a number and its unit, is broken only where no line has room for it") {
  constexpr double size = 2.5;
  const auto broken_after = [&](const std::string& begin, const std::string& rest) {
    return wrap(begin + " " + rest, size, measure(begin, size).width + 0.2);
  };
  using Lines = std::vector<std::string>;
  CHECK(broken_after("The angle of tan $γ$ =", "$α$ / $ω$ here") ==
        Lines{"The angle of", "tan $γ$ = $α$ / $ω$ here"});
  CHECK(broken_after("its value is 312.1", "m/s²,") == Lines{"its value is", "312.1 m/s²,"});
  CHECK(broken_after("its moment is 5 N", "m.") == Lines{"its moment is", "5 N m."});
  CHECK(broken_after("there are 312.1", "of them") == Lines{"there are 312.1", "of them"});
  // Where it must be: before a relation, or else at any word.
  CHECK(broken_after("$a$ = $b$ + $c$", "= $d$") == Lines{"$a$ = $b$ + $c$", "= $d$"});
  CHECK(broken_after("$a$ = $b$ +", "$c$ + $d$ = $e$") == Lines{"$a$ = $b$ +", "$c$ + $d$", "= $e$"});
  CHECK(broken_after("$a$ +", "$b$") == Lines{"$a$ +", "$b$"});
}

TEST_CASE("the lines of a title are of nearly one length") {
  constexpr double size = 5;
  const std::string title = "Poligono delle accelerazioni di B";
  const double room = measure(title, size, Weight::bold).width - 1;
  CHECK(wrap(title, size, room, Weight::bold) == std::vector<std::string>{"Poligono delle accelerazioni di", "B"});
  CHECK(wrap_evenly(title, size, room, Weight::bold) ==
        std::vector<std::string>{"Poligono delle", "accelerazioni di B"});
  CHECK(wrap_evenly("B", size, 1, Weight::bold) == std::vector<std::string>{"B"});
}
