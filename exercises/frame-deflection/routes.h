// The frame by all its routes: cut pieces, elastic weights and their second polygon; from the clamp, virtual work and
// the matrix of stiffness.
#pragma once

#include "exercises/frame-deflection/problem.h"
#include "exercises/frame-deflection/quantities.h"
#include "exercises/kit/proof/ledger.h"
#include "exercises/kit/proof/once.h"
#include "geometry/analytic/frame_stiffness.h"
#include "geometry/analytic/frame_work.h"
#include "geometry/analytic/section_formulas.h"
#include "geometry/analytic/torsion_series.h"
#include "geometry/statics/rectangle_torsion.h"
#include "geometry/statics/second_polygon.h"
#include "geometry/statics/section.h"

namespace epure::frame_deflection {

inline constexpr std::array<const char*, 4> nodes{"O", "B", "C", "A"};

template <class T>
void put_rational(Ledger<T>& ledger, const Quantity& quantity, const Rational& value) {
  ledger.put(quantity, geometry::from_rational<T>(value));
}

template <class T>
struct Stiffness {
  geometry::BarStiffness<T> rectangle, circle;
  const geometry::BarStiffness<T>& of(int bar) const { return bar == 2 ? circle : rectangle; }
};

// By Mohr's circles of a bar in tension, σ = 1: τ = ½ on the planes at 45°, γ the difference of the strains.
inline Rational shear_modulus_by_circles(const Problem& of) {
  const Rational along = 1 / of.E, across = -of.nu / of.E;
  return Rational(1, 2) / (along - across);
}

template <class T>
Stiffness<T> constructed_stiffness(const Problem& of) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const T E = number(of.E), G = number(shear_modulus_by_circles(of));
  const auto circle = geometry::circle<T>(number(of.phi));
  return {{E * geometry::rectangle<T>(number(of.s_r), number(of.H_r)).J_x,
           G * geometry::rectangle_torsion<T>(of.H_r, of.s_r)},
          {E * circle.J_x, G * circle.J_p()}};
}

template <class T>
T analytic_torsion_constant(const Problem& of) {
  return geometry::analytic::torsion_series<T>(of.H_r, of.s_r);
}
inline Rational analytic_shear_modulus(const Problem& of) { return of.E / (2 * (1 + of.nu)); }
// ∫ 2πr·r² dr.
template <class T>
T polar_by_rings(const Rational& diameter) {
  const Rational R = diameter / 2;
  return geometry::pi<T>() * geometry::from_rational<T>(R * R * R * R / 2);
}

template <class T>
Stiffness<T> analytic_stiffness(const Problem& of) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const T G = number(analytic_shear_modulus(of));
  return {{number(of.E * geometry::analytic::rectangle_J(of.s_r, of.H_r)), G * analytic_torsion_constant<T>(of)},
          {number(of.E) * geometry::analytic::circle_J<T>(of.phi), G * polar_by_rings<T>(of.phi)}};
}

template <class T>
void put_sections(Ledger<T>& ledger, const Problem& of) {
  const auto number = [](const Rational& q) { return geometry::from_rational<T>(q); };
  const T width = number(of.s_r), height = number(of.H_r);
  const auto rectangle = geometry::rectangle<T>(width, height);
  ledger.route("construction");
  put_rational(ledger, shear_modulus(), shear_modulus_by_circles(of));
  ledger.put(inertia("x1"), rectangle.J_x);
  ledger.put(inertia("y1"), rectangle.J_y);
  ledger.put(inertia("p1"), rectangle.J_p());
  ledger.put(inertia("t1"), [&] { return geometry::rectangle_torsion<T>(of.H_r, of.s_r); });
  ledger.put(inertia("x2"), [&] { return geometry::circle<T>(number(of.phi)).J_x; });
  ledger.put(inertia("p2"), [&] { return geometry::circle<T>(number(of.phi)).J_p(); });
  ledger.route("analytic");
  put_rational(ledger, shear_modulus(), analytic_shear_modulus(of));
  put_rational(ledger, inertia("x1"), geometry::analytic::rectangle_J(of.s_r, of.H_r));
  put_rational(ledger, inertia("y1"), geometry::analytic::rectangle_J(of.H_r, of.s_r));
  put_rational(ledger, inertia("p1"), of.s_r * of.H_r * (of.s_r * of.s_r + of.H_r * of.H_r) / 12);
  ledger.put(inertia("t1"), [&] { return analytic_torsion_constant<T>(of); });
  ledger.put(inertia("x2"), [&] { return geometry::analytic::circle_J<T>(of.phi); });
  ledger.put(inertia("p2"), [&] { return polar_by_rings<T>(of.phi); });
}

inline std::vector<geometry::CutBar> cut_bars(const Problem& of) {
  std::vector<geometry::CutBar> all;
  for (const geometry::FrameBar& bar : of.bars()) all.push_back(geometry::cut_bar(bar, of.P, of.loaded()));
  return all;
}

// Bar i begins in node i - 1 and ends in node i.
template <class T>
void put_moments(Ledger<T>& ledger, int bar, const Rational& start, const Rational& middle, const Rational& end,
                 const Rational& twist) {
  put_rational(ledger, bending(nodes[bar - 1], bar), start);
  put_rational(ledger, bending("mid", bar), middle);
  put_rational(ledger, bending(nodes[bar], bar), end);
  put_rational(ledger, torsion(bar), twist);
}

// The clamp holds what is cut off it in equilibrium.
template <class T>
void by_cut_pieces(Ledger<T>& ledger, const Problem& of) {
  const std::vector<geometry::CutBar> bars = cut_bars(of);
  const auto M = geometry::moment_of_upright(-of.P, of.loaded(), bars.front().bar.from);
  ledger.route("construction");
  put_rational(ledger, clamp_force(), of.P);
  put_rational(ledger, clamp_couple("x"), -M.x);
  put_rational(ledger, clamp_couple("y"), -M.y);
  put_rational(ledger, shear(), of.P);
  for (int i = 1; i <= 3; ++i) {
    const geometry::CutBar& at = bars[i - 1];
    put_moments(ledger, i, at.start.bending, at.middle.bending, at.end.bending, at.middle.torsion);
  }
}

template <class T>
void put_node(Ledger<T>& ledger, const std::string& node, const std::function<T()>& theta_x,
              const std::function<T()>& theta_y, const std::function<T()>& w) {
  ledger.put(rotation(node, "x"), theta_x);
  ledger.put(rotation(node, "y"), theta_y);
  ledger.put(rise(node), w);
}

// Displacements as moments of the elastic weights; the energies by Clapeyron, from the work the load does by them.
template <class T>
void by_elastic_weights(Ledger<T>& ledger, const Problem& of) {
  const std::vector<geometry::CutBar> bars = cut_bars(of);
  const auto weighed = once([&] {
    const Stiffness<T> stiffness = constructed_stiffness<T>(of);
    geometry::WeighedBars<T> all;
    for (int i = 1; i <= 3; ++i) all.weights.push_back(geometry::elastic_weights(bars[i - 1], stiffness.of(i)));
    return all;
  });
  const geometry::Point<T> A = geometry::in_number<T>(of.loaded());
  const T half_load = geometry::from_rational<T>(of.P / 2);
  const auto bends = [&](int i) { return -geometry::rise(weighed().weights[i - 1].bending, A); };
  const auto twists = [&](int i) { return -geometry::moment(weighed().weights[i - 1].torsion, A); };
  ledger.route("construction");
  for (int i = 1; i <= 3; ++i) {
    put_node<T>(
        ledger, nodes[i], [&, i] { return weighed().rotation(i).x; }, [&, i] { return weighed().rotation(i).y; },
        [&, i] { return weighed().rise(i, geometry::in_number<T>(bars[i - 1].bar.to())); });
    ledger.put(bending_share(i), [&, i] { return bends(i); });
    if (i < 3) ledger.put(torsion_share(i), [&, i] { return twists(i); });
    ledger.put(energy(i), [&, i] { return half_load * (bends(i) + twists(i)); });
  }
  ledger.put(whole_energy(), [&] { return -(half_load * weighed().rise(3, A)); });
  ledger.put(deflection(), [&] { return -weighed().rise(3, A); });
}

// Each bar's polygon from a level tangent, and all of them in a chain: from where the bar before ends, as steeply as
// its end has turned.
template <class T>
struct Strung {
  std::vector<geometry::StrungBar<T>> own, chained;
};

template <class T>
Strung<T> strung(const Problem& of) {
  const Stiffness<T> stiffness = constructed_stiffness<T>(of);
  const geometry::BarState<T> level{T(0), T(0), T(0)};
  geometry::BarState<T> state = level;
  Strung<T> all;
  int i = 1;
  for (const geometry::CutBar& cut : cut_bars(of)) {
    all.own.push_back(geometry::string_bar(cut, level, stiffness.of(i)));
    all.chained.push_back(geometry::string_bar(cut, state, stiffness.of(i++)));
    state = all.chained.back().end.round_the_corner();
  }
  return all;
}

// What the sheets draw of it: corners of the polygons, ends of the tangents, weights.
template <class T, class Find>
void draw_polygons(Ledger<T>& ledger, const Problem& of, const Find& strung) {
  Rational before = 0;
  for (int i = 1; i <= 3; ++i) {
    const std::string number = std::to_string(i);
    const Rational length = of.lengths()[i - 1];
    for (int k = 0; k < 4; ++k) {
      const std::string name = number + "_" + std::to_string(k);
      ledger.draws_point("own_" + name, [&, i, k] { return strung().own[i - 1].corners[k]; });
      ledger.draws_point("chain_" + name, [&, i, k, before] {
        const geometry::Point<T> corner = strung().chained[i - 1].corners[k];
        return geometry::Point<T>{geometry::from_rational<T>(before) + corner.x, corner.y};
      });
    }
    ledger.draws_point("tangent_" + number, [&, i, before, length] {
      const auto& at = strung().chained[i - 1].corners;
      return geometry::Point<T>{geometry::from_rational<T>(before + length), at[0].y + T(3) * (at[1].y - at[0].y)};
    });
    ledger.tells(elastic_weight(i), [&, i] { return strung().own[i - 1].end.slope; });
    before += length;
  }
}

template <class T>
void by_second_polygon(Ledger<T>& ledger, const Problem& of) {
  const auto bars = of.bars();
  const auto polygons = once([&] { return strung<T>(of); });
  ledger.route("second polygon");
  for (int i = 1; i <= 3; ++i) {
    const auto end = [&, i] { return polygons().chained[i - 1].end; };
    put_node<T>(
        ledger, nodes[i], [&, i, end] { return end().rotation(bars[i - 1]).x; },
        [&, i, end] { return end().rotation(bars[i - 1]).y; }, [end] { return end().rise; });
    if (i > 1) ledger.put(bending_share(i), [&, i] { return -polygons().own[i - 1].end.rise; });
  }
  ledger.put(deflection(), [&] { return -polygons().chained[2].end.rise; });
  draw_polygons(ledger, of, polygons);
}

template <class T>
void by_virtual_work(Ledger<T>& ledger, const Problem& of) {
  namespace analytic = geometry::analytic;
  const analytic::ChainOfBars chain{of.lengths()};
  const auto clamp = chain.at_clamp({2, -of.P});
  const std::vector<analytic::BarMoments> M = chain.moments({2, -of.P});
  ledger.route("analytic");
  put_rational(ledger, clamp_force(), clamp.force);
  put_rational(ledger, clamp_couple("x"), clamp.couple_x);
  put_rational(ledger, clamp_couple("y"), clamp.couple_y);
  put_rational(ledger, shear(), (M[0].bending_at_end - M[0].bending_at_start) / of.L_2);
  for (int i = 1; i <= 3; ++i)
    put_moments(ledger, i, M[i - 1].bending_at_start, M[i - 1].bending_in_middle(), M[i - 1].bending_at_end,
                M[i - 1].torsion);

  const auto stiffness = once([&] { return analytic_stiffness<T>(of); });
  const auto bends = [&](int i, const Rational& work) {
    return geometry::quotient(geometry::from_rational<T>(work), stiffness().of(i).bending);
  };
  const auto twists = [&](int i, const Rational& work) {
    return geometry::quotient(geometry::from_rational<T>(work), stiffness().of(i).torsion);
  };
  const auto works = [&](const analytic::EndAction& unit) {
    const auto m = chain.moments(unit);
    std::vector<analytic::Work> all;
    for (std::size_t i = 0; i < 3; ++i) all.push_back(analytic::work(M[i], m[i], of.lengths()[i]));
    return all;
  };
  const auto moved = [&](const std::vector<analytic::Work>& by) {
    T sum(0);
    for (int i = 1; i <= 3; ++i) sum += bends(i, by[i - 1].bending) + twists(i, by[i - 1].torsion);
    return sum;
  };
  ledger.route("virtual work");
  for (std::size_t i = 0; i < 3; ++i)
    put_node<T>(
        ledger, nodes[i + 1],
        [&, i] {
          return moved(works({i, 0, 1, 0}));
        },
        [&, i] {
          return moved(works({i, 0, 0, 1}));
        },
        [&, i] {
          return moved(works({i, 1, 0, 0}));
        });
  const auto downwards = works({2, -1, 0, 0}), of_itself = works({2, -of.P, 0, 0});
  const T half = geometry::from_rational<T>(Rational(1, 2));
  const auto stored = [&](int i) {
    return half * (bends(i, of_itself[i - 1].bending) + twists(i, of_itself[i - 1].torsion));
  };
  for (int i = 1; i <= 3; ++i) {
    ledger.put(bending_share(i), [&, i] { return bends(i, downwards[i - 1].bending); });
    if (i < 3) ledger.put(torsion_share(i), [&, i] { return twists(i, downwards[i - 1].torsion); });
    ledger.put(energy(i), [&, i] { return stored(i); });
  }
  const auto all_stored = [&] { return stored(1) + stored(2) + stored(3); };
  ledger.put(whole_energy(), all_stored);
  ledger.put(deflection(), [&] { return geometry::quotient(T(2) * all_stored(), geometry::from_rational<T>(of.P)); });
  // With the polar moment of the rectangle, as the source has it.
  const auto by_polar = [&] {
    const T G_J_p1 = geometry::from_rational<T>(analytic_shear_modulus(of) * of.s_r * of.H_r *
                                                (of.s_r * of.s_r + of.H_r * of.H_r) / 12);
    return geometry::quotient(geometry::from_rational<T>(downwards[0].torsion), G_J_p1);
  };
  ledger.tells(Quantity{"delta_torsion_1_p", "$δ_{t1,p}$", "m", {}}, by_polar);
  ledger.tells(Quantity{"delta_A_p", "$δ_{A,p}$", "m", {}},
               [&] { return moved(downwards) - twists(1, downwards[0].torsion) + by_polar(); });
}

template <class T>
void by_stiffness(Ledger<T>& ledger, const Problem& of) {
  namespace analytic = geometry::analytic;
  const auto chain = once([&] {
    const Stiffness<T> stiffness = analytic_stiffness<T>(of);
    std::vector<analytic::ElasticBar<T>> bars;
    for (int i = 1; i <= 3; ++i)
      bars.push_back(
          {geometry::from_rational<T>(of.lengths()[i - 1]), stiffness.of(i).bending, stiffness.of(i).torsion});
    return analytic::elastic_chain(bars, geometry::from_rational<T>(-of.P));
  });
  ledger.route("stiffness matrix");
  for (int i = 1; i <= 3; ++i) {
    const auto node = [&, i ]() -> const auto& { return chain().nodes[i - 1]; };
    put_node<T>(
        ledger, nodes[i], [node] { return node().theta_x; }, [node] { return node().theta_y; },
        [node] { return node().rise; });
    ledger.put(energy(i), [&, i] { return chain().energies[i - 1]; });
  }
  ledger.put(deflection(), [&] { return -chain().nodes[2].rise; });
}

struct Routes {
  Problem problem;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    put_sections(ledger, problem);
    by_cut_pieces(ledger, problem);
    by_elastic_weights(ledger, problem);
    by_second_polygon(ledger, problem);
    by_virtual_work(ledger, problem);
    by_stiffness(ledger, problem);
    return ledger;
  }
};

}  // namespace epure::frame_deflection
