#include "exercises/cli/staged_pages.h"

#include <optional>
#include <string>

#include "drawings/text/text.h"
#include "exercises/kit/panels/results.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

bool is_at(drawings::Point a, drawings::Point b) { return a.x == b.x && a.y == b.y; }

bool is_drawn_between(const drawings::Line& line, drawings::Point from, drawings::Point to) {
  if (line.path.closed || line.path.pieces.size() != 1 || !line.path.pieces.front().straight) return false;
  const drawings::Point start = line.path.start, end = line.path.pieces.front().end;
  return (is_at(start, from) && is_at(end, to)) || (is_at(start, to) && is_at(end, from));
}

// "P0" of the measurement of P0_x; none of a length.
std::optional<std::string> point_of(const Measurement& measured) {
  if (measured.kind == Measurement::length) return {};
  return measured.quantity.substr(0, measured.quantity.rfind('_'));
}

// The plot put mark and measurement at the same numbers.
struct NamedBy {
  const Measurement& measured;

  void operator()(drawings::Line& line) const {
    if (line.name.empty() && measured.kind == Measurement::length &&
        is_drawn_between(line, measured.from, measured.to))
      line.name = measured.quantity;
  }
  void operator()(drawings::Dot& dot) const { point(dot); }
  void operator()(drawings::Cross& cross) const { point(cross); }
  template <class Other>
  void operator()(Other&) const {}

 private:
  template <class Mark>
  void point(Mark& mark) const {
    if (const auto name = point_of(measured); name && mark.name.empty() && is_at(mark.at, measured.to))
      mark.name = *name;
  }
};

void name_what_is_measured(DrawnSheet& drawn) {
  for (const Measurement& measured : drawn.measurements)
    for (drawings::Mark& mark : drawn.sheet.figure.marks) std::visit(NamedBy{measured}, mark);
}

class Tell {
 public:
  Tell(const Solution& solution, Language language) : solution_(solution), language_(language) {}

  // "v_B = 5.236 m/s, speed of B", or "P0 = (0.1; 0.2) m"; empty of what is no quantity, or has no value.
  std::string operator()(const std::string& name) const {
    if (solution_.is_reported(name)) {
      const auto number = value(name);
      const Quantity& quantity = solution_.described(name);
      return number ? drawings::plain(quantity.symbol) + " = " + *number + unit(name) + ", " +
                          drawings::plain(quantity.meaning.in(language_))
                    : "";
    }
    const std::string x = name + "_x", y = name + "_y";
    if (!solution_.is_reported(x) || !solution_.is_reported(y)) return {};
    const auto along_x = value(x), along_y = value(y);
    return along_x && along_y ? name + " = (" + *along_x + "; " + *along_y + ")" + unit(x) : "";
  }

 private:
  std::optional<std::string> value(const std::string& name) const {
    const auto number = solution_.value(name);
    return number ? std::optional(figures(*number, 4, language_)) : std::nullopt;
  }
  std::string unit(const std::string& name) const {
    return unit_after_number(solution_.described(name).unit, language_);
  }

  const Solution& solution_;
  Language language_;
};

const std::string* name_of(const drawings::Primitive& primitive) {
  if (const auto* stroke = std::get_if<drawings::Stroke>(&primitive)) return &stroke->name;
  if (const auto* fill = std::get_if<drawings::Fill>(&primitive)) return &fill->name;
  return nullptr;
}

}  // namespace

std::vector<drawings::Page> staged_pages(DrawnSheet drawn, const drawings::Figure& given, const Solution& solution,
                                         Language language) {
  name_what_is_measured(drawn);
  std::vector<drawings::Page> pages{drawings::compose_in_steps(drawn.sheet, given)};
  for (const drawings::Sheet& further : drawn.further) pages.push_back(drawings::compose(further));
  const Tell tell(solution, language);
  for (drawings::Page& page : pages)
    for (const drawings::Primitive& primitive : page.primitives)
      if (const std::string* name = name_of(primitive); name && !name->empty() && !page.told.contains(*name))
        if (std::string words = tell(*name); !words.empty()) page.told.emplace(*name, std::move(words));
  return pages;
}

std::vector<drawings::Page> page_of_each_step(const drawings::Page& page) {
  std::vector<drawings::Page> pages;
  for (int step = 1; step < static_cast<int>(page.steps.size()); ++step) pages.push_back(after_step(page, step));
  pages.push_back(page);
  return pages;
}

drawings::Page silent(drawings::Page page) {
  page.told.clear();
  return page;
}

}  // namespace epure
