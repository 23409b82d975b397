// A worked solution as a document, before it is Markdown, LaTeX or HTML. All texts are rich text
// (drawings/picture.h).
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "drawings/page.h"

namespace epure {

struct ReportHeading {
  int level;  // 1: of the document's parts, 2: within them
  std::string text;
};
struct ReportList {
  std::vector<std::string> items;
};
struct ReportFigure {
  std::string name;     // of its file, without folder and ending
  std::string caption;  // for who does not see it
  drawings::Page page;
};
using ReportBlock =
    std::variant<ReportHeading, drawings::Paragraph, drawings::Steps, drawings::Table, ReportList, ReportFigure>;

struct ReportDocument {
  std::string title, source;
  Language language = Language::english;
  std::vector<ReportBlock> blocks;
};

// A text parted at blanks outside of mathematics, which stay, so that no part is longer than drawings::longest_label.
std::vector<std::string> labels_in(const std::string& rich_text);

// The widest figure, in mm: on a page of A4 beside margins of 20 mm; and in the text of the documents of Word that
// pandoc makes of Markdown, where a wider one would be shrunk, and no longer at its scale.
inline constexpr double widest_report_figure = 170, widest_markdown_figure = 148;

// Figures are in files beside: SVG, for LaTeX PDF. HTML holds them itself.
std::string markdown_of(const ReportDocument& document);
std::string latex_of(const ReportDocument& document);
std::string html_of(const ReportDocument& document);

}  // namespace epure
