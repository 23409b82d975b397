#include "exercises/cli/figure_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawings/output.h"
#include "drawings/page.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/statement/format_words.h"

namespace epure {
namespace {

struct Size {
  double width = 0, height = 0;
};

// A figure with what its letters need and lack.
struct Figure {
  DrawnSheet drawn;
  Size size = {};
  std::size_t overlaps = 0;
};

Figure composed(DrawnSheet drawn) {
  std::vector<std::string> overlaps;
  std::vector<drawings::Page> pages{drawings::compose(drawn.sheet, &overlaps)};
  for (const drawings::Sheet& further : drawn.further) pages.push_back(drawings::compose(further));
  Size size;
  for (const drawings::Page& page : pages)
    size = {std::max(size.width, page.extent.width()), std::max(size.height, page.extent.height())};
  return {std::move(drawn), size, overlaps.size()};
}

// A figure takes less than its room where letters did not need the air it has for them, or more where they found none
// inside. So the room begins larger than asked, and shrinks until the figure is no larger: by half of what it is too
// large, so that it does not pass over a scale that would do. None: it is larger at every standard scale.
std::optional<Figure> largest_within(const FigureSize& most, const DrawnIn& draw) {
  constexpr double air_for_letters = 20, least_step = 1;  // mm
  FigureSize room = most;
  if (room.width) *room.width += air_for_letters;
  if (room.height) *room.height += air_for_letters;
  const auto shrink = [&](std::optional<double>& side, double excess) {
    if (excess > 0) *side -= std::max(excess / 2, least_step);
  };
  while (room.width.value_or(1) > 0 && room.height.value_or(1) > 0) {
    Figure figure;
    try {
      figure = composed(draw(room));
    } catch (const DoesNotFit&) {
      break;
    }
    const double too_wide = most.width ? figure.size.width - *most.width : 0,
                 too_high = most.height ? figure.size.height - *most.height : 0;
    if (too_wide <= 0 && too_high <= 0) return figure;
    shrink(room.width, too_wide);
    shrink(room.height, too_high);
  }
  return {};
}

// Of the width, or of the height where that alone was asked for, the least in whole mm that would suit, which what
// was asked for does not; none: no figure of this paper does.
std::optional<int> least_that_suits(const FigureSize& asked, const DrawnIn& draw,
                                    const std::function<bool(const Figure&)>& suits) {
  const auto side = asked.width ? &FigureSize::width : &FigureSize::height;
  const auto suits_at = [&](int mm) {
    FigureSize size = asked;
    size.*side = mm;
    const auto figure = largest_within(size, draw);
    return figure && suits(*figure);
  };
  FigureSize other_side = asked;
  (other_side.*side).reset();
  const auto whole = largest_within(other_side, draw);
  if (!whole) return {};
  const Size& size = whole->size;
  int too_small = static_cast<int>(std::floor(*(asked.*side))),
      large_enough = static_cast<int>(std::ceil(asked.width ? size.width : size.height));
  if (large_enough <= too_small || !suits_at(large_enough)) return {};
  while (large_enough - too_small > 1) {
    const int between = (too_small + large_enough) / 2;
    (suits_at(between) ? large_enough : too_small) = between;
  }
  return large_enough;
}

Words in_mm(const FigureSize& size) {
  const auto number = [](double mm) { return decimal(fmt::format("{:.4g}", mm)); };
  if (size.width && size.height)
    return format_words("{} x {} mm", "{} x {} mm", number(*size.width), number(*size.height));
  return format_words("{} mm", "{} mm", number(size.width ? *size.width : *size.height));
}

// How many times smaller what is measured on the one is drawn than on the other.
double times_smaller(const DrawnSheet& figure, const DrawnSheet& whole) {
  double times = 1;
  for (const Measurement& here : figure.measurements)
    for (const Measurement& there : whole.measurements)
      if (here.quantity == there.quantity && here.kind == there.kind) {
        times = std::max(times, here.per_mm / there.per_mm);
        break;
      }
  return times;
}

// The next smaller standard scale is at most 2.5 times smaller, the one after it 4 or 5 times: with that letters
// crowd.
constexpr double most_times_smaller = 3;

}  // namespace

DrawnSheet drawn_within(const FigureSize& most, const DrawnIn& draw) {
  if (auto figure = largest_within(most, draw)) return std::move(figure->drawn);
  const auto least = least_that_suits(most, draw, [](const Figure&) { return true; });
  const Words larger = !most.height  ? Words{"wider", "più larga"}
                       : !most.width ? Words{"higher", "più alta"}
                                     : Words{"larger", "più grande"};
  Words why = format_words("the figure is {} than {} at every standard scale, as letters and symbols do not shrink",
                           "la figura è {} di {} in ogni scala normalizzata, perché lettere e simboli non "
                           "rimpiccioliscono",
                           larger, in_mm(most));
  if (least)
    why = format_words("{}; {} {}mm would do", "{}; andrebbe bene {} {}mm", why, most.width ? "--width" : "--height",
                       *least);
  throw DoesNotFit(why);
}

std::optional<Words> hard_to_read(const DrawnSheet& figure, const FigureSize& most, const DrawnIn& draw) {
  DrawnSheet whole;
  try {
    whole = draw({});
  } catch (const DoesNotFit&) {
    return {};
  }
  const std::size_t crowded = overlaps(whole.sheet).size();
  const auto is_large = [&](const DrawnSheet& drawn) { return times_smaller(drawn, whole) < most_times_smaller; };
  const bool has_room_here = overlaps(figure.sheet).size() <= crowded, is_large_here = is_large(figure);
  if (has_room_here && is_large_here) return {};
  Words why =
      is_large_here
          ? format_words("at {} the figure is hard to read, as letters find no free place",
                         "a {} la figura si legge male, perché le lettere non trovano posto libero", in_mm(most))
          : format_words("at {} the figure is hard to read, as it is {} times smaller than on its sheet",
                         "a {} la figura si legge male, perché è {} volte più piccola che sulla sua tavola",
                         in_mm(most), std::lround(times_smaller(figure, whole)));
  const auto least = least_that_suits(
      most, draw, [&](const Figure& other) { return other.overlaps <= crowded && is_large(other.drawn); });
  if (!least) return why;
  return format_words("{}; from {} {}mm on it reads well", "{}; da {} {}mm in su si legge bene", why,
                      most.width ? "--width" : "--height", *least);
}

}  // namespace epure
