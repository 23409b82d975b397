#include "exercises/cli/sheet_html.h"

#include <fmt/format.h>

#include <utility>

#include "drawings/files/xml.h"
#include "drawings/text/text.h"
#include "exercises/cli/html_page.h"
#include "exercises/cli/html_words.h"
#include "exercises/cli/inline_svg.h"
#include "exercises/cli/screen_style.h"
#include "exercises/cli/sheet_html_parts.h"

namespace epure {
namespace {

// Paper as large as the sheet; of a bare figure the smallest that holds it.
std::string print_style(const std::vector<drawings::Page>& pages, bool is_bare) {
  const drawings::Box extent = pages.front().extent;
  const double width = extent.width(), height = extent.height();
  const std::string size =
      fmt::format("@media print {{ .sheet svg {{ width: {:.5f}mm; height: {:.5f}mm; }} }}\n", width, height);
  if (!is_bare) return size + fmt::format("@page {{ size: {:.0f}mm {:.0f}mm; margin: 0; }}\n", width, height);
  constexpr double margin = 10;
  const bool fits_a4 = width + 2 * margin <= 297 && height + 2 * margin <= 210;
  return size + fmt::format("@page {{ size: {} landscape; margin: {}mm; }}\n", fits_a4 ? "A4" : "A3", margin);
}

std::string say(const Words& words, const drawings::Page& page) { return words.in(page.language); }

std::string state(const std::string& name, const std::string& words) {
  return fmt::format("<li data-name=\"{}\">{}</li>\n", drawings::escaped_for_attribute(name), words);
}

std::string controls(const drawings::Page& page) {
  const std::size_t count = page.steps.size();
  const std::string given = say({"What is given.", "Ciò che è dato."}, page),
                    whole = say({"The whole sheet.", "La tavola intera."}, page);
  std::string html_text = fmt::format(
      "<div class=\"controls\" role=\"group\" aria-label=\"{0}\" hidden=\"\">\n<div class=\"moves\">\n"
      "<button type=\"button\" class=\"previous\">{1}</button>\n"
      "<input type=\"range\" class=\"slider\" min=\"0\" max=\"{2}\" step=\"1\" value=\"{2}\" aria-label=\"{3}\"/>\n"
      "<button type=\"button\" class=\"next\">{4}</button>\n</div>\n"
      "<p class=\"words\" aria-live=\"polite\"></p>\n</div>\n"
      "<details class=\"states\"><summary>{5}</summary>\n<ol start=\"0\">\n",
      say({"Construction", "Costruzione"}, page), say({"Previous", "Indietro"}, page), count + 1,
      say({"Step", "Passo"}, page), say({"Next", "Avanti"}, page), say({"All steps", "Tutti i passi"}, page));
  html_text += state(given, given);
  for (std::size_t i = 0; i < count; ++i)
    html_text += state(fmt::format("{} {}/{}.", say({"Step", "Passo"}, page), i + 1, count), html(page.steps[i]));
  return html_text + state(whole, whole) + "</ol></details>\n";
}

}  // namespace

std::string sheet_html(const std::vector<drawings::Page>& pages, SheetOnScreen as) {
  const drawings::Page& first = pages.front();
  std::string body =
      "<main class=\"epure\">\n<h1>" + drawings::escaped_for_xml(first.title) + "</h1>\n<figure class=\"sheet\">\n";
  InlineSvgs svgs;
  for (const drawings::Page& page : pages) body += svgs.add(page);
  body += "</figure>\n";
  if (!first.steps.empty()) body += controls(first);
  body +=
      "<div class=\"tip\" aria-hidden=\"true\" hidden=\"\"></div>\n" + script_of_page(script_of_sheet) + "</main>\n";
  return html_page({.language = first.language,
                    .title = first.title,
                    .style = std::string(style_of_moved_page) + style_of_sheet + style_of_words +
                             print_style(pages, as.is_bare) + (as.follows_reader ? dark_style(pages) : ""),
                    .body = std::move(body)});
}

}  // namespace epure
