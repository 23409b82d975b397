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

// With what its letters need and lack.
struct FigureWithin::Figure {
  DrawnSheet drawn;
  Size size = {};
  std::size_t overlaps = 0;
};

// Null where it does not fit.
std::shared_ptr<const FigureWithin::Figure> FigureWithin::in(const FigureSize& room) {
  const std::pair key(room.width, room.height);
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  std::shared_ptr<const Figure> fitting;
  try {
    Figure figure{.drawn = draw_(room)};
    std::vector<std::string> overlaps;
    std::vector<drawings::Page> pages{drawings::compose(figure.drawn.sheet, &overlaps)};
    for (const drawings::Sheet& further : figure.drawn.further) pages.push_back(drawings::compose(further));
    for (const drawings::Page& page : pages)
      figure.size = {std::max(figure.size.width, page.extent.width()),
                     std::max(figure.size.height, page.extent.height())};
    figure.overlaps = overlaps.size();
    fitting = std::make_shared<const Figure>(std::move(figure));
  } catch (const DoesNotFit&) {  // none
  }
  return known_[key] = fitting;
}

// A figure takes less than its room where letters did not need the air it has for them, or more where they found none
// inside. So the room begins larger than asked, and shrinks until the figure is no larger: by half of what it is too
// large, so that it does not pass over a scale that would do, and in whole mm, so that another size comes through the
// same rooms. Null: it is larger at every standard scale.
std::shared_ptr<const FigureWithin::Figure> FigureWithin::largest_within(const FigureSize& most) {
  constexpr double air_for_letters = 20, least_step = 1;  // mm
  FigureSize room = most;
  if (room.width) room.width = std::floor(*room.width) + air_for_letters;
  if (room.height) room.height = std::floor(*room.height) + air_for_letters;
  const auto shrink = [&](std::optional<double>& side, double excess) {
    if (excess > 0) *side -= std::max(std::floor(excess / 2), least_step);
  };
  while (room.width.value_or(1) > 0 && room.height.value_or(1) > 0) {
    auto figure = in(room);
    if (!figure) break;
    const double too_wide = most.width ? figure->size.width - *most.width : 0,
                 too_high = most.height ? figure->size.height - *most.height : 0;
    if (too_wide <= 0 && too_high <= 0) return figure;
    shrink(room.width, too_wide);
    shrink(room.height, too_high);
  }
  return {};
}

// What was drawn on the way to the size that was asked for is hardly ever far from the least that suits.
std::optional<int> FigureWithin::guess(const Suits& suits) const {
  std::optional<int> least;
  for (const auto& [room, figure] : known_) {
    if (!figure || !suits(*figure) || (most_.width && figure->size.height > most_.height.value_or(INFINITY)))
      continue;
    const int mm = static_cast<int>(std::ceil(most_.width ? figure->size.width : figure->size.height));
    least = std::min(mm, least.value_or(mm));
  }
  return least;
}

// Of the width, or of the height where that alone was asked for, the least in whole mm that would suit, which what
// was asked for does not; none: no figure of this paper does.
std::optional<int> FigureWithin::least_that_suits(const Suits& suits) {
  const auto side = most_.width ? &FigureSize::width : &FigureSize::height;
  int too_small = static_cast<int>(std::floor(*(most_.*side)));
  const auto suits_at = [&](int mm) {
    FigureSize size = most_;
    size.*side = mm;
    const auto figure = mm > too_small ? largest_within(size) : nullptr;
    return figure && suits(*figure);
  };
  int large_enough = guess(suits).value_or(too_small);
  if (!suits_at(large_enough)) {
    FigureSize other_side = most_;
    (other_side.*side).reset();
    const auto whole = largest_within(other_side);
    if (!whole) return {};
    large_enough = static_cast<int>(std::ceil(most_.width ? whole->size.width : whole->size.height));
    if (!suits_at(large_enough)) return {};
  }
  for (int next = large_enough - 1; large_enough - too_small > 1; next = (too_small + large_enough) / 2)
    (suits_at(next) ? large_enough : too_small) = next;
  return large_enough;
}

FigureWithin::FigureWithin(const FigureSize& most, DrawnIn draw) : most_(most), draw_(std::move(draw)) {}

const DrawnSheet& FigureWithin::largest() {
  if (const auto figure = largest_within(most_)) return figure->drawn;
  const auto least = least_that_suits([](const Figure&) { return true; });
  const Words larger = !most_.height  ? Words{"wider", "più larga"}
                       : !most_.width ? Words{"higher", "più alta"}
                                      : Words{"larger", "più grande"};
  Words why = format_words("the figure is {} than {} at every standard scale, as letters and symbols do not shrink",
                           "la figura è {} di {} in ogni scala normalizzata, perché lettere e simboli non "
                           "rimpiccioliscono",
                           larger, in_mm(most_));
  if (least)
    why = format_words("{}; {} {}mm would do", "{}; andrebbe bene {} {}mm", why, most_.width ? "--width" : "--height",
                       *least);
  throw DoesNotFit(why);
}

std::optional<Words> FigureWithin::hard_to_read() {
  const DrawnSheet& figure = largest();
  DrawnSheet whole;
  try {
    whole = draw_({});
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
                         "a {} la figura si legge male, perché le lettere non trovano posto libero", in_mm(most_))
          : format_words("at {} the figure is hard to read, as it is {} times smaller than on its sheet",
                         "a {} la figura si legge male, perché è {} volte più piccola che sulla sua tavola",
                         in_mm(most_), std::lround(times_smaller(figure, whole)));
  const auto least =
      least_that_suits([&](const Figure& other) { return other.overlaps <= crowded && is_large(other.drawn); });
  if (!least) return why;
  return format_words("{}; from {} {}mm on it reads well", "{}; da {} {}mm in su si legge bene", why,
                      most_.width ? "--width" : "--height", *least);
}

}  // namespace epure
