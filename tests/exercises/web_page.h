// Pages for a browser, read as XML and shown by Chromium without a window.
#pragma once

#include <poppler-document.h>
#include <poppler-page.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <regex>
#include <set>
#include <string>

#include "drawings/picture.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

namespace epure {

// An HTML page, which a parser of XML reads too.
struct WebPage {
  explicit WebPage(const std::string& bytes) : html(bytes) {
    const auto read = xml.load_buffer(html.data(), html.size(), pugi::parse_default | pugi::parse_doctype);
    CAPTURE(read.description(),
            html.substr(static_cast<std::size_t>(std::max<std::ptrdiff_t>(read.offset - 80, 0)), 160));
    REQUIRE(read);
  }
  template <class See>
  void each(See see) const {
    struct Walker : pugi::xml_tree_walker {
      explicit Walker(See s) : see(s) {}
      bool for_each(pugi::xml_node& node) override {
        see(node);
        return true;
      }
      See see;
    } walker(see);
    const_cast<pugi::xml_document&>(xml).traverse(walker);
  }
  int count(const char* path) const { return static_cast<int>(xml.select_nodes(path).size()); }
  int steps() const { return std::max(0, count("//ol/li") - 2); }
  // Of the figure, without its column: the elements of a step.
  std::map<int, int> marks_of_steps() const {
    std::map<int, int> marks;
    each([&](const pugi::xml_node& node) {
      const std::string name = node.attribute("class").value();
      if (name.starts_with("step-")) ++marks[std::stoi(name.substr(5))];
    });
    return marks;
  }

  std::string html;
  pugi::xml_document xml;
};

inline std::string text_of(pugi::xml_node node) {
  std::string text = node.value();
  for (const pugi::xml_node child : node) text += text_of(child);
  return text;
}

// An id once, and what refers to one finds it.
inline void demand_clear_ids(const WebPage& page) {
  std::set<std::string> ids, wanted;
  page.each([&](const pugi::xml_node& node) {
    if (const pugi::xml_attribute id = node.attribute("id")) {
      if (!ids.insert(id.value()).second) FAIL_CHECK(id.value() << " stands twice");
    }
    if (const pugi::xml_attribute link = node.attribute("xlink:href"))
      wanted.insert(std::string(link.value()).substr(1));
    const std::string clip = node.attribute("clip-path").value();
    if (!clip.empty()) wanted.insert(clip.substr(5, clip.size() - 6));
  });
  for (const std::string& id : wanted)
    if (!ids.contains(id)) FAIL_CHECK(id << " is nowhere");
  CHECK(ids.size() > 10);
}

// Nothing is fetched: names of name spaces are no addresses.
inline void demand_self_contained(const WebPage& page) {
  page.each([](const pugi::xml_node& node) {
    const std::string name = node.name();
    for (const char* element : {"link", "img", "iframe", "object", "embed", "image", "base"})
      if (name == element) FAIL_CHECK(name << " on the page");
    for (const pugi::xml_attribute attribute : node.attributes()) {
      const std::string of = attribute.name(), value = attribute.value();
      if (of.starts_with("xmlns")) continue;
      const bool leads_out = value.find("://") != std::string::npos || of == "src" || of.starts_with("on") ||
                             (of.ends_with("href") && !value.starts_with("#"));
      if (leads_out) FAIL_CHECK(name << " has " << of << " " << value);
    }
  });
  for (const char* element : {"//script", "//style"}) {
    const std::string text = std::regex_replace(text_of(page.xml.select_node(element).node()),
                                                std::regex("http://www.w3.org/2000/svg"), "");
    CHECK(text.find("://") == std::string::npos);
    CHECK(text.find("@import") == std::string::npos);
    CHECK(text.find("url(") == std::string::npos);
  }
  CHECK(page.html.find("Content-Security-Policy\" content=\"default-src 'none'") != std::string::npos);
}

inline bool is_at_hand(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

inline void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out << bytes;
  REQUIRE(out.flush());
}

// The browser, without a window.
inline std::string chromium(const Scratch& scratch, const std::string& options, const std::string& page) {
  const std::string command =
      "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync --window-size=1200,800 "
      "--user-data-dir='" +
      (scratch.path() / "profile").string() + "' " + options + " 'file://" + (scratch.path() / page).string() +
      "' > seen.txt 2> /dev/null";
  CAPTURE(command);
  REQUIRE(std::system(command.c_str()) == 0);
  return contents("seen.txt");
}

// What is seen of a page in which this script has run.
inline std::string driven(const Scratch& scratch, const std::string& html, const std::string& script,
                          const std::string& options = {}) {
  write("driven.html", std::regex_replace(html, std::regex("</body>"), "<script>" + script + "</script></body>"));
  return chromium(scratch, options + " --dump-dom", "driven.html");
}

// The paper, in mm, of a page that is printed on one sheet.
inline drawings::Point paper_of_print(const Scratch& scratch, const std::string& html) {
  write("page.html", html);
  chromium(scratch, "--no-pdf-header-footer --print-to-pdf=printed.pdf", "page.html");
  const std::string pdf = contents("printed.pdf");
  const std::unique_ptr<poppler::document> printed(
      poppler::document::load_from_raw_data(pdf.data(), static_cast<int>(pdf.size())));
  REQUIRE(printed);
  CHECK(printed->pages() == 1);
  const poppler::rectf paper = std::unique_ptr<poppler::page>(printed->create_page(0))->page_rect();
  return {paper.width() / 72 * 25.4, paper.height() / 72 * 25.4};
}

}  // namespace epure
