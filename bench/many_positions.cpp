#include "bench/many_positions.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/corpus.h"
#include "bench/measure_family.h"
#include "bench/sweeping/two_bounded.h"
#include "bench/timing.h"
#include "geometry/linkages/carried_out.h"
#include "geometry/mechanisms/second_order.h"

namespace epure::geometry::linkages {
template <>
struct Constant<TwoBounded> {
  static Vector<TwoBounded> direction(const Angle& angle) {
    const Vector<Bounded> both = Constant<Bounded>::direction(angle);
    return {TwoBounded(both.x), TwoBounded(both.y)};
  }
};
}  // namespace epure::geometry::linkages

namespace epure::bench {
namespace {

using namespace geometry;

// The crank turns fully: 0.15 + 0.45 < 0.37 + 0.4.
DrivenFourBar four_bar_by_hand() {
  return {{Rational(3, 20), Rational(37, 100), Rational(9, 20), Rational(2, 5), Rational(0)},
          Side::left,
          Rational(10),
          Rational(3),
          Rational(1, 2),
          Rational(1, 5)};
}

// The same as links and joints. Points: 0 and 1 are A0 and B0, then come A, B, C; of the six-bar D and E too.
Linkage four_bar() {
  const Own origin{0, 0};
  return {
      .links = {{.points = {{0, origin}, {1, {Rational(2, 5), 0}}}},
                {.points = {{0, origin}, {2, {Rational(3, 20), 0}}}},
                {.points = {{2, origin}, {3, {Rational(37, 100), 0}}, {4, {Rational(37, 200), Rational(37, 500)}}}},
                {.points = {{1, origin}, {3, {Rational(9, 20), 0}}}}},
      .drives = {TurnedLink{1, {}, {0, 10}, {0, 3}}},
      .chosen = {BesideLine{3, 2, 1, true}}};
}
// Watt's: two more links on coupler and rocker.
Linkage six_bar() {
  Linkage of = four_bar();
  of.links[3].points.push_back({5, {Rational(1, 10), Rational(1, 5)}});
  of.links.push_back({.points = {{4, {0, 0}}, {6, {Rational(3, 10), 0}}}});
  of.links.push_back({.points = {{5, {0, 0}}, {6, {Rational(7, 20), 0}}}});
  of.chosen.push_back(BesideLine{6, 4, 5, true});
  return of;
}

// Named as the corpus has them.
template <class T>
using Values = std::vector<std::pair<std::string, T>>;

template <class T, class Pair>
void add_pair(Values<T>& values, const std::string& name, const Pair& pair) {
  values.emplace_back("x_" + name, pair.x);
  values.emplace_back("y_" + name, pair.y);
}

template <class T>
Values<T> values_of(const SecondOrder<T>& at) {
  Values<T> all{{"omega_3", at.omega_3},
                {"alpha_3", at.alpha_3},
                {"omega_4", at.driven_velocity},
                {"alpha_4", at.driven_acceleration}};
  add_pair(all, "B", at.B), add_pair(all, "C", at.C), add_pair(all, "P0", at.P0), add_pair(all, "K", at.K),
      add_pair(all, "centre", at.centre);
  return all;
}

template <class T>
class ByHand {
 public:
  static constexpr const char *name = "four-bar by hand", *corpus = "four-bar";

  void run(std::span<const Vector<T>> cranks) {
    results_.resize(cranks.size());
    second_order_one_by_one<T>(driven_, cranks, std::span<SecondOrder<T>>(results_));
  }
  Values<T> last() const { return values_of(results_.back()); }

 private:
  const DrivenFourBar driven_ = four_bar_by_hand();
  std::vector<SecondOrder<T>> results_;
};

// Read once; what is found is written over what was found before.
template <class T>
struct Carried {
  explicit Carried(const Linkage& of)
      : linkage(of),
        steps(assur_groups(linkage)),
        carried_out(linkage, steps),
        at(carried_out.position_before(0, DriveAt<T>{0, {T(1), T(0)}, T(0)})),
        motion(carried_out.at_rest(at)) {
    at.wanted = Wanted::points;
  }
  Carried(const Carried&) = delete;
  Carried& operator=(const Carried&) = delete;

  void find(const Vector<T>& crank) {
    at.elsewhere->direction = crank;
    carried_out.place_all(at);
    carried_out.move_all(motion, at, rates);
  }

  const Linkage linkage;
  const std::vector<Step> steps;
  const CarriedOut<T> carried_out;
  const std::vector<DriveRates<T>> rates{{T(10), T(3)}};
  LinkagePosition<T> at;
  LinkageMotion<T> motion;
};

template <class T>
class FourBarCarriedOut {
 public:
  static constexpr const char *name = "four-bar", *corpus = "four-bar";

  void run(std::span<const Vector<T>> cranks) {
    results_.resize(cranks.size());
    for (std::size_t i = 0; i < cranks.size(); ++i) {
      of_.find(cranks[i]);
      const PlaneMotion<T>&coupler = of_.motion.links[2], &rocker = of_.motion.links[3];
      const std::vector<Point<T>>& points = of_.at.points;
      results_[i] = {points[2],
                     points[3],
                     points[4],
                     coupler.omega,
                     coupler.alpha,
                     rocker.omega,
                     rocker.alpha,
                     finite(coupler.pole()),
                     finite(coupler.acceleration_pole()),
                     finite(coupler.centre_of_curvature(points[4]))};
    }
  }
  Values<T> last() const { return values_of(results_.back()); }

 private:
  Carried<T> of_{four_bar()};
  std::vector<SecondOrder<T>> results_;
};

template <class T>
class SixBarCarriedOut {
 public:
  static constexpr const char *name = "six-bar", *corpus = "six-bar";

  void run(std::span<const Vector<T>> cranks) {
    for (const Vector<T>& crank : cranks) {
      of_.find(crank);
      keep(of_.motion);
    }
  }
  Values<T> last() const {
    const std::vector<PlaneMotion<T>>& links = of_.motion.links;
    Values<T> all{{"omega_5", links[4].omega},
                  {"alpha_5", links[4].alpha},
                  {"omega_6", links[5].omega},
                  {"alpha_6", links[5].alpha}};
    for (const auto& [letter, point] : {std::pair("B", 3), {"C", 4}, {"D", 5}, {"E", 6}}) {
      const Pin<T>& P = of_.motion.points[static_cast<std::size_t>(point)];
      add_pair(all, letter, P.at), add_pair(all, std::string("v") + letter, P.v),
          add_pair(all, std::string("a") + letter, P.a);
    }
    return all;
  }

 private:
  Carried<T> of_{six_bar()};
};

// Of a number, what is said of a position by it, and how many positions it is.
template <class T>
struct SaidBy {
  static constexpr int positions = 1;
  static Vector<T> direction(const Turn& turn) { return {cosine<T>(turn), sine<T>(turn)}; }
  static Compared compare(const T& x, const Rational& reference) { return compared(x, reference); }
};
template <>
struct SaidBy<TwoBounded> {
  static constexpr int positions = 2;
  static Vector<TwoBounded> direction(const Turn& turn) {
    const Vector<Bounded> both = SaidBy<Bounded>::direction(turn);
    return {TwoBounded(both.x), TwoBounded(both.y)};
  }
  static Compared compare(const TwoBounded& x, const Rational& reference) { return compared(x.lane(0), reference); }
};

template <class T, class Mechanism>
PositionResult measure_one(const char* number, const std::vector<CorpusCase>& corpus, double budget) {
  constexpr int count = 2000;
  Mechanism mechanism;
  PositionResult result{.mechanism = Mechanism::name, .number = number};
  for (const CorpusCase& each : corpus) {
    if (each.choices.at("mechanism") != Mechanism::corpus) continue;
    const Vector<T> crank = SaidBy<T>::direction(Turn{each.givens.at("turn")});
    mechanism.run(std::span(&crank, 1));
    for (const auto& [name, value] : mechanism.last()) {
      const Compared said = SaidBy<T>::compare(value, exact_decimal(each.reference(name)));
      result.max_relative_error = std::max(result.max_relative_error, said.error);
      if (said.bound) result.max_relative_bound = std::max(result.max_relative_bound.value_or(0), *said.bound);
    }
  }
  std::vector<Vector<T>> all_round;
  for (int k = 0; k < count; ++k) all_round.push_back(SaidBy<T>::direction(Turn{Rational(2 * k + 1, 2 * count)}));
  result.ns = 1e9 * seconds_per_call([&] { mechanism.run(all_round); }, budget) / (count * SaidBy<T>::positions);
  return result;
}

template <class T, class Scope>
void measure_each(const char* number, const std::vector<CorpusCase>& corpus, double budget,
                  std::vector<PositionResult>& results) {
  const Arithmetic<Scope> scope;
  results.push_back(measure_one<T, ByHand<T>>(number, corpus, budget));
  results.push_back(measure_one<T, FourBarCarriedOut<T>>(number, corpus, budget));
  results.push_back(measure_one<T, SixBarCarriedOut<T>>(number, corpus, budget));
}

}  // namespace

std::vector<PositionResult> measure_positions(const std::string& corpora, double budget) {
  const std::vector<CorpusCase> corpus = read_corpus(corpora + "/mechanisms.txt");
  std::vector<PositionResult> results;
  measure_each<Fast, Fast>("fast", corpus, budget / 9, results);
  measure_each<Bounded, Bounded>("bounded", corpus, budget / 9, results);
  measure_each<TwoBounded, Bounded>("bounded by twos", corpus, budget / 9, results);
  return results;
}

}  // namespace epure::bench
