#include "exercises/scenes/forces/force_names.h"

#include <algorithm>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/forces/scene_forces.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using Force = ActingForce;

std::string without_dollars(const std::string& symbol) { return symbol.substr(1, symbol.size() - 2); }
// Without dollars: "\\it{R}^{t}_{23}".
std::string with_script(const std::string& letter, const std::string& of, ForcePart part) {
  const std::string script = part == ForcePart::whole ? "" : part == ForcePart::across ? "^{t}" : "^{n}";
  return "\\it{" + letter + "}" + script + "_{" + of + "}";
}
std::string in_dollars_with_arrow(const std::string& letters) {
  const std::size_t scripts = std::min(letters.find_first_of("_^"), letters.size());
  return "$\\vec{" + letters.substr(0, scripts) + "}" + letters.substr(scripts) + "$";
}
// Of link i on link j, as the file numbers them.
std::string both_numbers(int i, int j) {
  constexpr int two_digits = 10;
  return std::to_string(i) + (std::max(i, j) < two_digits ? "" : ",") + std::to_string(j);
}
// The number of the link that exerts the force of two.
int number_of_other(const Built& built, const Force& force) {
  return built.letters.links[index(links_of(built.linkage, force).other(force.link))];
}
Quantity scalar_force(const Built& built, const Force& force) {
  if (const LineFriction* friction = friction_of(built, force)) return whole_contact_force(built, *friction);
  if (force.kind == Force::Kind::pin) return pin_force(built, index(force.which));
  if (force.kind == Force::Kind::guide) return guide_forces(built, index(force.which)).force;
  return driving_effort(built, built.linkage.drives[index(force.which)]);
}
// Without dollars, and without a minus.
std::string plain_letters(const Built& built, const Force& force, ForcePart part) {
  switch (force.kind) {
    case Force::Kind::load:
      return without_dollars(built.force_names[index(force.which)].symbol);
    case Force::Kind::hinge:
    case Force::Kind::tooth:
      return with_script("R", both_numbers(number_of_other(built, force), built.letters.links[index(force.link)]),
                         part);
    case Force::Kind::weight:
    case Force::Kind::inertia:
      return with_script(force.kind == Force::Kind::weight ? "W" : "F",
                         std::to_string(built.letters.links[index(built.loads->masses[index(force.which)].link)]),
                         part);
    case Force::Kind::held:
      return with_script("R", point_letters(built.letters.points[index(force.which)]), part);
    default:
      break;
  }
  return without_dollars(scalar_force(built, force).symbol);
}
std::string minus_of(const Force& force) { return force.is_opposite && !is_of_links(force) ? "−" : ""; }

}  // namespace

const LineFriction* friction_of(const Built& built, const ActingForce& force) {
  if (force.kind != Force::Kind::pin && force.kind != Force::Kind::guide) return nullptr;
  const auto& all = built.loads->frictions;
  const auto found = std::find_if(all.begin(), all.end(), [&](const LineFriction& each) {
    return each.is_of_block == (force.kind == Force::Kind::guide) && each.which == force.which;
  });
  return found == all.end() ? nullptr : &*found;
}
std::string name_of_force(const Built& built, const ActingForce& force) {
  if (force.kind == Force::Kind::load) return built.force_names[index(force.which)].name;
  if (is_of_mass(force)) return mass_force(built, force).name;
  if (force.kind == Force::Kind::held) return held_force(built, force.which).name;
  if (!is_of_links(force)) return scalar_force(built, force).name;
  return force_of_two(built, force).name;
}
std::string letters_of_force(const Built& built, const ActingForce& force, ForcePart part) {
  return "$" + plain_letters(built, force, part) + "$";
}
std::string arrow_of_force(const Built& built, const ActingForce& force, ForcePart part) {
  return minus_of(force) + in_dollars_with_arrow(plain_letters(built, force, part));
}
bool is_reversed(const Built& built, const ActingForce& force) {
  return is_of_links(force) ? number_of_other(built, force) > built.letters.links[index(force.link)]
                            : force.is_opposite;
}

VectorQuantity part_of_force(const Built& built, const ActingForce& force, ForcePart part) {
  const bool is_across = part == ForcePart::across;
  const std::string whole = name_of_force(built, force), script = is_across ? "t" : "n";
  std::string of = force.kind == Force::Kind::held ? point_letters(built.letters.points[index(force.which)]) : "";
  if (of.empty()) of = both_numbers(number_of_other(built, force), built.letters.links[index(force.link)]);
  const Words meaning = is_across
                            ? format_words("part of {} square to the line of the hinges of link {}",
                                           "componente di {} normale alla congiungente le cerniere del membro {}",
                                           whole, built.letters.links[index(force.link)])
                            : format_words("part of {} along the line of the hinges of link {}",
                                           "componente di {} lungo la congiungente le cerniere del membro {}", whole,
                                           built.letters.links[index(force.link)]);
  return {whole + "_" + script, "\\it{{R}}^{{" + script + "}}_{{{}}}", of, "N", meaning, meaning};
}
VectorQuantity force_of_two(const Built& built, const ActingForce& force) {
  if (force.kind == Force::Kind::tooth) return tooth_force(built, index(force.which)).quantity;
  const TwoLinks links = links_of(built.linkage, force);
  return hinge_force(built, force.point, links.by, links.on).quantity;
}
VectorQuantity held_force(const Built& built, int point) {
  const std::string& A = built.letters.points[index(point)];
  const Words meaning =
      format_words("force of all that holds {} on its link", "forza di tutto ciò che trattiene {} sul suo membro", A);
  return {"R_" + A, "\\it{{R}}_{{{}}}", point_letters(A), "N", meaning, meaning};
}
bool turns_steadily(const Built& built, int link) {
  const auto& drives = built.linkage.drives;
  return std::any_of(drives.begin(), drives.end(), [&](const Drive& drive) {
    const auto* turned = std::get_if<TurnedLink>(&drive);
    return turned && turned->link == link && is_zero(turned->alpha);
  });
}
VectorQuantity mass_force(const Built& built, const ActingForce& force) {
  const std::string number = std::to_string(built.letters.links[index(built.loads->masses[index(force.which)].link)]);
  const bool is_weight = force.kind == Force::Kind::weight;
  const std::string letter = is_weight ? "W" : "F";
  const Words meaning = is_weight ? format_words("weight of link {}", "peso del membro {}", number)
                                  : format_words("inertia force of link {}", "forza d'inerzia del membro {}", number);
  return {letter + "_" + number, "\\it{{" + letter + "}}_{{{}}}", number, "N", meaning, meaning};
}
Quantity inertia_couple(const Built& built, std::size_t mass) {
  const std::string number = std::to_string(built.letters.links[index(built.loads->masses[mass].link)]);
  return {"C_" + number, "$\\it{C}_{" + number + "}$", "N*m",
          format_words("inertia couple of link {}", "coppia d'inerzia del membro {}", number)};
}
std::string letters_of_centre(const Built& built, std::size_t mass) {
  const geometry::LinkMass& body = built.loads->masses[mass];
  if (const int G = point_at(built, body.link, body.at); G != nothing)
    return point_letters(built.letters.points[index(G)]);
  return "G_{" + std::to_string(built.letters.links[index(body.link)]) + "}";
}
std::string acceleration_of_centre(const Built& built, std::size_t mass) {
  std::string letters = letters_of_centre(built, mass);
  letters.erase(
      std::remove_if(letters.begin(), letters.end(), [](char c) { return c == '_' || c == '{' || c == '}'; }),
      letters.end());
  return "$a_{" + letters + "}$";
}
VectorQuantity load_force(const Built& built, std::size_t load) {
  const LoadName& of = built.force_names[load];
  const Words meaning = format_words("load on link {}", "carico sul membro {}",
                                     built.letters.links[index(built.loads->forces[load].link)]);
  const std::string script = of.symbol.substr(of.symbol.find('{', of.symbol.find('_')) + 1);
  return {of.name, "\\it{{Q}}_{{{}}}", script.substr(0, script.size() - 2), "N", meaning, meaning};
}

}  // namespace epure::scenes
