#include "exercises/scenes/extremes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "drawings/text/sheet_words.h"
#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/proof/asked.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/found_by_search.h"
#include "exercises/scenes/range_of_drive.h"
#include "exercises/scenes/scene_routes.h"
#include "geometry/linkages/over_turn.h"

namespace epure::scenes {
namespace {

using namespace geometry;

// What extremes can be asked of: how it is made over a turn, and which quantity tells how fast it changes.
struct Changing {
  Quantity quantity;
  std::variant<CoordinateOfPoint, DirectionOfLink> of;
  bool is_rate;
  std::string slope;

  bool is_angle() const { return std::holds_alternative<DirectionOfLink>(of) && !is_rate; }
};

std::vector<Changing> changing_quantities(const Built& built) {
  std::vector<Changing> all;
  for (int p = 0; p < built.linkage.count_of_points(); ++p) {
    if (built.linkage.links_at(p).front() == 0) continue;
    const std::string& P = built.letters.points[index(p)];
    const VectorQuantity v = velocity(P), a = acceleration(P);
    const PointQuantity at = point(P);
    all.push_back({at.x(), CoordinateOfPoint{p, true}, false, v.x().name});
    all.push_back({at.y(), CoordinateOfPoint{p, false}, false, v.y().name});
    all.push_back({v.x(), CoordinateOfPoint{p, true}, true, a.x().name});
    all.push_back({v.y(), CoordinateOfPoint{p, false}, true, a.y().name});
  }
  const auto* driven = std::get_if<TurnedLink>(&built.linkage.drives.front());
  for (std::size_t i = 1; i < built.linkage.links.size(); ++i) {
    const int link = static_cast<int>(i), number = built.letters.links[i];
    if (driven && driven->link == link) continue;
    all.push_back({link_angle(number), DirectionOfLink{link}, false, angular_velocity(number).name});
    all.push_back({angular_velocity(number), DirectionOfLink{link}, true, angular_acceleration(number).name});
  }
  return all;
}

int number_of_drive(const Built& built) {
  return built.letters.links[index(std::get<TurnedLink>(built.linkage.drives.front()).link)];
}

Quantity extreme_of(const Built& built, const Quantity& of, bool is_greatest) {
  const int drive = number_of_drive(built);
  return {extreme_name(of.name, is_greatest), symbol_of_extreme(of.symbol, is_greatest), of.unit,
          is_greatest ? format_words("greatest over a turn of link {}: {}", "massima in un giro del membro {}: {}",
                                     drive, of.meaning)
                      : format_words("least over a turn of link {}: {}", "minima in un giro del membro {}: {}", drive,
                                     of.meaning)};
}
Quantity place_of(const Built& built, const Quantity& of, bool is_greatest) {
  const Quantity extreme = extreme_of(built, of, is_greatest), drive = link_angle(number_of_drive(built));
  return {place_of_extreme(of.name, is_greatest), drive.symbol + "(" + extreme.symbol + ")", "deg",
          format_words("direction of link {} where {} is {}", "direzione del membro {} dove {} è {}",
                       number_of_drive(built), of.name,
                       is_greatest ? Words{"greatest", "massima"} : Words{"least", "minima"})};
}

// An extreme and where it is, by one route.
struct Found {
  Settled value, place;
};

bool is_zero(const Settled& settled) {
  return settled.kind == Settled::Kind::certain && settled.enclosure.lower == 0 && settled.enclosure.upper == 0;
}
std::optional<Bounded> bounds(const Settled& settled) {
  if (settled.kind != Settled::Kind::certain && settled.kind != Settled::Kind::enclosed) return {};
  return Bounded(settled.enclosure.lower, settled.enclosure.upper);
}

// The mechanism with its drive somewhere else, turning steadily; and what the ledger says of it there.
class Elsewhere {
 public:
  Elsewhere(const Built& built, const Changing& changing)
      : built_(built), plan_(route_plan(built)), quantity_(changing.quantity.name), slope_(changing.slope) {
    TurnedLink& drive = drive_of(built_);
    drive.alpha = {};
    if (!changing.is_rate) drive.omega = {0, 1};  // how fast it turns does not matter to places
  }

  // By one route, with the drive at this part of a turn: the quantity, and how fast it changes.
  Settled value(const Rational& turns, const std::string& route) { return at(turns, route, quantity_, Rung::climb); }
  Settled slope(const Rational& turns, const std::string& route) { return at(turns, route, slope_, Rung::climb); }
  // Bounds of that, where it is not zero as near as it takes to tell its sign; none where that is not found.
  std::optional<Bounded> rough_slope(const Rational& turns, const std::string& route) {
    const auto in_doubles = bounds(at(turns, route, slope_, Rung::bounded));
    return in_doubles && sign(*in_doubles) != Sign::undecided ? in_doubles : bounds(slope(turns, route));
  }
  Bounded omega() { return radians<Bounded>(drive_of(built_).omega); }

 private:
  static TurnedLink& drive_of(Built& built) { return std::get<TurnedLink>(built.linkage.drives.front()); }

  Settled at(const Rational& turns, const std::string& route, const std::string& name, Rung rung) const {
    auto there = std::make_shared<Built>(built_);
    drive_of(*there).angle = {turns, 0};
    const std::vector<std::string> names{name};
    const Asked asked(names);
    for (const RouteValue& value : by_both_routes(there, plan_, rung))
      if (value.route == route && value.quantity == name) return value.settled;
    return undecided({});
  }

  Built built_;
  std::shared_ptr<const RoutePlan> plan_;
  std::string quantity_, slope_;
};

// By equations of joints: the slope changes its sign between two places so near each other that the quantity cannot
// change by more than its slope allows. `near`: where the construction has it, in turns of the drive.
Found by_sign_of_slope(Elsewhere& elsewhere, const std::string& route, double near) {
  const Arithmetic<Bounded> scope;
  const Bounded turn = Bounded(2) * pi<Bounded>();
  for (const double part_of_turn : {0x1p-40, 0x1p-30, 0x1p-20}) {
    const Rational middle(near), apart(part_of_turn);
    const auto before = elsewhere.rough_slope(middle - apart, route),
               after = elsewhere.rough_slope(middle + apart, route);
    if (!before || !after || sign(*before * *after) != Sign::negative) continue;
    const auto value = bounds(elsewhere.value(middle, route));
    if (!value) continue;
    const Bounded slope = CGAL::max(CGAL::abs(*before), CGAL::abs(*after)),
                  reach = quotient(slope, CGAL::abs(elsewhere.omega())) * turn * from_rational<Bounded>(apart);
    const Rational full(360);
    return {known(enclosure(widened(*value, Bounded(reach.sup()))), "Bounded"),
            known(enclosure(widened(from_rational<Bounded>(full * middle), from_rational<Bounded>(full * apart))),
                  "Bounded")};
  }
  const Words open{"whether it changes its sense where the construction has it",
                   "se lì dove la costruzione la trova cambi senso"};
  return {undecided(open), undecided(open)};
}

bool does_not_close(Elsewhere& elsewhere, double turns, const std::string& route) {
  try {
    elsewhere.value(Rational(turns), route);
  } catch (const NotClosed&) {
    return true;
  }
  return false;
}

// By equations of joints: in many places of the drive it grows, or in all it falls.
bool is_nowhere_stationary(Elsewhere& elsewhere, const std::string& route) {
  const Arithmetic<Bounded> scope;
  constexpr int places = 24;
  bool grows = true, falls = true;
  for (int k = 0; k < places; ++k) {
    const auto slope = elsewhere.rough_slope(Rational(k, places), route);
    grows = grows && slope && sign(*slope) == Sign::positive;
    falls = falls && slope && sign(*slope) == Sign::negative;
  }
  return grows || falls;
}

// Where an extreme is at a plain part of a turn that can be proved: exactly there.
std::optional<Found> at_plain_place(Elsewhere& elsewhere, const std::string& route, const Settled& place) {
  constexpr int parts = 48;  // 7.5°
  const int part = static_cast<int>(std::lround(place.enclosure.value * parts / 360));
  const double nearest = part * (360.0 / parts);
  if (place.enclosure.lower > nearest || place.enclosure.upper < nearest) return {};
  const Rational there(part, parts);
  if (!is_zero(elsewhere.slope(there, route))) return {};
  return Found{
      elsewhere.value(there, route),
      {.kind = Settled::Kind::certain, .enclosure = {nearest, nearest, nearest}, .reason = {}, .rung = "Exact"}};
}

// Turns of an angle that one route counts and another does not.
Settled with_turns_of(Settled settled, const Settled& other) {
  const double turns = 360 * std::round((other.enclosure.value - settled.enclosure.value) / 360);
  if (turns == 0) return settled;
  const Arithmetic<Bounded> scope;
  const Bounded moved = Bounded(settled.enclosure.lower, settled.enclosure.upper) + Bounded(turns);
  return known(enclosure(moved), settled.rung);
}

class OfChanging {
 public:
  OfChanging(const Built& built, const EveryPlace& places, const Changing& changing)
      : built_(built),
        places_(places),
        changing_(changing),
        number_(over_turn(places, built.linkage, built.steps, changing.of, changing.is_rate)) {}

  // In a scope of Arithmetic<Bounded>.
  void put(std::vector<RouteValue>& all, Rung rung) const {
    const auto put_undecided = [&](const Words& why, bool is_greatest) {
      for (const char* route : {construction, joint_equations})
        add(all, is_greatest, route, {undecided(why), undecided(why)});
    };
    try {
      const std::vector<StationaryPlace> found = stationary_places(number_);
      for (const bool is_greatest : {true, false}) put_found(all, is_greatest, foremost(found, is_greatest), rung);
    } catch (const Undecided& open) {
      for (const bool is_greatest : {true, false}) put_undecided(open.words(), is_greatest);
    } catch (const NotEverywhere& gap) {
      put_absent(all, rung,
                 format_words("link {} does not turn right round: the mechanism does not close everywhere",
                              "il membro {} non fa il giro completo: il meccanismo non si chiude dappertutto",
                              number_of_drive(built_)),
                 gap.angle);
    } catch (const Impossible& none) {
      put_absent(all, rung, none.words());
    }
  }

 private:
  static constexpr const char *construction = "construction", *joint_equations = "joint equations";

  void put_found(std::vector<RouteValue>& all, bool is_greatest, const std::vector<StationaryPlace>& places,
                 Rung rung) const {
    std::vector<Found> found;
    for (const StationaryPlace& place : places)
      found.push_back(rung == Rung::fast || rung == Rung::bounded ? in_doubles(place) : by_many_bits(place));
    Found first = foremost_of(std::move(found), is_greatest);
    if (rung == Rung::fast || rung == Rung::bounded || rung == Rung::drawing)
      return add(all, is_greatest, construction, first);
    Elsewhere elsewhere(built_, changing_);
    const bool is_one = first.place.kind == Settled::Kind::certain || first.place.kind == Settled::Kind::enclosed;
    if (const auto exactly = is_one ? at_plain_place(elsewhere, construction, first.place) : std::nullopt) {
      first.place = exactly->place;
      if (!changing_.is_angle()) first.value = exactly->value;
    }
    const double near = is_one ? first.place.enclosure.value : in_doubles(places.front()).place.enclosure.value;
    Found second = by_sign_of_slope(elsewhere, joint_equations, near / 360);
    if (changing_.is_angle()) second.value = with_turns_of(second.value, first.value);
    if (!is_one) second.place = first.place;
    add(all, is_greatest, construction, first);
    add(all, is_greatest, joint_equations, second);
  }

  // `gap`: where the construction does not close, by the angle of EveryPlace; or nowhere.
  void put_absent(std::vector<RouteValue>& all, Rung rung, const Words& why, std::optional<double> gap = {}) const {
    const Settled none{.kind = Settled::Kind::absent, .enclosure = {}, .reason = why};
    for (const bool is_greatest : {true, false}) add(all, is_greatest, construction, {none, none});
    if (rung != Rung::climb) return;
    Elsewhere elsewhere(built_, changing_);
    const bool is_so = gap ? does_not_close(elsewhere, of_drive(*gap) / (2 * std::numbers::pi), joint_equations)
                           : is_nowhere_stationary(elsewhere, joint_equations);
    const Settled second = is_so ? none
                                 : undecided({"whether it has no extreme, as the construction has it",
                                              "se non abbia estremi, come risulta dalla costruzione"});
    for (const bool is_greatest : {true, false}) add(all, is_greatest, joint_equations, {second, second});
  }

  Found in_doubles(const StationaryPlace& place) const {
    return {known(enclosure(changing_.is_angle() ? in_degrees(place.at.value) : place.at.value), "Bounded"),
            known(enclosure(of_drive(in_degrees(place.at.angle))), "Bounded")};
  }

  Found by_many_bits(const StationaryPlace& place) const {
    Found found;
    for (const long bits : {128, 256, 512}) {
      const Arithmetic<Deep> scope(bits);
      const Stationary<Deep> at = closed_in(number_, place);
      found = {known(changing_.is_angle() ? in_degrees(at.value) : at.value), known(of_drive(in_degrees(at.angle)))};
      if (found.value.kind == Settled::Kind::certain && found.place.kind == Settled::Kind::certain) break;
    }
    return found;
  }

  // Of several that cannot be told apart the value is known, and not where it is; where to the last digit of a double
  // they are one, no place is more so than another.
  static Found foremost_of(std::vector<Found> all, bool is_greatest) {
    const auto ends = [&](const Found& each) {
      const Enclosure& of = each.value.enclosure;
      return is_greatest ? std::pair(of.lower, of.upper) : std::pair(-of.upper, -of.lower);
    };
    const Found first = *std::max_element(
        all.begin(), all.end(), [&](const Found& a, const Found& b) { return ends(a).first < ends(b).first; });
    std::erase_if(all, [&](const Found& each) { return ends(each).second < ends(first).first; });
    if (all.size() == 1) return first;
    Found together = first;
    const bool are_one_double = std::all_of(all.begin(), all.end(), [&](const Found& each) {
      return each.value.kind == Settled::Kind::certain && each.value.enclosure.value == first.value.enclosure.value;
    });
    together.place = are_one_double
                         ? Settled{.kind = Settled::Kind::absent, .enclosure = {}, .reason = in_several_places(all)}
                         : undecided({"it is so in more than one position, or nearly so",
                                      "lo è in più di una posizione, o quasi"});
    for (const Found& each : all)
      if (each.value.enclosure.value != first.value.enclosure.value) {
        together.value.kind = Settled::Kind::enclosed;
        Enclosure& of = together.value.enclosure;
        (is_greatest ? of.upper : of.lower) = is_greatest ? std::max(of.upper, each.value.enclosure.upper)
                                                          : std::min(of.lower, each.value.enclosure.lower);
      }
    return together;
  }

  // In the order of the turn.
  static Words in_several_places(std::vector<Found> all) {
    constexpr int shown = 4;  // figures
    std::sort(all.begin(), all.end(),
              [](const Found& a, const Found& b) { return a.place.enclosure.value < b.place.enclosure.value; });
    const auto listed = [&](Language language) {
      std::string list;
      for (const Found& each : all)
        list += (list.empty() ? "" : ", ") + drawings::number(each.place.enclosure.value, shown, language) + "°";
      return list;
    };
    return {"it is so, to the last digit of a double, in more than one position: " + listed(Language::english),
            "lo è, fino all'ultima cifra di un double, in più di una posizione: " + listed(Language::italian)};
  }

  // The angle of the drive's link, where gears make its turn a part of the whole.
  template <class T>
  T of_drive(const T& angle) const {
    return T(places_.turns()) * angle;
  }

  void add(std::vector<RouteValue>& all, bool is_greatest, const std::string& route, const Found& found) const {
    const Quantity value = extreme_of(built_, changing_.quantity, is_greatest),
                   place = place_of(built_, changing_.quantity, is_greatest);
    if (Asked::for_quantity(value.name)) all.push_back({value.name, route, found.value, value});
    if (Asked::for_quantity(place.name)) all.push_back({place.name, route, found.place, place});
  }

  const Built& built_;
  const EveryPlace& places_;
  const Changing& changing_;
  NumberOverAngle number_;
};

bool is_asked(const std::string& quantity) {
  for (const bool is_greatest : {true, false})
    if (Asked::for_quantity(extreme_name(quantity, is_greatest)) ||
        Asked::for_quantity(place_of_extreme(quantity, is_greatest)))
      return true;
  return false;
}

}  // namespace

std::vector<std::string> with_extremes(const Built& built) {
  std::vector<std::string> names;
  for (const Quantity& coordinate : driven_coordinates(built)) names.push_back(coordinate.name);
  if (built.linkage.drives.size() > 1 || !std::holds_alternative<TurnedLink>(built.linkage.drives.front()))
    return names;
  for (const Changing& changing : changing_quantities(built)) names.push_back(changing.quantity.name);
  return names;
}

bool is_rate(const Built& built, const std::string& quantity) {
  const std::vector<Changing> all = changing_quantities(built);
  return std::any_of(all.begin(), all.end(),
                     [&](const Changing& each) { return each.quantity.name == quantity && each.is_rate; });
}

std::string symbol_of_extreme(const std::string& symbol, bool is_greatest) {
  const std::string which = is_greatest ? "max" : "min", end = "}$";
  if (!symbol.ends_with(end)) return symbol.substr(0, symbol.size() - 1) + "_{" + which + end;
  return symbol.substr(0, symbol.size() - end.size()) + "," + which + end;
}
std::string extreme_name(const std::string& quantity, bool is_greatest) {
  return quantity + (is_greatest ? "_max" : "_min");
}
std::string place_of_extreme(const std::string& quantity, bool is_greatest) {
  return extreme_name(quantity, is_greatest) + "_at";
}

std::vector<RouteValue> extremes(const Built& built, const std::vector<std::string>& names, Rung rung) {
  std::vector<RouteValue> all = ranges(built, names, rung);
  const auto is_set = [&](const std::string& name) { return drive_of_coordinate(built, name).has_value(); };
  if (std::all_of(names.begin(), names.end(), is_set)) return all;
  const EveryPlace places(built.linkage, built.steps);
  for (const Changing& changing : changing_quantities(built)) {
    const std::string& name = changing.quantity.name;
    if (std::find(names.begin(), names.end(), name) == names.end() || !is_asked(name)) continue;
    if (rung == Rung::names) {
      for (const bool is_greatest : {true, false})
        for (const Quantity& each :
             {extreme_of(built, changing.quantity, is_greatest), place_of(built, changing.quantity, is_greatest)})
          for (const char* route : {"construction", "joint equations"}) all.push_back({each.name, route, {}, each});
      continue;
    }
    const Arithmetic<Bounded> scope;
    OfChanging(built, places, changing).put(all, rung);
  }
  return all;
}

}  // namespace epure::scenes
