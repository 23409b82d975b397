// One HTML file that needs no other: figures are inline SVG. Legible light and dark, and on paper.
#include <fmt/format.h>

#include "drawings/files/xml.h"
#include "drawings/text/text.h"
#include "exercises/cli/html_page.h"
#include "exercises/cli/html_words.h"
#include "exercises/cli/inline_svg.h"
#include "exercises/cli/report_document.h"

namespace epure {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; }
body { font: 1rem/1.5 "STIX Two Text", Georgia, "Times New Roman", serif; max-width: 46rem; margin: 2rem auto;
  padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; break-after: avoid; }
figure { margin: 1.5rem 0; break-inside: avoid; }
figure svg { background: #fff; color-scheme: light; max-width: 100%; height: auto; display: block; margin: auto; }
.table { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .9rem; }
th, td { text-align: left; vertical-align: top; padding: .2rem .9rem .2rem 0; border-bottom: 1px solid #8888; }
tr { break-inside: avoid; }
@media print { body { max-width: none; margin: 0; padding: 0; font-size: 10.5pt; } .table { overflow: visible; } }
@page { size: A4; margin: 20mm; }
)";

std::string element(const char* name, const std::string& rich_text) {
  return fmt::format("<{0}>{1}</{0}>\n", name, html(rich_text));
}

class Html {
 public:
  void operator()(const ReportHeading& heading) { text_ += element(heading.level == 1 ? "h2" : "h3", heading.text); }
  void operator()(const drawings::Paragraph& words) { text_ += element("p", words.text); }
  void operator()(const drawings::Steps& steps) {
    text_ += steps.first == 1 ? std::string("<ol>\n") : fmt::format("<ol start=\"{}\">\n", steps.first);
    for (const std::string& line : steps.lines) text_ += element("li", line);
    text_ += "</ol>\n";
  }
  void operator()(const ReportList& list) {
    text_ += "<ul>\n";
    for (const std::string& item : list.items) text_ += element("li", item);
    text_ += "</ul>\n";
  }
  void operator()(const drawings::Table& table) {
    text_ += "<div class=\"table\" tabindex=\"0\"><table>\n";
    if (!table.head.empty()) {
      text_ += "<thead>";
      add_row("th scope=\"col\"", "th", table.head);
      text_ += "</thead>\n";
    }
    text_ += "<tbody>\n";
    for (const auto& row : table.rows) add_row("td", "td", row);
    text_ += "</tbody></table></div>\n";
  }
  void operator()(const ReportFigure& figure) { text_ += "<figure>\n" + svgs_.add(figure.page) + "</figure>\n"; }
  std::string text() && { return std::move(text_); }

 private:
  void add_row(const char* open, const char* close, const std::vector<std::string>& cells) {
    text_ += "<tr>";
    for (const std::string& cell : cells) text_ += fmt::format("<{}>{}</{}>", open, html(cell), close);
    text_ += "</tr>\n";
  }

  std::string text_;
  InlineSvgs svgs_;
};

}  // namespace

std::string html_of(const ReportDocument& document) {
  Html writer;
  for (const ReportBlock& block : document.blocks) std::visit(writer, block);
  return html_page({.language = document.language,
                    .title = drawings::plain(document.title),
                    .style = std::string(style) + style_of_words,
                    .body = "<main>\n" + element("h1", document.title) + element("p", document.source) +
                            std::move(writer).text() + "</main>\n"});
}

}  // namespace epure
