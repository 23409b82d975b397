#include "exercises/scenes/range_of_drive.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/proof/asked.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/extremes.h"
#include "exercises/scenes/file/refusals.h"
#include "exercises/scenes/found_by_search.h"
#include "exercises/scenes/scene_routes.h"
#include "exercises/scenes/scene_states.h"
#include "geometry/linkages/drive_range.h"

namespace epure::scenes {
namespace {

using namespace geometry;

Quantity end_of_range(const Quantity& of, bool is_greatest) {
  const Words what =
      is_greatest ? Words{"greatest at which the mechanism closes: ", "massimo con cui il meccanismo si chiude: "}
                  : Words{"least at which the mechanism closes: ", "minimo con cui il meccanismo si chiude: "};
  return {extreme_name(of.name, is_greatest), symbol_of_extreme(of.symbol, is_greatest), of.unit, what + of.meaning};
}

// The mechanism with a drive elsewhere: as the range has it, radians or metres.
Built with_drive_at(const Built& built, std::size_t drive, double at) {
  Built there = built;
  Drive& moved = there.linkage.drives[drive];
  put(moved, Rational(std::holds_alternative<TurnedLink>(moved) ? at / (2 * pi<Fast>()) : at));
  return there;
}

Words endless_in_words(const Built& built, std::size_t drive, double farthest) {
  if (const auto* turned = std::get_if<TurnedLink>(&built.linkage.drives[drive]))
    return format_words("link {} goes right round: the mechanism closes everywhere",
                        "il membro {} fa il giro completo: il meccanismo si chiude dappertutto",
                        built.letters.links[index(turned->link)]);
  if (farthest == 0)
    return {"the mechanism closes until the cylinder has no length left",
            "il meccanismo si chiude finché il cilindro non ha più lunghezza"};
  return {"the mechanism closes, farther off than all its links in one line would reach",
          "il meccanismo si chiude, più lontano di quanto arriverebbero tutti i suoi membri su una retta"};
}

// How far apart that sets the pins of two rods in one line: "A B0 = A B + B0 B".
Words distance_in_words(const Built& there, const Step& step, const LinkagePosition<Bounded>& at) {
  const auto* rods = std::get_if<TwoRods>(&step);
  if (!rods) return {};
  const int P = rods->first.pin, Q = rods->second.pin, X = rods->joint;
  const auto squared = [&](int from, int to) {
    return midpoint(length_squared(at.points[index(to)] - at.points[index(from)])).inf();
  };
  const auto letters = [&](int from, int to) {
    return "$" + point_letters(there.letters.points[index(from)]) + point_letters(there.letters.points[index(to)]) +
           "$";
  };
  const double first = squared(P, X), second = squared(Q, X), apart = squared(P, Q);
  const bool is_stretched = apart > std::max(first, second), first_is_longer = first > second;
  if (is_stretched)
    return format_words(": {} = {} + {}", ": {} = {} + {}", letters(P, Q), letters(P, X), letters(Q, X));
  return format_words(": {} = {} − {}", ": {} = {} − {}", letters(P, Q),
                      first_is_longer ? letters(P, X) : letters(Q, X),
                      first_is_longer ? letters(Q, X) : letters(P, X));
}

class RangeOfDrive {
 public:
  RangeOfDrive(const Built& built, std::size_t drive)
      : built_(built),
        drive_(static_cast<int>(drive)),
        coordinate_(driven_coordinates(built)[drive]),
        range_(built.linkage, built.steps, drive_) {}

  // In a scope of Arithmetic<Bounded>.
  void put(std::vector<RouteValue>& all, Rung rung) const {
    std::optional<DriveEnd<Bounded>> ends[2];
    try {
      for (const bool is_greatest : {true, false}) ends[is_greatest ? 1 : 0] = range_.end(is_greatest);
    } catch (const Undecided& open) {
      return put_both(all, undecided(open.words()));
    } catch (const Impossible& none) {
      return put_both(all, undecided(none.words()));
    }
    const double turns = whole_turns_off(ends[0]);
    for (const bool is_greatest : {true, false}) {
      const std::optional<DriveEnd<Bounded>>& end = ends[is_greatest ? 1 : 0];
      if (end)
        put_end(all, rung, is_greatest, *end, turns);
      else
        put_endless(all, rung, is_greatest);
    }
  }

 private:
  static constexpr const char *construction = "construction", *joint_equations = "joint equations";

  bool turns() const { return std::holds_alternative<TurnedLink>(built_.linkage.drives[index(drive_)]); }
  // The least is told between -180° and 180°, the greatest is counted on from there.
  double whole_turns_off(const std::optional<DriveEnd<Bounded>>& least) const {
    if (!turns() || !least) return 0;
    return -std::ceil(midpoint(in_degrees(least->at)).inf() / 360 - 0.5);
  }
  template <class T>
  T told(const T& at, double turns_more) const {
    return turns() ? in_degrees(at) + from_rational<T>(Rational(360 * turns_more)) : at;
  }

  void put_both(std::vector<RouteValue>& all, const Settled& settled) const {
    for (const bool is_greatest : {true, false})
      for (const char* route : {construction, joint_equations}) add(all, is_greatest, route, settled);
  }

  void put_end(std::vector<RouteValue>& all, Rung rung, bool is_greatest, const DriveEnd<Bounded>& end,
               double turns_more) const {
    if (rung == Rung::fast || rung == Rung::bounded)
      return add(all, is_greatest, construction, known(enclosure(told(end.at, turns_more)), "Bounded"));
    Settled first = undecided({}), second = first;
    for (const long bits : {128, 256, 512}) {
      const Arithmetic<Deep> scope(bits);
      const DriveEnd<Deep> closed = range_.closed_in(end);
      if (first.kind != Settled::Kind::certain) first = known(told(closed.at, turns_more));
      if (rung == Rung::drawing) break;
      if (second.kind != Settled::Kind::certain) second = by_joints(closed, turns_more);
      if (first.kind == Settled::Kind::certain && second.kind == Settled::Kind::certain) break;
    }
    add(all, is_greatest, construction, first);
    if (rung != Rung::drawing) add(all, is_greatest, joint_equations, second);
  }

  // Of what is constructed the place where to begin.
  Settled by_joints(const DriveEnd<Deep>& end, double turns_more) const {
    const Built there = with_drive_at(built_, index(drive_), enclosure(end.at).value);
    analytic::Beginning<Deep> beginning;
    for (const PlacedLink<Deep>& link : range_.position_at(end).links)
      beginning.push_back(
          {{link.O.x, link.O.y}, {}, {}, Deep(0), Deep(0), Deep(0), analytic::Complex<Deep>{link.x.x, link.x.y}});
    add_turns_of_wheels(there, beginning);
    try {
      return known(
          told(analytic::place_of_drive<Deep>(there.linkage, drive_,
                                              analytic::solve_dead_point<Deep>(there.linkage, drive_, beginning)),
               turns_more));
    } catch (const Undecided& open) {
      return undecided(open.words());
    }
  }

  void put_endless(std::vector<RouteValue>& all, Rung rung, bool is_greatest) const {
    const double farthest = range_.farthest(is_greatest);
    const Settled none{
        .kind = Settled::Kind::absent, .enclosure = {}, .reason = endless_in_words(built_, index(drive_), farthest)};
    add(all, is_greatest, construction, none);
    if (rung != Rung::climb) return;
    add(all, is_greatest, joint_equations,
        closes_on_the_way(farthest)
            ? none
            : undecided({"whether it closes wherever the drive is, as the construction has it",
                         "se si chiuda dovunque sia il movente, come risulta dalla costruzione"}));
  }
  // By the equations of the joints, in many places.
  bool closes_on_the_way(double farthest) const {
    constexpr int places = 24;
    for (int k = 1; k < places; ++k) {
      const double part = static_cast<double>(k) / places, at = range_.now() + part * (farthest - range_.now());
      const Built there = with_drive_at(built_, index(drive_), at);
      try {
        analytic::solve_joints<Bounded>(there.linkage, beginning(there, Constructed<Bounded>(there)));
      } catch (const Undecided&) {
        return false;
      } catch (const Impossible&) {
        return false;
      }
    }
    return true;
  }

  void add(std::vector<RouteValue>& all, bool is_greatest, const char* route, const Settled& settled) const {
    const Quantity end = end_of_range(coordinate_, is_greatest);
    if (Asked::for_quantity(end.name)) all.push_back({end.name, route, settled, end});
  }

  const Built& built_;
  int drive_;
  Quantity coordinate_;
  DriveRange range_;
};

}  // namespace

std::vector<Quantity> driven_coordinates(const Built& built) {
  const auto letter = [&](int p) { return built.letters.points[index(p)]; };
  std::vector<Quantity> all;
  for (const Drive& drive : built.linkage.drives) {
    if (const auto* turned = std::get_if<TurnedLink>(&drive)) {
      all.push_back(link_angle(built.letters.links[index(turned->link)]));
    } else if (const auto* slid = std::get_if<SlidPoint>(&drive)) {
      const std::string A = letter(slid->point), &g = built.letters.lines[index(slid->guide)];
      all.push_back({"s_" + A, "$s_{" + point_letters(A) + "}$", "m",
                     format_words("how far {} is ahead on {}", "quanto {} sta avanti su {}", A, g)});
    } else {
      const auto& cylinder = std::get<Stretched>(drive);
      const std::string P = letter(cylinder.from), Q = letter(cylinder.to);
      all.push_back({"l_" + P + Q, "$l_{" + point_letters(P) + point_letters(Q) + "}$", "m",
                     format_words("length of the cylinder {0} {1}", "lunghezza del cilindro {0} {1}", P, Q)});
    }
  }
  return all;
}

std::optional<std::size_t> drive_of_coordinate(const Built& built, const std::string& name) {
  const std::vector<Quantity> all = driven_coordinates(built);
  const auto found = std::find_if(all.begin(), all.end(), [&](const Quantity& each) { return each.name == name; });
  if (found == all.end()) return {};
  return static_cast<std::size_t>(found - all.begin());
}

std::vector<RouteValue> ranges(const Built& built, const std::vector<std::string>& names, Rung rung) {
  std::vector<RouteValue> all;
  const std::vector<Quantity> coordinates = driven_coordinates(built);
  for (std::size_t drive = 0; drive < coordinates.size(); ++drive) {
    const std::string& name = coordinates[drive].name;
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    if (rung == Rung::names) {
      for (const bool is_greatest : {true, false})
        for (const char* route : {"construction", "joint equations"}) {
          const Quantity end = end_of_range(coordinates[drive], is_greatest);
          all.push_back({end.name, route, {}, end});
        }
      continue;
    }
    if (!Asked::for_quantity(extreme_name(name, true)) && !Asked::for_quantity(extreme_name(name, false))) continue;
    const Arithmetic<Bounded> scope;
    RangeOfDrive(built, drive).put(all, rung);
  }
  return all;
}

AtEnd at_end(const Built& built, std::size_t drive, bool is_greatest) {
  const Arithmetic<Bounded> scope;
  try {
    const DriveRange range(built.linkage, built.steps, static_cast<int>(drive));
    const auto end = range.end(is_greatest);
    if (!end)
      return {{},
              Words{"No end: ", "Nessun estremo: "} + endless_in_words(built, drive, range.farthest(is_greatest))};
    const Built there = with_drive_at(built, drive, midpoint(end->at).inf());
    const auto at = range.position_at(*end);
    const auto* rods = std::get_if<TwoRods>(&there.steps[end->step]);
    return {at,
            special_in_words(end->step, there, LettersAs::rich_text) +
                distance_in_words(there, there.steps[end->step], at),
            rods ? std::optional(*rods) : std::nullopt};
  } catch (const Undecided& open) {
    return {{}, Words{"Not decided: ", "Non deciso: "} + open.words()};
  } catch (const Impossible& none) {
    return {{}, Words{"Not decided: ", "Non deciso: "} + none.words()};
  }
}

}  // namespace epure::scenes
