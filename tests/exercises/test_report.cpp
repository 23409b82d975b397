// Worked solutions as documents, and exercises bound into one.
#include <poppler-document.h>
#include <poppler-page.h>
#include <poppler-toc.h>

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <sstream>

#include "drawings/files/tex.h"
#include "drawings/text/unicode.h"
#include "exercises/cli/report_document.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"
#include "tests/support/unpacked.h"

using namespace epure;

namespace {

using Typed = std::vector<std::string>;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

pugi::xml_document parsed(const std::string& html) {
  pugi::xml_document xml;
  const auto read = xml.load_buffer(html.data(), html.size(), pugi::parse_default | pugi::parse_doctype);
  CAPTURE(read.description(),
          html.substr(static_cast<std::size_t>(std::max<std::ptrdiff_t>(read.offset - 80, 0)), 160));
  REQUIRE(read);
  return xml;
}

// Letters of an element and all below it.
std::string text_of(pugi::xml_node node) {
  std::string text = node.value();
  for (const pugi::xml_node child : node) text += text_of(child);
  return text;
}

// Braces that no backslash precedes, and environments.
void demand_balanced(const std::string& tex) {
  int depth = 0;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    if (tex[i] == '\\') {
      ++i;
      continue;
    }
    depth += tex[i] == '{' ? 1 : tex[i] == '}' ? -1 : 0;
    REQUIRE(depth >= 0);
  }
  CHECK(depth == 0);
}

const ReportDocument awkward{
    .title = "50 % of a_b | <c> & \\$d #e *f* \\g ~h^ {i}",
    .source = "[x] `y` @z",
    .language = Language::italian,
    .blocks = {drawings::Paragraph{"- no list"}, drawings::Paragraph{"3. no list"},
               drawings::Paragraph{"$\\vec{v}_{BA}$ ⊥ $BA$, $ω_{2}^{2}$ = 5 s$^{−2}$"},
               drawings::Steps{{"first", "[second]"}, 4},
               drawings::Table{.head = {"$|x|$", "b"}, .rows = {{"1", "2", "3"}, {"[4]"}}}},
};

// Each object that the table of a PDF promises is where it says. (Cairo 1.18 packs the table.)
void demand_whole(const std::string& pdf) {
  const std::string told = "startxref\n";
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind(told) + told.size()));
  if (pdf.compare(table, 5, "xref\n") != 0) return;
  std::istringstream lines(pdf.substr(table));
  std::string line;
  std::getline(lines, line);
  std::size_t first = 0, count = 0;
  lines >> first >> count;
  CHECK(first == 0);
  REQUIRE(count > 5);
  std::getline(lines, line);
  for (std::size_t object = 0; object < count; ++object) {
    std::getline(lines, line);
    if (line.find(" f") != std::string::npos) continue;
    const std::string begins = std::to_string(object) + " 0 obj";
    if (pdf.compare(std::stoul(line), begins.size(), begins) != 0) FAIL_CHECK("no object " << object << ": " << line);
  }
}

}  // namespace

TEST_CASE("what a language of documents takes for its own is escaped in it") {
  CHECK(markdown_of(awkward) ==
        "# 50 % of a\\_b \\| \\<c\\> \\& \\$d \\#e \\*f\\* \\\\g \\~h\\^ {i}\n\n"
        "\\[x\\] \\`y\\` \\@z\n\n"
        "\\- no list\n\n"
        "3\\. no list\n\n"
        "${\\vec{v}}_{\\mathrm{BA}}$ $\\perp$ BA, ${\\omega }_{2}^{2}$ = 5 $\\mathrm{s}^{-2}$\n\n"
        "4. first\n5. \\[second\\]\n\n"
        "| ${\\mid}x{\\mid}$ | b |  |\n|------|---|---|\n| 1 | 2 | 3 |\n| \\[4\\] |  |  |\n\n");
  const std::string tex = latex_of(awkward);
  CAPTURE(tex);
  CHECK(has(tex, "\\usepackage[italian]{babel}"));
  CHECK(has(tex,
            "\\section*{50 \\% of a\\_b \\ensuremath{|} \\ensuremath{<}c\\ensuremath{>} \\& \\$d \\#e *f* "
            "\\textbackslash{}g \\textasciitilde{}h\\textasciicircum{} \\{i\\}}"));
  CHECK(has(tex, "\\setcounter{enumi}{3}\n\\item {}first\n\\item {}[second]\n"));
  CHECK(has(tex, "{}[4]"));
  demand_balanced(tex);
  const std::string html = html_of(awkward);
  CHECK(has(html, "<html lang=\"it\">"));
  CHECK(has(html, "<h1>50 % of a_b | &lt;c&gt; &amp; $d #e *f* \\g ~h^ {i}</h1>"));
  CHECK(has(html, "<span class=\"vector\"><i>v</i></span><sub>BA</sub> ⊥ BA, <i>ω</i><sub>2</sub><sup>2</sup>"));
  CHECK(has(html, "<ol start=\"4\">"));
  parsed(html);
}

TEST_CASE("what LaTeX sets in mathematics alone is a formula in Markdown, whole words and numbers of it") {
  const ReportDocument document{
      .title = "t",
      .source = "s",
      .language = Language::italian,
      .blocks = {
          drawings::Paragraph{"P₀, A′B and h ≥ −0,25 or −3·x²: 5°, ½, è"},
          drawings::Paragraph{"∥$x$ and $α$5 and $x$$y$ and \\$5"},
          drawings::Paragraph{"P₁₂, m⁴, 10⁻⁷; ($n$ − 1)$^{2}$, ($α$)$^{2}$, |$R$|$_{max}$"},
          drawings::Paragraph{"√(3·2), √($α$), √2; $h^{*}$, $t^{A+}$, $(a)_{y}$"},
          drawings::Table{.head = {"between"}, .rows = {{"0,00022857142857142857\u00a0… 0,0002285714285714286"}}}}};
  const std::string told = markdown_of(document);
  CAPTURE(told);
  CHECK(has(told, "$\\mathrm{P}_{0}$, $\\mathrm{A}'\\mathrm{B}$ and h $\\geq$ $-0{,}25$ or $-3$·x²: 5°, ½, è\n"));
  CHECK(has(told, "$\\parallel x$ and $\\alpha 5$ and $x y$ and \\$5\n"));
  // A script on nothing is an empty box in Word and LibreOffice.
  CHECK(has(
      told,
      "$\\mathrm{P}_{12}$, $\\mathrm{m}^{4}$, $10^{-7}$; ($n$ $-$ $1{\\text{)}}^{2}$, ($\\alpha {\\text{)}}^{2}$, "
      "\\|$\\mathrm{R}{\\mid}_{\\mathrm{max}}$\n"));
  CHECK(has(told,
            "$\\surd {\\text{(}}3$·2), $\\surd {\\text{(}} \\alpha$), $\\surd 2$; ${h}^{\\text{*}}$, "
            "${t}^{\\mathrm{A}\\text{+}}$, $\\text{(}a{\\text{)}}_{\\mathrm{y}}$\n"));
  CHECK(drawings::tex_of_mathematics({{.letters = "P₁₂²₃x²′"}}) ==
        "\\mathrm{P}_{12}^{2}{}_{3}\\mathrm{x}^{2}{}'");  // TeX takes no two of a kind on one base
  CHECK(has(told, "|" + std::string(48, '-') + "|"));     // twice its longest word
}

TEST_CASE("no report has a sign outside of mathematics that LaTeX has not in text", "[slow]") {
  const std::regex formula(R"(([^\\]|^)\$[^$]*[^$\\]\$)");
  for (const Listed& exercise : catalogue())
    for (const std::string language : {"en", "it"}) {
      const Scratch scratch;
      REQUIRE(run_on_all({"report", exercise.id(), "--lang", language, "-o", "r.md"}).exit != 2);
      const std::string outside = std::regex_replace(contents("r.md"), formula, "$1");
      CHECK_FALSE(has(contents("r.md"), "{}_"));
      CHECK_FALSE(has(contents("r.md"), "{}^"));
      for (const char32_t c : drawings::characters(std::regex_replace(outside, std::regex("\n"), " "))) {
        CAPTURE(exercise.id(), language, drawings::utf8(c));
        if (drawings::is_mathematics_only(c)) FAIL_CHECK("outside of mathematics");
      }
    }
}

// The text of the documents of Word that pandoc makes is 5334000 of its units wide, 360 of which are 0.01 mm.
TEST_CASE("figures of Markdown are no wider than the text of a document of Word, so that they keep their scale") {
  const Scratch scratch;
  REQUIRE(run_on_all({"report", "slider-crank-velocity", "-o", "r.md"}).exit <= 1);
  for (const std::string sheet : {"poles", "polar-diagram", "polodes", "coupler-curve"}) {
    CAPTURE(sheet);
    pugi::xml_document svg;
    REQUIRE(svg.load_string(contents("r-" + sheet + ".svg").c_str()));
    CHECK(svg.child("svg").attribute("width").as_double() <= 5334000 / 36000.0);
  }
}

TEST_CASE("a report names sheets in its language") {
  const Scratch scratch;
  REQUIRE(run_on_all({"report", "slider-crank-velocity", "--lang", "it", "-o", "r.md"}).exit <= 1);
  const std::string told = contents("r.md");
  const Words& title = title_of_sheet(find_exercise(catalogue(), "slider-crank-velocity"), "polar-diagram");
  CHECK(has(told, "(" + title.italian + ")"));
  CHECK_FALSE(has(told, "(polar-diagram)"));
}

TEST_CASE("a text of any length is parted between words, and nothing is lost") {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "word $v_{B} + a$ \\$ ";
  const std::vector<std::string> parts = labels_in(text);
  CHECK(parts.size() > 1);
  std::string all;
  for (const std::string& part : parts) {
    CHECK(part.size() <= 2000);
    CHECK(std::count(part.begin(), part.end(), '$') % 3 == 0);
    all += part;
  }
  CHECK(all == text);
  CHECK(labels_in("") == std::vector<std::string>{""});
}

TEST_CASE("a report tells the question, the givens, every sheet and every quantity") {
  const Scratch scratch;
  CHECK(run({"report", "triangle", "--set", "a=0.5"}).out ==
        "out/triangle-report-sides.svg\nout/triangle-report-small.svg\nout/triangle-report.md\n");
  const std::string told = std::regex_replace(contents("out/triangle-report.md"), std::regex("\u00a0"), " ");
  CAPTURE(told);
  for (const std::string part :
       {"# A right triangle\n", "Euclid, I.47, givens changed\n", "## Question\n\nFind the hypotenuse.\n",
        "- a = 0.5 m, base\n", "## The sides\n\n![The sides](triangle-report-sides.svg)\n", "hypotenuse | 0.640312 m",
        "Found by: ruler, analytic."})
    CHECK(has(told, part));
  CHECK_FALSE(has(told, "What the source printed"));
  CHECK(run({"report", "triangle", "-o", "it/t.tex", "--lang", "it"}).out ==
        "it/t-sides.pdf\nit/t-small.pdf\nit/t.tex\n");
  const std::string tex = contents("it/t.tex");
  CHECK(has(tex, "\\includegraphics{t-sides.pdf}"));
  CHECK(has(tex, "\\section*{Ciò che la fonte stampa}"));
  CHECK(has(tex, "i cateti sono stati sommati"));
  CHECK(contents("it/t-sides.pdf").starts_with("%PDF"));
  CHECK(run({"report", "triangle", "--format", "html", "--out", "h"}).out == "h/triangle-report.html\n");
  CHECK(run({"report", "triangle", "-o", "-"}).out == contents("h/triangle-report.html"));
}

TEST_CASE("the numbers of a report are those of check, as bounds to the last digit") {
  const auto html = parsed(run_on_all({"report", "slider-crank-velocity", "-o", "-"}).out);
  const auto checked = nlohmann::json::parse(run_on_all({"check", "slider-crank-velocity", "--json"}).out);
  std::vector<std::string> lower, upper;
  for (const pugi::xpath_node table : html.select_nodes("//table")) {
    if (text_of(table.node().select_node("thead/tr/th[3]").node()) != "between") continue;
    for (const pugi::xpath_node row : table.node().select_nodes("tbody/tr")) {
      const std::string told = text_of(row.node().select_node("td[3]").node()), dots = "\u00a0… ";
      const auto at = told.find(dots);
      lower.push_back(told.substr(0, at));
      upper.push_back(at == std::string::npos ? told : told.substr(at + dots.size()));
    }
  }
  const auto& quantities = checked["exercises"][0]["quantities"];
  REQUIRE(lower.size() == quantities.size());
  const auto number = [](std::string text) {
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"−", "-"}, {"−", "-"}, {"·10", "e"}})
      if (const auto at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
    return std::stod(text);
  };
  for (std::size_t i = 0; i < lower.size(); ++i) {
    CAPTURE(quantities[i]["name"], lower[i], upper[i]);
    CHECK(number(lower[i]) == quantities[i]["lower"].get<double>());
    CHECK(number(upper[i]) == quantities[i]["upper"].get<double>());
  }
  for (const auto& quantity : quantities)
    if (quantity.contains("printed"))
      for (const auto& printed : quantity["printed"])
        if (printed.contains("explanation")) {
          const std::string words = printed["explanation"];
          CAPTURE(words);
          CHECK(has(text_of(html), words.substr(0, words.find_first_of("_^"))));
        }
}

TEST_CASE("a report of what fails or is open says so, and exits as check does") {
  const Scratch scratch;
  Triangle wrong;
  wrong.spoil_values = [](auto& values) { value_of(values, "c", "ruler") = certain(7); };
  const Ran failed = run_on(wrong, {"report", "triangle"});
  CHECK(failed.exit == 1);
  CHECK(has(contents("out/triangle-report.md"), "## What failed"));
  Triangle open;
  open.spoil_values = [](auto& values) {
    for (const char* route : {"ruler", "analytic"}) value_of(values, "omega", route) = undecided("too hard");
  };
  const Ran undecided = run_on(open, {"report", "triangle"});
  CHECK(undecided.exit == 4);
  CHECK(has(contents("out/triangle-report.md"), "## What is undecided"));
}

TEST_CASE("what a report cannot be is one sentence, and nothing is written") {
  const auto refused = [](const Typed& words, int exit, const std::string& part) {
    const Scratch scratch;
    const Ran ran = run(words);
    CAPTURE(words, ran.err);
    CHECK(ran.exit == exit);
    CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
    CHECK(has(ran.err, part));
    CHECK(scratch.files().empty());
  };
  refused({"report"}, 2, "no exercise named");
  refused({"report", "triangle/sides"}, 2, "report takes one exercise");
  refused({"report", "triangle", "--format", "docx"}, 2, "choose md, tex or html");
  refused({"report", "triangle", "-o", "x.doc"}, 2, "tells no format");
  refused({"report", "triangle", "-o", "x.md", "--format", "tex"}, 2, "is not the ending of --format tex");
  refused({"report", "triangle", "-o", "x.svg", "--format", "md"}, 2, "what is written here is md, tex or html");
  refused({"report", "triangle", "-o", "-", "--format", "md"}, 2, "figures in files beside it");
  refused({"report", "triangle", "-o", "è.tex"}, 2, "a file for TeX has a name of");
  refused({"report", "triangle", "-o", "x.md", "--out", "y"}, 2, "choose one of them");
  refused({"report", "triangle", "--set", "a=-1"}, 2, "a");
  refused({"report", "triangle", "-o", "/proc/none/x.md"}, 3, "/proc/none");
  refused({"booklet", "triangle/sides"}, 2, "is a sheet");
  refused({"booklet", "-o", "x.svg"}, 2, "end it in .pdf");
  refused({"booklet", "-o", "x.pdf", "--out", "y"}, 2, "choose one of them");
  refused({"booklet", "nothing"}, 2, "there is no exercise \"nothing\"");
  refused({"booklet", "-o", "/proc/none/x.pdf"}, 3, "/proc/none");
}

TEST_CASE("every exercise has a report that is well formed, in both languages", "[slow]") {
  for (const Listed& exercise : catalogue())
    for (const std::string language : {"en", "it"}) {
      CAPTURE(exercise.id(), language);
      const Scratch scratch;
      const Ran html = run_on_all({"report", exercise.id(), "-o", "-", "--lang", language});
      CAPTURE(html.err);
      REQUIRE(html.exit == 0);
      const auto xml = parsed(html.out);
      CHECK(xml.child("html").attribute("lang").value() == language);
      CHECK(xml.select_nodes("//figure/svg").size() >= exercise->about().sheets.size());
      // One document, so no mark of one figure is taken for another's: only letters, whose outlines are the same.
      std::map<std::string, std::string> known;
      for (const pugi::xpath_node found : xml.select_nodes("//*[@id]")) {
        std::string all = found.node().name();
        for (const pugi::xml_attribute each : found.node().attributes()) all += std::string(" ") + each.value();
        const auto [first, is_new] = known.emplace(found.node().attribute("id").value(), all);
        CAPTURE(first->first);
        if (!is_new) CHECK((found.node().parent().name() == std::string("defs") && first->second == all));
      }
      REQUIRE(run_on_all({"report", exercise.id(), "-o", "r.tex", "--lang", language}).exit == 0);
      const std::string tex = contents("r.tex");
      demand_balanced(tex);
      for (auto at = tex.find("\\begin{longtable}"); at != std::string::npos;
           at = tex.find("\\begin{longtable}", at + 1)) {
        const std::string table = tex.substr(at, tex.find("\\end{longtable}", at) - at);
        CHECK(has(table, "\\hline\\endhead\n"));  // on every page its heads
      }
    }
}

TEST_CASE("a booklet has contents, which lead to every sheet") {
  const Scratch scratch;
  CHECK(run_on_two({"booklet", "--lang", "it", "--course", "Meccanica"}).out == "out/booklet.pdf\n");
  const std::string bytes = contents("out/booklet.pdf");
  poppler::byte_array data(bytes.begin(), bytes.end());
  const std::unique_ptr<poppler::document> pdf(poppler::document::load_from_data(&data));
  REQUIRE(pdf);
  REQUIRE(pdf->pages() == 6);
  const auto text = [&](int page) {
    const std::unique_ptr<poppler::page> of(pdf->create_page(page));
    const poppler::byte_array utf8 = of->text().to_utf8();
    return std::string(utf8.begin(), utf8.end());
  };
  CHECK(has(text(0), "Costruzioni grafiche"));
  CHECK(has(text(0), "Meccanica"));
  CHECK(has(text(0), "Esercizi: 2. Tavole: 4."));
  const std::string contents_page = std::regex_replace(text(1), std::regex("\\s+"), " ");
  CHECK(has(contents_page, "Indice"));
  CHECK(has(contents_page, "Un triangolo rettangolo"));
  for (const std::string page : {"3", "4", "5", "6"}) CHECK(has(contents_page, " " + page));
  const std::unique_ptr<poppler::toc> toc(pdf->create_toc());
  REQUIRE(toc);
  CHECK(toc->root()->children().size() == 3);  // contents, and two exercises
  const std::string plain = with_packed_objects(bytes);
  const std::regex link("/Subtype\\s*/Link");
  CHECK(std::distance(std::sregex_iterator(plain.begin(), plain.end(), link), std::sregex_iterator()) == 6);
  for (const std::string page : {"page3", "page4", "page5", "page6"}) CHECK(has(plain, page));
  demand_whole(bytes);
  CHECK(run_on_two({"booklet", "triangle", "-o", "-"}).out.starts_with("%PDF"));
}

TEST_CASE("a PDF tells the language of its words") {
  for (const std::string language : {"en", "it"}) {
    const std::string bytes = run({"draw", "triangle", "-o", "-", "--lang", language}).out;
    CHECK(has(bytes, "/Type /Catalog\n   /Lang (" + language + ")\n"));
    demand_whole(bytes);
  }
}
