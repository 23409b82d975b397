#include "exercises/scenes/file/refusals.h"

#include <algorithm>
#include <optional>

#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/statement/format_words.h"

namespace epure::scenes {
namespace {

using namespace geometry;

class InLetters {
 public:
  explicit InLetters(const Built& built, LettersAs as = LettersAs::plain) : built_(built), as_(as) {}

  std::string point(int p) const { return written(built_.letters.points[index(p)]); }
  std::string line(int l) const { return written(built_.letters.lines[index(l)]); }
  // "link 3", "links 3 and 4".
  Words links(const std::vector<int>& links) const {
    std::vector<std::string> numbers;
    for (const int link : links)
      if (link != nothing) numbers.push_back(std::to_string(built_.letters.links[index(link)]));
    return (numbers.size() == 1 ? Words{"link ", "membro "} : Words{"links ", "membri "}) + enumerated(numbers);
  }
  Words points(const std::vector<int>& points) const {
    std::vector<std::string> names;
    for (const int p : points)
      if (std::find(names.begin(), names.end(), point(p)) == names.end()) names.push_back(point(p));
    std::sort(names.begin(), names.end());
    return enumerated(names);
  }

  // What may be said under assembly:, one way and the other.
  std::pair<std::string, std::string> choices(const OpenSide& side) const {
    const auto both = [](const std::string& of, const std::string& one, const std::string& other) {
      return std::pair{of + ": " + one, of + ": " + other};
    };
    switch (side.kind) {
      case OpenSide::Kind::beside_line: {
        const std::string between = " of " + point(side.from) + " " + point(side.to);
        return both(point(side.joint), "left" + between, "right" + between);
      }
      case OpenSide::Kind::on_guide:
        return both(point(side.joint), "ahead on " + line(side.line), "behind on " + line(side.line));
      case OpenSide::Kind::along_slot:
        break;
    }
    const std::string from = "from " + point(side.from) + " ";
    return both(line(side.line), from + "towards " + point(side.to), from + "away from " + point(side.to));
  }

  Words open(const OpenSide& side) const {
    const auto [one, other] = choices(side);
    Words where;
    switch (side.kind) {
      case OpenSide::Kind::beside_line:
        where = format_words("{0} may lie on either side of {1} -> {2}",
                             "{0} può stare da una parte o dall'altra di {1} -> {2}", point(side.joint),
                             point(side.from), point(side.to));
        break;
      case OpenSide::Kind::on_guide:
        where = format_words("{} may lie ahead or behind on {}", "{} può stare avanti o indietro su {}",
                             point(side.joint), line(side.line));
        break;
      case OpenSide::Kind::along_slot:
        where = format_words("{} may point from {} towards {} or away",
                             "{} può puntare da {} verso {} o dall'altra parte", line(side.line), point(side.from),
                             point(side.to));
    }
    return where + format_words(": say under assembly:  {}  or  {}", ": dire sotto assembly:  {}  o  {}", one, other);
  }

  Words open(const std::vector<OpenSide>& sides) const {
    if (sides.size() == 1) return open(sides.front());
    Words all = format_words("{} joints may lie in two places each: say under assembly:",
                             "{} nodi possono stare in due posti ciascuno: dire sotto assembly:", sides.size());
    for (const OpenSide& side : sides) {
      const auto [one, other] = choices(side);
      all = all + format_words("{}  {}  or  {}", "{}  {}  o  {}", &side == &sides.front() ? "" : ";", one, other);
    }
    return all;
  }

  Words overconstrained(const NotPlaced& open) const {
    if (open.links.size() == 1)
      return format_words("{} hangs on more than it can follow ({}): the mechanism cannot move",
                          "{} è vincolato più di quanto possa seguire ({}): il meccanismo non si muove",
                          links(open.links), points(open.points));
    return format_words("{} hang on more than they can follow ({}): the mechanism cannot move",
                        "{} sono vincolati più di quanto possano seguire ({}): il meccanismo non si muove",
                        links(open.links), points(open.points));
  }

  Words free(const NotPlaced& open) const {
    const Words held = open.links.size() == 1
                           ? format_words("{} is not held", "{} non è trattenuto", links(open.links))
                           : format_words("{} are not held", "{} non sono trattenuti", links(open.links));
    return held +
           (open.freedom == 1 ? Words{": a drive or joint is missing", ": manca un movente o un vincolo"}
                              : format_words(": {} more drives or joints are missing",
                                             ": mancano ancora {} moventi o vincoli", open.freedom)) +
           forgotten(open.links);
  }
  // What may have been left out or mistyped, where `links` are not held: a line on which nothing slides, letters that
  // stand on one link only.
  Words forgotten(const std::vector<int>& links) const {
    Words slides;
    const std::vector<int> unused = unused_lines();
    for (const int guide : unused)
      if (const auto what = sliding_on(guide, links, unused); slides.empty() && what)
        slides = format_words("; nothing slides on {0}: say under slides:  {1}: {0}",
                              "; su {0} nulla scorre: dire sotto slides:  {1}: {0}", line(guide), *what);
    return slides.empty() ? lone_letters(links) : slides;
  }

  Words not_dyadic(const NotPlaced& open) const {
    const Words all = open.links.size() == 1 ? format_words("{} cannot be placed on what stands at {}",
                                                            "{} non si può disporre su quanto sta in {}",
                                                            links(open.links), points(open.points))
                                             : format_words(
                                                   "{} move only together, on what stands at {}: ruler and compass "
                                                   "place groups of one or two links only",
                                                   "{} si muovono solo insieme, su quanto sta in {}: riga e compasso "
                                                   "dispongono solo gruppi di uno o due membri",
                                                   links(open.links), points(open.points));
    if (has_rolling(open.links))
      return all +
             Words{"; a wheel follows what it rolls on: drive its centre, or the rack, and not the wheel",
                   "; una ruota segue ciò su cui rotola: muovere il suo centro, o la cremagliera, e non la ruota"};
    const Stretched* cylinder = within(open.links);
    if (!cylinder) return all;
    const int driven = built_.linkage.links_at(cylinder->from).front();
    return all + format_words(
                     "; the cylinder {0} {1} lies between two of them: drive one by its angle instead, as  drive: "
                     "{{link: {2}, angle: ..., speed: ...}}",
                     "; il cilindro {0} {1} sta fra due di essi: muoverne invece uno con il suo angolo, come  drive: "
                     "{{link: {2}, angle: ..., speed: ...}}",
                     point(cylinder->from), point(cylinder->to), built_.letters.links[index(driven)]);
  }

 private:
  std::vector<int> unused_lines() const {
    std::vector<int> all;
    const Linkage& of = built_.linkage;
    for (int l = 0; l < of.count_of_lines(); ++l) {
      const bool is_used =
          std::any_of(of.pins.begin(), of.pins.end(), [&](const PinOnLine& pin) { return pin.line == l; }) ||
          std::any_of(of.blocks.begin(), of.blocks.end(),
                      [&](const LineOnLine& each) { return each.moving == l || each.guide == l; });
      if (!is_used) all.push_back(l);
    }
    return all;
  }
  // A line of one of the links that nothing uses either, or its last letter that is not another's already.
  std::optional<std::string> sliding_on(int guide, const std::vector<int>& links,
                                        const std::vector<int>& unused) const {
    const Linkage& of = built_.linkage;
    const int on = of.link_of_line(guide);
    std::optional<std::string> best;
    for (const int link : links) {
      if (link == on) continue;
      for (const int l : unused)
        if (of.link_of_line(l) == link) return line(l);
      for (const LinkPoint& p : of.links[index(link)].points)
        if (of.links_at(p.point).size() == 1) best = point(p.point);
    }
    return best;
  }
  Words lone_letters(const std::vector<int>& links) const {
    const Linkage& of = built_.linkage;
    std::vector<std::string> lone;
    for (std::size_t i = 0; i < of.links.size(); ++i) {
      const int link = static_cast<int>(i);
      if (link != 0 && std::find(links.begin(), links.end(), link) == links.end()) continue;
      for (const LinkPoint& p : of.links[i].points)
        if (of.links_at(p.point).size() == 1)
          lone.push_back(point(p.point) + " (" + std::to_string(built_.letters.links[i]) + ")");
    }
    if (lone.size() < 2) return {};
    return format_words(
        "; {} stand on one link each (its number behind): links hang on each other where they have the same letter",
        "; {} stanno su un membro solo (il suo numero dopo): i membri si incernierano dove hanno la stessa lettera",
        enumerated(lone));
  }
  bool has_rolling(const std::vector<int>& links) const {
    const auto& rolls = built_.linkage.rolls;
    return std::any_of(rolls.begin(), rolls.end(), [&](const RollingWheel& roll) {
      return std::find(links.begin(), links.end(), roll.wheel) != links.end();
    });
  }
  // A cylinder both ends of which are of these links alone.
  const Stretched* within(const std::vector<int>& links) const {
    const auto is_one = [&](int point) {
      const std::vector<int> there = built_.linkage.links_at(point);
      return std::all_of(there.begin(), there.end(),
                         [&](int link) { return std::find(links.begin(), links.end(), link) != links.end(); });
    };
    for (const Drive& drive : built_.linkage.drives)
      if (const auto* cylinder = std::get_if<Stretched>(&drive))
        if (is_one(cylinder->from) && is_one(cylinder->to)) return cylinder;
    return nullptr;
  }

  std::string written(const std::string& name) const {
    return as_ == LettersAs::plain ? name : "$" + point_letters(name) + "$";
  }

  const Built& built_;
  LettersAs as_;
};

// To four figures: enough to see what to change.
Words metres(double x) { return decimal(x, 4) + " m"; }

// Where a step fails, to tell by how much: with as many bits as that takes, for it may be far less than what it is a
// difference of. Within deeply().
class Missing {
 public:
  Missing(const Built& built, std::size_t step, LettersAs as = LettersAs::plain)
      : built_(built), told_(built, as), at_(CarriedOut<Deep>(built.linkage, built.steps).position_before(step)) {}

  Words at(const TwoRods& step) const {
    const Deep a = length_of(step.first, step.joint), b = length_of(step.second, step.joint);
    const Deep apart = distance(step.first.pin, step.second.pin);
    const bool is_too_far = is_positive(apart - a - b);
    return format_words("{}: {} and {} do not meet, for {} {} is {}, {} too {}",
                        "{}: {} e {} non si incontrano, poiché {} {} è {}, {} {}", told_.point(step.joint),
                        rod(step.first, step.joint, a), rod(step.second, step.joint, b), told_.point(step.first.pin),
                        told_.point(step.second.pin), metres(apart),
                        missing(is_too_far ? apart - a - b : size_of(a - b) - apart),
                        is_too_far ? Words{"far", "di troppo"} : Words{"near", "di meno del necessario"});
  }

  Words at(const RodAndTrack& step) const {
    const Deep length = length_of(step.rod, step.joint);
    const Point<Deep>& P = at_.points[index(step.rod.pin)];
    const auto [G, s] = in_plane(step.track.line);
    const Deep away = size_of(cross(s, P - G) - offset(step.track, step.joint));
    return format_words("{}: {} does not reach {}, which is {} away from {}: {} are missing",
                        "{}: {} non raggiunge {}, che dista {} da {}: mancano {}", told_.point(step.joint),
                        rod(step.rod, step.joint, length), told_.line(step.track.line), metres(away),
                        told_.point(step.rod.pin), missing(away - length));
  }

  // What is special where it closes without room to move.
  Words at_limit(const TwoRods& step) const {
    const Rational a2 = squared_length(step.first, step.joint), b2 = squared_length(step.second, step.joint);
    const std::string P = told_.point(step.first.pin), Q = told_.point(step.second.pin), X = told_.point(step.joint);
    // The difference of the rods, or their sum.
    const bool is_stretched =
        is_positive(square(distance(step.first.pin, step.second.pin)) - from_rational<Deep>(std::max(a2, b2)));
    if (a2 == b2 && !is_stretched)
      return format_words("{0} and {1} lie in one place, and {0} {2} is as long as {1} {2}",
                          "{0} e {1} stanno in un punto, e {0} {2} è lungo quanto {1} {2}", P, Q, X);
    return format_words(
        "{0} {2} and {1} {2} lie in one line, {3}", "{0} {2} e {1} {2} stanno su una retta, {3}", P, Q, X,
        is_stretched ? Words{"stretched out", "l'uno dopo l'altro"}
                     : format_words("folded, with {} between", "l'uno sull'altro, con {} in mezzo", a2 > b2 ? Q : P));
  }
  Words at_limit(const RodAndTrack& step) const {
    return format_words("{} {} stands square to {}", "{} {} sta normale a {}", told_.point(step.rod.pin),
                        told_.point(step.joint), told_.line(step.track.line));
  }
  Words at_limit(const TwoTracks& step) const {
    return format_words("{} and {} are parallel", "{} e {} sono parallele", told_.line(step.first.line),
                        told_.line(step.second.line));
  }
  Words at_limit(const SlotOnPin& step) const {
    return format_words("{} is as near to {} as {} lets it come", "{} è vicino a {} quanto {} permette",
                        told_.point(step.pin), told_.point(step.hinge), told_.line(step.line));
  }
  template <class WithoutLimit>
  static Words at_limit(const WithoutLimit&) {
    return {};
  }

 private:
  static Words metres(const Deep& x) { return epure::scenes::metres(to_double(x)); }
  static bool is_positive(const Deep& x) {
    const Sign decided = sign(x);
    if (decided == Sign::undecided)
      throw Undecided("by how much a joint does not close", "di quanto un nodo non si chiuda");
    return decided == Sign::positive;
  }
  // However little: all figures that are told are its own.
  static Words missing(const Deep& x) {
    const Enclosure known = enclosure(x);
    if (!is_positive(x) || known.upper - known.lower > 1e-6 * known.lower)
      throw Undecided("by how much a joint does not close", "di quanto un nodo non si chiuda");
    return epure::scenes::metres(known.value);
  }
  static Deep size_of(const Deep& x) { return is_positive(x) ? x : -x; }
  Deep distance(int one, int other) const {
    return root(length_squared(at_.points[index(other)] - at_.points[index(one)]));
  }
  Rational squared_length(const Rod& rod, int joint) const {
    if (rod.link == nothing) {
      const Rational& length = std::get<Stretched>(built_.linkage.drives[index(rod.cylinder)]).length;
      return length * length;
    }
    const Own &P = built_.linkage.place(rod.link, rod.pin), &X = built_.linkage.place(rod.link, joint);
    return (X.x - P.x) * (X.x - P.x) + (X.y - P.y) * (X.y - P.y);
  }
  Deep length_of(const Rod& rod, int joint) const { return root(from_rational<Deep>(squared_length(rod, joint))); }
  Words rod(const Rod& rod, int joint, const Deep& length) const {
    return told_.point(rod.pin) + " " + told_.point(joint) + " (" + metres(length) + ")";
  }
  std::pair<Point<Deep>, Vector<Deep>> in_plane(int line) const {
    const LinkLine& own = built_.linkage.line(line);
    const PlacedLink<Deep>& link = at_.links[index(built_.linkage.link_of_line(line))];
    return {link.at(vector(own.through)), link.turned(linkages::unit_vector<Deep>(own.along))};
  }
  // How far left of its guide the joint of a block stays.
  Deep offset(const Track& track, int joint) const {
    if (track.block == nothing) return Deep(0);
    const LinkLine& own = built_.linkage.line(track.moving);
    return cross(linkages::unit_vector<Deep>(own.along),
                 vector(built_.linkage.place(track.block, joint)) - vector(own.through));
  }
  static Vector<Deep> vector(const Own& own) { return {from_rational<Deep>(own.x), from_rational<Deep>(own.y)}; }

  const Built& built_;
  InLetters told_;
  LinkagePosition<Deep> at_;
};

// The joint of a step, by its letter.
std::string joint_of(const Step& step, const InLetters& told) {
  return std::visit(
      [&](const auto& s) -> std::string {
        if constexpr (requires { s.joint; })
          return told.point(s.joint);
        else if constexpr (requires { s.pin; })
          return told.point(s.pin);
        else if constexpr (requires { s.hinge; })
          return told.point(s.hinge);
        else
          return told.point(s.point);
      },
      step);
}

}  // namespace

Words enumerated(const std::vector<std::string>& names) {
  Words all;
  for (std::size_t i = 0; i < names.size(); ++i)
    all = all + (i == 0 ? Words{} : i + 1 == names.size() ? Words{" and ", " e "} : Words{", ", ", "}) + names[i];
  return all;
}

Words in_words(const NotPlaced& open, const Built& built) {
  using Why = NotPlaced::Why;
  const InLetters told(built);
  switch (open.why) {
    case Why::overconstrained:
      return told.overconstrained(open);
    case Why::freedom:
      return told.free(open);
    case Why::not_dyadic:
      return told.not_dyadic(open);
    case Why::open_sides:
      return told.open(open.sides);
    case Why::contradicting_side:
      break;
  }
  return {};
}

Words in_words(const NotClosed& open, const Built& built) {
  const Step& step = built.steps[open.step];
  const auto missing = [&](const auto& at) { return deeply([&] { return Missing(built, open.step).at(at); }); };
  try {
    if (const auto* rods = std::get_if<TwoRods>(&step)) return missing(*rods);
    if (const auto* rod = std::get_if<RodAndTrack>(&step)) return missing(*rod);
  } catch (const Undecided&) {
    // a step before is at its limit
  }
  return in_words_at_limit(open, built);
}

Words special_in_words(std::size_t step, const Built& built, LettersAs as) {
  return joint_of(built.steps[step], InLetters(built, as)) + ": " + deeply([&] {
           return std::visit([&](const auto& s) { return Missing(built, step, as).at_limit(s); }, built.steps[step]);
         });
}

Words limit_in_words(std::size_t step, const Built& built) {
  const std::vector<int> links = placed_by(built.steps[step]);
  const Words whose = links.empty() ? Words{} : " (" + InLetters(built).links(links) + ")";
  return special_in_words(step, built, LettersAs::plain) +
         format_words(": at this dead centre or change point the drive does not determine the motion{}",
                      ": in questo punto morto o di biforcazione il movente non determina il moto{}", whose);
}

Words in_words_at_limit(const NotClosed& open, const Built& built) {
  return joint_of(built.steps[open.step], InLetters(built)) + ": " + open.words();
}

}  // namespace epure::scenes
