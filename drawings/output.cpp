#include "drawings/output.h"

#include "drawings/page.h"

namespace epure::drawings {

std::string pdf(const std::vector<Sheet>& sheets, const std::string& document_title) {
  std::vector<Page> pages;
  for (const Sheet& sheet : sheets) pages.push_back(compose(sheet));
  return write_pdf(pages, {.title = document_title});
}

std::string svg(const Sheet& sheet) { return write_svg(compose(sheet)); }

}  // namespace epure::drawings
