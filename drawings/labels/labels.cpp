#include "drawings/labels/labels.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "drawings/labels/candidates.h"
#include "drawings/paths/vectors.h"

namespace epure::drawings {

namespace {

// Greedy from the most constrained label on, then improved until no single move, and no move that pushes its
// neighbours aside, makes the whole cheaper.
class Placement {
 public:
  Placement(const std::vector<LabelBox>& labels, const Obstacles& obstacles, Box area)
      : labels_(labels), obstacles_(obstacles), area_(area) {
    options_.resize(labels.size());
    beside_.resize(labels.size());
    reach_.assign(labels.size(), {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}});
    all_.resize(labels.size());
    std::iota(all_.begin(), all_.end(), 0);
    for (std::size_t i = 0; i < labels.size(); ++i) add_options(i, clear_places(labels[i], obstacles, area));
    looked_at_.assign(labels.size(), Kinds::clear);
    chosen_.assign(labels.size(), none);
    taken_.resize(labels.size());
  }

  std::vector<Place> run() {
    for (const std::size_t i : most_constrained_first()) choose(i, best_option(i));
    improve();
    for (int round = 0; round < 4 && push_aside(); ++round) improve();
    std::vector<Place> places;
    for (std::size_t i = 0; i < labels_.size(); ++i) places.push_back(place(i));
    return places;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  enum class Kinds { clear, along_line, with_leader, all };
  // Looks at one label beside another: many times what the fullest sheets take (1.1 million). Counted and not timed,
  // so that a sheet has the same places each time; in a crowd beyond it labels stay where they are by then.
  static constexpr std::size_t budget = 20'000'000;

  void add_options(std::size_t i, std::vector<Candidate> more) {
    if (labels_[i].window)
      for (Candidate& option : more)
        if (!contains(*labels_[i].window, option.box)) option.cost += price::out_of_window;
    if (labels_[i].naming) add_strangers(*labels_[i].naming, more);
    if (is_number(i)) add_other_steps(labels_[i], more);
    std::vector<Candidate>& options = options_[i];
    options.insert(options.end(), more.begin(), more.end());
    std::stable_sort(options.begin(), options.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    beside_[i].assign(options.size(), {});
    for (const Candidate& option : options) {
      const Box reach = near(option);
      reach_[i] = {{std::min(reach_[i].low.x, reach.low.x), std::min(reach_[i].low.y, reach.low.y)},
                   {std::max(reach_[i].high.x, reach.high.x), std::max(reach_[i].high.y, reach.high.y)}};
    }
  }

  // A label must not seem to name anything but its own.
  static void add_strangers(const Naming& naming, std::vector<Candidate>& options) {
    constexpr double clearly_nearer = 1;  // mm
    for (Candidate& option : options) {
      const Point here = middle(option.box);
      const Segment way{nearest_on(naming.own.first, naming.own.second, here), here};
      for (const Segment& other : naming.not_between)
        if (cross(way, other)) option.cost += price::behind_another;
      if (option.leader) {
        if (std::any_of(naming.others.begin(), naming.others.end(),
                        [&](const Segment& other) { return cross(*option.leader, other); }))
          option.cost += price::past_stranger;
        continue;
      }
      const double own = gap(option.box, naming.own.first, naming.own.second), reach = own + clearly_nearer;
      double nearest = reach;
      for (const auto& [from, to] : naming.others)
        if (!is_beyond(reach, option.box, from, to)) nearest = std::min(nearest, gap(option.box, from, to));
      option.cost += nearest <= own ? price::stranger : price::near_stranger * (reach - nearest) / clearly_nearer;
    }
  }

  static constexpr double along_by = 7;  // mm
  // Of a number that stands on a line: elsewhere on that.
  std::vector<Candidate> farther_along(const LabelBox& number) const {
    constexpr double from_end = 8;  // mm
    const auto& [from, to] = *number.along;
    const Point way = unit(from, to);
    const double here = dot(number.at - from, way), whole = distance(from, to);
    std::vector<Candidate> places;
    for (const double by : {along_by, -along_by, 2 * along_by, -2 * along_by}) {
      if (here + by < from_end || here + by > whole - from_end) continue;
      LabelBox moved = number;
      moved.at = number.at + by * way;
      for (Candidate& place : clear_places(moved, obstacles_, area_)) {
        place.cost += price::along_line * std::abs(by);
        places.push_back(place);
      }
    }
    return places;
  }

  bool is_number(std::size_t i) const { return labels_[i].number != LabelBox::Number::no; }

  // What another thing costs that is so far from a step's number, which what its step drew is `own` away from: the
  // nearer of them is taken for what the step is about.
  static double mistaken(double own, double other) {
    constexpr double clearly_nearer = 1;  // mm
    const double lack = (own + clearly_nearer - other) / clearly_nearer;
    return lack <= 1 ? price::as_near_as_own * std::max(lack, 0.0)
                     : std::lerp(price::as_near_as_own, price::stranger, std::min(2 * (lack - 1), 1.0));
  }

  // What another step drew is no stranger to a number where it runs through the point that this stands at, or along
  // the line.
  static bool is_stranger(const LabelBox& number, const Obstacle& o) {
    constexpr double meets = 0.1, one_line = 0.5;  // mm
    if (o.step == 0 || o.step == number.step) return false;
    if (number.number == LabelBox::Number::at_point)
      return std::abs(dot(left_of(unit(o.from, o.to)), number.at - o.from)) > meets;
    if (!number.along) return true;
    const Point across = left_of(unit(number.along->first, number.along->second));
    return std::max(std::abs(dot(across, o.from - number.at)), std::abs(dot(across, o.to - number.at))) > one_line;
  }

  // The number of a step must not seem to belong to what another step drew.
  void add_other_steps(const LabelBox& number, std::vector<Candidate>& options) const {
    constexpr double reach = 7;  // mm: from a place without a leader as far as what it belongs to, and clearly more
    const bool is_curve = number.number == LabelBox::Number::on_line && !number.along;
    for (Candidate& option : options) {
      if (option.leader) continue;
      const Point here = middle(option.box);
      double other = INFINITY;
      option.own =
          distance(here, number.along ? nearest_on(number.along->first, number.along->second, here) : number.at);
      obstacles_.near(option.box, reach, [&](const Obstacle& o) {
        const bool is_own = o.step == number.step && is_curve;
        if (is_own || is_stranger(number, o)) {
          double& nearest = is_own ? option.own : other;
          nearest = std::min(nearest, distance(here, nearest_on(o.from, o.to, here)));
        }
        return true;
      });
      option.cost += mistaken(option.own, other);
    }
  }

  // By the places in the clear: asked before any others are looked at.
  std::vector<std::size_t> most_constrained_first() const {
    std::vector<std::size_t> order(labels_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return options_[a].size() < options_[b].size(); });
    return order;
  }

  // Option o of label i, from the cheapest on; null when it costs `limit` or more. Most labels find a place in the
  // clear, so the others, which are many, are looked at in turn, each kind only when an option as dear as the
  // cheapest of it may be wanted. Until then no option that dear is chosen, so those that are keep their numbers.
  const Candidate* option_below(double limit, std::size_t i, std::size_t o) {
    const std::vector<Candidate>& options = options_[i];
    const auto may_be_among = [&](double least) {
      return limit > least && (o >= options.size() || options[o].cost >= least);
    };
    if (looked_at_[i] == Kinds::clear && may_be_among(price::along_line * along_by)) {
      if (labels_[i].along) add_options(i, farther_along(labels_[i]));
      looked_at_[i] = Kinds::along_line;
    }
    if (looked_at_[i] == Kinds::along_line && may_be_among(price::leader)) {
      add_options(i, places_with_leader(labels_[i], obstacles_, area_));
      looked_at_[i] = Kinds::with_leader;
    }
    if (looked_at_[i] == Kinds::with_leader && may_be_among(price::touch_thin)) {
      add_options(i, touching_places(labels_[i], obstacles_, area_));
      looked_at_[i] = Kinds::all;
    }
    return o < options.size() && options[o].cost < limit ? &options[o] : nullptr;
  }

  static bool leaders_cross(const Candidate& a, const Candidate& b) {
    return a.leader && b.leader && cross(*a.leader, *b.leader);
  }

  static bool leader_meets(const Candidate& a, const Candidate& b) {
    constexpr double air = 0.3;
    const auto meets = [](const std::optional<Segment>& leader, Box box) {
      return leader && !is_beyond(air, box, leader->first, leader->second) &&
             gap(box, leader->first, leader->second) < air;
    };
    return meets(a.leader, b.box) || meets(b.leader, a.box);
  }

  // With its leader.
  static Box around(const Candidate& option) {
    if (!option.leader) return option.box;
    const auto& [from, to] = *option.leader;
    return {{std::min({option.box.low.x, from.x, to.x}), std::min({option.box.low.y, from.y, to.y})},
            {std::max({option.box.high.x, from.x, to.x}), std::max({option.box.high.y, from.y, to.y})}};
  }

  static constexpr double told_apart = 3;  // mm between letters of one row
  // Two things' letters in one row, so near that they read as one word.
  static double read_as_one(Box a, Box b) {
    constexpr double in_row = 0.5;  // of the lower one's height
    const double shared = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y),
                 between = std::max(a.low.x, b.low.x) - std::min(a.high.x, b.high.x);
    if (between >= told_apart || shared < in_row * std::min(a.high.y - a.low.y, b.high.y - b.low.y)) return 0;
    return price::one_word * (1 - std::max(between, 0.0) / told_apart);
  }

  double together(std::size_t i, const Candidate& a, std::size_t j, const Candidate& b) const {
    const double letters = labels_[i].naming && labels_[j].naming ? read_as_one(a.box, b.box) : 0;
    return letters + beside_letters(i, a, j, b) + beside_letters(j, b, i, a) + in_the_way(a, b);
  }

  // A step's number that stands nearer to the letters of something else than to what its step drew.
  double beside_letters(std::size_t number, const Candidate& a, std::size_t letters, const Candidate& b) const {
    const LabelBox &of_number = labels_[number], &of_letters = labels_[letters];
    if (!is_number(number) || is_number(letters) || a.leader || of_number.step == of_letters.step) return 0;
    const Point at = of_number.at, here = middle(a.box);
    constexpr double same = 0.1;  // mm
    if (distance(at, nearest_on(of_letters.at, of_letters.to.value_or(of_letters.at), at)) < same) return 0;
    const double nearer = a.own - distance(here, nearest_in(b.box, here));
    return price::letters_of_another * std::clamp(nearer + 1, 0.0, 2.0);
  }

  static double in_the_way(const Candidate& a, const Candidate& b) {
    if (apart(grown(around(a), label_clearance), around(b))) return 0;
    double cost = 0;
    if (leader_meets(a, b)) cost += price::leader_through;
    if (leaders_cross(a, b)) cost += price::leaders_crossed;
    const double d = gap(a.box, b.box);
    if (d >= label_clearance) return cost;
    const double lack = 1 - d / label_clearance;
    cost += price::crowded * lack * lack;
    if (d > 0) return cost;
    const Box common = intersection(a.box, b.box);
    return cost + price::overlap + price::inside * common.width() * common.height();
  }

  // Without a branch for each side, as nearly all are apart, on any side.
  static bool meet(const Box& a, const Box& b) {
    return static_cast<bool>(static_cast<int>(a.high.x >= b.low.x) & static_cast<int>(b.high.x >= a.low.x) &
                             static_cast<int>(a.high.y >= b.low.y) & static_cast<int>(b.high.y >= a.low.y));
  }

  static Box near(const Candidate& option) { return grown(around(option), std::max(label_clearance, told_apart)); }

  // What option `o` of label i costs beside the others as they stand; gives up once worse than `limit`.
  double total(std::size_t i, std::size_t o) { return total(i, o, all_); }
  double total(std::size_t i, std::size_t o, const std::vector<std::size_t>& others, double limit = INFINITY) {
    const Candidate& option = options_[i][o];
    const Box reach = near(option);
    looks_ += labels_.size();
    double cost = option.cost;
    for (std::size_t k = 0; k < others.size() && cost < limit; ++k)
      if (const std::size_t j = others[k]; meet(reach, taken_[j]) && j != i && chosen_[j] != none)  // hardly ever
        cost += beside(i, option, j, beside_[i][o]);
    return cost;
  }

  // Those that may be in the way of any option of label i.
  std::vector<std::size_t> around_options(std::size_t i) const {
    std::vector<std::size_t> others;
    std::copy_if(all_.begin(), all_.end(), std::back_inserter(others),
                 [&](std::size_t j) { return chosen_[j] != none && meet(reach_[i], taken_[j]); });
    return others;
  }

  // What an option costs beside that chosen of label j. The same two are asked for again and again.
  struct Beside {
    std::size_t label, option;
    double cost;
  };
  double beside(std::size_t i, const Candidate& option, std::size_t j, std::vector<Beside>& known) const {
    const auto found = std::find_if(known.begin(), known.end(), [j](const Beside& each) { return each.label == j; });
    if (found != known.end() && found->option == chosen_[j]) return found->cost;
    const Beside now{j, chosen_[j], together(i, option, j, options_[j][chosen_[j]])};
    if (found == known.end())
      known.push_back(now);
    else
      *found = now;
    return now.cost;
  }

  void choose(std::size_t i, std::size_t o) {
    chosen_[i] = o;
    if (o != none) taken_[i] = around(options_[i][o]);
  }

  std::size_t best_option(std::size_t i) {
    std::size_t best = chosen_[i], options = 0;
    double least = best == none ? INFINITY : total(i, best);
    std::vector<std::size_t> others;
    for (std::size_t o = 0; option_below(least, i, o); ++o) {
      if (options != options_[i].size()) {  // more were added, farther out
        options = options_[i].size();
        others = around_options(i);
      }
      const double cost = total(i, o, others, least);
      if (cost < least - 1e-9) {
        least = cost;
        best = o;
      }
    }
    return best;
  }

  // Each in turn, until all stand best beside the others as they stand.
  void improve() {
    constexpr std::size_t rounds = 20;
    std::size_t content = 0;  // labels in a row
    for (std::size_t turn = 0; turn < rounds * labels_.size() && content < labels_.size() && looks_ < budget;
         ++turn) {
      const std::size_t i = turn % labels_.size(), best = best_option(i);
      content = best == chosen_[i] ? content + 1 : 1;
      choose(i, best);
    }
  }

  // Moves label i and returns by how much the whole grows dearer.
  double move(std::size_t i, std::size_t to) {
    const double before = total(i, chosen_[i]);
    choose(i, to);
    return total(i, to) - before;
  }

  // For labels that could stand better: take a place of their own liking and let those in the way move. True if it
  // helped.
  bool push_aside() {
    constexpr std::size_t tries = 24;
    constexpr double content = 1.5;
    bool helped = false;
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      if (chosen_[i] == none || total(i, chosen_[i]) < content) continue;
      for (std::size_t o = 0; o < tries && looks_ < budget; ++o) helped = try_pushing(i, o) || helped;
    }
    return helped;
  }

  bool try_pushing(std::size_t i, std::size_t o) {
    const Candidate* wanted = option_below(total(i, chosen_[i]), i, o);
    if (!wanted) return false;
    const std::vector<std::size_t> before = chosen_;
    double change = move(i, o);
    for (std::size_t j = 0; j < labels_.size(); ++j)
      if (j != i && before[j] != none && together(i, *wanted, j, options_[j][before[j]]) > 0)
        change += move(j, best_option(j));
    if (change < -1e-9) return true;
    for (std::size_t j = 0; j < labels_.size(); ++j) choose(j, before[j]);
    return false;
  }

  Place place(std::size_t i) const {
    if (chosen_[i] == none) return {};
    const Candidate& option = options_[i][chosen_[i]];
    Place result{option.box, option.leader, true, option.blocked, {}};
    for (std::size_t j = 0; j < labels_.size(); ++j) {
      if (j == i || chosen_[j] == none) continue;
      const Candidate& other = options_[j][chosen_[j]];
      if (gap(option.box, other.box) <= 0 || leader_meets(option, other)) result.touches.push_back(j);
    }
    return result;
  }

  const std::vector<LabelBox>& labels_;
  const Obstacles& obstacles_;
  Box area_;
  std::vector<std::vector<Candidate>> options_;
  std::vector<std::vector<std::vector<Beside>>> beside_;  // by label and option
  std::vector<Kinds> looked_at_;
  std::vector<std::size_t> chosen_;
  std::vector<Box> reach_;  // around all options and what is near them
  std::vector<std::size_t> all_;
  std::vector<Box> taken_;  // around those chosen; where none is, anything
  std::size_t looks_ = 0;
};

}  // namespace

std::vector<Place> place_labels(const std::vector<LabelBox>& labels, const Obstacles& obstacles, Box area) {
  return Placement(labels, obstacles, area).run();
}

}  // namespace epure::drawings
