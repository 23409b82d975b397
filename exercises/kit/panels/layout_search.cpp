#include "exercises/kit/panels/layout_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

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
// where that is too much; the rest goes in equal shares to both.
double first_share(double left_over, double first_lacks, double second_lacks) {
  const double lack = first_lacks + second_lacks;
  return lack > left_over ? left_over * first_lacks / lack : first_lacks + (left_over - lack) / 2;
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

// The scales that can be chosen: the lengths of each panel that shows a plane of them, the vectors of each group.
struct Choice {
  Scale scale;
  bool is_fixed = false;
};
struct Choices {
  std::vector<Choice> lengths;            // by panel
  std::map<std::string, Choice> vectors;  // by group
};

// Those whose vectors have one scale; empty for a panel without vectors. Bodies with their forces, which tell where
// these act, have one of their own: polygons are read, and need not be as small as those must be.
std::string group_of_vectors(const Panel& panel) {
  const std::string unit = panel.vectors().unit, bodies = panel.scale_group();
  return unit.empty() || bodies.empty() ? unit : unit + " on " + bodies;
}

class Search {
 public:
  enum class Of { all, near };
  Search(const std::vector<const Panel*>& panels, Of of, const drawings::Box& room, const SheetRequest& request)
      : panels_(panels),
        of_(of),
        room_(room),
        language_(request.language),
        proportion_(request.room_width && !request.room_height ? proportion_of(request.paper) : std::nullopt) {
    for (const auto& panel : panels) {
      vectors_.push_back(panel->vectors());
      groups_.push_back(group_of_vectors(*panel));
    }
    largest_ = largest(request.scale);
  }

  struct Found {
    double merit = 0;
    Choices choices;
    std::shared_ptr<const Division> division;
  };
  std::optional<Found> best() {
    std::optional<Found> best;
    for (const auto& division : divisions(0, panels_.size()))
      if (const auto choices = largest_that_fit(*division))
        if (const double found = merit(*choices); !best || found > best->merit + 1e-9)
          best = Found{found, *choices, division};
    return best;
  }

  std::vector<PlacedPanel> placed(const Found& found) {
    std::vector<drawings::Box> rooms(panels_.size());
    place(*found.division, sizes(found.choices), whole_sizes(found.choices), room_, rooms);
    for (std::size_t i = 0; i < panels_.size(); ++i)
      if (panels_[i]->is_cut() || !panels_[i]->has_scale()) keep_proportion(rooms[i], extent(found.choices, i));
    std::vector<PlacedPanel> all;
    for (std::size_t i = 0; i < panels_.size(); ++i)
      all.push_back({panels_[i], rooms[i], found.choices.lengths[i].scale, vectors_of(found.choices, i),
                     panels_[i]->origin(rooms[i], extent(found.choices, i), found.choices.lengths[i].scale)});
    return all;
  }

 private:
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

  const Scale& vectors_of(const Choices& choices, std::size_t panel) const {
    static const Scale none;
    const auto found = choices.vectors.find(groups_[panel]);
    return found == choices.vectors.end() ? none : found->second.scale;
  }

  const drawings::Box& extent(const Choices& choices, std::size_t panel) {
    const Scale &lengths = choices.lengths[panel].scale, &vectors = vectors_of(choices, panel);
    const auto [at, is_new] = known_.try_emplace(std::tuple(panel, lengths.mm_per_unit, vectors.mm_per_unit));
    if (is_new)
      at->second = of_ == Of::all ? panels_[panel]->extent(lengths, vectors)
                                  : panels_[panel]->extent_of_near(lengths, vectors);
    return at->second;
  }

  std::vector<Size> sizes(const Choices& choices) {
    std::vector<Size> all;
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      const drawings::Box& box = extent(choices, i);
      all.push_back({box.width(), box.height()});
    }
    return all;
  }

  // With what is left out of those that are cut, and no less than what is needed of them.
  std::vector<Size> whole_sizes(const Choices& choices) {
    std::vector<Size> all = sizes(choices);
    for (std::size_t i = 0; i < panels_.size(); ++i) {
      if (!panels_[i]->is_cut()) continue;
      const drawings::Box box = panels_[i]->extent(choices.lengths[i].scale, vectors_of(choices, i));
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
  void keep_in_step(Choices& choices) const {
    for (std::size_t i = 0; i < choices.lengths.size(); ++i) choices.lengths[i] = choices.lengths[leader(i)];
  }

  Choices largest(const std::optional<Rational>& asked) const {
    Choices choices;
    bool is_asked = asked.has_value();
    for (const auto& panel : panels_) {
      if (panel->is_of_vectors() || !panel->has_scale()) {
        choices.lengths.push_back({{}, true});
      } else {
        choices.lengths.push_back(is_asked ? Choice{length_scale(*asked), true}
                                           : Choice{largest_length_scale(1000 / panel->reach())});
        is_asked = false;
      }
    }
    for (std::size_t i = 0; i < vectors_.size(); ++i) {
      const Panel::Vectors& shown = vectors_[i];
      if (shown.unit.empty()) continue;
      const double most = shown.longest_on_paper / (shown.longest > 0 ? shown.longest : 1);
      const Scale scale = largest_vector_scale(most, shown.unit, language_);
      const auto [at, is_new] = choices.vectors.try_emplace(groups_[i], Choice{scale});
      if (!is_new && scale.mm_per_unit < at->second.scale.mm_per_unit) at->second.scale = scale;
    }
    keep_in_step(choices);
    return choices;
  }

  double excess(const Division& division, const Choices& choices) {
    const Size needed = size_of(division, sizes(choices));
    return std::max(0.0, needed.width - room_.width()) + std::max(0.0, needed.height - room_.height());
  }

  // The next smaller standard scale of one choice after the other; none of those that are fixed.
  std::vector<Choices> next_smaller(const Choices& choices) const {
    constexpr double smaller = 0.99;
    std::vector<Choices> all;
    for (std::size_t i = 0; i < choices.lengths.size(); ++i) {
      if (choices.lengths[i].is_fixed || leader(i) != i) continue;
      all.push_back(choices);
      all.back().lengths[i].scale = largest_length_scale(smaller * choices.lengths[i].scale.mm_per_unit);
      keep_in_step(all.back());
    }
    for (const auto& [group, choice] : choices.vectors) {
      all.push_back(choices);
      all.back().vectors[group].scale =
          largest_vector_scale(smaller * choice.scale.mm_per_unit, choice.scale.unit, language_);
    }
    return all;
  }

  // From the largest scales down, each time the one whose next smaller step gains most for what it loses.
  std::optional<Choices> largest_that_fit(const Division& division) {
    constexpr int most_steps = 200;  // letters and symbols do not shrink: then nothing fits
    std::vector<Choices> tried{largest_};
    while (tried.size() < most_steps) {
      const Choices& choices = tried.back();
      const double now = excess(division, choices);
      if (now == 0) return exchanged(division, tried);
      std::optional<Choices> best;
      double best_gain = 0;
      for (const Choices& next : next_smaller(choices)) {
        const double gain = (now - excess(division, next)) / (merit(choices) - merit(next));
        if (best && gain <= best_gain) continue;
        best = next;
        best_gain = gain;
      }
      if (!best) return {};
      tried.push_back(*best);
    }
    return {};
  }

  // One scale a step smaller for the others as large as there is then room for them, as long as that is better.
  Choices exchanged(const Division& division, const std::vector<Choices>& tried) {
    constexpr double better = 1e-6;  // merit
    Choices best = enlarged(division, tried, tried.back());
    for (bool improved = true; improved;) {
      improved = false;
      for (const Choices& smaller : next_smaller(best)) {
        const Choices other = enlarged(division, tried, smaller, best);
        if (merit(other) <= merit(best) + better) continue;
        best = other;
        improved = true;
        break;
      }
    }
    return best;
  }

  // Each of the scales as large again as it was when tried, where there is room after all. What is smaller than in
  // `before` stays so.
  Choices enlarged(const Division& division, const std::vector<Choices>& tried, Choices choices,
                   const std::optional<Choices>& before = {}) {
    const auto stays = [](const Choice& now, const Choice& then) {
      return now.scale.mm_per_unit < then.scale.mm_per_unit;
    };
    const Choices start = choices;
    const auto try_with = [&](const auto& set) {
      for (const Choices& known : tried) {
        Choices larger = choices;
        set(larger, known);
        if (excess(division, larger) > 0) continue;
        choices = larger;
        return;
      }
    };
    for (std::size_t i = 0; i < choices.lengths.size(); ++i)
      if (!before || !stays(start.lengths[i], before->lengths[i]))
        try_with([this, i](Choices& larger, const Choices& known) {
          larger.lengths[i] = known.lengths[i];
          keep_in_step(larger);
        });
    for (const auto& [group, choice] : largest_.vectors)
      if (!before || !stays(start.vectors.at(group), before->vectors.at(group)))
        try_with([&group = group](Choices& larger, const Choices& known) {
          larger.vectors[group] = known.vectors.at(group);
        });
    return choices;
  }

  // Twice the scale of one panel outweighs half that of another, but a small panel is worth enlarging more than a
  // large one.
  double merit(const Choices& choices) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Size& size : sizes(choices)) smallest = std::min(smallest, std::max(size.width, size.height));
    return size_of_all(choices) + std::log(smallest) / 2;
  }

  double size_of_all(const Choices& choices) const {
    double size = 0;
    for (const Choice& choice : choices.lengths) size += std::log(choice.scale.mm_per_unit);
    for (const auto& [group, choice] : choices.vectors) size += planes(group) * std::log(choice.scale.mm_per_unit);
    return size;
  }

  // How many panels are planes of these vectors; one, where a panel of lengths shows them. A plane counts a little
  // more than a picture of lengths: it is read with a ruler. Of one that is built a stage a panel the last counts,
  // and of the others little.
  double planes(const std::string& group) const {
    constexpr double of_plane = 1.1, of_stage = 0.1;
    double count = 0;
    for (std::size_t i = 0; i < panels_.size(); ++i)
      if (panels_[i]->is_of_vectors() && groups_[i] == group) count += panels_[i]->is_stage() ? of_stage : of_plane;
    return std::max(count, 1.0);
  }

  const std::vector<const Panel*>& panels_;
  Of of_;
  drawings::Box room_;
  Language language_;
  std::optional<double> proportion_;  // none: what fills its room may be as high as it
  std::vector<Panel::Vectors> vectors_ = {};
  std::vector<std::string> groups_ = {};  // of vectors at one scale, by panel
  Choices largest_;
  std::map<std::tuple<std::size_t, double, double>, drawings::Box> known_;  // extents
};

// Whether no panel becomes smaller than it may in order to show what is far.
bool is_large_enough(const std::vector<const Panel*>& panels, const Choices& all, const Choices& near) {
  for (std::size_t i = 0; i < panels.size(); ++i)
    if (all.lengths[i].scale.mm_per_unit * panels[i]->times_smaller() < near.lengths[i].scale.mm_per_unit)
      return false;
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
  return all && is_large_enough(panels, all->choices, near->choices) ? of_all.placed(*all) : of_near.placed(*near);
}

}  // namespace epure
