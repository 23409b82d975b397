// Sheet 3: disc and lever cut free, each in equilibrium with its forces of inertia, and the polygons that find the
// reactions.
#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/pin-in-slot/figure.h"

namespace epure::pin_in_slot {
namespace {

// Of one body: its forces in the order of the polygon, and the polygon.
struct Acting {
  Place at;
  Arrow2 f;
  std::string label;
  bool pushes = false;  // drawn with its tip on the point, as what presses on a body from outside
};
struct Body {
  std::vector<Acting> forces;
  VectorPolygon polygon;
};

PolygonSide known(const std::string& label, const Words& direction, const std::string& magnitude, const Arrow2& f,
                  Language language) {
  const bool none = f.x == 0 && f.y == 0;
  return {.label = label, .direction = direction.in(language), .magnitude = none ? "0" : magnitude, .v = f};
}

// The last known force of a chain has the letter from which the line of the unknown one starts.
void letter_last_known(std::vector<PolygonSide>& chain, const std::string& letter) {
  for (auto side = chain.rbegin(); side != chain.rend(); ++side) {
    if (!side->is_drawn() || side->is_unknown()) continue;
    side->tip = letter;
    return;
  }
}

Body disc_of(const Drawn& f, Language language) {
  const Words upright{"vertical", "verticale"}, level{"∥ guide", "∥ guida"};
  VectorPolygon polygon{.meaning = Meaning::force,
                        .unit = "N",
                        .origin = "$O_{d}$",
                        .left = {{.quantity = "ground_normal_force",
                                  .label = "$\\vec{N}$",
                                  .direction = upright.in(language),
                                  .magnitude = "?",
                                  .v = f.ground_force,
                                  .along = {0, 1}}},
                        .right = {known("$\\vec{T}$", level, "$J_{2}α_{d}/R$", f.friction, language),
                                  known("$\\vec{F}_{2}$", level, "$M_{2}a_{B}$", f.disc_inertia, language),
                                  known("$\\vec{P}_{2}$", upright, "$M_{2}g$", f.disc_weight, language),
                                  {.quantity = "slot_force_on_pin",
                                   .label = "$\\vec{S}$",
                                   .direction = "⊥ $OB$",
                                   .magnitude = "?",
                                   .v = f.slot_force,
                                   .tip = "$e$",
                                   .along = geometry::quarter_turn(f.slot)}},
                        .loop = true};
  polygon.right.front().quantity = "ground_friction_force";
  letter_last_known(polygon.right, "$d$");
  return {{{f.B, f.disc_weight, "$\\vec{P}_{2}$"},
           {f.D, f.friction, "$\\vec{T}$"},
           {f.B, f.disc_inertia, "$\\vec{F}_{2}$"},
           {f.B, f.slot_force, "$\\vec{S}$", true},
           {f.D, f.ground_force, "$\\vec{N}$", true}},
          polygon};
}

Body lever_of(const Drawn& f, Language language) {
  const Words upright{"vertical", "verticale"}, along_a_A{"∥ $\\vec{a}_{A}$", "∥ $\\vec{a}_{A}$"},
      across{"⊥ $OB$", "⊥ $OB$"};
  VectorPolygon polygon{.meaning = Meaning::force,
                        .unit = "N",
                        .origin = "$O_{l}$",
                        .left = {{.quantity = "pivot_force",
                                  .label = "$\\vec{R}_{O}$",
                                  .direction = "?",
                                  .magnitude = "?",
                                  .v = f.pivot_force}},
                        .right = {known("−$\\vec{S}$", across, "$S$", -f.slot_force, language),
                                  known("$\\vec{P}_{1}$", upright, "$M_{1}g$", f.lever_weight, language),
                                  known("$\\vec{F}_{1}$", along_a_A, "$M_{1}a_{A}$", f.lever_inertia, language)},
                        .loop = true};
  letter_last_known(polygon.right, "$l$");
  return {{{f.B, -f.slot_force, "−$\\vec{S}$", true},
           {f.A, f.lever_weight, "$\\vec{P}_{1}$"},
           {f.A, f.lever_inertia, "$\\vec{F}_{1}$"},
           {f.O, f.pivot_force, "$\\vec{R}_{O}$"}},
          polygon};
}

struct Scales {
  Scale lengths, newtons;
};

// The end of a force that does not lie on its point.
Place free_end(const Acting& force, double metres_per_newton) {
  const double along = force.pushes ? -metres_per_newton : metres_per_newton;
  return {force.at.x + along * force.f.x, force.at.y + along * force.f.y};
}

void draw_acting(Plot& plot, const std::vector<Acting>& forces) {
  const double metres_per_newton = plot.vector_scale().mm_per_unit / plot.scale().mm_per_unit;
  for (const Acting& force : forces) {
    if (force.f.x == 0 && force.f.y == 0) continue;
    const Place end = free_end(force, metres_per_newton);
    plot.side("", force.pushes ? end : force.at, force.pushes ? force.at : end, Meaning::force, force.label);
  }
}

void include_acting(Extent& extent, const Scales& at, const std::vector<Acting>& forces) {
  constexpr double air = 4;  // mm, for letters beside it
  for (const Acting& force : forces) {
    extent.include(at.lengths, free_end(force, at.newtons.mm_per_unit / at.lengths.mm_per_unit), air);
  }
}

// Four pictures: the disc on the left, the lever on the right; the bodies above, their polygons below.
struct Rooms {
  drawings::Box disc, lever, disc_polygon, lever_polygon;
};
Rooms rooms_in(const drawings::Box& room) {
  const double x = room.low.x + 0.43 * room.width(), y = room.low.y + 0.42 * room.height();
  return {{{room.low.x, y}, {x, room.high.y}},
          {{x, y}, room.high},
          {room.low, {x, y}},
          {{x, room.low.y}, {room.high.x, y}}};
}

struct Pictures {
  Body disc, lever;
};
drawings::Box extent_of_disc(const Drawn& f, const Body& disc, const Scales& at) {
  constexpr double air = 4;  // mm
  const double R = f.B.y;
  Extent extent;
  extent.include(at.lengths, {f.B.x - R, 0}, air);
  extent.include(at.lengths, {f.B.x + R, 2 * R}, air);
  include_acting(extent, at, disc.forces);
  return extent.box();
}
drawings::Box extent_of_lever(const Drawn& f, const Body& lever, const Scales& at) {
  Extent extent;
  include_lever(extent, at.lengths, f);
  include_acting(extent, at, lever.forces);
  return extent.box();
}

bool all_fit(const Drawn& f, const Pictures& pictures, const Rooms& rooms, const Scales& at) {
  return fits(extent_of_disc(f, pictures.disc, at), rooms.disc) &&
         fits(extent_of_lever(f, pictures.lever, at), rooms.lever) &&
         fits(extent_of(pictures.disc.polygon, at.newtons), rooms.disc_polygon) &&
         fits(extent_of(pictures.lever.polygon, at.newtons), rooms.lever_polygon);
}

// Bodies at one scale of lengths, all forces at one scale. Forces first, as large as their polygons allow; of lengths
// the largest scale that leaves room for them, but none so small that the bodies are lost among their forces. So the
// forces may have to shrink.
Scales chosen_scales(const Drawn& f, const Pictures& pictures, const Rooms& rooms, const SheetRequest& request) {
  const auto bodies_alone = [&](const drawings::Box& room, double at_most) {
    return fit_lengths(room, request, at_most,
                       [&](const Scale& scale) {
                         Extent extent;
                         include_lever(extent, scale, f);
                         include_disc(extent, scale, f);
                         return extent.box();
                       })
        .scale;
  };
  const Scale largest = bodies_alone(rooms.lever, 2000 / reach(f));
  const double longest = std::max(greatest(pictures.disc.polygon), greatest(pictures.lever.polygon));
  Scale newtons = largest_vector_scale(rooms.lever.width() / (longest > 0 ? longest : 1), "N", request.language);
  constexpr int lengths_tried = 2, forces_tried = 60;
  for (int i = 0; i < forces_tried; ++i) {
    Scale lengths = largest;
    for (int k = 0; k < (request.scale ? 1 : lengths_tried); ++k) {
      if (all_fit(f, pictures, rooms, {lengths, newtons})) return {lengths, newtons};
      lengths = largest_length_scale(0.99 * lengths.mm_per_unit);
    }
    newtons = largest_vector_scale(0.99 * newtons.mm_per_unit, "N", request.language);
  }
  throw BadGivens("the bodies and their forces do not fit the paper at any standard scale",
                  "i corpi e le loro forze non stanno sulla carta in alcuna scala normalizzata");
}

// The couple of inertia stands opposite to the lever, on the right of B.
void draw_free_disc(Plot& plot, const Drawn& f, const Body& disc) {
  constexpr double radius = 9, middle = 0.5;  // mm, radians
  draw_disc(plot, f);
  plot.hinge(f.B);
  plot.dot(f.D, Meaning::link);
  draw_acting(plot, disc.forces);
  if (f.instant.masses.J2 != 0)
    draw_sense(plot, f.B, radius, middle, -f.alpha_disc, {"$J_{2}α_{d}$", Meaning::force});
  plot.label("$B$", f.B);
  plot.label("$D$", f.D);
}

void draw_free_lever(Plot& plot, const Drawn& f, const Body& lever) {
  draw_lever(plot, f);
  plot.hinge(f.O);
  plot.dot(f.B, Meaning::link);
  draw_acting(plot, lever.forces);
  constexpr double radius = 9, ahead = 1.2;  // mm, radians
  draw_sense(plot, f.O, radius, std::atan2(f.slot.y, f.slot.x) + ahead, -f.couple, {"$C$", Meaning::force});
  plot.label("$O$", f.O);
  plot.label("$A$", f.A);
  plot.label("$B$", f.B);
}

void draw_pictures(DrawnSheet& onto, const Drawn& f, const Pictures& pictures, const SheetRequest& request) {
  const Rooms rooms = rooms_in(room_above_scale_bars(request));
  const Scales at = chosen_scales(f, pictures, rooms, request);
  Plot disc(onto, origin_in(rooms.disc, extent_of_disc(f, pictures.disc, at)), at.lengths);
  disc.vectors_at(at.newtons);
  draw_free_disc(disc, f, pictures.disc);
  Plot lever(onto, origin_in(rooms.lever, extent_of_lever(f, pictures.lever, at)), at.lengths);
  lever.vectors_at(at.newtons);
  draw_free_lever(lever, f, pictures.lever);
  Plot disc_polygon(onto, origin_in(rooms.disc_polygon, extent_of(pictures.disc.polygon, at.newtons)), at.newtons);
  draw_polygon(disc_polygon, pictures.disc.polygon);
  Plot lever_polygon(onto, origin_in(rooms.lever_polygon, extent_of(pictures.lever.polygon, at.newtons)), at.newtons);
  draw_polygon(lever_polygon, pictures.lever.polygon, {.numbers_after = steps_of_sides(pictures.disc.polygon)});
  lever_polygon.measures_coordinates("pivot_force", {0, 0}, closing_corner(pictures.lever.polygon));
  add_scale_bars(onto, {at.lengths, at.newtons}, request);
}

std::string moments(const Drawn& f, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  const std::string pin = f.slot_force.x < 0 ? "−" : "";  // the disc, when it is braked, drives the lever on
  const Words about_B{"Moments about $B$", "Momenti in $B$"}, about_O{"About $O$", "In $O$"};
  return about_B.in(language) + ": $T$ = $J_{2}$|$α_{d}$|/$R$ = " + num(std::abs(f.friction.x)) + " N. " +
         about_O.in(language) + ": $C$ = " + pin +
         "$S$·$OB$ + $M_{1}g$·$AO$ cos $α$ + $M_{1}$·$AO^{2}$·$dω/dt$ = " + num(f.couple) + " N m.";
}

std::string friction(const Drawn& f, Language language) {
  if (!(f.normal > 0)) {
    return Words{"$N$ ≤ 0: the guide would have to hold the disc down. It cannot, and the disc lifts off.",
                 "$N$ ≤ 0: la guida dovrebbe trattenere il disco. Non può, e il disco si stacca."}
        .in(language);
  }
  const Words to_roll{"To roll without slipping", "Per rotolare senza strisciare"};
  return to_roll.in(language) + ": $f$ ≥ $T$/$N$ = " + figures(std::abs(f.friction.x) / f.normal, 4, language) + ".";
}

std::string results(const Drawn& f, Language language) {
  const auto newtons = [&](const char* symbol, double x) { return symbol + figures(x, 4, language) + " N"; };
  const auto length = [](const Arrow2& v) { return std::hypot(v.x, v.y); };
  return newtons("$S$ = ", length(f.slot_force)) + newtons(",  $N$ = ", f.normal) +
         newtons(",  $T$ = ", length(f.friction)) + newtons(",  $R_{O}$ = ", length(f.pivot_force));
}

}  // namespace

void draw_forces(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const Pictures pictures{disc_of(f, language), lever_of(f, language)};
  draw_pictures(onto, f, pictures, request);

  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(drawings::Paragraph{
      english ? "$\\vec{P}_{1}$, $\\vec{P}_{2}$: weights; $\\vec{F}_{1}$ = −$M_{1}\\vec{a}_{A}$, $\\vec{F}_{2}$ = "
                "−$M_{2}\\vec{a}_{B}$: forces of inertia; $\\vec{S}$: of the slot on the pin."
              : "$\\vec{P}_{1}$, $\\vec{P}_{2}$: pesi; $\\vec{F}_{1}$ = −$M_{1}\\vec{a}_{A}$, $\\vec{F}_{2}$ = "
                "−$M_{2}\\vec{a}_{B}$: forze d'inerzia; $\\vec{S}$: del glifo sul piolo."});
  column.push_back(drawings::Heading{english ? "Disc" : "Disco"});
  column.push_back(equation(pictures.disc.polygon));
  column.push_back(drawings::Steps{steps_of(pictures.disc.polygon, language)});
  column.push_back(drawings::Heading{english ? "Lever" : "Glifo"});
  column.push_back(equation(pictures.lever.polygon));
  column.push_back(
      drawings::Steps{steps_of(pictures.lever.polygon, language), steps_of_sides(pictures.disc.polygon) + 1});
  column.push_back(drawings::Paragraph{moments(f, language)});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(drawings::Paragraph{results(f, language)});
  column.push_back(drawings::Paragraph{friction(f, language)});
  const auto length = [](const Arrow2& v) { return std::hypot(v.x, v.y); };
  onto.sheet.description = in_words({"Disc and lever cut free, and the polygons of their forces",
                                     "Disco e glifo isolati, e i poligoni delle loro forze"},
                                    {{"S", length(f.slot_force), "N"},
                                     {"N", f.normal, "N"},
                                     {"T", length(f.friction), "N"},
                                     {"C", f.couple, "N m"}},
                                    language);
}

}  // namespace epure::pin_in_slot
