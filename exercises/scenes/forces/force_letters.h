// What the letters of forces and couples mean that a scene's sheets tell, as a legend.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/forces/force_groups.h"
#include "exercises/scenes/forces/force_names.h"
#include "exercises/scenes/forces/scene_forces.h"

namespace epure::scenes {

class ForceLetters {
 public:
  explicit ForceLetters(const Built& built) : built_(built) {}

  Words all(const std::vector<GroupForces>& groups) const {
    std::vector<Words> told;
    const auto add = [&](const Words& meaning) {
      const auto is_it = [&](const Words& other) { return other.english == meaning.english; };
      if (!meaning.empty() && std::none_of(told.begin(), told.end(), is_it)) told.push_back(meaning);
    };
    for (const GroupForces& group : groups)
      for (const LinkForces& body : group.bodies) {
        for (const ActingForce& force : body.sought) add(of(force));
        for (const ActingForce& force : body.known)
          if (is_of_mass(force)) add(of(force));
        for (const ActingCouple& couple : body.couples)
          if (couple.kind != ActingCouple::Kind::guide) add(of(couple));
      }
    for (const GroupForces& group : groups)
      for (const Moments& each : group.moments)
        if (const auto* couple = std::get_if<ActingCouple>(&each.sought)) add(of(*couple));
    Words all;
    for (const Words& each : told) all = all + (all.empty() ? "" : "; ") + each;
    return all.empty() ? all : all + ".";
  }

 private:
  using Force = ActingForce;
  std::string letter(const std::string& name) const { return "$" + point_letters(name) + "$"; }
  std::string number(int link) const { return std::to_string(built_.letters.links[index(link)]); }
  // "g (link 1)".
  Words line(int l) const {
    const std::string g = letter(built_.letters.lines[index(l)]), i = number(built_.linkage.link_of_line(l));
    return format_words("{} (link\u00a0{})", "{} (membro\u00a0{})", g, i);
  }

  Words of(const Force& force) const {
    const auto k = index(force.which);
    switch (force.kind) {
      case Force::Kind::hinge:
      case Force::Kind::tooth:
        return {"$\\it{R}_{ij}$: force of link\u00a0$i$ on link\u00a0$j$",
                "$\\it{R}_{ij}$: forza del membro\u00a0$i$ sul membro\u00a0$j$"};
      case Force::Kind::weight:
        return {"$\\it{W}_{i}$: weight of link\u00a0$i$", "$\\it{W}_{i}$: peso del membro\u00a0$i$"};
      case Force::Kind::inertia:
        return {"$\\it{F}_{i}$: inertia force of link\u00a0$i$",
                "$\\it{F}_{i}$: forza d'inerzia del membro\u00a0$i$"};
      case Force::Kind::held: {
        const std::string A = letter(built_.letters.points[k]);
        return format_words("{}: force of all that holds {} on its link",
                            "{}: forza di tutto ciò che trattiene {} sul suo membro", letters_of_force(built_, force),
                            A);
      }
      case Force::Kind::pin: {
        const geometry::PinOnLine& pin = built_.linkage.pins[k];
        const std::string A = letter(built_.letters.points[index(pin.point)]);
        return of_line(force, line(pin.line), {A, A});
      }
      case Force::Kind::guide: {
        const LineOnLine& block = built_.linkage.blocks[k];
        const std::string i = number(built_.linkage.link_of_line(block.moving));
        return of_line(force, line(block.guide), format_words("link\u00a0{}", "membro\u00a0{}", i));
      }
      case Force::Kind::slid: {
        const auto& drive = std::get<SlidPoint>(built_.linkage.drives[k]);
        return format_words("{}: driving force on {}", "{}: forza motrice su {}", letters_of_force(built_, force),
                            letter(built_.letters.points[index(drive.point)]));
      }
      case Force::Kind::cylinder:
        return format_words("{}: push of the cylinder", "{}: spinta del cilindro", letters_of_force(built_, force));
      case Force::Kind::load:
        break;
    }
    return {};
  }
  Words of_line(const Force& force, const Words& by, const Words& on) const {
    const Words whole =
        format_words("{}: force of {} on {}", "{}: forza di {} su {}", letters_of_force(built_, force), by, on);
    const auto* friction = friction_of(built_, force);
    if (!friction) return whole;
    return whole + format_words(", of which {} is normal and {} friction", ", di cui {} normale e {} d'attrito",
                                contact(built_, *friction).normal.symbol, friction_force(built_, *friction).symbol);
  }
  Words of(const ActingCouple& couple) const {
    const auto k = index(couple.which);
    switch (couple.kind) {
      case ActingCouple::Kind::inertia:
        return {"$\\it{C}_{i}$: inertia couple of link\u00a0$i$",
                "$\\it{C}_{i}$: coppia d'inerzia del membro\u00a0$i$"};
      case ActingCouple::Kind::hinge:
        return {"$\\it{M}_{ij}$: couple of friction of link\u00a0$i$ on link\u00a0$j$",
                "$\\it{M}_{ij}$: coppia d'attrito del membro\u00a0$i$ sul membro\u00a0$j$"};
      case ActingCouple::Kind::guide: {
        const LineOnLine& block = built_.linkage.blocks[k];
        const std::string i = number(built_.linkage.link_of_line(block.moving));
        return format_words("{}: couple of {} on link\u00a0{}", "{}: coppia di {} sul membro\u00a0{}",
                            guide_forces(built_, k).couple.symbol, line(block.guide), i);
      }
      case ActingCouple::Kind::drive: {
        const Quantity M = driving_effort(built_, built_.linkage.drives[k]);
        const int link = std::get<TurnedLink>(built_.linkage.drives[k]).link;
        return format_words("{}: driving couple on link\u00a0{}", "{}: coppia motrice sul membro\u00a0{}", M.symbol,
                            number(link));
      }
      case ActingCouple::Kind::load:
        break;
    }
    return {};
  }

  const Built& built_;
};

}  // namespace epure::scenes
