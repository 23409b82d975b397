// LaTeX for pdflatex and lualatex, with packages that every distribution has.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "drawings/files/tex.h"
#include "drawings/text/text.h"
#include "exercises/cli/report_document.h"
#include "exercises/cli/utf8.h"

namespace epure {
namespace {

constexpr const char* preamble = R"(\documentclass[11pt,a4paper]{{article}}
\usepackage[T1]{{fontenc}}
\usepackage{{lmodern}}
\usepackage[{}]{{babel}}
\usepackage[a4paper,margin=20mm]{{geometry}}
\usepackage{{graphicx,longtable,array}}
\usepackage[hidelinks,unicode,pdflang={},pdftitle={{{}}}]{{hyperref}}
\setlength{{\parindent}}{{0pt}}
\setlength{{\parskip}}{{4pt}}
\raggedbottom
\emergencystretch=3em
\renewcommand{{\arraystretch}}{{1.15}}
\begin{{document}}
\section*{{{}}}
{}

)";

constexpr std::size_t letters_of_a_line = 95, rows_that_stay_together = 25;  // in the size of tables

// Of a column: the letters of its longest word, which nothing breaks, and of its longest cell.
struct ColumnLetters {
  std::size_t word = 1, cell = 1;
};

std::vector<ColumnLetters> letters_of(const drawings::Table& table) {
  std::vector<ColumnLetters> columns;
  const auto add = [&](const std::vector<std::string>& row) {
    columns.resize(std::max(columns.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string text = drawings::plain(row[i]);
      columns[i].cell = std::max(columns[i].cell, count_characters(text));
      std::istringstream words(text);
      for (std::string word; std::getline(words, word, ' ');)
        columns[i].word = std::max(columns[i].word, count_characters(word));
    }
  };
  add(table.head);
  for (const auto& row : table.rows) add(row);
  return columns;
}

// As wide as the page: each has room for its longest word, and what is left goes to those with longer cells.
std::string columns_over_the_page(const std::vector<ColumnLetters>& columns) {
  double words = 0, more = 0;
  for (const ColumnLetters& each : columns) {
    words += static_cast<double>(each.word);
    more += static_cast<double>(each.cell - each.word);
  }
  const double left = std::max(0.0, static_cast<double>(letters_of_a_line) - words);
  std::string set;
  for (const ColumnLetters& each : columns) {
    const double letters =
        static_cast<double>(each.word) + (more > 0 ? left * static_cast<double>(each.cell - each.word) / more : 0);
    set += fmt::format(">{{\\raggedright\\arraybackslash}}p{{\\dimexpr{:.3f}\\linewidth-2\\tabcolsep}}",
                       letters / (words + (more > 0 ? left : 0)));
  }
  return set;
}

std::string latex(const std::string& rich_text) {
  std::string set;
  for (const std::string& part : labels_in(rich_text)) set += drawings::tex_of(part);
  return set;
}

class Latex {
 public:
  void operator()(const ReportHeading& heading) {
    text_ += fmt::format("\\{}section*{{{}}}\n", heading.level == 1 ? "" : "sub", latex(heading.text));
  }
  void operator()(const drawings::Paragraph& words) { text_ += latex(words.text) + "\n\n"; }
  void operator()(const drawings::Steps& steps) {
    text_ += fmt::format("\\begin{{enumerate}}\\setcounter{{enumi}}{{{}}}\n", steps.first - 1);
    add_items(steps.lines);
    text_ += "\\end{enumerate}\n";
  }
  void operator()(const ReportList& list) {
    text_ += "\\begin{itemize}\n";
    add_items(list.items);
    text_ += "\\end{itemize}\n";
  }
  // Short and narrow ones stay together; columns of others have a width, so that one run of LaTeX sets them.
  void operator()(const drawings::Table& table) {
    const std::vector<ColumnLetters> columns = letters_of(table);
    const std::size_t letters = std::accumulate(columns.begin(), columns.end(), 3 * columns.size(),
                                                [](std::size_t sum, const auto& each) { return sum + each.cell; });
    const bool is_small = letters <= letters_of_a_line && table.rows.size() <= rows_that_stay_together;
    const std::string kind = is_small ? "tabular" : "longtable";
    text_ += fmt::format("{{\\footnotesize\\begin{{{}}}{}{{{}}}\n", kind, is_small ? "" : "[l]",
                         is_small ? std::string(columns.size(), 'l') : columns_over_the_page(columns));
    if (!table.head.empty()) {
      add_row(table.head);
      text_ += is_small ? "\\hline\n" : "\\hline\\endhead\n";
    }
    for (const auto& row : table.rows) add_row(row);
    text_ += fmt::format("\\end{{{}}}\\par}}\n", kind);
  }
  void operator()(const ReportFigure& figure) {
    const bool is_shrunk = figure.page.extent.width() > widest_report_figure;
    text_ += fmt::format("\\begin{{center}}\n\\includegraphics{}{{{}.pdf}}\n\\end{{center}}\n",
                         is_shrunk ? "[width=\\linewidth]" : "", figure.name);
  }
  std::string text() && { return std::move(text_); }

 private:
  // A bracket at the beginning would be taken for what \item, or \\, takes.
  void add_items(const std::vector<std::string>& items) {
    for (const std::string& item : items) text_ += "\\item {}" + latex(item) + "\n";
  }
  void add_row(const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) text_ += (i == 0 ? "{}" : " & ") + latex(cells[i]);
    text_ += " \\\\\n";
  }

  std::string text_;
};

}  // namespace

std::string latex_of(const ReportDocument& document) {
  Latex writer;
  for (const ReportBlock& block : document.blocks) std::visit(writer, block);
  const bool is_english = document.language == Language::english;
  return fmt::format(fmt::runtime(preamble), is_english ? "english" : "italian", is_english ? "en" : "it",
                     latex(drawings::escaped(drawings::plain(document.title))), latex(document.title),
                     latex(document.source)) +
         std::move(writer).text() + "\\end{document}\n";
}

}  // namespace epure
