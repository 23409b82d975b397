#include "exercises/kit/panels/layout_search.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "drawings/text/text.h"

namespace epure {
namespace {

constexpr double between_panels = 3;  // mm

struct Size {
  double width = 0, height = 0;
};

// A part of the room: one panel, or two parts side by side or one above the other.
struct Division {
  std::size_t panel = 0;
  bool side_by_side = false;
  std::shared_ptr<const Division> first = {}, second = {};  // none: one panel
};
using Divisions = std::vector<std::shared_ptr<const Division>>;

// All divisions of the panels from `begin` to `end`. Three in a row are divided once: the first from the other two.
Divisions divisions(std::size_t begin, std::size_t end) {
  if (end - begin == 1) return {std::make_shared<Division>(Division{.panel = begin})};
  Divisions all;
  for (std::size_t middle = begin + 1; middle < end; ++middle)
    for (const auto& first : divisions(begin, middle))
      for (const auto& second : divisions(middle, end))
        for (const bool side_by_side : {true, false})
          if (!first->first || first->side_by_side != side_by_side)
            all.push_back(std::make_shared<Division>(Division{0, side_by_side, first, second}));
  return all;
}

Size size_of(const Division& part, const std::vector<Size>& panels) {
  if (!part.first) return panels[part.panel];
  const Size a = size_of(*part.first, panels), b = size_of(*part.second, panels);
  if (part.side_by_side) return {a.width + between_panels + b.width, std::max(a.height, b.height)};
  return {std::max(a.width, b.width), a.height + between_panels + b.height};
}

// How much of what is left over the first of two parts gets: what is left out of each comes first, in proportion
// where that is too much; the rest goes in equal shares to both. (Rounding leaves less than nothing where all just
// fits.)
double first_share(double left_over, double first_lacks, double second_lacks) {
  const double lack = first_lacks + second_lacks;
  return lack > left_over && lack > 0 ? left_over * first_lacks / lack : first_lacks + (left_over - lack) / 2;
}

// `whole`: the panels with what may be cut.
void place(const Division& part, const std::vector<Size>& panels, const std::vector<Size>& whole,
           const drawings::Box& room, std::vector<drawings::Box>& rooms) {
  if (!part.first) {
    rooms[part.panel] = room;
    return;
  }
  const Size a = size_of(*part.first, panels), b = size_of(*part.second, panels);
  const Size whole_a = size_of(*part.first, whole), whole_b = size_of(*part.second, whole);
  drawings::Box one = room, other = room;
  if (part.side_by_side) {
    const double left_over = room.width() - a.width - between_panels - b.width;
    one.high.x = room.low.x + a.width + first_share(left_over, whole_a.width - a.width, whole_b.width - b.width);
    other.low.x = one.high.x + between_panels;
  } else {
    const double left_over = room.height() - a.height - between_panels - b.height;
    one.low.y = room.high.y - a.height - first_share(left_over, whole_a.height - a.height, whole_b.height - b.height);
    other.high.y = one.low.y - between_panels;
  }
  place(*part.first, panels, whole, one, rooms);
  place(*part.second, panels, whole, other, rooms);
}

// The standard scales from the largest down that panels of one plane of lengths, or vectors of one group, can have.
// What is weighed anew thousands of times is a rung's number, and each rung's scale is worked out once.
class Ladder {
 public:
  using Below = std::function<Scale(double mm_per_unit)>;  // the largest that is not larger
  // Without `below`: the scale is as it is.
  explicit Ladder(Scale highest, Below below = {}) : below_(std::move(below)) { add(std::move(highest)); }

  bool is_fixed() const { return !below_; }
  const Scale& scale(std::size_t rung) { return at(rung).scale; }
  double logarithm(std::size_t rung) { return at(rung).logarithm; }
  // The highest, some below it, and one below any that is tried.
  std::vector<Scale> samples() {
    std::vector<Scale> all{scale(0)};
    if (!is_fixed())
      for (const double share : {1e-4, 1e-10, 1e-66})  // three rungs are a power of ten
        all.push_back(below_(share * scale(0).mm_per_unit));
    return all;
  }

 private:
  struct Rung {
    Scale scale;
    double logarithm;
  };
  void add(Scale scale) {
    const double logarithm = std::log(scale.mm_per_unit);
    rungs_.push_back({std::move(scale), logarithm});
  }
  const Rung& at(std::size_t rung) {
    constexpr double smaller = 0.99;
    while (rungs_.size() <= rung) add(below_(smaller * rungs_.back().scale.mm_per_unit));
    return rungs_[rung];
  }

  Below below_;
  std::deque<Rung> rungs_ = {};  // which stay where they are
};

// The rung chosen of each ladder, counted from the highest.
using Choices = std::vector<std::size_t>;

// Those whose vectors have one scale; empty for a panel without vectors. Bodies with their forces, which tell where
// these act, have one of their own: polygons are read, and need not be as small as those must be. What follows a
// comma in a group's name tells scales of lengths apart only.
std::string group_of_vectors(const Panel& panel) {
  const std::string unit = panel.vectors().unit, group = panel.scale_group(),
                    bodies = group.substr(0, group.find(','));
  return unit.empty() || bodies.empty() ? unit : unit + " on " + bodies;
}

class Search {
 public:
  enum class Of { all, near };
  Search(const std::vector<const Panel*>& panels, Of of, const drawings::Box& room, const SheetRequest& request)
      : panels_(panels),
        of_(of),
        room_(room),
        proportion_(request.room_width && !request.room_height ? proportion_of(request.paper) : std::nullopt),
        known_(panels.size()) {
    add_lengths(request.scale);
    add_vectors(request.language);
    panels_of_.resize(ladders_.size());
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      panels_of_[lengths_[i]].push_back(i);
      if (vectors_[i] != none) panels_of_[vectors_[i]].push_back(i);
    }
  }

  struct Found {
    double merit = 0;
    Choices choices;
    std::shared_ptr<const Division> division;
  };
  std::optional<Found> best() {
    std::optional<Found> best;
    for (const auto& division : divisions(0, panels_.size()))
      if (const auto fitting = may_fit(*division) ? largest_that_fit(*division) : std::nullopt)
        if (const double found = merit(*fitting); !best || found > best->merit + 1e-9)
          best = Found{found, fitting->choices, division};
    return best;
  }

  std::vector<PlacedPanel> placed(const Found& found) {
    std::vector<drawings::Box> rooms(panels_.size());
    place(*found.division, weighed(found.choices).sizes, whole_sizes(found.choices), room_, rooms);
    for (std::size_t i = 0; i < panels_.size(); ++i)
      if (panels_[i]->is_cut() || !panels_[i]->has_scale()) keep_proportion(rooms[i], extent(found.choices, i));
    std::vector<PlacedPanel> all;
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      const Scale& lengths = lengths_of(found.choices, i);
      all.push_back({panels_[i], rooms[i], lengths, vectors_of(found.choices, i),
                     panels_[i]->origin(rooms[i], extent(found.choices, i), lengths)});
    }
    return all;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // Height over width of the room that a whole sheet has.
  static std::optional<double> proportion_of(drawings::Paper paper) {
    const drawings::Box area = drawings::drawing_area(paper);
    return area.height() / area.width();
  }
  // What is cut out of more than there is room for fills its room, and so does a chart. Where only the width was
  // asked for, it is no higher than on a whole sheet for its width, or what is needed of it.
  void keep_proportion(drawings::Box& room, const drawings::Box& needed) const {
    if (!proportion_) return;
    const double excess = room.height() - std::max(needed.height(), *proportion_ * room.width());
    if (excess <= 0) return;
    room.low.y += excess / 2;
    room.high.y -= excess / 2;
  }

  const Scale& lengths_of(const Choices& choices, std::size_t panel) {
    const std::size_t ladder = lengths_[panel];
    return ladders_[ladder].scale(choices[ladder]);
  }
  const Scale& vectors_of(const Choices& choices, std::size_t panel) {
    static const Scale no_vectors;
    const std::size_t ladder = vectors_[panel];
    return ladder == none ? no_vectors : ladders_[ladder].scale(choices[ladder]);
  }

  // Asked of the panel once for each two scales.
  const drawings::Box& extent(const Choices& choices, std::size_t panel) {
    const std::size_t lengths = choices[lengths_[panel]],
                      vectors = vectors_[panel] == none ? 0 : choices[vectors_[panel]];
    std::vector<std::vector<std::optional<drawings::Box>>>& known = known_[panel];
    if (known.size() <= lengths) known.resize(lengths + 1);
    if (known[lengths].size() <= vectors) known[lengths].resize(vectors + 1);
    std::optional<drawings::Box>& box = known[lengths][vectors];
    if (!box) box = extent_at(panel, lengths_of(choices, panel), vectors_of(choices, panel));
    return *box;
  }
  drawings::Box extent_at(std::size_t panel, const Scale& lengths, const Scale& vectors) const {
    return of_ == Of::all ? panels_[panel]->extent(lengths, vectors)
                          : panels_[panel]->extent_of_near(lengths, vectors);
  }

  // Choices, and what follows from them for each panel and each ladder. Where one ladder's rung changes, only what
  // follows from that is worked out again.
  struct Weighed {
    Choices choices;
    std::vector<Size> sizes;         // by panel
    std::vector<double> logarithms;  // by ladder
  };
  Weighed weighed(const Choices& choices) {
    Weighed all{choices, std::vector<Size>(panels_.size()), std::vector<double>(ladders_.size())};
    for (std::size_t ladder = 0; ladder < ladders_.size(); ++ladder) set(all, ladder, choices[ladder]);
    return all;
  }
  void set(Weighed& weighed, std::size_t ladder, std::size_t rung) {
    weighed.choices[ladder] = rung;
    weighed.logarithms[ladder] = ladders_[ladder].logarithm(rung);
    for (const std::size_t panel : panels_of_[ladder]) {
      const drawings::Box& box = extent(weighed.choices, panel);
      weighed.sizes[panel] = {box.width(), box.height()};
    }
  }

  // With what is left out of those that are cut, and no less than what is needed of them.
  std::vector<Size> whole_sizes(const Choices& choices) {
    std::vector<Size> all = weighed(choices).sizes;
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      if (!panels_[i]->is_cut()) continue;
      const drawings::Box box = panels_[i]->extent(lengths_of(choices, i), vectors_of(choices, i));
      all[i] = {std::max(all[i].width, box.width()), std::max(all[i].height, box.height())};
    }
    return all;
  }

  // The first panel of its group, whose scale of lengths it has.
  std::size_t leader(std::size_t panel) const {
    const std::string group = panels_[panel]->scale_group();
    for (std::size_t i = 0; i < panel && !group.empty(); ++i)
      if (panels_[i]->scale_group() == group) return i;
    return panel;
  }

  std::size_t add(Ladder ladder) {
    ladders_.push_back(std::move(ladder));
    return ladders_.size() - 1;
  }

  // One ladder for those of one group. What was asked for is the scale of the first that shows lengths.
  void add_lengths(const std::optional<Rational>& asked) {
    bool is_asked = asked.has_value();
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      const Panel& panel = *panels_[i];
      const bool shows_lengths = !panel.is_of_vectors() && panel.has_scale();
      const bool is_as_asked = std::exchange(is_asked, is_asked && !shows_lengths) && shows_lengths;
      if (const std::size_t first = leader(i); first != i)
        lengths_.push_back(lengths_[first]);
      else if (!shows_lengths)
        lengths_.push_back(add(Ladder(Scale{})));
      else if (is_as_asked)
        lengths_.push_back(add(Ladder(length_scale(*asked))));
      else
        lengths_.push_back(add(Ladder(largest_length_scale(1000 / panel.reach()), largest_length_scale)));
    }
  }

  // One ladder for those of one group, in the order of the groups' names, from the least of what each panel allows.
  void add_vectors(Language language) {
    vectors_.assign(panels_.size(), none);
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < panels_.size(); ++i)
      if (!panels_[i]->vectors().unit.empty()) groups[group_of_vectors(*panels_[i])].push_back(i);
    for (const auto& [group, members] : groups) {
      std::optional<Scale> highest;
      for (const std::size_t i : members) {
        const Panel::Vectors shown = panels_[i]->vectors();
        const double most = shown.longest_on_paper / (shown.longest > 0 ? shown.longest : 1);
        const Scale scale = largest_vector_scale(most, shown.unit, language);
        if (!highest || scale.mm_per_unit < highest->mm_per_unit) highest = scale;
      }
      const std::size_t ladder = add(Ladder(*highest, [unit = highest->unit, language](double mm_per_unit) {
        return largest_vector_scale(mm_per_unit, unit, language);
      }));
      for (const std::size_t i : members) vectors_[i] = ladder;
      planes_.push_back({ladder, planes(members)});
    }
  }

  double excess(const Division& division, const Weighed& weighed) const { return excess(division, weighed.sizes); }
  double excess(const Division& division, const std::vector<Size>& sizes) const {
    const Size needed = size_of(division, sizes);
    return std::max(0.0, needed.width - room_.width()) + std::max(0.0, needed.height - room_.height());
  }

  // Whether letters and symbols, which do not shrink, leave room for the rest at some scale. Each panel counts as no
  // larger than it is at any of some scales all the way down, as what is drawn may hang on the ratio of its two.
  bool may_fit(const Division& division) {
    if (smallest_.empty())
      for (std::size_t i = 0; i < panels_.size(); ++i) smallest_.push_back(smallest(i));
    return excess(division, smallest_) == 0;
  }
  Size smallest(std::size_t panel) {
    const std::vector<Scale> no_vectors(1),
        of_lengths = ladders_[lengths_[panel]].samples(),
        of_vectors = vectors_[panel] == none ? no_vectors : ladders_[vectors_[panel]].samples();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Size least{infinity, infinity};
    for (const Scale& lengths : of_lengths)
      for (const Scale& vectors : of_vectors) {
        const drawings::Box box = extent_at(panel, lengths, vectors);
        least = {std::min(least.width, box.width()), std::min(least.height, box.height())};
      }
    return least;
  }

  // From the largest scales down, each time the one whose next smaller step gains most for what it loses.
  std::optional<Weighed> largest_that_fit(const Division& division) {
    constexpr int most_steps = 200;  // letters and symbols do not shrink: then nothing fits
    Weighed now = weighed(Choices(ladders_.size(), 0));
    std::vector<Choices> tried;
    while (tried.size() + 1 < most_steps) {
      tried.push_back(now.choices);
      const double excess_now = excess(division, now), merit_now = merit(now);
      if (excess_now == 0) return exchanged(division, tried, std::move(now));
      std::optional<std::size_t> best;
      double best_gain = 0;
      for (std::size_t ladder = 0; ladder < ladders_.size(); ++ladder) {
        if (ladders_[ladder].is_fixed()) continue;
        const std::size_t rung = now.choices[ladder];
        set(now, ladder, rung + 1);
        const double gain = (excess_now - excess(division, now)) / (merit_now - merit(now));
        set(now, ladder, rung);
        if (best && gain <= best_gain) continue;
        best = ladder;
        best_gain = gain;
      }
      if (!best) return {};
      set(now, *best, now.choices[*best] + 1);
    }
    return {};
  }

  // One scale a step smaller for the others as large as there is then room for them, as long as that is better.
  Weighed exchanged(const Division& division, const std::vector<Choices>& tried, Weighed fitting) {
    constexpr double better = 1e-6;  // merit
    Weighed best = enlarged(division, tried, std::move(fitting));
    for (bool improved = true; improved;) {
      improved = false;
      for (std::size_t ladder = 0; ladder < ladders_.size() && !improved; ++ladder) {
        if (ladders_[ladder].is_fixed()) continue;
        Weighed other = best;
        set(other, ladder, best.choices[ladder] + 1);
        other = enlarged(division, tried, std::move(other), &best.choices);
        improved = merit(other) > merit(best) + better;
        if (improved) best = std::move(other);
      }
    }
    return best;
  }

  // Each of the scales as large again as it was when tried, where there is room after all. What is smaller than in
  // `before` stays so.
  Weighed enlarged(const Division& division, const std::vector<Choices>& tried, Weighed now,
                   const Choices* before = nullptr) {
    for (std::size_t ladder = 0; ladder < ladders_.size(); ++ladder) {
      const std::size_t start = now.choices[ladder];
      if (before && start > (*before)[ladder]) continue;
      std::optional<std::size_t> last;
      for (const Choices& known : tried) {
        if (last == known[ladder]) continue;
        last = known[ladder];
        set(now, ladder, *last);
        if (excess(division, now) == 0) break;
        set(now, ladder, start);
      }
    }
    return now;
  }

  // Twice the scale of one panel outweighs half that of another, but a small panel is worth enlarging more than a
  // large one.
  double merit(const Weighed& weighed) const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Size& size : weighed.sizes) smallest = std::min(smallest, std::max(size.width, size.height));
    return size_of_all(weighed) + std::log(smallest) / 2;
  }

  double size_of_all(const Weighed& weighed) const {
    double size = 0;
    for (const std::size_t ladder : lengths_) size += weighed.logarithms[ladder];
    for (const auto& [ladder, planes] : planes_) size += planes * weighed.logarithms[ladder];
    return size;
  }

  // How many panels are planes of these vectors; one, where a panel of lengths shows them. A plane counts a little
  // more than a picture of lengths: it is read with a ruler. Of one that is built a stage a panel the last counts,
  // and of the others little.
  double planes(const std::vector<std::size_t>& members) const {
    constexpr double of_plane = 1.1, of_stage = 0.1;
    double count = 0;
    for (const std::size_t i : members)
      if (panels_[i]->is_of_vectors()) count += panels_[i]->is_stage() ? of_stage : of_plane;
    return std::max(count, 1.0);
  }

  const std::vector<const Panel*>& panels_;
  Of of_;
  drawings::Box room_;
  std::optional<double> proportion_;  // none: what fills its room may be as high as it
  std::vector<Ladder> ladders_ = {};
  std::vector<std::size_t> lengths_ = {}, vectors_ = {};     // by panel, its ladders; of vectors perhaps none
  std::vector<std::pair<std::size_t, double>> planes_ = {};  // of each ladder of vectors, how many planes it counts
  std::vector<Size> smallest_ = {};                          // by panel; empty until asked for
  std::vector<std::vector<std::size_t>> panels_of_ = {};     // by ladder
  std::vector<std::vector<std::vector<std::optional<drawings::Box>>>> known_;  // extents, by panel and its two rungs
};

// Whether no panel becomes smaller than it may in order to show what is far.
bool is_large_enough(const std::vector<const Panel*>& panels, const std::vector<PlacedPanel>& all,
                     const std::vector<PlacedPanel>& near) {
  for (std::size_t i = 0; i < panels.size(); ++i)
    if (all[i].lengths.mm_per_unit * panels[i]->times_smaller() < near[i].lengths.mm_per_unit) return false;
  return true;
}

// A scale that was asked for does not fit: by how much, and what would.
[[noreturn]] void refuse(const std::vector<const Panel*>& panels, const drawings::Box& room,
                         const SheetRequest& request) {
  SheetRequest any_scale = request;
  any_scale.scale.reset();
  const std::vector<PlacedPanel> would_fit = laid_out(panels, room, any_scale);
  const auto first = std::find_if(would_fit.begin(), would_fit.end(), [](const PlacedPanel& each) {
    return !each.panel->is_of_vectors() && each.panel->has_scale();
  });
  const Scale asked = length_scale(*request.scale);
  const drawings::Box extent = first->panel->extent_of_near(asked, first->vectors);
  throw DoesNotFit(
      format_words("at scale {} the figure takes {:.0f} x {:.0f} mm, but this sheet has {:.0f} x {:.0f} mm for it "
                   "and what stands beside it; {} would fit",
                   "in scala {} la figura occupa {:.0f} x {:.0f} mm, ma questa tavola ne ha {:.0f} x {:.0f} per essa "
                   "e per ciò che le sta accanto; andrebbe bene {}",
                   drawings::plain(asked.caption), extent.width(), extent.height(), room.width(), room.height(),
                   drawings::plain(first->lengths.caption)));
}

}  // namespace

std::vector<PlacedPanel> laid_out(const Panels& panels, const drawings::Box& room, const SheetRequest& request) {
  std::vector<const Panel*> all;
  for (const auto& panel : panels) all.push_back(panel.get());
  return laid_out(all, room, request);
}

std::vector<PlacedPanel> laid_out(const std::vector<const Panel*>& panels, const drawings::Box& room,
                                  const SheetRequest& request) {
  if (panels.empty()) return {};
  Search of_all(panels, Search::Of::all, room, request);
  const auto all = of_all.best();
  if (all && std::all_of(panels.begin(), panels.end(), [](const auto& each) { return each->times_smaller() == 1; }))
    return of_all.placed(*all);

  Search of_near(panels, Search::Of::near, room, request);
  const auto near = of_near.best();
  if (!near) {
    if (request.scale) refuse(panels, room, request);
    throw DoesNotFit("the figure does not fit the paper at any standard scale",
                     "la figura non sta sulla carta in alcuna scala normalizzata");
  }
  const std::vector<PlacedPanel> placed_near = of_near.placed(*near);
  if (!all) return placed_near;
  const std::vector<PlacedPanel> placed_all = of_all.placed(*all);
  return is_large_enough(panels, placed_all, placed_near) ? placed_all : placed_near;
}

}  // namespace epure
