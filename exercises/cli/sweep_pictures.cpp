#include "exercises/cli/sweep_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "drawings/output.h"
#include "drawings/paths/vectors.h"
#include "drawings/text/text.h"
#include "exercises/cli/abreast.h"
#include "exercises/cli/sweep_words.h"
#include "exercises/kit/panels/moving_mechanism.h"
#include "exercises/kit/panels/results.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace {

// What cannot be drawn at some givens is not drawn there: the row tells why it is not found, or its values are told
// without a picture.
template <class Make>
auto made_or_none(const Make& make) -> std::optional<decltype(make())> {
  try {
    return make();
  } catch (const geometry::Undecided&) {
  } catch (const geometry::Impossible&) {
  } catch (const BadGivens&) {
  } catch (const drawings::TooFar&) {
  }
  return {};
}

class PicturesOfSweep {
 public:
  PicturesOfSweep(const SweepStudy& study, Language language) : study_(study), language_(language) {
    const std::vector<std::string> names = study.quantity_names();
    quantities_ = {names.begin(), names.end()};
    solutions_.resize(study.size());
    abreast(solutions_.size(), [&](std::size_t row) {
      solutions_[row] = made_or_none([&] { return study_.exercise->solution(study_.givens_at(row)); });
    });
  }

  std::optional<SweepPictures> pictures() {
    const std::string sheet = sheet_that_shows_most();
    if (sheet.empty()) return {};
    mechanisms_.resize(solutions_.size());
    abreast(solutions_.size(), [&](std::size_t row) { mechanisms_[row] = mechanism(sheet, row); });
    const auto view = common_view();
    if (!view) return {};
    SweepPictures made;
    made.positions.resize(solutions_.size());
    abreast(solutions_.size(), [&](std::size_t row) {
      if (mechanisms_[row])
        made.positions[row] = made_or_none([&] { return page(row, mechanisms_[row]->drawn(*view, quantities_)); });
    });
    if (std::none_of(made.positions.begin(), made.positions.end(), [](const auto& each) { return !!each; }))
      return {};
    made.scales = scales(*view);
    lay_over_each_other(made);
    return made;
  }

 private:
  std::optional<MovingMechanism> mechanism(const std::string& sheet, std::size_t row) const {
    if (!solutions_[row]) return {};
    return made_or_none([&] { return MovingMechanism::of(*study_.exercise, sheet, *solutions_[row], language_); })
        .value_or(std::nullopt);
  }

  std::string sheet_that_shows_most() const {
    const auto solved = std::find_if(solutions_.begin(), solutions_.end(), [](const auto& each) { return !!each; });
    if (solved == solutions_.end()) return {};
    std::string best;
    std::size_t most = 0;
    for (const SheetSpec& sheet : study_.exercise->about().sheets) {
      const auto there = mechanism(sheet.name, static_cast<std::size_t>(solved - solutions_.begin()));
      if (!there) continue;
      const auto shown = made_or_none([&] { return there->shown(quantities_); });
      if (!shown || (!best.empty() && shown->count <= most)) continue;
      best = sheet.name;
      most = shown->count;
    }
    return best;
  }

  // The largest standard scale at which all positions find room.
  std::optional<MovingMechanism::View> common_view() const {
    MovingMechanism::Shown shown;
    double reach = 0;
    for (const auto& each : mechanisms_) {
      if (!each) continue;
      const auto here = made_or_none([&] { return each->shown(quantities_); });
      if (!here) continue;
      shown.unit = here->unit;
      shown.longest = std::max(shown.longest, here->longest);
      reach = std::max(reach, each->reach());
    }
    if (reach == 0) return {};
    MovingMechanism::View view;
    constexpr double longest_vector = 40;  // mm
    if (shown.longest > 0)
      view.vectors =
          largest_vector_scale(longest_vector / shown.longest, written_unit(shown.unit, language_), language_);
    const drawings::Box area = drawings::drawing_area(drawings::Paper::a4);
    const drawings::Point middle{(area.low.x + area.high.x) / 2, (area.low.y + area.high.y) / 2};
    constexpr double half_width = 85, half_height = 45;  // mm
    const drawings::Box room{{middle.x - half_width, middle.y - half_height},
                             {middle.x + half_width, middle.y + half_height}};
    constexpr double mm_per_metre = 1000;
    try {
      const Fit fit = fit_lengths(room, {.language = language_, .bare = true}, mm_per_metre / reach,
                                  [&](const Scale& lengths) { return extent(lengths, view.vectors); });
      view.lengths = fit.scale;
      view.origin = fit.origin;
      view.room = room;
      return view;
    } catch (const DoesNotFit&) {
      return {};
    }
  }

  drawings::Box extent(const Scale& lengths, const Scale& vectors) const {
    Extent all;
    for (const auto& each : mechanisms_) {
      if (!each) continue;
      const auto box = made_or_none([&] { return each->extent(lengths, vectors, quantities_); });
      if (!box) continue;
      all.include(box->low.x, box->low.y);
      all.include(box->high.x, box->high.y);
    }
    return all.box();
  }

  drawings::Page bare_page(std::string id, std::string title, drawings::Figure figure) const {
    drawings::Sheet sheet;
    sheet.id = std::move(id);
    sheet.title = std::move(title);
    sheet.language = language_;
    sheet.bare = true;
    sheet.figure = std::move(figure);
    return drawings::compose(sheet);
  }
  drawings::Page page(std::size_t row, drawings::Figure figure) const {
    return bare_page(fmt::format("{}-position-{}", study_.exercise->about().id, row + 1),
                     drawings::plain(position_in_words(study_, study_.places(row), language_)), std::move(figure));
  }
  drawings::Page scales(const MovingMechanism::View& view) const {
    drawings::Figure bars;
    bars.marks.push_back(bar(view.lengths, {}, language_));
    if (!view.vectors.caption.empty()) bars.marks.push_back(bar(view.vectors, {}, language_));
    return bare_page(study_.exercise->about().id + "-scales", Words{"Scales", "Scale"}.in(language_),
                     std::move(bars));
  }

  // One extent for all; the bars at its foot.
  static void lay_over_each_other(SweepPictures& made) {
    drawings::Box all = drawings::nothing();
    for (const auto& each : made.positions)
      if (each) all = include(all, each->extent);
    const drawings::Box bars = made.scales.extent;
    all.low.y -= bars.height();
    all.high.x = std::max(all.high.x, all.low.x + bars.width());
    for (auto& each : made.positions)
      if (each) each->extent = all;
    made.scales.extent = {bars.low, {bars.low.x + all.width(), bars.low.y + all.height()}};
  }

  const SweepStudy& study_;
  Language language_;
  std::set<std::string> quantities_;
  std::vector<std::optional<Solution>> solutions_;               // by row
  std::vector<std::optional<MovingMechanism>> mechanisms_ = {};  // by row
};

}  // namespace

std::optional<SweepPictures> sweep_pictures(const SweepStudy& study, Language language) {
  return PicturesOfSweep(study, language).pictures();
}

}  // namespace epure
