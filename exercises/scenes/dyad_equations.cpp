#include "exercises/scenes/dyad_equations.h"

#include <algorithm>
#include <cctype>

#include "exercises/kit/statement/format_words.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Source = VectorSource::Kind;

// "k_{1}" of K1.
std::string small(const std::string& point) {
  std::string letters = point;
  for (char& c : letters) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return point_letters(letters);
}

// Names, letters and meanings.
class Vectors {
 public:
  explicit Vectors(const Built& built) : built_(built) {}

  const std::string& point(int p) const { return built_.letters.points[index(p)]; }
  const std::string& line(int l) const { return built_.letters.lines[index(l)]; }
  int number(int link) const { return built_.letters.links[index(link)]; }
  bool is_fixed(int point) const { return built_.linkage.links_at(point).front() == 0; }

  // "BA": B seen from A. Where that names something else, too, "B_A".
  std::string seen_from(const std::string& X, const std::string& P) const {
    int readings = 0;
    for (const std::string& one : built_.letters.points) {
      if (one == X + P) ++readings;
      for (const std::string& other : built_.letters.points)
        if (one + other == X + P) ++readings;
    }
    return readings == 1 ? X + P : X + "_" + P;
  }

  enum class Part { whole, normal, tangential, stretching, coriolis };
  // Of X seen from P, or of X alone where P rests.
  VectorQuantity relative(int X, int P, bool is_velocity, Part part) const {
    const bool is_alone = is_fixed(P);
    const Words of = is_alone ? format_words(" of {}", " di {}", point(X))
                              : format_words(" of {} relative to {}", " di {} rispetto a {}", point(X), point(P));
    return vector(is_alone ? point(X) : seen_from(point(X), point(P)), is_alone ? point(X) : point(X) + point(P), of,
                  is_velocity, part);
  }
  // The same of a cylinder from P, which may rest.
  VectorQuantity of_cylinder(int X, int P, bool is_velocity, Part part) const {
    return vector(seen_from(point(X), point(P)), point(X) + point(P),
                  format_words(" of {} relative to {}", " di {} rispetto a {}", point(X), point(P)), is_velocity,
                  part);
  }
  // The point of link j under X: "X*".
  std::string star(int X, int j) const { return point(X) + stars(X, j); }
  VectorQuantity on_link(int X, int j, bool is_velocity, Part part = Part::whole) const {
    return vector(
        point(X) + "_on_" + std::to_string(number(j)), star(X, j),
        format_words(" of the point of link {} under {}", " del punto del membro {} sotto {}", number(j), point(X)),
        is_velocity, part);
  }
  // The same seen from the link's moving point Q.
  VectorQuantity on_link_seen_from(int X, int j, int Q, bool is_velocity, Part part) const {
    return vector(point(X) + "_on_" + std::to_string(number(j)) + "_" + point(Q), star(X, j) + point(Q),
                  format_words(" of the point of link {} under {} relative to {}",
                               " del punto del membro {} sotto {} rispetto a {}", number(j), point(X), point(Q)),
                  is_velocity, part);
  }
  VectorQuantity sliding(int X, int j, bool is_velocity, Part part = Part::whole) const {
    return vector(point(X) + "_rel_" + std::to_string(number(j)), point(X) + star(X, j),
                  format_words(" of {} relative to link {}", " di {} rispetto al membro {}", point(X), number(j)),
                  is_velocity, part);
  }

 private:
  // A point may slide on two moving links: then the second one's has two stars.
  std::string stars(int X, int j) const {
    std::vector<int> before;
    const auto slides_on = [&](int link) {
      if (link != 0 && link < j) before.push_back(link);
    };
    for (const PinOnLine& pin : built_.linkage.pins)
      if (pin.point == X) slides_on(built_.linkage.link_of_line(pin.line));
    const std::vector<int> links = built_.linkage.links_at(X);
    for (const LineOnLine& block : built_.linkage.blocks)
      for (const auto& [own, other] : {std::pair(block.moving, block.guide), {block.guide, block.moving}})
        if (std::find(links.begin(), links.end(), built_.linkage.link_of_line(own)) != links.end())
          slides_on(built_.linkage.link_of_line(other));
    return std::string(before.size() + 1, '*');
  }

  static VectorQuantity vector(const std::string& name, const std::string& letters, const Words& of, bool is_velocity,
                               Part part) {
    Words what = is_velocity ? Words{"velocity", "velocità"} : Words{"acceleration", "accelerazione"};
    std::string ending, script;
    switch (part) {
      case Part::whole:
        break;
      case Part::normal:
        what = {"normal part of the acceleration", "parte normale dell'accelerazione"};
        ending = "_n", script = "n";
        break;
      case Part::tangential:
        what = is_velocity ? Words{"velocity across the cylinder", "velocità trasversale al cilindro"}
                           : Words{"tangential part of the acceleration", "parte tangenziale dell'accelerazione"};
        ending = "_t", script = "t";
        break;
      case Part::stretching:
        what = is_velocity ? Words{"velocity along the cylinder", "velocità lungo il cilindro"}
                           : Words{"acceleration along the cylinder", "accelerazione lungo il cilindro"};
        ending = "_s", script = "s";
        break;
      case Part::coriolis:
        what = {"Coriolis acceleration", "accelerazione di Coriolis"};
        ending = "_c", script = "c";
        break;
    }
    const std::string letter = is_velocity ? "v" : "a";
    return {letter + "_" + name + ending,
            script.empty() ? letter + "_{{{}}}" : letter + "^{{" + script + "}}_{{{}}}",
            letters,
            is_velocity ? "m/s" : "m/s^2",
            what + of,
            what + of};
  }

  const Built& built_;
};

using Part = Vectors::Part;

// What one side of a joint says of it, in the order in which it is drawn; the last is unknown.
struct Chain {
  std::vector<Term> v, a;
};

class Writer {
 public:
  explicit Writer(const Built& built) : built_(built), of_(built) {}

  std::vector<DyadEquation> all() {
    std::vector<DyadEquation> equations;
    for (const Step& step : built_.steps)
      if (auto equation = std::visit([this](const auto& s) { return write(s); }, step)) {
        for (const int link : placed_by(step)) equation->links.push_back(of_.number(link));
        equations.push_back(std::move(*equation));
      }
    return equations;
  }

 private:
  using Found = std::optional<DyadEquation>;
  const Linkage& linkage() const { return built_.linkage; }
  const std::string& name(int p) const { return of_.point(p); }
  std::string letters(int p) const { return point_letters(name(p)); }
  std::string omega(int link) const { return "$ω_{" + std::to_string(of_.number(link)) + "}$"; }
  std::string omega_squared(int link) const { return "$ω^{2}_{" + std::to_string(of_.number(link)) + "}$"; }
  std::string alpha(int link) const { return "$α_{" + std::to_string(of_.number(link)) + "}$"; }
  std::string tip(int p) const { return in_mathematics(small(name(p)) + "'"); }
  std::string starred_tip(int p, int link) const {
    const std::string star = of_.star(p, link);
    return in_mathematics(small(name(p)) + star.substr(name(p).size()));
  }

  // A hinge of the link that rests.
  std::optional<int> pivot(int link) const {
    for (const LinkPoint& p : linkage().links[index(link)].points)
      if (of_.is_fixed(p.point)) return p.point;
    return {};
  }
  // A link with a pivot that carries the point.
  std::optional<std::pair<int, int>> turning_with(int point) const {
    for (const int link : linkage().links_at(point))
      if (const auto O = pivot(link)) return std::pair{link, *O};
    return {};
  }
  // Whether the turning of a link grows; none where neither a drive, nor gears nor rolling turn it.
  std::optional<bool> speeds_up(int link) const {
    const auto grows = [&](std::size_t drive) {
      const auto* turned = std::get_if<TurnedLink>(&linkage().drives[drive]);
      return turned && !is_zero(turned->alpha);
    };
    for (std::size_t k = 0; k < linkage().drives.size(); ++k)
      if (const auto* turned = std::get_if<TurnedLink>(&linkage().drives[k]); turned && turned->link == link)
        return grows(k);
    for (const Step& step : built_.steps)
      if (const auto* wheel = std::get_if<RolledWheel>(&step); wheel && wheel->link == link) return true;
    for (const Step& step : built_.steps)
      if (const auto* wheel = std::get_if<GearedWheel>(&step); wheel && wheel->link == link) {
        bool any = false;
        for (std::size_t k = 0; k < linkage().drives.size(); ++k)
          any = any || (wheel->turn.times[k] != 0 && grows(k));
        return any;
      }
    return {};
  }

  // --- what is known of a pin ------------------------------------------------------------------------------------
  void add_known_pin(Chain& chain, int P) const {
    if (of_.is_fixed(P)) return;
    const auto turning = turning_with(P);
    if (turning) {
      const auto [link, O] = *turning;
      const std::string rod = "$" + letters(O) + letters(P) + "$";
      chain.v.push_back({velocity(name(P)), "⊥ " + rod, "|" + omega(link) + "|·" + rod, tip(P)});
      if (const auto known = speeds_up(link)) {
        const bool grows = *known;
        chain.a.push_back({of_.relative(P, O, false, Part::normal), "∥ $" + letters(P) + letters(O) + "$",
                           omega_squared(link) + "·" + rod, grows ? "" : tip(P),
                           VectorSource{.kind = Source::rod_normal, .point = P, .link = link, .about = O}});
        Term tangential{of_.relative(P, O, false, Part::tangential), grows ? "⊥ " + rod : "–",
                        grows ? "|" + alpha(link) + "|·" + rod : "0", tip(P),
                        VectorSource{.kind = Source::rod_tangential, .point = P, .link = link, .about = O}};
        tangential.is_square = true;
        chain.a.push_back(std::move(tangential));
        return;
      }
    } else {
      chain.v.push_back(found_before(velocity(name(P)), "v", P));
    }
    chain.a.push_back(found_before(acceleration(name(P)), "a", P));
  }
  // Its image stands in a polygon drawn before.
  Term found_before(const VectorQuantity& quantity, const std::string& origin, int P) const {
    Term known{quantity, {}, {}, tip(P)};
    known.found_before = name(P);
    for (const PinOnLine& pin : linkage().pins)
      if (pin.point == P && linkage().link_of_line(pin.line) == 0) {
        known.direction = "∥ $" + point_letters(of_.line(pin.line)) + "$";
        known.magnitude = quantity.length().symbol;
        return known;
      }
    known.magnitude = "$O_{" + origin + "}" + small(name(P)) + "'$";
    known.direction = "∥ " + known.magnitude;
    return known;
  }

  // --- the sides -------------------------------------------------------------------------------------------------
  Chain rod(int link, int P, int X) const {
    Chain chain;
    add_known_pin(chain, P);
    const bool is_alone = of_.is_fixed(P);
    const std::string along = "$" + letters(X) + letters(P) + "$";
    chain.v.push_back(unknown_across(
        {is_alone ? velocity(name(X)) : of_.relative(X, P, true, Part::whole), "⊥ " + along, "?", tip(X)}, P, X));
    if (!is_alone)
      chain.v.back().source = VectorSource{.kind = Source::rod_velocity, .point = X, .link = link, .about = P};
    chain.a.push_back({of_.relative(X, P, false, Part::normal), "∥ " + along, omega_squared(link) + "·" + along, "",
                       VectorSource{.kind = Source::rod_normal, .point = X, .link = link, .about = P}});
    chain.a.push_back(
        unknown_across({of_.relative(X, P, false, Part::tangential), "⊥ " + along, "?", tip(X),
                        VectorSource{.kind = Source::rod_tangential, .point = X, .link = link, .about = P}},
                       P, X));
    chain.a.back().is_square = true;
    return chain;
  }
  Term unknown_across(Term term, int P, int X) const {
    term.across_from = name(P);
    term.across_to = name(X);
    return term;
  }

  Chain cylinder(int drive, int P, int X) const {
    Chain chain;
    add_known_pin(chain, P);
    const std::string along = "$" + letters(P) + letters(X) + "$";
    const auto source = [&](Source kind) {
      return VectorSource{.kind = kind, .point = X, .about = P, .drive = drive};
    };
    const auto of = [&](bool is_velocity, Part part) { return of_.of_cylinder(X, P, is_velocity, part); };
    chain.v.push_back(
        {of(true, Part::stretching), "∥ " + along, "d" + along + "/d$t$", "", source(Source::stretch_velocity)});
    chain.v.push_back(unknown_across(
        {of(true, Part::tangential), "⊥ " + along, "?", tip(X), source(Source::swing_velocity)}, P, X));
    const std::string swing = of(true, Part::tangential).length().symbol;
    chain.a.push_back(
        {of(false, Part::normal), "∥ " + along, swing + "²/" + along, "", source(Source::stretch_normal)});
    const bool speeds_up = std::get<Stretched>(linkage().drives[index(drive)]).acceleration != 0;
    chain.a.push_back({of(false, Part::stretching), speeds_up ? "∥ " + along : "–",
                       speeds_up ? "d²" + along + "/d$t$²" : "0", "", source(Source::stretch_acceleration)});
    chain.a.push_back({of(false, Part::coriolis), "⊥ " + along,
                       "2" + swing + "·" + of(true, Part::stretching).length().symbol + "/" + along, "",
                       source(Source::stretch_coriolis)});
    chain.a.push_back(unknown_across(
        {of(false, Part::tangential), "⊥ " + along, "?", tip(X), source(Source::swing_acceleration)}, P, X));
    return chain;
  }
  Chain side(const Rod& one, int X) const {
    return one.link == nothing ? cylinder(one.cylinder, one.pin, X) : rod(one.link, one.pin, X);
  }

  // X slides along a line of link j.
  Chain track(int line, int X) const {
    const int j = linkage().link_of_line(line);
    const std::string along = "∥ $" + point_letters(of_.line(line)) + "$";
    Chain chain;
    if (j == 0) {
      chain.v.push_back(unknown_along({velocity(name(X)), along, "?", tip(X)}, line));
      chain.a.push_back(unknown_along({acceleration(name(X)), along, "?", tip(X)}, line));
      return chain;
    }
    add_point_under(chain, j, X);
    const auto source = [&](Source kind) { return VectorSource{.kind = kind, .point = X, .link = j, .line = line}; };
    chain.v.push_back(
        unknown_along({of_.sliding(X, j, true), along, "?", tip(X), source(Source::sliding_velocity)}, line));
    chain.a.push_back(
        {of_.sliding(X, j, false, Part::coriolis), across(line), coriolis(X, j), "", source(Source::coriolis)});
    chain.a.push_back(
        unknown_along({of_.sliding(X, j, false), along, "?", tip(X), source(Source::sliding_acceleration)}, line));
    return chain;
  }
  std::string across(int line) const { return "⊥ $" + point_letters(of_.line(line)) + "$"; }
  std::string coriolis(int X, int j) const {
    return "2|" + omega(j) + "|·" + of_.sliding(X, j, true).length().symbol;
  }
  Term unknown_along(Term term, int line) const {
    term.along_line = of_.line(line);
    return term;
  }
  // The point of link j where X is, j being placed already.
  void add_point_under(Chain& chain, int j, int X) const {
    const std::string end = starred_tip(X, j);
    const VectorSource v{.kind = Source::on_link_velocity, .point = X, .link = j},
        a{.kind = Source::on_link_acceleration, .point = X, .link = j};
    const auto O = pivot(j);
    if (!O) {
      const auto image = [&](const char* origin) { return "$O_{" + std::string(origin) + "}" + end.substr(1); };
      chain.v.push_back({of_.on_link(X, j, true), "∥ " + image("v"), image("v"), end, v});
      chain.a.push_back({of_.on_link(X, j, false), "∥ " + image("a"), image("a"), end, a});
      return;
    }
    const std::string rod = "$" + letters(*O) + letters(X) + "$", back = "$" + letters(X) + letters(*O) + "$";
    chain.v.push_back({of_.on_link(X, j, true), "⊥ " + rod, "|" + omega(j) + "|·" + rod, end, v});
    chain.a.push_back({of_.on_link(X, j, false, Part::normal), "∥ " + back, omega_squared(j) + "·" + rod, "",
                       VectorSource{.kind = Source::rod_normal, .point = X, .link = j, .about = *O}});
    const auto grows = speeds_up(j);
    const bool is_none = grows && !*grows;
    if (is_none) chain.a.back().tip = end;
    chain.a.push_back({of_.on_link(X, j, false, Part::tangential), is_none ? "–" : "⊥ " + rod,
                       is_none ? "0" : "|" + alpha(j) + "|·" + rod, end,
                       VectorSource{.kind = Source::rod_tangential, .point = X, .link = j, .about = *O}});
    chain.a.back().is_square = true;
  }

  // The point of the slotted link i under its pin P: i turns about Q, which is placed.
  Chain lever(int i, int Q, int P) const {
    Chain chain;
    add_known_pin(chain, Q);
    const bool is_alone = of_.is_fixed(Q);
    const std::string along = "$" + letters(P) + letters(Q) + "$", end = starred_tip(P, i);
    const auto source = [&](Source kind) { return VectorSource{.kind = kind, .point = P, .link = i, .about = Q}; };
    const auto of = [&](bool is_velocity, Part part) {
      return is_alone ? of_.on_link(P, i, is_velocity, part) : of_.on_link_seen_from(P, i, Q, is_velocity, part);
    };
    chain.v.push_back(
        unknown_across({of(true, Part::whole), "⊥ " + along, "?", end, source(Source::rod_velocity)}, Q, P));
    chain.a.push_back(
        {of(false, Part::normal), "∥ " + along, omega_squared(i) + "·" + along, "", source(Source::rod_normal)});
    chain.a.push_back(
        unknown_across({of(false, Part::tangential), "⊥ " + along, "?", end, source(Source::rod_tangential)}, Q, P));
    chain.a.back().is_square = true;
    return chain;
  }
  // The same point seen from the pin, which slides in the line: less what the pin has beside it.
  Chain from_pin(int i, int line, int P, bool turns) const {
    Chain chain;
    add_known_pin(chain, P);
    const std::string along = "∥ $" + point_letters(of_.line(line)) + "$";
    const auto source = [&](Source kind) { return VectorSource{.kind = kind, .point = P, .link = i, .line = line}; };
    const auto less = [&](Term term) {
      term.is_subtracted = true;
      return term;
    };
    chain.v.push_back(less(unknown_along(
        {of_.sliding(P, i, true), along, "?", starred_tip(P, i), source(Source::sliding_velocity)}, line)));
    if (turns)
      chain.a.push_back(less(
          {of_.sliding(P, i, false, Part::coriolis), across(line), coriolis(P, i), "", source(Source::coriolis)}));
    chain.a.push_back(less(unknown_along(
        {of_.sliding(P, i, false), along, "?", starred_tip(P, i), source(Source::sliding_acceleration)}, line)));
    return chain;
  }

  // --- the steps -------------------------------------------------------------------------------------------------
  DyadEquation equation(int joint, Chain left, Chain right) const {
    // With two corners of one name, the letters stand once.
    for (auto* chain : {&left.v, &left.a}) chain->back().tip.clear();
    DyadEquation written{.joint = name(joint),
                         .is_joint_found = true,
                         .v_left = std::move(left.v),
                         .v_right = std::move(right.v),
                         .a_left = std::move(left.a),
                         .a_right = std::move(right.a),
                         .images = {},
                         .sums = {},
                         .links = {},
                         .rates_from_velocities = {},
                         .rates_from_accelerations = {},
                         .rods = {}};
    return written;
  }
  void add_sum(DyadEquation& to, int X) const {
    const bool is_side =
        to.v_left.size() == 1 && to.v_left[0].quantity.name == velocity(name(X)).name && to.a_left.size() == 1;
    if (!is_side) to.sums.push_back(name(X));
  }
  void add_rates(DyadEquation& to, int link, int P, int X, const VectorQuantity& v, const VectorQuantity& a_t) const {
    const std::string far = "$" + letters(P) + letters(X) + "$";
    to.rates_from_velocities.push_back("|" + omega(link) + "| = " + v.length().symbol + " / " + far);
    to.rates_from_accelerations.push_back("|" + alpha(link) + "| = " + a_t.length().symbol + " / " + far);
    to.rods.push_back({of_.number(link), name(P), name(X)});
  }
  void add_rates(DyadEquation& to, const Rod& rod, int X) const {
    if (rod.link == nothing) return;
    const bool is_alone = of_.is_fixed(rod.pin);
    add_rates(to, rod.link, rod.pin, X, is_alone ? velocity(name(X)) : of_.relative(X, rod.pin, true, Part::whole),
              of_.relative(X, rod.pin, false, Part::tangential));
    add_images(to, rod.link, rod.pin, X, tip(X));
  }
  // Of the link's other points, from those of P and X.
  void add_images(DyadEquation& to, int link, int P, int X, const std::string& image_of_X) const {
    const auto inner = [](const std::string& mathematics) { return mathematics.substr(1, mathematics.size() - 2); };
    const Own& at_P = linkage().place(link, P);
    for (const LinkPoint& p : linkage().links[index(link)].points) {
      if (p.point == P || p.point == X || of_.is_fixed(p.point)) continue;
      bool is_in_line = false;
      const auto& points = linkage().links[index(link)].points;
      const auto on_link =
          std::find_if(points.begin(), points.end(), [&](const LinkPoint& q) { return q.point == X; });
      if (on_link != points.end()) {
        const Rational ux = on_link->at.x - at_P.x, uy = on_link->at.y - at_P.y;
        is_in_line = ux * (p.at.y - at_P.y) == uy * (p.at.x - at_P.x);
      } else {
        is_in_line = slot_runs_through(link, P, X, p.at);
      }
      to.images.push_back({name(p.point), letters(P) + letters(X) + letters(p.point),
                           of_.is_fixed(P) ? "" : inner(tip(P)), inner(image_of_X), inner(tip(p.point)), is_in_line});
    }
  }
  // A slotted link whose slot runs through its hinge P and this place, and its pin X is in line with both.
  bool slot_runs_through(int link, int P, int X, const Own& place) const {
    const auto& lines = linkage().links[index(link)].lines;
    return std::any_of(lines.begin(), lines.end(), [&](const LinkLine& line) {
      return is_on(line, linkage().place(link, P)) && is_on(line, place) && pin_is_on(line.line, X);
    });
  }
  static bool is_on(const LinkLine& line, const Own& place) {
    const auto* s = std::get_if<Own>(&line.along);
    return s && s->x * (place.y - line.through.y) == s->y * (place.x - line.through.x);
  }
  // The pin itself, or the block whose hinge it is, with its line through that.
  bool pin_is_on(int line, int X) const {
    for (const PinOnLine& pin : linkage().pins)
      if (pin.line == line && pin.point == X) return true;
    for (const LineOnLine& block : linkage().blocks)
      for (const auto& [one, other] : {std::pair(block.moving, block.guide), {block.guide, block.moving}}) {
        if (one != line) continue;
        const int on = linkage().link_of_line(other);
        const auto links = linkage().links_at(X);
        if (std::find(links.begin(), links.end(), on) != links.end())
          return is_on(linkage().line(other), linkage().place(on, X));
      }
    return false;
  }

  Found write(const TwoRods& step) const {
    // Right stands what is driven: a cylinder, or else the rod whose pin moves.
    const bool first_is_right =
        step.first.link == nothing || (step.second.link != nothing && !of_.is_fixed(step.first.pin));
    const Rod &right = first_is_right ? step.first : step.second, &left = first_is_right ? step.second : step.first;
    DyadEquation written = equation(step.joint, side(left, step.joint), side(right, step.joint));
    add_sum(written, step.joint);
    add_rates(written, right, step.joint);
    add_rates(written, left, step.joint);
    return written;
  }
  Found write(const RodAndTrack& step) const {
    const bool track_is_right =
        of_.is_fixed(step.rod.pin) && step.rod.link != nothing && linkage().link_of_line(step.track.line) != 0;
    Chain of_rod = side(step.rod, step.joint), of_track = track(step.track.line, step.joint);
    DyadEquation written = track_is_right ? equation(step.joint, std::move(of_rod), std::move(of_track))
                                          : equation(step.joint, std::move(of_track), std::move(of_rod));
    add_sum(written, step.joint);
    add_rates(written, step.rod, step.joint);
    return written;
  }
  Found write(const TwoTracks& step) const {
    if (step.joint == nothing) return {};
    const bool first_is_right = linkage().link_of_line(step.first.line) != 0;
    const Track &right = first_is_right ? step.first : step.second, &left = first_is_right ? step.second : step.first;
    DyadEquation written = equation(step.joint, track(left.line, step.joint), track(right.line, step.joint));
    add_sum(written, step.joint);
    return written;
  }
  Found write(const SlotOnPin& step) const {
    DyadEquation written =
        equation(step.pin, lever(step.link, step.hinge, step.pin), from_pin(step.link, step.line, step.pin, true));
    written.is_joint_found = false;
    const bool is_alone = of_.is_fixed(step.hinge);
    const auto of = [&](bool is_velocity, Part part) {
      return is_alone ? of_.on_link(step.pin, step.link, is_velocity, part)
                      : of_.on_link_seen_from(step.pin, step.link, step.hinge, is_velocity, part);
    };
    add_rates(written, step.link, step.hinge, step.pin, of(true, Part::whole), of(false, Part::tangential));
    add_images(written, step.link, step.hinge, step.pin, starred_tip(step.pin, step.link));
    return written;
  }
  Found write(const BlockOnPin& step) const {
    const int i = step.track.block, guide_of = linkage().link_of_line(step.track.line);
    if (guide_of != 0) return {};  // the guide carries it round: two slidings in one equation
    const std::string along = "∥ $" + point_letters(of_.line(step.track.line)) + "$", end = starred_tip(step.pin, i);
    const auto source = [&](Source kind) { return VectorSource{.kind = kind, .point = step.pin, .link = i}; };
    Chain on_guide;
    on_guide.v.push_back(unknown_along(
        {of_.on_link(step.pin, i, true), along, "?", end, source(Source::on_link_velocity)}, step.track.line));
    on_guide.a.push_back(unknown_along(
        {of_.on_link(step.pin, i, false), along, "?", end, source(Source::on_link_acceleration)}, step.track.line));
    DyadEquation written = equation(step.pin, std::move(on_guide), from_pin(i, step.line, step.pin, false));
    written.is_joint_found = false;
    return written;
  }
  Found write(const CrossedBlock& step) const {
    const auto& points = linkage().links[index(step.track.block)].points;
    if (points.empty()) return {};
    const int C = points.front().point;
    DyadEquation written = equation(C, track(step.track.line, C), track(step.line, C));
    add_sum(written, C);
    return written;
  }
  static Found write(const TurnedCrank&) { return {}; }
  static Found write(const GearedWheel&) { return {}; }
  static Found write(const RolledWheel&) { return {}; }
  static Found write(const SlidPin&) { return {}; }
  static Found write(const SlidBlock&) { return {}; }

  const Built& built_;
  Vectors of_;
};

}  // namespace

std::vector<DyadEquation> dyad_equations(const Built& built) { return Writer(built).all(); }

std::vector<Term> relative_vectors(const std::vector<DyadEquation>& equations) {
  std::vector<Term> all;
  for (const DyadEquation& equation : equations)
    for (const auto* chain : {&equation.v_left, &equation.v_right, &equation.a_left, &equation.a_right})
      for (const Term& term : *chain)
        if (term.source && std::none_of(all.begin(), all.end(),
                                        [&](const Term& other) { return other.quantity.name == term.quantity.name; }))
          all.push_back(term);
  return all;
}

}  // namespace epure::scenes
