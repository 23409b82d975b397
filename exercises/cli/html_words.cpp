#include "exercises/cli/html_words.h"

#include <vector>

#include "drawings/files/xml.h"
#include "drawings/text/rich_text.h"
#include "exercises/cli/report_document.h"

namespace epure {
namespace {

std::string html_of_nodes(const std::vector<drawings::Node>& nodes) {
  std::string set;
  for (const drawings::Node& node : nodes) {
    std::string nucleus = drawings::escaped_for_xml(node.letters) + html_of_nodes(node.group);
    if (node.italic) nucleus = "<i>" + nucleus + "</i>";
    if (node.arrow) nucleus = "<span class=\"vector\">" + nucleus + "</span>";
    set += nucleus;
    if (!node.below.empty()) set += "<sub>" + html_of_nodes(node.below) + "</sub>";
    if (!node.above.empty()) set += "<sup>" + html_of_nodes(node.above) + "</sup>";
  }
  return set;
}

}  // namespace

std::string html(const std::string& rich_text) {
  std::string set;
  for (const std::string& part : labels_in(rich_text)) set += html_of_nodes(drawings::parse(part));
  return set;
}

}  // namespace epure
