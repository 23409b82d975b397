// On which side of others the joints lie, beside what was said.
#pragma once

#include <variant>

#include "geometry/analytic/joints/equations.h"

namespace epure::geometry::analytic::joints {

// Whether a solution is the one that was meant, whatever it was looked for from.
template <class T>
class Sides {
 public:
  Sides(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Hanging& hanging)
      : linkage_(linkage), links_(links), hanging_(hanging) {}

  // Of every joint: no where one is proved to lie on the other side.
  Truth are_as_meant() const {
    bool is_open = false;
    const auto look = [&](const T& ahead) {  // zero where the two places are one
      const Sign decided = sign(ahead);
      is_open = is_open || decided == Sign::undecided;
      return decided != Sign::negative;
    };
    for (const Chosen& chosen : linkage_.chosen)
      if (std::visit([this](const auto& side) { return is_joined(side); }, chosen) &&
          !look(std::visit([this](const auto& side) { return ahead(side); }, chosen)))
        return Truth::no;
    for (const LineOnLine& block : linkage_.blocks)  // the equations hold for both ways it can lie in its guide
      if (joints::is_joined(linkage_, hanging_, {},
                            {linkage_.link_of_line(block.moving), linkage_.link_of_line(block.guide)}) &&
          !look(dot(direction(block.moving), direction(block.guide))))
        return Truth::no;
    return is_open ? Truth::undecided : Truth::yes;
  }

 private:
  bool is_joined(const BesideLine& side) const {
    return joints::is_joined(linkage_, hanging_, {side.joint, side.from, side.to}, {});
  }
  bool is_joined(const OnGuide& side) const {
    demand_told(side.guide != nothing && side.other_end != nothing);
    return joints::is_joined(linkage_, hanging_, {side.joint, side.other_end}, {linkage_.link_of_line(side.guide)});
  }
  bool is_joined(const SlotPoints& side) const {
    demand_told(side.hinge != nothing && side.pin != nothing);
    return joints::is_joined(linkage_, hanging_, {side.pin, side.hinge}, {linkage_.link_of_line(side.line)});
  }
  // Positive in the place that is meant, negative in the other.
  T ahead(const BesideLine& side) const {
    const Complex<T> P = at(side.from);
    const T left = cross(at(side.to) - P, at(side.joint) - P);
    return side.is_left ? left : -left;
  }
  T ahead(const OnGuide& side) const {
    const T ahead = dot(direction(side.guide), at(side.joint) - at(side.other_end));
    return side.is_ahead ? ahead : -ahead;
  }
  T ahead(const SlotPoints& side) const {
    const T towards = dot(direction(side.line), at(side.pin) - at(side.hinge));
    return side.is_towards_pin ? towards : -towards;
  }
  static void demand_told(bool is_told) {
    if (!is_told)
      throw Undecided("a side is not told in full: from which point",
                      "un lato non è detto per intero: da quale punto");
  }

  Complex<T> at(int point) const {
    const int link = links_at(linkage_, hanging_, point).front();
    return point_of(links_[static_cast<std::size_t>(link)], linkage_.place(link, point)).z;
  }
  Complex<T> direction(int line) const {
    return analytic::direction(linkage_.line(line), links_[static_cast<std::size_t>(linkage_.link_of_line(line))]);
  }

  const Linkage& linkage_;
  const std::vector<LinkState<T>>& links_;
  const Hanging& hanging_;
};

template <class T>
void demand_sides(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Hanging& hanging) {
  const Truth as_meant = Sides<T>(linkage, links, hanging).are_as_meant();
  if (as_meant == Truth::undecided)
    throw Undecided("whether a joint lies on the side that was said", "se un nodo stia dalla parte che si è detta");
  if (as_meant == Truth::no)
    throw Impossible("a joint lies on the other side than was said",
                     "un nodo sta dalla parte opposta a quella che si è detta");
}

}  // namespace epure::geometry::analytic::joints
