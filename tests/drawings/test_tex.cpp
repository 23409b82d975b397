#include "drawings/files/tex.h"

#include "drawings/paths/vectors.h"
#include "probe.h"
#include "tests/support/catch.h"

using namespace epure::drawings;

TEST_CASE("rich text becomes LaTeX that shows the same") {
  CHECK(tex_of("$P_{0}$") == "${\\mathrm{P}}_{0}$");
  CHECK(tex_of("$ω_{3}$") == "${\\omega }_{3}$");
  CHECK(tex_of("$b'$") == "$b$\\ensuremath{'}");
  CHECK(tex_of("$v_B$") == "${v}_{\\mathrm{B}}$");
  CHECK(tex_of("$\\vec{v}_{BA}$") == "${\\vec{v}}_{\\mathrm{BA}}$");
  CHECK(tex_of("$2ab_{A1B}$") == "2$a$${b}_{\\mathrm{A}1\\mathrm{B}}$");
  CHECK(tex_of("1 : 5") == "1 : 5");
  CHECK(tex_of("1 cm ≙ 2.5 m/s") == "1 cm \\ensuremath{\\mathrel{\\stackrel{\\wedge}{=}}} 2.5 m/s");
  CHECK(tex_of("2,5") == "2,5");
  CHECK(tex_of("è") == "è");
  CHECK(tex_of("0.2\u00a0m") == "0.2~m");
}

TEST_CASE("what TeX would take for a command is shown as it is") {
  CHECK(tex_of("100% & #1 {a_b} ~^ \\x") ==
        "100\\% \\& \\#1 \\{a\\_b\\} \\textasciitilde{}\\textasciicircum{} \\textbackslash{}x");
  CHECK(tex_of(escaped("\\input{/etc/passwd}$x$")) == "\\textbackslash{}input\\{/etc/passwd\\}\\$x\\$");
  CHECK(tex_of("a--b") == "a-{}-{}b");
  CHECK(tex_of("$a_{%}$") == "${a}_{\\mbox{\\%}}$");
}

TEST_CASE("letters stay where the figure has them, the figure below them without letters") {
  Page page{"demo", "t", "d", {{10, 20}, {110, 70}}, epure::Language::english, {}};
  page.primitives.emplace_back(Stroke{segment({10, 20}, {50, 50}), 0.2, {}, {}, {}, {}});
  page.primitives.emplace_back(
      PlacedText{.text = "$v$", .baseline = {30, 40}, .size = 3.5, .colour = {}, .anchor = 0.5});
  page.primitives.emplace_back(PlacedText{"a", {30, 45}, 2.5, {0, 0.5, 1, 1}, Weight::bold});
  page.primitives.emplace_back(
      PlacedText{.text = "bc", .baseline = {30, 60}, .size = 3.5, .colour = {}, .anchor = 1});
  const std::string tex = write_tex(page, "demo-art.pdf");
  CHECK(tex.find("\\begin{picture}(100.000,50.000)%\n\\put(0,0){\\includegraphics{demo-art.pdf}}%\n") !=
        std::string::npos);
  const double middle = 20 + measure("$v$", 3.5).width / 2;
  const std::string start = "\\put(" + std::to_string(middle).substr(0, 5);
  CHECK(tex.find(start) != std::string::npos);
  CHECK(tex.find(",20.000){\\makebox(0,0)[b]{\\smash{\\fontsize{10}{12.0}\\selectfont $v$}}}%\n") !=
        std::string::npos);
  CHECK(tex.find("\\fontsize{7}{8.4}\\selectfont \\epureink{0.000,0.500,1.000}{\\bfseries a}}}}%\n") !=
        std::string::npos);
  CHECK(tex.find("\\put(20.000,25.000){\\makebox(0,0)[bl]{") != std::string::npos);
  const double right = 20 + measure("bc", 3.5).width;
  CHECK(tex.find("\\put(" + std::to_string(right).substr(0, 5)) != std::string::npos);
  CHECK(tex.find(",40.000){\\makebox(0,0)[br]{") != std::string::npos);
  const Page art = without_letters(page);
  CHECK(art.primitives.size() == 1);
  CHECK(art.extent.width() == page.extent.width());
  CHECK(write_tex(page, "demo-art.pdf") == tex);
}
