#include "exercises/scenes/forces/force_groups.h"

#include <algorithm>
#include <map>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/dyad_equations.h"
#include "exercises/scenes/forces/force_names.h"
#include "exercises/scenes/forces/scene_forces.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Force = ActingForce;

class ForcePlanner {
 public:
  explicit ForcePlanner(const Built& built)
      : built_(built),
        of_(built.linkage),
        joints_(built.linkage),
        placed_(of_.links.size(), nothing),
        pinned_(index(of_.count_of_points()), nothing),
        is_loaded_(built.steps.size(), false) {
    for (std::size_t k = 0; k < built.steps.size(); ++k)
      for (const int link : placed_by(built.steps[k])) placed_[index(link)] = static_cast<int>(k);
    for (int p = 0; p < of_.count_of_points(); ++p) pinned_[index(p)] = step_of_point(p);
  }

  std::vector<GroupForces> all() {
    std::vector<GroupForces> groups;
    for (std::size_t k = built_.steps.size(); k-- > 0;) {
      now_ = static_cast<int>(k);
      group_ = {.step = k, .bodies = {}, .moments = {}, .loops = {}};
      const std::vector<int> links = placed_by(built_.steps[k]);
      is_loaded_[k] = std::any_of(links.begin(), links.end(), [&](int link) { return bears(link); }) ||
                      (links.empty() && bears_pin(joint_of(built_.steps[k])));
      if (!is_loaded_[k]) continue;
      std::visit([this](const auto& step) { write(step); }, built_.steps[k]);
      for (const int link : links) group_.bodies.push_back({link, known(link), sought(link), couples_on(link)});
      groups.push_back(std::move(group_));
    }
    for (GroupForces& group : groups)
      for (Moments& each : group.moments) name_arms(each);
    return groups;
  }

  // What holds a point that no link brought along: all that was there before the link that carries it.
  std::vector<Force> forces_that_hold(int point) const {
    std::vector<Force> all;
    for (const Force& force : forces_on_pin(point))
      if (step_of(force) < placed_[index(carrier(point))]) all.push_back(force);
    return all;
  }

 private:
  // --- what acts on a link -----------------------------------------------------------------------------------------
  int carrier(int point) const { return of_.links_at(point).front(); }
  static int joint_of(const Step& step) {
    if (const auto* slid = std::get_if<SlidPin>(&step)) return slid->point;
    if (const auto* two = std::get_if<TwoTracks>(&step)) return two->joint;
    if (const auto* two = std::get_if<TwoRods>(&step)) return two->joint;
    if (const auto* rod = std::get_if<RodAndTrack>(&step)) return rod->joint;
    return nothing;
  }
  // Which step brings the point to its place.
  int step_of_point(int point) const {
    int first = static_cast<int>(built_.steps.size());
    for (const int link : of_.links_at(point)) first = std::min(first, placed_[index(link)]);
    for (std::size_t k = 0; k < built_.steps.size(); ++k)
      if (joint_of(built_.steps[k]) == point) first = std::min(first, static_cast<int>(k));
    return first;
  }
  // The step that finds a force.
  int step_of(const Force& force) const {
    const auto of_line = [&](int line) { return placed_[index(of_.link_of_line(line))]; };
    switch (force.kind) {
      case Force::Kind::load:
      case Force::Kind::weight:
      case Force::Kind::inertia:
        return static_cast<int>(built_.steps.size());
      case Force::Kind::hinge:
      case Force::Kind::tooth: {
        const TwoLinks two = links_of(of_, force);
        return std::max(placed_[index(two.by)], placed_[index(two.on)]);
      }
      case Force::Kind::pin: {
        const PinOnLine& pin = of_.pins[index(force.which)];
        return std::max(pinned_[index(pin.point)], of_line(pin.line));
      }
      case Force::Kind::guide: {
        const LineOnLine& block = of_.blocks[index(force.which)];
        return std::max(of_line(block.moving), of_line(block.guide));
      }
      case Force::Kind::slid: {
        const auto& drive = std::get<SlidPoint>(of_.drives[index(force.which)]);
        return std::max(pinned_[index(drive.point)], of_line(drive.guide));
      }
      case Force::Kind::cylinder: {
        const auto& drive = std::get<Stretched>(of_.drives[index(force.which)]);
        return std::max(pinned_[index(drive.from)], pinned_[index(drive.to)]);
      }
      case Force::Kind::held:
        break;
    }
    return placed_[index(force.link)];
  }
  bool has_point(int link, int point) const {
    const std::vector<int> there = of_.links_at(point);
    return std::find(there.begin(), there.end(), link) != there.end();
  }

  // All forces on a link but those that hold a point of it which no link brought along.
  std::vector<Force> forces_on(int link) const {
    using Kind = Force::Kind;
    std::vector<Force> all;
    for (std::size_t k = 0; k < built_.loads->forces.size(); ++k)
      if (built_.loads->forces[k].link == link)
        all.push_back(
            {Kind::load, static_cast<int>(k), link, false, point_at(built_, link, built_.loads->forces[k].at)});
    for (std::size_t k = 0; k < built_.loads->masses.size(); ++k) {
      const LinkMass& body = built_.loads->masses[k];
      if (body.link != link) continue;
      const int G = point_at(built_, link, body.at);
      if (!built_.gravity.empty()) all.push_back({Kind::weight, static_cast<int>(k), link, false, G});
      all.push_back({Kind::inertia, static_cast<int>(k), link, false, G});
    }
    for (std::size_t k = 0; k < joints_.hinges.size(); ++k) {
      const auto& hinge = joints_.hinges[k];
      if (hinge.on == link) all.push_back({Kind::hinge, static_cast<int>(k), link, false, hinge.point});
      if (hinge.by == link) all.push_back({Kind::hinge, static_cast<int>(k), link, true, hinge.point});
    }
    for (std::size_t k = 0; k < of_.gears.size(); ++k)
      for (const int wheel : {of_.gears[k].first, of_.gears[k].second})
        if (wheel == link) all.push_back({Kind::tooth, static_cast<int>(k), link});
    for (std::size_t k = 0; k < of_.blocks.size(); ++k)
      for (const bool is_guide : {false, true})
        if (of_.link_of_line(is_guide ? of_.blocks[k].guide : of_.blocks[k].moving) == link)
          all.push_back({Kind::guide, static_cast<int>(k), link, is_guide, through_point(of_.blocks[k].moving)});
    for (std::size_t k = 0; k < of_.pins.size(); ++k)
      if (of_.link_of_line(of_.pins[k].line) == link)
        all.push_back({Kind::pin, static_cast<int>(k), link, true, of_.pins[k].point});
    for (std::size_t k = 0; k < of_.drives.size(); ++k)
      if (const auto* slid = std::get_if<SlidPoint>(&of_.drives[k]); slid && of_.link_of_line(slid->guide) == link)
        all.push_back({Kind::slid, static_cast<int>(k), link, true, slid->point});
    for (const LinkPoint& p : of_.links[index(link)].points)
      if (carrier(p.point) == link)
        for (Force& force : forces_on_pin(p.point)) {
          force.link = link;
          all.push_back(force);
        }
    return all;
  }
  // Of slots, drives and cylinders.
  std::vector<Force> forces_on_pin(int point) const {
    using Kind = Force::Kind;
    std::vector<Force> all;
    for (std::size_t k = 0; k < of_.pins.size(); ++k)
      if (of_.pins[k].point == point) all.push_back({Kind::pin, static_cast<int>(k), nothing, false, point});
    for (std::size_t k = 0; k < of_.drives.size(); ++k) {
      if (const auto* slid = std::get_if<SlidPoint>(&of_.drives[k]); slid && slid->point == point)
        all.push_back({Kind::slid, static_cast<int>(k), nothing, false, point});
      if (const auto* cylinder = std::get_if<Stretched>(&of_.drives[k]))
        for (const bool is_from : {false, true})
          if ((is_from ? cylinder->from : cylinder->to) == point)
            all.push_back({Kind::cylinder, static_cast<int>(k), nothing, is_from, point});
    }
    return all;
  }
  bool is_borne(const Force& force) const {
    const int step = step_of(force);
    return step > now_ && (step == static_cast<int>(built_.steps.size()) || is_loaded_[index(step)]);
  }
  // Loads, and what later groups hand on.
  std::vector<Force> known(int link) const {
    std::vector<Force> all;
    for (const Force& force : forces_on(link))
      if (is_borne(force)) all.push_back(force);
    return all;
  }
  std::vector<Force> sought(int link) const {
    std::vector<Force> all;
    for (const Force& force : forces_on(link)) {
      const int step = step_of(force);
      if (step == now_) all.push_back(force);
      // What holds a pin that this link hangs on.
      if (step < now_) {
        const Force whole = held(link, force.point);
        if (std::none_of(all.begin(), all.end(), [&](const Force& other) { return other.is_same(whole); }))
          all.push_back(whole);
      }
    }
    return all;
  }
  static Force held(int link, int point) { return {Force::Kind::held, point, link, false, point}; }

  std::vector<ActingCouple> couples_on(int link) const {
    using Kind = ActingCouple::Kind;
    std::vector<ActingCouple> all;
    for (std::size_t k = 0; k < built_.loads->couples.size(); ++k)
      if (built_.loads->couples[k].link == link) all.push_back({Kind::load, static_cast<int>(k)});
    for (std::size_t k = 0; k < built_.loads->masses.size(); ++k)
      if (built_.loads->masses[k].link == link && !built_.mass_names[k].inertia.empty() &&
          !turns_steadily(built_, link))
        all.push_back({Kind::inertia, static_cast<int>(k)});
    for (const Force& force : forces_on(link))
      if (force.kind == Force::Kind::guide && step_of(force) >= now_ && is_loaded_[index(step_of(force))])
        all.push_back({Kind::guide, force.which, force.is_opposite});
    for (const Force& force : forces_on(link))
      if (force.kind == Force::Kind::hinge && has_friction(*built_.loads, force.point) &&
          is_loaded_[index(step_of(force))])
        all.push_back({Kind::hinge, force.which, is_reversed(built_, force)});
    for (std::size_t k = 0; k < of_.drives.size(); ++k)
      if (const auto* crank = std::get_if<TurnedLink>(&of_.drives[k]); crank && crank->link == link)
        all.push_back({Kind::drive, static_cast<int>(k)});
    return all;
  }
  bool is_known(const ActingCouple& couple) const {
    if (couple.kind != ActingCouple::Kind::guide) return couple.kind != ActingCouple::Kind::drive;
    return step_of({Force::Kind::guide, couple.which, nothing}) > now_;
  }
  std::vector<ActingCouple> known_couples(int link) const {
    std::vector<ActingCouple> all;
    for (const ActingCouple& couple : couples_on(link))
      if (is_known(couple)) all.push_back(couple);
    return all;
  }
  bool bears(int link) const { return !known(link).empty() || !known_couples(link).empty(); }
  bool bears_pin(int point) const {
    if (point == nothing) return false;
    const std::vector<Force> all = forces_that_hold(point);
    return is_loaded_[index(placed_[index(carrier(point))])] ||
           std::any_of(all.begin(), all.end(), [&](const Force& force) { return is_borne(force); });
  }

  // --- places ------------------------------------------------------------------------------------------------------
  int through_point(int line) const { return point_at(built_, of_.link_of_line(line), of_.line(line).through); }
  About through(int line) const {
    const int point = through_point(line);
    return point != nothing ? About{.point = point} : About{.line = line};
  }
  bool is_at(const Force& force, const About& about) const {
    if (about.point != nothing) return force.point == about.point;
    return force.kind == Force::Kind::guide && of_.blocks[index(force.which)].moving == about.line;
  }

  // --- moments -----------------------------------------------------------------------------------------------------
  std::vector<Arm> arms(const std::vector<Force>& forces, const About& about) const {
    std::vector<Arm> all;
    for (const Force& force : forces)
      if (!is_at(force, about) && !runs_through(force, about)) all.push_back({force, {}});
    return all;
  }
  // The inertia of what turns steadily about a point at rest.
  bool runs_through(const Force& force, const About& about) const {
    return force.kind == Force::Kind::inertia && turns_steadily(built_, force.link) && about.point != nothing &&
           carrier(about.point) == 0;
  }
  void name_arms(Moments& moments) {
    for (Arm& arm : moments.arms) name_arm(arm, moments);
    if (auto* arm = std::get_if<Arm>(&moments.sought)) name_arm(*arm, moments);
  }
  // Under another link's name where a force has an arm already.
  void name_arm(Arm& arm, const Moments& moments) {
    const std::string number = std::to_string(built_.letters.links[index(moments.link)]),
                      force = name_of_force(built_, arm.force);
    std::string name = "h_" + force, letters = force;
    if (letters.starts_with("R_")) letters = letters.substr(2);
    letters.erase(std::remove(letters.begin(), letters.end(), '_'), letters.end());
    if (!arm_names_.insert({name, 0}).second) {
      name += "_on_" + number;
      letters += "," + number;
    }
    arm.length = {name, "$h_{" + letters + "}$", "m",
                  format_words("how far the line of {} passes by {}", "distanza della retta di {} da {}",
                               letters_of_force(built_, arm.force), about_in_words(moments.about))};
  }
  Words about_in_words(const About& about) const {
    if (about.point != nothing) return Words{name(about.point), name(about.point)};
    const std::string& line = built_.letters.lines[index(about.line)];
    return format_words("the point that {} is given through", "il punto per cui {} è data", line);
  }

  // --- the sides of a group ----------------------------------------------------------------------------------------
  const std::string& name(int point) const { return built_.letters.points[index(point)]; }
  std::string letters(int point) const { return point_letters(name(point)); }
  std::string two(int P, int X) const { return "$" + letters(P) + letters(X) + "$"; }
  std::string line(int l) const { return "$" + point_letters(built_.letters.lines[index(l)]) + "$"; }
  std::string number(int link) const { return std::to_string(built_.letters.links[index(link)]); }

  ForceSide known_side(const Force& force) const {
    ForceSide side{.force = force};
    if (force.kind == Force::Kind::load) {
      side.direction = built_.force_names[index(force.which)].direction;
    } else if (force.kind == Force::Kind::weight) {
      const Own& g = built_.loads->gravity;
      side.direction = g.x == 0 ? "∥ $y$" : g.y == 0 ? "∥ $x$" : "∥ " + built_.gravity;
    } else if (force.kind == Force::Kind::inertia) {
      side.direction = "∥ " + acceleration_of_centre(built_, index(force.which));
    } else if (force.kind == Force::Kind::tooth && step_of(force) == now_) {
      const MeshingLinks& gear = of_.gears[index(force.which)];
      side.direction = "⊥ " + two(of_.hinge_of(gear.first, gear.carrier), of_.hinge_of(gear.second, gear.carrier));
      side.is_along_action = true;
    } else {
      side.direction = "∥ " + letters_of_force(built_, on_other(force));
      if (const int l = line_of(force); l != nothing) side.direction = (is_across(force) ? "⊥ " : "∥ ") + line(l);
    }
    return side;
  }
  // What the link does to the other in return, which was found before.
  Force on_other(const Force& force) const {
    if (!is_of_links(force)) return force;
    Force other = force;
    other.link = links_of(of_, force).other(force.link);
    return other;
  }
  // Along or across which the force is, whatever acts.
  int line_of(const Force& force) const {
    if (force.kind == Force::Kind::pin) return of_.pins[index(force.which)].line;
    if (force.kind == Force::Kind::guide) return of_.blocks[index(force.which)].guide;
    if (force.kind == Force::Kind::slid) return std::get<SlidPoint>(of_.drives[index(force.which)]).guide;
    return nothing;
  }
  static bool is_across(const Force& force) { return force.kind != Force::Kind::slid; }
  ForceSide unknown_on_line(const Force& force) const {
    ForceSide side = known_side(force);
    side.is_unknown = true;
    side.line = line_of(force);
    side.is_square = is_across(force);
    if (force.kind == Force::Kind::cylinder) {
      const auto& cylinder = std::get<Stretched>(of_.drives[index(force.which)]);
      side.from = cylinder.from;
      side.to = cylinder.to;
      side.direction = "∥ " + two(side.from, side.to);
    }
    return side;
  }
  static ForceSide closing(const Force& force) {
    ForceSide side{.force = force};
    side.is_unknown = true;
    side.direction = "?";
    return side;
  }
  void add_known(std::vector<ForceSide>& chain, const std::vector<Force>& forces) const {
    for (const Force& force : forces) chain.push_back(known_side(force));
  }

  // What one side of a group brings: what is known on its link, and its unknown, of a rod perhaps with a part that
  // moments give.
  struct GroupSide {
    int link = nothing;
    std::vector<Force> known = {};
    bool is_loaded = false;
    std::optional<ForceSide> across = {};
    ForceSide unknown;
  };
  Force outer(int link, int pin) const {
    for (const Force& force : sought(link))
      if (force.point == pin && (force.kind == Force::Kind::hinge || force.kind == Force::Kind::held)) return force;
    return held(link, pin);
  }
  GroupSide side(const Rod& rod, int joint) {
    GroupSide side;
    if (rod.link == nothing) {
      const int k = rod.cylinder;
      const auto& cylinder = std::get<Stretched>(of_.drives[index(k)]);
      side.unknown = unknown_on_line({Force::Kind::cylinder, k, carrier(joint), cylinder.from == joint, joint});
      return side;
    }
    side.link = rod.link;
    side.known = known(rod.link);
    const std::vector<ActingCouple> couples = known_couples(rod.link);
    side.is_loaded = !side.known.empty() || !couples.empty();
    const Force force = outer(rod.link, rod.pin);
    side.unknown = {
        .force = force, .part = ForcePart::whole, .is_unknown = true, .direction = "∥ " + two(rod.pin, joint)};
    side.unknown.from = rod.pin;
    side.unknown.to = joint;
    std::vector<Arm> about_joint = arms(side.known, {.point = joint});
    if (about_joint.empty() && couples.empty()) {
      if (!side.is_loaded) group_.struts.push_back({rod.link, rod.pin, joint});
      return side;
    }
    group_.moments.push_back({rod.link, {.point = joint}, about_joint, couples, AcrossRod{force, rod.pin, joint}});
    side.unknown.part = ForcePart::along;
    side.across = ForceSide{.force = force, .part = ForcePart::across};
    side.across->direction = "⊥ " + two(rod.pin, joint);
    return side;
  }
  GroupSide side(const Track& track, int joint) {
    GroupSide side;
    if (track.block == nothing) {
      side.unknown = unknown_on_line(in_slot(joint, track.line, link_on_pin(joint), false));
    } else {
      side.link = track.block;
      side.known = known(track.block);
      side.is_loaded = bears(track.block);
      side.unknown = unknown_on_line(guide_of(track));
    }
    group_.pressed.push_back({side.unknown.force, track.line});
    return side;
  }
  // The link on whose pin it presses; nothing where the pin is placed alone.
  int link_on_pin(int joint) const {
    const int link = carrier(joint);
    return placed_[index(link)] == now_ ? link : nothing;
  }
  // Between a pin and the slot that it runs in; opposite on the slot's link.
  Force in_slot(int pin, int line, int link, bool is_opposite) const {
    const auto found = std::find_if(of_.pins.begin(), of_.pins.end(),
                                    [&](const PinOnLine& each) { return each.point == pin && each.line == line; });
    return {Force::Kind::pin, static_cast<int>(found - of_.pins.begin()), link, is_opposite, pin};
  }
  Force guide_between(int link, int own, int other) const {
    for (std::size_t k = 0; k < of_.blocks.size(); ++k) {
      const LineOnLine& block = of_.blocks[k];
      if ((block.moving == own && block.guide == other) || (block.moving == other && block.guide == own))
        return {Force::Kind::guide, static_cast<int>(k), link, block.guide == own, through_point(block.moving)};
    }
    return {Force::Kind::guide, 0, link};
  }
  Force guide_of(const Track& track) const { return guide_between(track.block, track.moving, track.line); }

  // Of a block: about the point its line is given through, what its guide does against turning.
  void moments_of_guide(const Force& guide, const std::vector<Force>& others) {
    const About about = through(of_.blocks[index(guide.which)].moving);
    std::vector<Force> forces = known(guide.link);
    forces.insert(forces.end(), others.begin(), others.end());
    const std::vector<Arm> with_arms = arms(forces, about);
    const std::vector<ActingCouple> couples = known_couples(guide.link);
    if (with_arms.empty() && couples.empty()) return;
    group_.moments.push_back({guide.link, about, with_arms, couples,
                              ActingCouple{ActingCouple::Kind::guide, guide.which, guide.is_opposite}});
  }

  // Of a block: its guide's force and another one, both along known lines.
  void add_loop_of_block(const Force& guide, const Force& other) {
    ForceLoop loop{.letter = number(guide.link), .left = {unknown_on_line(guide)}, .right = {}};
    add_known(loop.right, known(guide.link));
    loop.right.push_back(unknown_on_line(other));
    group_.loops.push_back(std::move(loop));
  }
  // Of a link of which all but the force in a hinge is known, these among it.
  void add_closed_loop(int link, int hinge, const std::vector<Force>& found) {
    ForceLoop loop{.letter = number(link), .left = {closing(outer(link, hinge))}, .right = {}};
    add_known(loop.right, known(link));
    add_known(loop.right, found);
    group_.loops.push_back(std::move(loop));
  }

  std::optional<Force> inner(int link, int joint, int other) const {
    for (const Force& force : forces_on(link)) {
      if (force.kind != Force::Kind::hinge || force.point != joint) continue;
      const auto& hinge = joints_.hinges[index(force.which)];
      if (hinge.by == other || hinge.on == other) return force;
    }
    return {};
  }

  // --- the groups --------------------------------------------------------------------------------------------------
  void write(const TwoRods& step) { write(step.first, step.second, step.joint); }
  void write(const RodAndTrack& step) { write(step.rod, step.track, step.joint); }
  void write(const TwoTracks& step) { write(step.first, step.second, step.joint); }
  template <class First, class Second>
  void write(const First& first, const Second& second, int joint) {
    GroupSide a = side(first, joint), b = side(second, joint);
    std::optional<Force> on_a, on_b;
    if (a.link != nothing && b.link != nothing) {
      on_a = inner(a.link, joint, b.link);
      on_b = inner(b.link, joint, a.link);
    }
    // Of a link without loads the polygon is the other's, on which it exerts what it bears itself.
    if (!a.is_loaded && on_b) a.unknown.force = *on_b;
    if (!b.is_loaded && on_a) b.unknown.force = *on_a;
    ForceLoop loop{.letter = letter_of(a, b, joint), .left = {a.unknown}, .right = {}};
    if (a.across) loop.right.push_back(*a.across);
    add_known(loop.right, a.known);
    const std::size_t after_a = loop.right.size();
    add_known(loop.right, b.known);
    if (a.link == nothing && b.link == nothing) {  // a pin alone
      Force borne = held(nothing, joint);
      borne.is_opposite = true;
      std::vector<Force> on_pin{borne};
      for (const Force& force : forces_that_hold(joint))
        if (is_borne(force)) on_pin.push_back(force);
      add_known(loop.right, on_pin);
      group_.bodies.push_back({nothing, on_pin, {a.unknown.force, b.unknown.force}, {}});
    }
    const std::size_t before_b = loop.right.size();
    if (b.across) loop.right.push_back(*b.across);
    loop.right.push_back(b.unknown);
    const std::size_t last = loop.right.size();
    if (a.across) loop.between.push_back({a.unknown.force, last, 1, true});
    if (b.across) loop.between.push_back({b.unknown.force, before_b, last, true});
    if (a.is_loaded && b.is_loaded && on_a) loop.between.push_back({*on_a, after_a, last, false});
    group_.loops.push_back(std::move(loop));
    close_guide(first, joint, on_a);
    close_guide(second, joint, on_b);
  }
  void close_guide(const Rod&, int, const std::optional<Force>&) const {}
  void close_guide(const Track& track, int, const std::optional<Force>& of_joint) {
    if (track.block == nothing) return;
    moments_of_guide(guide_of(track), of_joint ? std::vector<Force>{*of_joint} : std::vector<Force>{});
  }
  std::string letter_of(const GroupSide& a, const GroupSide& b, int joint) const {
    if (a.is_loaded && b.is_loaded) return number(a.link) + "," + number(b.link);
    if (a.is_loaded || b.is_loaded) return number(a.is_loaded ? a.link : b.link);
    return letters(joint);
  }

  void write(const SlotOnPin& step) {
    const bool has_block = step.block != nothing;
    Force slot;
    if (has_block) {
      const Force on_block = guide_between(step.block, step.moving, step.line);
      slot = guide_between(step.link, step.line, step.moving);
      moments_of_guide(on_block, {outer(step.block, step.pin)});
    } else {
      slot = in_slot(step.pin, step.line, step.link, true);
    }
    group_.pressed.push_back({slot, step.line});
    std::vector<ActingCouple> couples = known_couples(step.link);
    for (const Moments& each : group_.moments)
      if (const auto* of_block = std::get_if<ActingCouple>(&each.sought))
        couples.push_back({of_block->kind, of_block->which, slot.is_opposite});
    group_.moments.push_back(
        {step.link, {.point = step.hinge}, arms(known(step.link), {.point = step.hinge}), couples, Arm{slot, {}}});
    add_closed_loop(step.link, step.hinge, {slot});
    if (has_block) add_closed_loop(step.block, step.pin, {guide_between(step.block, step.moving, step.line)});
  }
  void write(const BlockOnPin& step) {
    const Force over = in_slot(step.pin, step.line, step.track.block, true), guide = guide_of(step.track);
    group_.pressed.push_back({over, step.line});
    group_.pressed.push_back({guide, step.track.line});
    add_loop_of_block(guide, over);
    moments_of_guide(guide, {over});
  }
  void write(const CrossedBlock& step) {
    const int block = step.track.block;
    const Force guide = guide_of(step.track), on_block = guide_between(block, step.crossing, step.line),
                on_link = guide_between(step.link, step.line, step.crossing);
    group_.pressed.push_back({on_block, step.line});
    group_.pressed.push_back({guide, step.track.line});
    add_loop_of_block(guide, on_block);
    add_closed_loop(step.link, step.hinge, {on_link});
    std::vector<Force> forces = known(step.link);
    forces.push_back(on_link);
    const ActingCouple between{ActingCouple::Kind::guide, on_link.which, on_link.is_opposite};
    group_.moments.push_back(
        {step.link, {.point = step.hinge}, arms(forces, {.point = step.hinge}), known_couples(step.link), between});
    moments_of_guide(guide, {on_block});
    // What holds the link against turning is a couple on the block too.
    if (auto& last = group_.moments.back(); last.link == block)
      last.couples.push_back({ActingCouple::Kind::guide, on_block.which, on_block.is_opposite});
  }
  void write(const TurnedCrank& step) {
    group_.moments.push_back({step.link,
                              {.point = step.hinge},
                              arms(known(step.link), {.point = step.hinge}),
                              known_couples(step.link),
                              ActingCouple{ActingCouple::Kind::drive, step.drive}});
    if (!known(step.link).empty()) add_closed_loop(step.link, step.hinge, {});
  }
  static void write(const RolledWheel&) {}  // of mechanisms without forces
  void write(const GearedWheel& step) {
    const std::vector<Force> all = forces_on(step.link);
    const Force tooth = *std::find_if(all.begin(), all.end(), [this](const Force& force) {
      return force.kind == Force::Kind::tooth && step_of(force) == now_;
    });
    group_.teeth.push_back(tooth);
    group_.moments.push_back({step.link,
                              {.point = step.hinge},
                              arms(known(step.link), {.point = step.hinge}),
                              known_couples(step.link),
                              Arm{tooth, {}}});
    add_closed_loop(step.link, step.hinge, {tooth});
  }
  void write(const SlidBlock& step) {
    const int block = step.track.block;
    const Force guide = guide_of(step.track), drive = {Force::Kind::slid, step.drive, block, false, step.point};
    group_.pressed.push_back({guide, step.track.line});
    add_loop_of_block(guide, drive);
    moments_of_guide(guide, {drive});
  }
  void write(const SlidPin& step) {
    const int line = std::get<SlidPoint>(of_.drives[index(step.drive)]).guide;
    Force borne = held(nothing, step.point);
    borne.is_opposite = true;
    const Force drive{Force::Kind::slid, step.drive, nothing, false, step.point};
    ForceLoop loop{.letter = letters(step.point), .left = {}, .right = {known_side(borne)}};
    std::vector<Force> known_on_pin{borne};
    for (const Force& force : forces_that_hold(step.point)) {
      if (is_borne(force)) {
        known_on_pin.push_back(force);
        loop.right.push_back(known_side(force));
      } else if (force.kind == Force::Kind::pin && of_.pins[index(force.which)].line == line) {
        loop.left.push_back(unknown_on_line(force));
        group_.pressed.push_back({force, line});
      }
    }
    loop.right.push_back(unknown_on_line(drive));
    group_.bodies.push_back({nothing, known_on_pin, {loop.left.front().force, drive}, {}});
    group_.loops.push_back(std::move(loop));
  }

  const Built& built_;
  const Linkage& of_;
  JointForces<Fast> joints_;
  std::vector<int> placed_, pinned_;  // by which step: links, points
  std::vector<bool> is_loaded_;
  std::map<std::string, int> arm_names_;
  int now_ = 0;
  GroupForces group_;
};

}  // namespace

std::vector<GroupForces> force_groups(const Built& built) {
  if (!built.loads) return {};
  return ForcePlanner(built).all();
}

TwoLinks links_of(const Linkage& linkage, const ActingForce& force) {
  if (force.kind == ActingForce::Kind::tooth) {
    const MeshingLinks& gear = linkage.gears[index(force.which)];
    return {gear.first, gear.second};
  }
  const auto hinge = JointForces<Fast>(linkage).hinges[index(force.which)];
  return {hinge.by, hinge.on};
}

std::vector<ActingForce> forces_that_hold(const Built& built, int point) {
  return ForcePlanner(built).forces_that_hold(point);
}

}  // namespace epure::scenes
