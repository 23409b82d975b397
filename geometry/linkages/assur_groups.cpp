#include "geometry/linkages/assur_groups.h"

#include <algorithm>
#include <optional>

namespace epure::geometry {

NotPlaced::NotPlaced(Why why_, std::vector<int> links_, std::vector<int> points_)
    : std::runtime_error("the links of a linkage cannot be placed one after the other"),
      why(why_),
      links(std::move(links_)),
      points(std::move(points_)) {}

namespace {

using Why = NotPlaced::Why;

// How a link that is not placed hangs on what is.
struct Hold {
  enum class Kind { turned, geared, rolled, hinge, pin_on_line, line_on_pin, block, cylinder, slid } kind;
  int drive = nothing;   // of turned, cylinder, slid; of rolled, which of the wheels that roll
  int point = nothing;   // hinge; the pin; the cylinder's end on the link; the slid point
  int line = nothing;    // the line that the pin is on; of a block the one that is placed
  int moving = nothing;  // of a block, its own line
  int taken() const { return kind == Kind::hinge || kind == Kind::block ? 2 : 1; }
};

// The angles of links as gears and drives determine them: linear equations for all at once, each with a part for
// every drive and a constant one. A row that has one link left tells it.
class GearedTurns {
 public:
  explicit GearedTurns(const Linkage& linkage) : linkage_(linkage), links_(linkage.links.size()) {
    if (linkage.gears.empty()) return;
    for (std::size_t k = 0; k < linkage.drives.size(); ++k)
      if (const auto* turned = std::get_if<TurnedLink>(&linkage.drives[k])) {
        Row row = empty();
        row.links[static_cast<std::size_t>(turned->link)] = 1;
        row.turn.times[k] = 1;
        rows_.push_back(std::move(row));
      }
    for (const MeshingLinks& gear : linkage.gears) {
      Row row = empty();
      const Rational of_second = gear.turns_of_second();
      row.links[static_cast<std::size_t>(gear.second)] += 1;
      row.links[static_cast<std::size_t>(gear.first)] -= of_second;
      row.links[static_cast<std::size_t>(gear.carrier)] += of_second - 1;
      row.links[0] = 0;  // the frame does not turn
      row.turn.rest = gear.phase;
      rows_.push_back(std::move(row));
    }
    eliminate();
  }

  std::optional<GearedTurn> of(int link) const {
    for (const Row& row : rows_) {
      const auto others = std::count_if(row.links.begin(), row.links.end(), [](const Rational& x) { return x != 0; });
      if (others == 1 && row.links[static_cast<std::size_t>(link)] != 0) return row.turn;
    }
    return {};
  }

 private:
  // The sum of so many times each link's angle is the turn.
  struct Row {
    std::vector<Rational> links;
    GearedTurn turn;
  };
  Row empty() const {
    return {std::vector<Rational>(links_, Rational(0)),
            {Angle{}, std::vector<Rational>(linkage_.drives.size(), Rational(0))}};
  }
  static void add(Row& to, const Rational& times, const Row& from) {
    for (std::size_t i = 0; i < to.links.size(); ++i) to.links[i] += times * from.links[i];
    for (std::size_t k = 0; k < to.turn.times.size(); ++k) to.turn.times[k] += times * from.turn.times[k];
    to.turn.rest = to.turn.rest + times * from.turn.rest;
  }
  // Gauss and Jordan; the leading link of each row has the factor 1.
  void eliminate() {
    std::size_t done = 0;
    for (std::size_t link = 1; link < links_ && done < rows_.size(); ++link) {
      const auto found = std::find_if(rows_.begin() + static_cast<std::ptrdiff_t>(done), rows_.end(),
                                      [&](const Row& row) { return row.links[link] != 0; });
      if (found == rows_.end()) continue;
      std::swap(rows_[done], *found);
      const Row lead = rows_[done];
      add(rows_[done], 1 / lead.links[link] - 1, lead);
      for (std::size_t k = 0; k < rows_.size(); ++k)
        if (k != done) add(rows_[k], Rational(-rows_[k].links[link]), Row(rows_[done]));
      ++done;
    }
  }

  const Linkage& linkage_;
  std::size_t links_;
  std::vector<Row> rows_ = {};
};

class Placing {
 public:
  explicit Placing(const Linkage& linkage)
      : linkage_(linkage),
        turns_(linkage),
        is_placed_(linkage.links.size(), false),
        is_known_(static_cast<std::size_t>(linkage.count_of_points()), false),
        is_used_(linkage.chosen.size(), false) {
    place(0);
  }

  std::vector<Step> all() {
    while (slid_pin() || one_link() || two_links()) {
    }
    std::vector<int> left;
    for (int i = 0; i < count(); ++i)
      if (!is_placed(i)) left.push_back(i);
    if (!left.empty()) refuse(left);
    if (linkage_.freedom() < 0) refuse(held_twice());
    if (!open_.empty()) {
      NotPlaced refused(Why::open_sides);
      refused.sides = open_;
      throw refused;
    }
    for (std::size_t k = 0; k < is_used_.size(); ++k)
      if (!is_used_[k]) {
        NotPlaced refused(Why::contradicting_side);
        refused.chosen = k;
        throw refused;
      }
    return std::move(steps_);
  }

 private:
  int count() const { return static_cast<int>(linkage_.links.size()); }
  bool is_placed(int link) const { return is_placed_[static_cast<std::size_t>(link)]; }
  bool is_known(int point) const { return is_known_[static_cast<std::size_t>(point)]; }
  bool is_line_placed(int line) const { return is_placed(linkage_.link_of_line(line)); }
  bool has(int link, int point) const {
    const auto there = linkage_.links_at(point);
    return std::find(there.begin(), there.end(), link) != there.end();
  }
  bool is_line_of(int link, int line) const { return linkage_.link_of_line(line) == link; }

  void place(int link) {
    is_placed_[static_cast<std::size_t>(link)] = true;
    for (const LinkPoint& p : linkage_.links[static_cast<std::size_t>(link)].points)
      is_known_[static_cast<std::size_t>(p.point)] = true;
  }
  bool take(const Step& step) {
    for (const int link : placed_by(step)) place(link);
    steps_.push_back(step);
    return true;
  }

  std::vector<Hold> holds(int link) const {
    using Kind = Hold::Kind;
    std::vector<Hold> all;
    bool is_turned = false;
    for (std::size_t k = 0; k < linkage_.drives.size(); ++k) {
      const int drive = static_cast<int>(k);
      if (const auto* turned = std::get_if<TurnedLink>(&linkage_.drives[k]); turned && turned->link == link) {
        all.push_back({.kind = Kind::turned, .drive = drive});
        is_turned = true;
      }
      if (const auto* slid = std::get_if<SlidPoint>(&linkage_.drives[k]);
          slid && has(link, slid->point) && !is_known(slid->point) && is_line_placed(slid->guide))
        all.push_back({.kind = Kind::slid, .drive = drive, .point = slid->point, .line = slid->guide});
      if (const auto* cylinder = std::get_if<Stretched>(&linkage_.drives[k])) {
        for (const auto& [own, other] : {std::pair(cylinder->from, cylinder->to), {cylinder->to, cylinder->from}})
          if (has(link, own) && !is_known(own) && is_known(other))
            all.push_back({.kind = Kind::cylinder, .drive = drive, .point = own});
      }
    }
    if (!is_turned && turns_.of(link)) all.push_back({.kind = Kind::geared});
    for (std::size_t k = 0; k < linkage_.rolls.size(); ++k)
      if (const RollingWheel& roll = linkage_.rolls[k];
          roll.wheel == link && is_known(roll.centre) && is_line_placed(roll.line))
        all.push_back({.kind = Kind::rolled, .drive = static_cast<int>(k)});
    for (const LinkPoint& p : linkage_.links[static_cast<std::size_t>(link)].points)
      if (is_known(p.point)) all.push_back({.kind = Kind::hinge, .point = p.point});
    for (const PinOnLine& pin : linkage_.pins) {
      if (has(link, pin.point) && !is_known(pin.point) && is_line_placed(pin.line))
        all.push_back({.kind = Kind::pin_on_line, .point = pin.point, .line = pin.line});
      if (is_line_of(link, pin.line) && is_known(pin.point))
        all.push_back({.kind = Kind::line_on_pin, .point = pin.point, .line = pin.line});
    }
    for (const LineOnLine& block : linkage_.blocks)
      for (const auto& [own, other] : {std::pair(block.moving, block.guide), {block.guide, block.moving}})
        if (is_line_of(link, own) && is_line_placed(other))
          all.push_back({.kind = Kind::block, .line = other, .moving = own});
    return all;
  }

  // A point that is driven along the slot it runs in is known before any of its links.
  bool slid_pin() {
    for (std::size_t k = 0; k < linkage_.drives.size(); ++k) {
      const auto* slid = std::get_if<SlidPoint>(&linkage_.drives[k]);
      if (!slid || is_known(slid->point) || !is_line_placed(slid->guide)) continue;
      const bool runs_in_it = std::any_of(linkage_.pins.begin(), linkage_.pins.end(), [&](const PinOnLine& pin) {
        return pin.point == slid->point && pin.line == slid->guide;
      });
      if (!runs_in_it) continue;
      is_known_[static_cast<std::size_t>(slid->point)] = true;
      steps_.push_back(SlidPin{slid->point, static_cast<int>(k)});
      return true;
    }
    return false;
  }

  bool one_link() {
    for (int link = 0; link < count(); ++link) {
      if (is_placed(link)) continue;
      const std::vector<Hold> all = holds(link);
      int taken = 0;
      for (const Hold& hold : all) taken += hold.taken();
      if (taken > 3) throw NotPlaced(Why::overconstrained, {link}, points_of(all));
      if (taken == 3 && all.size() == 2 && one_link(link, all[0], all[1])) return true;
    }
    return false;
  }

  // By two holds, in the order in which `holds` finds them.
  bool one_link(int link, const Hold& first, const Hold& second) {
    using Kind = Hold::Kind;
    const Hold &of_two = first.taken() == 2 ? first : second, &of_one = first.taken() == 2 ? second : first;
    if (of_two.kind == Kind::hinge) {
      const int hinge = of_two.point;
      switch (of_one.kind) {
        case Kind::turned:
          return take(TurnedCrank{link, hinge, of_one.drive});
        case Kind::geared:
          return take(GearedWheel{link, hinge, *turns_.of(link)});
        case Kind::rolled:
          return take(RolledWheel{link, hinge, of_one.drive});
        case Kind::cylinder:
          return take(two_rods({hinge, link}, {other_end(of_one), nothing, of_one.drive}, of_one.point));
        case Kind::pin_on_line:
          return take(rod_and_track({hinge, link}, {of_one.line}, of_one.point));
        case Kind::line_on_pin:
          return take(SlotOnPin{link, hinge, of_one.line, of_one.point, nothing, nothing,
                                is_towards(of_one.line, hinge, of_one.point)});
        default:
          return false;
      }
    }
    const Track track{of_two.line, link, of_two.moving};
    switch (of_one.kind) {
      case Kind::slid:
        return of_one.line == track.line && take(SlidBlock{track, of_one.point, of_one.drive});
      case Kind::pin_on_line:
        return take(TwoTracks{track, {of_one.line}, of_one.point});
      case Kind::line_on_pin:
        return take(BlockOnPin{track, of_one.line, of_one.point});
      case Kind::cylinder:
        return take(rod_and_track({other_end(of_one), nothing, of_one.drive}, track, of_one.point));
      default:
        return false;
    }
  }

  bool two_links() {
    for (int i = 0; i < count(); ++i)
      for (int j = i + 1; j < count(); ++j) {
        if (is_placed(i) || is_placed(j)) continue;
        const std::vector<Hold> of_i = holds(i), of_j = holds(j);
        if (of_i.size() != 1 || of_j.size() != 1 || of_i[0].taken() != 2 || of_j[0].taken() != 2) continue;
        if (hinged(i, of_i[0], j, of_j[0]) || sliding(i, of_i[0], j, of_j[0]) || sliding(j, of_j[0], i, of_i[0]))
          return true;
      }
    return false;
  }

  bool hinged(int i, const Hold& of_i, int j, const Hold& of_j) {
    for (const LinkPoint& p : linkage_.links[static_cast<std::size_t>(i)].points) {
      if (is_known(p.point) || !has(j, p.point)) continue;
      const bool i_is_rod = of_i.kind == Hold::Kind::hinge, j_is_rod = of_j.kind == Hold::Kind::hinge;
      if (i_is_rod && j_is_rod) return take(two_rods({of_i.point, i}, {of_j.point, j}, p.point));
      if (i_is_rod) return take(rod_and_track({of_i.point, i}, {of_j.line, j, of_j.moving}, p.point));
      if (j_is_rod) return take(rod_and_track({of_j.point, j}, {of_i.line, i, of_i.moving}, p.point));
      return take(TwoTracks{{of_i.line, i, of_i.moving}, {of_j.line, j, of_j.moving}, p.point});
    }
    return false;
  }

  // i on a hinge, j sliding along it.
  bool sliding(int i, const Hold& of_i, int j, const Hold& of_j) {
    if (of_i.kind != Hold::Kind::hinge) return false;
    for (const LineOnLine& block : linkage_.blocks)
      for (const auto& [on_i, on_j] : {std::pair(block.moving, block.guide), {block.guide, block.moving}}) {
        if (!is_line_of(i, on_i) || !is_line_of(j, on_j)) continue;
        if (of_j.kind == Hold::Kind::hinge) {
          // A block that is no more than its hinge is the pin, whichever link comes first.
          const bool is_block =
              on_i == block.moving && linkage_.links[static_cast<std::size_t>(i)].points.size() == 1;
          return is_block ? take(slot_on_pin(j, of_j.point, on_j, i, of_i.point, on_i))
                          : take(slot_on_pin(i, of_i.point, on_i, j, of_j.point, on_j));
        }
        return take(CrossedBlock{i, of_i.point, on_i, {of_j.line, j, of_j.moving}, on_j});
      }
    return false;
  }

  int other_end(const Hold& cylinder) const {
    const auto& drive = std::get<Stretched>(linkage_.drives[static_cast<std::size_t>(cylinder.drive)]);
    return drive.from == cylinder.point ? drive.to : drive.from;
  }

  static bool is_untold_or(int meant, int told) { return told == nothing || told == meant; }

  // What was chosen of the kind `Said` for which `is_meant` holds.
  template <class Said, class IsMeant>
  const Said* chosen(const IsMeant& is_meant) {
    for (std::size_t k = 0; k < linkage_.chosen.size(); ++k)
      if (const auto* said = std::get_if<Said>(&linkage_.chosen[k]); said && is_meant(*said)) {
        is_used_[k] = true;
        return said;
      }
    return nullptr;
  }

  // Where nothing is said of a side, the others are placed all the same, and all that is open is told at once.
  TwoRods two_rods(const Rod& first, const Rod& second, int joint) {
    const auto* said = chosen<BesideLine>([&](const BesideLine& beside) {
      return beside.joint == joint && ((beside.from == first.pin && beside.to == second.pin) ||
                                       (beside.from == second.pin && beside.to == first.pin));
    });
    if (!said) open_.push_back({OpenSide::Kind::beside_line, joint, first.pin, second.pin});
    const bool is_left = said && said->is_left == (said->from == first.pin);
    return {first, second, joint, is_left ? Side::left : Side::right};
  }
  RodAndTrack rod_and_track(const Rod& rod, const Track& track, int joint) {
    const auto* said = chosen<OnGuide>([&](const OnGuide& on) {
      return on.joint == joint && is_untold_or(track.line, on.guide) && is_untold_or(rod.pin, on.other_end);
    });
    if (!said) open_.push_back({OpenSide::Kind::on_guide, joint, rod.pin, nothing, track.line});
    return {rod, track, joint, said && said->is_ahead ? Along::ahead : Along::behind};
  }
  // Of two lines in each other, which have one direction, either may be told.
  SlotOnPin slot_on_pin(int link, int hinge, int line, int block, int pin, int moving) {
    const auto* said = chosen<SlotPoints>([&](const SlotPoints& slot) {
      return slot.line == moving && is_untold_or(pin, slot.hinge) && is_untold_or(hinge, slot.pin);
    });
    return {link, hinge, line, pin, block, moving, said ? !said->is_towards_pin : is_towards(line, hinge, pin)};
  }
  bool is_towards(int line, int hinge, int pin) {
    const auto* said = chosen<SlotPoints>([&](const SlotPoints& slot) {
      return slot.line == line && is_untold_or(hinge, slot.hinge) && is_untold_or(pin, slot.pin);
    });
    if (!said) open_.push_back({.kind = OpenSide::Kind::along_slot, .from = hinge, .to = pin, .line = line});
    return said && said->is_towards_pin;
  }

  static std::vector<int> points_of(const std::vector<Hold>& holds) {
    std::vector<int> points;
    for (const Hold& hold : holds)
      if (hold.point != nothing) points.push_back(hold.point);
    return points;
  }

  [[noreturn]] void refuse(const std::vector<int>& left) const {
    std::vector<int> outer;
    for (const int link : left)
      for (const Hold& hold : holds(link))
        if (hold.point != nothing) outer.push_back(hold.point);
    NotPlaced refused(linkage_.freedom() > 0   ? Why::freedom
                      : linkage_.freedom() < 0 ? Why::overconstrained
                                               : Why::not_dyadic,
                      left, outer);
    refused.freedom = linkage_.freedom();
    throw refused;
  }

  // All stand, and more than needed holds them: wheels, which turn so without their gears, or whatever there is.
  std::vector<int> held_twice() const {
    std::vector<int> all;
    for (const MeshingLinks& gear : linkage_.gears)
      for (const int wheel : {gear.first, gear.second})
        if (wheel != 0 && std::find(all.begin(), all.end(), wheel) == all.end()) all.push_back(wheel);
    for (int link = 1; all.empty() && link < count(); ++link) all.push_back(link);
    return all;
  }

  const Linkage& linkage_;
  GearedTurns turns_;
  std::vector<bool> is_placed_, is_known_, is_used_;
  std::vector<Step> steps_;
  std::vector<OpenSide> open_;
};

}  // namespace

std::vector<Hung> hung_by(const Step& step) {
  const auto links = std::visit(
      [](const auto& s) -> std::vector<Hung> {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, TurnedCrank> || std::is_same_v<S, GearedWheel> ||
                      std::is_same_v<S, RolledWheel>)
          return {{s.link, s.hinge}};
        if constexpr (std::is_same_v<S, SlidBlock>) return {{s.track.block, s.point}};
        if constexpr (std::is_same_v<S, BlockOnPin>) return {{s.track.block}};
        if constexpr (std::is_same_v<S, SlidPin>) return {};
        if constexpr (std::is_same_v<S, TwoRods>)
          return {{s.first.link, s.first.pin, s.joint}, {s.second.link, s.second.pin, s.joint}};
        if constexpr (std::is_same_v<S, RodAndTrack>)
          return {{s.rod.link, s.rod.pin, s.joint}, {s.track.block, s.joint}};
        if constexpr (std::is_same_v<S, TwoTracks>) return {{s.first.block, s.joint}, {s.second.block, s.joint}};
        if constexpr (std::is_same_v<S, SlotOnPin>) return {{s.link, s.hinge}, {s.block, s.pin}};
        if constexpr (std::is_same_v<S, CrossedBlock>) return {{s.link, s.hinge}, {s.track.block}};
      },
      step);
  std::vector<Hung> hung;
  std::copy_if(links.begin(), links.end(), std::back_inserter(hung), [](const Hung& h) { return h.link != nothing; });
  return hung;
}

std::vector<int> placed_by(const Step& step) {
  std::vector<int> links;
  for (const Hung& hung : hung_by(step)) links.push_back(hung.link);
  return links;
}

Angle angle_of(const GearedTurn& turn, const Linkage& linkage) {
  Angle angle = turn.rest;
  for (std::size_t k = 0; k < turn.times.size(); ++k)
    if (const auto* turned = std::get_if<TurnedLink>(&linkage.drives[k]))
      angle = angle + turn.times[k] * turned->angle;
  return angle;
}

std::vector<Step> assur_groups(const Linkage& linkage) { return Placing(linkage).all(); }

Linkage with_sides_in_full(Linkage linkage, const std::vector<Step>& steps) {
  for (const Step& step : steps)
    for (Chosen& chosen : linkage.chosen) {
      const auto* rod = std::get_if<RodAndTrack>(&step);
      if (auto* on = std::get_if<OnGuide>(&chosen); on && rod && on->joint == rod->joint) {
        on->guide = rod->track.line;
        on->other_end = rod->rod.pin;
      }
      const auto* lever = std::get_if<SlotOnPin>(&step);
      if (auto* slot = std::get_if<SlotPoints>(&chosen); slot && lever && slot->line == lever->line) {
        slot->hinge = lever->hinge;
        slot->pin = lever->pin;
      }
    }
  return linkage;
}

}  // namespace epure::geometry
