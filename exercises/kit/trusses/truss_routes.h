// The forces of a truss by Cremona's plan and by the equations of all joints.
#pragma once

#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "exercises/kit/trusses/loaded_truss.h"
#include "geometry/analytic/truss_equations.h"
#include "geometry/statics/cremona.h"

namespace epure::trusses {

using geometry::Point;
using geometry::Vector;

inline VectorQuantity reaction_of_hinge(const LoadedTruss& of) {
  const Words meaning{"force of the hinge on the truss", "forza della cerniera sulla travatura"};
  const std::string& A = of.truss.names[of.hinge()];
  return {"R_" + A, "\\it{{R}}_{{{}}}", A, "N", meaning, meaning};
}
inline Quantity reaction_of_roller(const LoadedTruss& of) {
  const std::string& B = of.truss.names[of.roller_at()];
  return {"R_" + B,
          "$\\it{R}_{" + B + "}$",
          "N",
          {"force of the roller on the truss, positive away from its plane",
           "forza del carrello sulla travatura, positiva dal piano verso la travatura"}};
}
inline VectorQuantity load_at(const LoadedTruss& of, const Load& load) {
  const Words meaning{"load", "carico"};
  return {"F_" + of.truss.names[load.joint], "\\it{{F}}_{{{}}}", of.truss.names[load.joint], "N", meaning, meaning};
}
inline Quantity bar_force(std::size_t bar) {
  const std::string i = std::to_string(bar + 1);
  return {"N_" + i, "$\\it{N}_{" + i + "}$", "N",
          format_words("force of bar {}, tension positive", "sforzo dell'asta {}, positivo di trazione", i)};
}
inline Quantity bar_length(std::size_t bar) {
  const std::string i = std::to_string(bar + 1);
  return {"l_" + i, "$l_{" + i + "}$", "m", format_words("length of bar {}", "lunghezza dell'asta {}", i)};
}
inline Quantity greatest_force() {
  return {"N_max",
          "$\\it{N}_{max}$",
          "N",
          {"greatest force of a bar, tension positive", "sforzo massimo nelle aste, positivo di trazione"}};
}
inline Quantity least_force() {
  return {"N_min",
          "$\\it{N}_{min}$",
          "N",
          {"least force of a bar: of compression, negative", "sforzo minimo nelle aste: di compressione, negativo"}};
}
// Maxwell's theorem: the sum over the bars is that of the forces from outside times the places where they act.
inline Quantity sum_of_forces_times_lengths() {
  return {"sum_N_l",
          "$Σ\\it{N}l$",
          "N*m",
          {"sum of force times length of all bars", "somma di sforzo per lunghezza di tutte le aste"}};
}

struct Routes {
  LoadedTruss of;
  std::size_t most_bars;  // that the truss of these givens can have: the quantities are always as many

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("Cremona's plan");
    by_plan(ledger);
    by_equations(ledger);
    for (std::size_t i = 0; i < of.bars(); ++i) ledger.tells(bar_length(i), [&] { return length<T>(i); });
    for (std::size_t k = 0; k < of.loads.size(); ++k)
      if (of.loads[k].is_told) {
        const VectorQuantity F = load_at(of, of.loads[k]);
        ledger.tells(F.x(), [&] { return load<T>(k).x; });
        ledger.tells(F.y(), [&] { return load<T>(k).y; });
        ledger.tells(F.length(), [&] { return size(load<T>(k)); });
      }
    return ledger;
  }

 private:
  template <class T>
  Point<T> joint(std::size_t i) const {
    return {number<T>(of.truss.joints[i].x), number<T>(of.truss.joints[i].y)};
  }
  template <class T>
  Vector<T> load(std::size_t k) const {
    const Load& of_it = of.loads[k];
    const Vector<T> components{number<T>(of_it.components.x), number<T>(of_it.components.y)};
    if (of_it.size == 0) return components;
    return components +
           number<T>(of_it.size) * Vector<T>{geometry::cosine<T>(of_it.along), geometry::sine<T>(of_it.along)};
  }
  template <class T>
  Vector<T> along_roller() const {
    return {geometry::cosine<T>(of.roller), geometry::sine<T>(of.roller)};
  }
  template <class T>
  T length(std::size_t bar) const {
    const Vector<Rational> d = geometry::along(of.truss, bar);
    return geometry::root(number<T>(geometry::dot(d, d)));
  }

  // The greater of two, of which nothing has to decide which it is.
  template <class T>
  static T greater(const T& a, const T& b) {
    return geometry::quotient(a + b + geometry::root(geometry::square(a - b)), T(2));
  }
  // Of the forces times `sense`, 1 or -1; for signs, one of its sign.
  template <class T>
  static T greatest(const std::vector<T>& forces, int sense) {
    T most = T(sense) * forces.front();
    for (const T& force : forces) {
      if constexpr (signs_only<T>) {
        const geometry::Sign so_far = geometry::sign(most), next = geometry::sign(T(sense) * force);
        if (so_far == geometry::Sign::undecided || next == geometry::Sign::undecided)
          throw geometry::Undecided("which way the greatest force acts", "il verso dello sforzo massimo");
        if (next > so_far) most = T(sense) * force;
      } else {
        most = greater(most, T(sense) * force);
      }
    }
    return most;
  }

  template <class T, class Find>
  void put_hinge(Ledger<T>& ledger, const Find& find) const {
    const VectorQuantity R = reaction_of_hinge(of);
    ledger.put(R.x(), [&] { return Vector<T>(find()).x; });
    ledger.put(R.y(), [&] { return Vector<T>(find()).y; });
    ledger.put(R.length(), [&] { return size(Vector<T>(find())); });
  }
  template <class T, class Forces>
  void put_forces(Ledger<T>& ledger, const Forces& forces) const {
    for (std::size_t i = 0; i < most_bars; ++i)
      ledger.put(bar_force(i), [&]() -> T {
        if (i >= of.bars())
          throw geometry::Impossible(
              format_words("this truss has {} bars", "questa travatura ha {} aste", of.bars()));
        return forces()[i];
      });
    ledger.put(greatest_force(), [&] { return greatest<T>(forces(), 1); });
    ledger.put(least_force(), [&] { return T(-1) * greatest<T>(forces(), -1); });
  }

  template <class T>
  struct Plan {
    geometry::SupportReactions<T> reactions;
    std::vector<Point<T>> regions;
    std::vector<T> times_length;  // of each bar
  };
  template <class T>
  Plan<T> plan() const {
    std::vector<geometry::Line<T>> lines;
    std::vector<Vector<T>> outside(2);
    for (std::size_t k = 0; k < of.loads.size(); ++k) {
      outside.push_back(load<T>(k));
      lines.push_back(geometry::line(joint<T>(of.loads[k].joint), outside.back()));
    }
    Plan<T> found{
        geometry::support_reactions<T>(lines, joint<T>(of.hinge()), {joint<T>(of.roller_at()), along_roller<T>()}),
        {},
        {}};
    outside[0] = found.reactions.hinge;
    outside[1] = found.reactions.roller;
    found.regions = geometry::cremona_plan<T>(of.truss, of.bow, outside);
    for (std::size_t i = 0; i < of.bars(); ++i)
      found.times_length.push_back(geometry::force_times_length<T>(of.truss, of.bow, found.regions, i));
    return found;
  }

  template <class T>
  void by_plan(Ledger<T>& ledger) const {
    const auto found = once([this] { return plan<T>(); });
    put_hinge(ledger, [found] { return found().reactions.hinge; });
    ledger.put(reaction_of_roller(of), [&] { return geometry::dot(found().reactions.roller, along_roller<T>()); });
    put_forces(ledger, once([this, found] {
                 std::vector<T> forces;
                 for (std::size_t i = 0; i < of.bars(); ++i)
                   forces.push_back(signs_only<T> ? found().times_length[i]
                                                  : geometry::quotient(found().times_length[i], length<T>(i)));
                 return forces;
               }));
    ledger.put(sum_of_forces_times_lengths(), [&] {
      T sum(0);
      for (const T& each : found().times_length) sum = sum + each;
      return sum;
    });
    for (std::size_t r = 0; r < of.bow.regions(); ++r)
      ledger.draws_point("region_" + std::to_string(r), [&, r] { return found().regions[r]; });
    for (std::size_t k = 0; k < of.loads.size(); ++k) ledger.draws_vector("load_" + std::to_string(k), load<T>(k));
    ledger.draws_point("roller", [&] { return Point<T>{T(0), T(0)} + found().reactions.roller; });
  }

  template <class T>
  std::vector<T> solved() const {
    using geometry::analytic::Complex;
    std::vector<Complex<T>> joints;
    for (const auto& J : of.truss.joints) joints.push_back({number<T>(J.x), number<T>(J.y)});
    geometry::analytic::TrussEquations<T> equations(joints);
    for (const geometry::TrussBar& bar : of.truss.bars) equations.bar(bar.from, bar.to);
    equations.support(of.hinge(), {T(1), T(0)});
    equations.support(of.hinge(), {T(0), T(1)});
    equations.support(of.roller_at(), {geometry::cosine<T>(of.roller), geometry::sine<T>(of.roller)});
    for (std::size_t k = 0; k < of.loads.size(); ++k) {
      const Vector<T> f = load<T>(k);
      equations.load(of.loads[k].joint, {f.x, f.y});
    }
    return equations.solve();
  }

  template <class T>
  void by_equations(Ledger<T>& ledger) const {
    ledger.route("equilibrium equations");
    const auto found = once([this] { return solved<T>(); });
    const auto reaction = [this, found](std::size_t component) { return found()[of.bars() + component]; };
    put_hinge(ledger, [reaction] { return Vector<T>{reaction(0), reaction(1)}; });
    ledger.put(reaction_of_roller(of), [&] { return reaction(2); });
    put_forces(ledger, once([this, found] {
                 std::vector<T> forces;
                 for (std::size_t i = 0; i < of.bars(); ++i)
                   forces.push_back(signs_only<T> ? found()[i] : found()[i] * length<T>(i));
                 return forces;
               }));
    ledger.put(sum_of_forces_times_lengths(), [&] {
      // From the hinge: its own force has no part in it.
      const Point<T> A = joint<T>(of.hinge());
      T sum = reaction(2) * geometry::dot(joint<T>(of.roller_at()) - A, along_roller<T>());
      for (std::size_t k = 0; k < of.loads.size(); ++k) {
        sum = sum + geometry::dot(joint<T>(of.loads[k].joint) - A, load<T>(k));
      }
      return sum;
    });
  }
};

}  // namespace epure::trusses
