#include "exercises/cli/html_page.h"

#include <fmt/format.h>

#include "drawings/files/xml.h"

namespace epure {

std::string html_page(const HtmlPage& page) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'unsafe-inline'\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"generator\" content=\"epure " EPURE_VERSION
      "\"/>\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      page.language == Language::english ? "en" : "it", drawings::escaped_for_xml(page.title), page.style, page.body);
}

std::string script_of_page(const char* own) {
  return std::string("<script>\n(() => {") + script_of_moved_page + own + "})();\n</script>\n";
}

}  // namespace epure
