#include "drawings/sheet/column.h"

#include <array>

#include "drawings/marks/symbols.h"
#include "drawings/text/text.h"

namespace epure::drawings {

namespace {

void set_block(Galley& galley, const Heading& heading, Language) {
  if (!galley.empty()) galley.down(0.55 * galley.size() * galley.air());
  galley.lines(wrap(heading.text, galley.size(), galley.width(), Weight::bold), galley.left(), Weight::bold);
  galley.down(0.1 * galley.size() * galley.air());
}

void set_block(Galley& galley, const Paragraph& paragraph, Language) {
  galley.lines(wrap(paragraph.text, galley.size(), galley.width()), galley.left());
  galley.down(0.3 * galley.size() * galley.air());
}

void set_block(Galley& galley, const Steps& steps, Language) {
  const double diameter = 1.22 * galley.size(), indent = 1.8 * galley.size();
  int number = steps.first;
  for (const std::string& line : steps.lines) {
    // The circle's middle at half the height of capitals, so that number and line read as one.
    const std::size_t before = galley.count();
    const Point centre{galley.left() + diameter / 2, galley.baseline() + 0.33 * galley.size()};
    galley.add(circled_number(centre, number, diameter, black));
    galley.lines(wrap(line, galley.size(), galley.width() - indent), galley.left() + indent);
    galley.since(before, number);
    galley.down(0.26 * galley.size() * galley.air());
    ++number;
  }
  galley.down(0.1 * galley.size() * galley.air());
}

Galley set_all(const std::vector<Block>& blocks, Box room, Language language, Setting setting) {
  Galley galley(room, setting);
  int told = 0;  // the last step so far: what is concluded after it comes with it
  for (const Block& block : blocks) {
    const std::size_t before = galley.count();
    std::visit([&](const auto& b) { set_block(galley, b, language); }, block);
    if (const auto* steps = std::get_if<Steps>(&block))
      told = steps->first + static_cast<int>(steps->lines.size()) - 1;
    else
      galley.since(before, told);
  }
  return galley;
}

}  // namespace

std::vector<Primitive> set_column(const std::vector<Block>& blocks, Box room, Language language,
                                  std::vector<std::string>* conflicts) {
  constexpr std::array sizes{column_size, 3.0, 2.8, 2.6, 2.4, smallest_size};
  constexpr std::array airs{1.0, 0.7, 0.4};
  for (const double size : sizes)
    for (const double air : airs) {
      Galley galley = set_all(blocks, room, language, {size, air});
      const bool last = size == sizes.back() && air == airs.back();
      if ((galley.overflows() || !galley.complaints.empty()) && !last) continue;
      if (conflicts && galley.overflows()) conflicts->push_back("the column does not fit beside the figure");
      if (conflicts) conflicts->insert(conflicts->end(), galley.complaints.begin(), galley.complaints.end());
      return galley.take();
    }
  return {};
}

}  // namespace epure::drawings
