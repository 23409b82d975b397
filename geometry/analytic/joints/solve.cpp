#include <cmath>
#include <functional>

#include "geometry/analytic/joints/beginning.h"
#include "geometry/analytic/joints/enclosed.h"
#include "geometry/analytic/joints/in_doubles.h"
#include "geometry/analytic/joints/sides.h"

namespace epure::geometry::analytic {
namespace {

using namespace joints;

// Of the links as they are driven: what says so of a turned one holds, and its angle is no unknown.
template <class T>
System<T> of_joints(const Linkage& linkage) {
  return [&linkage](const Column<T>& q) {
    std::vector<Equation<T>> rows = equations(linkage, as_driven(linkage, q));
    for (std::size_t k = 0; k < linkage.drives.size(); ++k)
      if (std::holds_alternative<TurnedLink>(linkage.drives[k])) rows[row_of_drive(linkage, rows, k)].residual = T(0);
    return rows;
  };
}
std::vector<bool> angles_of_drives(const Linkage& linkage) {
  std::vector<bool> given(unknowns_of_a_link * (linkage.links.size() - 1));
  for (const Drive& drive : linkage.drives)
    if (const auto* turned = std::get_if<TurnedLink>(&drive))
      given[static_cast<std::size_t>(unknowns_of_a_link * turned->link - 1)] = true;
  return given;
}

// The solution of J x = b.
template <class T>
using SolveRates = std::function<Column<T>(const std::vector<Equation<T>>& J, const Column<T>& b)>;

// The links that do not turn, as lines led in lines begin at the frame: there s_i x s_j = 0 says ω_i = ω_j = 0, which
// enclosures would only nearly say.
std::vector<bool> led_without_turning(const Linkage& linkage) {
  std::vector<bool> led(linkage.links.size());
  led[0] = true;
  for (std::size_t farther = 0; farther < linkage.blocks.size(); ++farther)
    for (const LineOnLine& block : linkage.blocks) {
      const auto i = static_cast<std::size_t>(linkage.link_of_line(block.moving)),
                 j = static_cast<std::size_t>(linkage.link_of_line(block.guide));
      if (led[i] || led[j]) led[i] = led[j] = true;
    }
  return led;
}

template <class T>
std::vector<LinkState<T>> with_rates(const Linkage& linkage, const Column<T>& q, const SolveRates<T>& solve) {
  std::vector<LinkState<T>> links = as_driven(linkage, q);
  const std::vector<bool> led = led_without_turning(linkage);
  const auto take = [&](const Column<T>& rates, bool is_first) {
    for (std::size_t k = 0; k < rates.size(); k += unknowns_of_a_link) {
      const std::size_t i = k / unknowns_of_a_link + 1;
      LinkState<T>& link = links[i];
      (is_first ? link.v : link.a) = Complex<T>{rates[k], rates[k + 1]};
      (is_first ? link.omega : link.alpha) = led[i] ? T(0) : rates[k + 2];
    }
  };
  Column<T> b;
  const std::vector<Equation<T>> at_rest = equations(linkage, links);
  for (const Equation<T>& row : at_rest) b.push_back(row.rate);
  take(solve(at_rest, b), true);
  b.clear();
  for (const Equation<T>& row : equations(linkage, links)) b.push_back(row.second_rate - row.quadratic);
  take(solve(at_rest, b), false);
  return links;
}

std::vector<LinkState<Fast>> found(const Linkage& linkage, const Beginning<Fast>& beginning) {
  return with_rates<Fast>(
      linkage, iterated(linkage, moving_links(linkage, beginning)),
      [](const std::vector<Equation<Fast>>& rows, const Column<Fast>& b) { return solved(rows, b); });
}

template <class T>
std::vector<LinkState<T>> proved_near(const Linkage& linkage, const Column<T>& last) {
  const System<T> system = of_joints<T>(linkage);
  const Preconditioner<T> Y(system(last));
  const Column<T> q = proved_box(system, Y, last, angles_of_drives(linkage));
  return with_rates<T>(linkage, q,
                       [&](const std::vector<Equation<T>>& rows, const Column<T>& b) { return solved(rows, Y, b); });
}

std::vector<LinkState<Bounded>> found(const Linkage& linkage, const Beginning<Bounded>& beginning) {
  Column<Fast> start;
  for (const Bounded& x : moving_links(linkage, beginning)) start.push_back(near(x));
  Column<Bounded> last;
  for (const double x : iterated(linkage, start)) last.emplace_back(x);
  return proved_near(linkage, refined(of_joints<Bounded>(linkage), last));
}

std::vector<LinkState<Deep>> found(const Linkage& linkage, const Beginning<Deep>& beginning) {
  return proved_near(linkage, refined(of_joints<Deep>(linkage), moving_links(linkage, beginning)));
}

[[noreturn]] void refuse_angles() {
  throw Undecided("the equations of all joints are solved for angles, which are no algebraic numbers",
                  "le equazioni di tutti i vincoli si risolvono negli angoli, che non sono numeri algebrici");
}

}  // namespace

template <class T>
std::vector<LinkState<T>> solve_joints(const Linkage& linkage, const Beginning<T>& beginning) {
  if constexpr (!NumberWithAngles<T>) {
    refuse_angles();
  } else {
    std::vector<LinkState<T>> links = found(linkage, beginning);
    // An iteration that went astray says nothing of the linkage.
    const Hanging all = all_links(linkage);
    if (Sides<T>(linkage, links, all).are_as_meant() == Truth::no &&
        Sides<T>(linkage, beginning, all).are_as_meant() != Truth::no)
      throw Undecided("the iteration came to the place of a joint on the other side than was said",
                      "l'iterazione è arrivata al posto di un nodo dalla parte opposta a quella detta");
    demand_sides(linkage, links, all);
    return links;
  }
}
template std::vector<LinkState<Fast>> solve_joints<Fast>(const Linkage&, const Beginning<Fast>&);
template std::vector<LinkState<Bounded>> solve_joints<Bounded>(const Linkage&, const Beginning<Bounded>&);
template std::vector<LinkState<Deep>> solve_joints<Deep>(const Linkage&, const Beginning<Deep>&);
template std::vector<LinkState<Exact>> solve_joints<Exact>(const Linkage&, const Beginning<Exact>&);
template std::vector<LinkState<Generic>> solve_joints<Generic>(const Linkage&, const Beginning<Generic>&);
template std::vector<LinkState<Calcium>> solve_joints<Calcium>(const Linkage&, const Beginning<Calcium>&);

}  // namespace epure::geometry::analytic
