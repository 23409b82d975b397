#include "exercises/scenes/sheets/motion_steps.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "exercises/scenes/dyad_equations.h"
#include "exercises/scenes/links_alike.h"
#include "exercises/scenes/sheets/polygon_sheets.h"

namespace epure::scenes {
namespace {

using namespace geometry;

class MotionWriter {
 public:
  MotionWriter(const Built& built, bool is_of_velocities, const SheetNumbers& numbers)
      : built_(built), alike_(built), is_of_velocities_(is_of_velocities), numbers_(numbers) {}

  std::vector<MotionStep> all() {
    const std::vector<DyadEquation> equations = dyad_equations(built_);
    for (const Step& step : built_.steps) {
      if (const auto* crank = std::get_if<TurnedCrank>(&step)) add_turned(crank->link, crank->hinge);
      if (const auto* wheel = std::get_if<GearedWheel>(&step)) add_geared(*wheel);
      if (const auto* wheel = std::get_if<RolledWheel>(&step)) add_rolled(*wheel);
      if (const auto* crossed = std::get_if<CrossedBlock>(&step)) add_crossed(*crossed);
      for (std::size_t i = 0; i < equations.size(); ++i)
        if (equations[i].links == numbers_of(placed_by(step))) {
          add_polygon(equations, i);
          if (const auto* on_pin = std::get_if<BlockOnPin>(&step)) add_block_on_pin(*on_pin, equations, i);
        }
      add_blocks(step);
      for (const int link : placed_by(step)) placed_.push_back(link);
    }
    return std::move(steps_);
  }

 private:
  const Linkage& linkage() const { return built_.linkage; }
  std::vector<int> numbers_of(const std::vector<int>& links) const {
    std::vector<int> all;
    for (const int link : links) all.push_back(number(link));
    return all;
  }
  int number(int link) const { return built_.letters.links[index(link)]; }
  const std::string& name(int p) const { return built_.letters.points[index(p)]; }
  std::string letters(int p) const { return point_letters(name(p)); }
  bool is_fixed(int p) const { return linkage().links_at(p).front() == 0; }
  std::string omega(int link) const { return "$ω_{" + std::to_string(number(link)) + "}$"; }
  std::string omega_squared(int link) const { return "$ω^{2}_{" + std::to_string(number(link)) + "}$"; }
  std::string alpha(int link) const { return "$α_{" + std::to_string(number(link)) + "}$"; }
  std::string rate(int link) const { return is_of_velocities_ ? omega(link) : alpha(link); }
  VectorQuantity vector(int p) const { return is_of_velocities_ ? velocity(name(p)) : acceleration(name(p)); }
  // "P_{13}"
  std::string centre(int one, int other) const {
    const auto [a, b] = std::minmax({number(one), number(other)});
    return "P_{" + std::to_string(a) + (b < 10 ? "" : ",") + std::to_string(b) + "}";
  }
  std::vector<int> others_of(int link, int hinge) const {
    std::vector<int> all;
    for (const LinkPoint& p : linkage().links[index(link)].points)
      if (p.point != hinge && !is_fixed(p.point)) all.push_back(p.point);
    return all;
  }
  // Whether the turning of a block does: it turns as its guide, steadily where a drive turns that so.
  bool speeds_up(int block) const {
    return std::none_of(linkage().drives.begin(), linkage().drives.end(), [&](const Drive& drive) {
      const auto* turned = std::get_if<TurnedLink>(&drive);
      return turned && is_zero(turned->alpha) && alike_.turn_alike(index(turned->link), index(block));
    });
  }
  bool speeds_up() const {
    return std::any_of(linkage().drives.begin(), linkage().drives.end(), [](const Drive& drive) {
      const auto* turned = std::get_if<TurnedLink>(&drive);
      return !turned || !is_zero(turned->alpha);
    });
  }

  // X turns about Q, which rests: "v_A ⊥ OA, |ω₂|·OA".
  void add_velocity_about(const std::string& Q, int X, int link) {
    const std::string arm = "$" + Q + letters(X) + "$";
    const std::string how = vector(X).arrow() + " ⊥ " + arm + ", |" + omega(link) + "|·" + arm + ".";
    steps_.push_back({{how, how}, name(X)});
  }
  // "a_A: ω₂²·OA from A to O"; seen from Q, where that moves.
  void add_acceleration_about(int Q, int X, int link) { add_acceleration_about(Q, X, link, speeds_up()); }
  void add_acceleration_about(int Q, int X, int link, bool grows) {
    const std::string arm = "$" + letters(Q) + letters(X) + "$";
    Words how = is_fixed(Q)
                    ? vector(X).arrow() + Words{": ", ": "}
                    : format_words("{} = {} + {}; the last is ", "{} = {} + {}; l'ultima è ", vector(X).arrow(),
                                   vector(Q).arrow(), acceleration(name(X) + name(Q)).arrow());
    how = how + format_words("{}·{} from ${}$ to ${}$", "{}·{} da ${}$ a ${}$", omega_squared(link), arm, letters(X),
                             letters(Q));
    if (grows) how = how + format_words(", and |{}|·{} ⊥ {}", ", e |{}|·{} ⊥ {}", alpha(link), arm, arm);
    steps_.push_back({how + ".", name(X), is_fixed(Q) ? "" : name(Q)});
  }

  void add_turned(int link, int hinge) {
    if (!is_fixed(hinge)) return;
    for (const int X : others_of(link, hinge))
      if (is_of_velocities_)
        add_velocity_about(letters(hinge), X, link);
      else
        add_acceleration_about(hinge, X, link);
  }
  // A wheel turns at this moment about where it touches one that rests.
  void add_about_touching(int link, int hinge, int resting) {
    const std::string P = centre(resting, link), C = letters(hinge);
    if (is_of_velocities_ && !is_fixed(hinge)) {
      const std::string rate =
          "|" + omega(link) + "| = " + velocity(name(hinge)).length().symbol + " / $" + P + C + "$";
      const Words where = numbers_.of("instant-centres");
      steps_.push_back({where.empty() ? Words{rate + ".", rate + "."}
                                      : rate + format_words(", ${}$: {}.", ", ${}$: {}.", P, where)});
    }
    for (const int X : others_of(link, hinge))
      if (is_of_velocities_)
        add_velocity_about(P, X, link);
      else
        add_acceleration_about(hinge, X, link);
  }
  void add_geared(const GearedWheel& wheel) {
    for (const MeshingLinks& gear : linkage().gears) {
      if (gear.first != wheel.link && gear.second != wheel.link) continue;
      const int other = gear.first == wheel.link ? gear.second : gear.first;
      if (other == 0) return add_about_touching(wheel.link, wheel.hinge, other);
      if (std::find(placed_.begin(), placed_.end(), other) == placed_.end()) continue;
      return add_meshing(wheel, other);
    }
  }
  // Two moving wheels have one velocity where they touch.
  void add_meshing(const GearedWheel& wheel, int other) {
    const std::string P = centre(wheel.link, other);
    const auto about = [&](int link) -> std::string {
      for (const LinkPoint& p : linkage().links[index(link)].points)
        if (is_fixed(p.point)) return letters(p.point);
      return centre(0, link);
    };
    if (is_of_velocities_)
      steps_.push_back(
          {format_words("Both wheels have one velocity at ${0}$: |{1}|·${2}{0}$ = |{3}|·${4}{0}$",
                        "Le due ruote hanno in ${0}$ la stessa velocità: |{1}|·${2}{0}$ = |{3}|·${4}{0}$", P,
                        omega(wheel.link), about(wheel.link), omega(other), about(other)) +
           found_on_sheet(P)});
    for (const int X : others_of(wheel.link, wheel.hinge))
      if (!is_of_velocities_)
        add_acceleration_about(wheel.hinge, X, wheel.link);
      else if (is_fixed(wheel.hinge))
        add_velocity_about(letters(wheel.hinge), X, wheel.link);
  }
  void add_rolled(const RolledWheel& wheel) {
    const int on = linkage().link_of_line(linkage().rolls[index(wheel.roll)].line);
    if (on == 0) return add_about_touching(wheel.link, wheel.hinge, on);
    if (is_fixed(wheel.hinge) && alike_.turn_alike(index(on), 0)) add_turned_by_rack(wheel, on);
  }
  // The end of a sentence on a centre: " (P_25: sheet 6)."
  Words found_on_sheet(const std::string& centre) const {
    const Words where = numbers_.of("instant-centres");
    return where.empty() ? Words{".", "."} : format_words(" (${}$: {}).", " (${}$: {}).", centre, where);
  }
  // All points of the rack move as the one at the pitch line does.
  void add_turned_by_rack(const RolledWheel& wheel, int rack) {
    const auto& points = linkage().links[index(rack)].points;
    if (points.empty()) return;
    const std::string P = centre(rack, wheel.link);
    steps_.push_back(
        {format_words(
             "Link {0} only slides, and link {1} rolls on ${2}$ at ${3}$: |{4}| = {5} / ${3}{6}$",
             "Il membro {0} scorre soltanto, e il membro {1} rotola su ${2}$ in ${3}$: |{4}| = {5} / ${3}{6}$",
             number(rack), number(wheel.link),
             point_letters(built_.letters.lines[index(linkage().rolls[index(wheel.roll)].line)]), P, rate(wheel.link),
             vector(points.front().point).length().symbol, letters(wheel.hinge)) +
         found_on_sheet(P)});
    for (const int X : others_of(wheel.link, wheel.hinge))
      if (is_of_velocities_)
        add_velocity_about(letters(wheel.hinge), X, wheel.link);
      else
        add_acceleration_about(wheel.hinge, X, wheel.link, true);
  }

  // A block slides in a link, and another link on it: all three turn alike.
  void add_crossed(const CrossedBlock& step) {
    const int block = step.track.block, guide = linkage().link_of_line(step.track.line);
    if (guide == 0) return;
    steps_.push_back({format_words(
        "Link {0} only slides in link {1}, and link {2} only on link {0}: {3} = {4} = {5}.",
        "Il membro {0} scorre soltanto nel membro {1}, e il membro {2} soltanto sul membro {0}: {3} = {4} = {5}.",
        number(block), number(guide), number(step.link), rate(step.link), rate(block), rate(guide))});
  }
  void add_blocks(const Step& step) {
    const auto on_track = [&](const Track& track, int joint) {
      if (track.block != nothing && joint != nothing)
        add_block(track.block, linkage().link_of_line(track.line), joint);
    };
    if (const auto* rod = std::get_if<RodAndTrack>(&step)) on_track(rod->track, rod->joint);
    if (const auto* both = std::get_if<TwoTracks>(&step)) {
      on_track(both->first, both->joint);
      on_track(both->second, both->joint);
    }
    if (const auto* lever = std::get_if<SlotOnPin>(&step); lever && lever->block != nothing)
      add_block(lever->block, lever->link, lever->pin);
  }
  // It has the joint X, of which the motion is found.
  void add_block(int block, int guide, int X) {
    const std::vector<int> others = others_of(block, X);
    if (guide == 0) {
      for (const int Y : others) add_sliding_with(block, Y, vector(X).arrow(), {});
      return;
    }
    steps_.push_back({format_words("Link {0} only slides in link {1}: {2} = {3}.",
                                   "Il membro {0} scorre soltanto nel membro {1}: {2} = {3}.", number(block),
                                   number(guide), rate(block), rate(guide))});
    for (const int Y : others)
      if (is_of_velocities_)
        add_velocity_seen_from(X, Y, block);
      else
        add_acceleration_about(X, Y, block, speeds_up(block));
  }
  void add_sliding_with(int block, int Y, const std::string& other, const Words& where) {
    steps_.push_back(
        {format_words("{} = {}: link {} only slides{}.", "{} = {}: il membro {} scorre soltanto{}.",
                      vector(Y).arrow(), other, number(block), where.empty() ? where : Words{", ", ", "} + where),
         name(Y)});
  }
  void add_velocity_seen_from(int X, int Y, int link) {
    const std::string relative = velocity(name(Y) + name(X)).arrow(), arm = "$" + letters(X) + letters(Y) + "$";
    const std::string how = vector(Y).arrow() + " = " + vector(X).arrow() + " + " + relative + ", " + relative +
                            " ⊥ " + arm + ", |" + omega(link) + "|·" + arm + ".";
    steps_.push_back({{how, how}, name(Y), name(X)});
  }
  // A block in the frame, of which the polygon finds how the point under the pin moves.
  void add_block_on_pin(const BlockOnPin& step, const std::vector<DyadEquation>& equations, std::size_t i) {
    const auto& under_pin = (is_of_velocities_ ? equations[i].v_left : equations[i].a_left).front().quantity;
    const Words sheet = numbers_.of(name_of_polygon(equations, i, is_of_velocities_));
    for (const LinkPoint& p : linkage().links[index(step.track.block)].points)
      if (!is_fixed(p.point)) add_sliding_with(step.track.block, p.point, under_pin.arrow(), sheet);
  }

  void add_polygon(const std::vector<DyadEquation>& equations, std::size_t i) {
    const Words sheet = numbers_.of(name_of_polygon(equations, i, is_of_velocities_));
    if (sheet.empty()) return;
    const DyadEquation& equation = equations[i];
    std::vector<std::string> points;
    if (equation.is_joint_found) points.push_back(equation.joint);
    for (const Image& image : equation.images) points.push_back(image.point);
    std::string found;
    const auto add = [&](const std::string& symbol) { found += (found.empty() ? "" : ", ") + symbol; };
    for (const std::string& X : points) add((is_of_velocities_ ? velocity(X) : acceleration(X)).arrow());
    for (const DyadEquation::TurningRod& rod : equation.rods)
      add((is_of_velocities_ ? angular_velocity : angular_acceleration)(rod.link).symbol);
    if (found.empty()) return;  // of a line on a line alone
    steps_.push_back({format_words("{}: by the polygon, {}.", "{}: con il poligono, {}.", found, sheet)});
  }

  const Built& built_;
  LinksAlike alike_;
  bool is_of_velocities_;
  const SheetNumbers& numbers_;
  std::vector<int> placed_ = {};
  std::vector<MotionStep> steps_ = {};
};

}  // namespace

std::vector<MotionStep> motion_steps(const Built& built, bool is_of_velocities, const SheetNumbers& numbers) {
  return MotionWriter(built, is_of_velocities, numbers).all();
}

}  // namespace epure::scenes
