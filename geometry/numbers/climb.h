// From one number to the next, until every quantity of a scene is certain.
//
// A scene is a construction that can run on any number:
//   const auto scene = [&]<class T>() -> std::vector<Reading<T>> { ... };
// It returns the same quantities in the same order for every T, and may throw Undecided (nothing of it can be said
// with this number), LeavesTheTower (Exact only) or Impossible (which goes through to the caller of the climb).
//
// The rungs:
//   Bounded                       settles what comes out as a point, and what is proved absent
//   Deep 128, 256, ... 4096       each settles what has become certain, and narrows the rest
//   Exact, or Generic and then Calcium if the scene leaves the tower: once, after Deep 512, when a quantity may still
//   be
//     zero or has no enclosure, and is worth a proof. Of these runs only three things are used: that a quantity is
//     zero, that it is not (then none of them is asked again), and that it is absent. A scene may therefore run on
//     these with other units than on Bounded and Deep (unit crank speed, so that π stays out), as long as zeros and
//     absences are the same.
#pragma once

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

#include <algorithm>
#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace epure::geometry {

// What one number can say of a quantity: a value, or that it does not exist (or lies at infinity), or nothing.
template <class T>
class Reading {
 public:
  static Reading of(T value) { return Reading(std::move(value), false, {}); }
  // The reason is meant for the user.
  static Reading absent(Words reason) { return Reading({}, true, std::move(reason)); }
  // The reason is kept for the case that no number can tell.
  static Reading undecided(Words reason) { return Reading({}, false, std::move(reason)); }

  // The reading of one quantity of several: an Undecided or Impossible thrown while computing it concerns it alone.
  template <class Computation>
  static Reading from(const Computation& computation) {
    try {
      return of(computation());
    } catch (const Undecided& open) {
      return undecided(open.words());
    } catch (const Impossible& proved) {
      return absent(proved.words());
    }
  }

  const std::optional<T>& value() const { return value_; }
  bool is_absent() const { return is_absent_; }
  const Words& reason() const { return reason_; }

 private:
  Reading(std::optional<T> value, bool is_absent, Words reason)
      : value_(std::move(value)), is_absent_(is_absent), reason_(std::move(reason)) {}

  std::optional<T> value_;
  bool is_absent_;
  Words reason_;
};

// A quantity after the climb.
struct Settled {
  enum class Kind {
    certain,    // the value is the double nearest to the true value, and the enclosure at most 2 ulp wide
    enclosed,   // the true value lies in the enclosure; the reason says why no more is known
    absent,     // proved not to exist; reason
    undecided,  // no number could tell; reason
    unbounded   // computed with doubles only: a value without any bound
  };
  Kind kind = Kind::undecided;
  Enclosure enclosure = {};  // of certain, enclosed; for unbounded the ends are infinite
  Words reason = {};
  // Which number settled or last narrowed it: "Fast", "Bounded", "Deep 128", ..., "Exact", "Calcium".
  std::string rung = {};
};

// Throws Undecided when no number could run the scene at all.
template <class Scene>
std::vector<Settled> climb(const Scene& scene);
// The same, where `is_worth_a_proof(i, so_far)` says whether quantity i is to be proved zero or absent, given what is
// known of all of them: not when another route has settled it already.
template <class Scene, class Worth>
std::vector<Settled> climb(const Scene& scene, const Worth& is_worth_a_proof);

// One rung alone, to compare speed and error, or where its bounds are narrow enough. All throw Undecided as the scene
// does.
template <class Scene>
std::vector<Settled> only_fast(const Scene& scene);
template <class Scene>
std::vector<Settled> only_bounded(const Scene& scene);
template <class Scene>
std::vector<Settled> only_deep(const Scene& scene, long bits);

// The sign of one quantity. Rungs: Bounded, Deep 128, 256, 512, Exact, Generic, Deep 1024, 2048, 4096, Calcium. (More
// bits before Calcium because they cost microseconds where Calcium may take a second.)
struct Decision {
  Sign sign = Sign::undecided;
  std::string rung = {};  // which number answered; empty when none did
  Words reason = {};      // why the last one could not, when none did
};
// The scene returns the quantity: []<class T>() -> T.
template <class Scene>
Decision decide(const Scene& scene);

// A question that turns on several signs.
struct Answer {
  Truth truth = Truth::undecided;
  std::string rung = {};
  Words reason = {};
};
// The scene returns the answer: []<class T>() -> Truth. Rungs as in decide.
template <class Scene>
Answer ask(const Scene& scene);

// ---------------------------------------------------------------------------------------------------------------------

namespace climbing {

// Which quantities are wanted of the scene that this thread runs: all, unless a scope is open that says otherwise.
// With exact numbers one may cost more than all that are wanted, so who writes them down may leave others undecided.
class Wanted {
 public:
  explicit Wanted(const std::vector<bool>& these) : outer_(std::exchange(these_, &these)) {}
  ~Wanted() { these_ = outer_; }
  Wanted(const Wanted&) = delete;
  Wanted& operator=(const Wanted&) = delete;

  static bool is(std::size_t quantity) { return !these_ || these_->empty() || these_->at(quantity); }

 private:
  inline static thread_local const std::vector<bool>* these_ = nullptr;
  const std::vector<bool>* outer_;
};

// What a rung says of a quantity, once the number type is left behind.
struct Finding {
  enum class Kind { value, absent, undecided };
  Kind kind = Kind::undecided;
  Enclosure enclosure = {};            // of a value, from an enclosing number
  std::optional<double> certain = {};  // the double nearest to the value, when that is certain
  Sign proved = Sign::undecided;       // from an exact number; of its sign only whether it is zero counts
  Words reason = {};                   // of absent, undecided
};

// A whole run: the findings, or why there are none.
struct Run {
  std::vector<Finding> findings = {};
  std::optional<Words> failure = {};
};

// The state of the climb.
class Ledger {
 public:
  void take_enclosures(const std::string& rung, const Run& run);
  void take_proofs(const std::string& rung, const Run& run);

  bool is_settled() const;
  bool has_run() const { return has_run_; }
  std::size_t size() const { return entries_.size(); }
  // What is not settled; none before any run.
  std::vector<bool> open() const;
  // Quantity i may be zero or has no enclosure.
  bool needs_proof(std::size_t i) const;
  std::vector<Settled> result() const;

 private:
  struct Entry {
    Settled settled;
    bool is_final = false;
    bool has_enclosure = false;
    bool is_not_zero = false;  // proved
  };
  bool accept(const std::string& rung, const Run& run);
  static void narrow(Entry& entry, const std::string& rung, const Finding& finding);

  std::vector<Entry> entries_;
  Words failure_;                   // of the last run that said nothing
  std::vector<std::string> tried_;  // the rungs so far
  bool has_run_ = false;
};

inline Finding finding_of(Fast x) {
  const bool is_number = x - x == 0;  // neither infinite nor NaN
  if (!is_number) return {.reason = {"the computed value is not a number", "il valore calcolato non è un numero"}};
  return {.kind = Finding::Kind::value, .enclosure = {x, x, x}};
}

inline Finding finding_of(const Bounded& x) {
  const Enclosure ends = enclosure(x);
  const auto certain = ends.lower == ends.upper ? std::optional(ends.value) : std::nullopt;
  return {.kind = Finding::Kind::value, .enclosure = ends, .certain = certain};
}

inline Finding finding_of(const Deep& x) {
  return {.kind = Finding::Kind::value, .enclosure = enclosure(x), .certain = certain_double(x)};
}

template <class T>
requires std::same_as<T, Exact> || std::same_as<T, Generic> || std::same_as<T, Calcium> Finding
finding_of(const T& x) {
  return {.kind = Finding::Kind::value, .proved = sign(x)};
}

template <class T>
Finding finding_of(const Reading<T>& reading) {
  if (reading.value()) return finding_of(*reading.value());
  const auto kind = reading.is_absent() ? Finding::Kind::absent : Finding::Kind::undecided;
  return {.kind = kind, .reason = reading.reason()};
}

// Runs the scene on T, inside the scope that is open. A reading that is not wanted is not looked at: with Calcium a
// look may be dear. None of `wanted` means all.
template <class T, class Scene>
Run run(const Scene& scene, const std::vector<bool>& wanted = {}) {
  const Wanted scope(wanted);
  try {
    const std::vector<Reading<T>> readings = scene.template operator()<T>();
    Run result;
    for (std::size_t i = 0; i < readings.size(); ++i)
      result.findings.push_back(Wanted::is(i) ? finding_of<T>(readings[i]) : Finding{});
    return result;
  } catch (const Undecided& open) {
    return {{}, open.words()};
  }
}

// What is settled is not found again.
template <class Scene>
void run_deep(Ledger& ledger, const Scene& scene, long bits) {
  const Arithmetic<Deep> scope(bits);
  ledger.take_enclosures("Deep " + std::to_string(bits), run<Deep>(scene, ledger.open()));
}

// Before any run nothing is known, not even how many quantities there are: everything is wanted.
template <class Scene, class Worth>
void run_exactly(Ledger& ledger, const Scene& scene, const Worth& is_worth_a_proof) {
  std::vector<bool> chosen;
  const auto choose = [&] {
    chosen.clear();
    if (!ledger.has_run()) return true;
    const std::vector<Settled> so_far = ledger.result();
    for (std::size_t i = 0; i < ledger.size(); ++i)
      chosen.push_back(ledger.needs_proof(i) && is_worth_a_proof(i, so_far));
    return std::find(chosen.begin(), chosen.end(), true) != chosen.end();
  };
  if (!choose()) return;
  try {
    const Arithmetic<Exact> scope;
    ledger.take_proofs("Exact", run<Exact>(scene, chosen));
    return;
  } catch (const LeavesTheTower&) {
    // the next two can go on
  }
  {
    const Arithmetic<Generic> scope;
    ledger.take_proofs("Generic", run<Generic>(scene, chosen));
  }
  if (!choose()) return;
  const Arithmetic<Calcium> scope;
  ledger.take_proofs("Calcium", run<Calcium>(scene, chosen));
}

// One rung alone; what it throws goes through.
template <class T, class Scene, class... Scope>
std::vector<Finding> run_alone(const Scene& scene, Scope... scope_argument) {
  [[maybe_unused]] const Arithmetic<T> scope(scope_argument...);
  const std::vector<Reading<T>> readings = scene.template operator()<T>();
  std::vector<Finding> findings;
  for (const Reading<T>& reading : readings) findings.push_back(finding_of<T>(reading));
  return findings;
}

std::vector<Settled> settle_fast(const std::vector<Finding>& findings);
std::vector<Settled> settle_bounded(const std::vector<Finding>& findings);
std::vector<Settled> settle_deep(const std::vector<Finding>& findings, long bits);

// The first verdict that is not undecided. The question is []<class T>() -> Verdict.
template <class Verdict, class Question>
class FirstVerdict {
 public:
  explicit FirstVerdict(const Question& question) : question_(question) {}

  void up_the_rungs() {
    if (on<Bounded>("Bounded")) return;
    for (const long bits : {128L, 256L, 512L})
      if (on<Deep>("Deep " + std::to_string(bits), bits)) return;
    if (on<Exact>("Exact")) return;
    if (has_left_the_tower && on<Generic>("Generic")) return;
    for (const long bits : {1024L, 2048L, 4096L})
      if (on<Deep>("Deep " + std::to_string(bits), bits)) return;
    if (!has_left_the_tower) return;
    on<Calcium>("Calcium");
  }

  Verdict verdict = Verdict::undecided;
  std::string rung;
  Words reason;

 private:
  bool has_left_the_tower = false;

  template <class T, class... Scope>
  bool on(const std::string& name, Scope... scope_argument) {
    const Arithmetic<T> scope(scope_argument...);
    reason = {"the sign of a quantity that may be zero", "il segno di una grandezza che può essere zero"};
    try {
      verdict = question_.template operator()<T>();
    } catch (const Undecided& open) {
      reason = open.words();
    } catch (const LeavesTheTower& outside) {
      reason = outside.words();
      has_left_the_tower = true;
    }
    if (verdict == Verdict::undecided) return false;
    rung = name;
    reason = {};
    return true;
  }

  const Question& question_;
};

}  // namespace climbing

template <class Scene>
std::vector<Settled> climb(const Scene& scene) {
  return climb(scene, [](std::size_t, const std::vector<Settled>&) { return true; });
}

template <class Scene, class Worth>
std::vector<Settled> climb(const Scene& scene, const Worth& is_worth_a_proof) {
  climbing::Ledger ledger;
  {
    const Arithmetic<Bounded> scope;
    ledger.take_enclosures("Bounded", climbing::run<Bounded>(scene));
  }
  for (const long bits : {128L, 256L, 512L, 1024L, 2048L, 4096L}) {
    if (ledger.is_settled()) break;
    climbing::run_deep(ledger, scene, bits);
    if (bits == 512) climbing::run_exactly(ledger, scene, is_worth_a_proof);
  }
  return ledger.result();
}

template <class Scene>
std::vector<Settled> only_fast(const Scene& scene) {
  return climbing::settle_fast(climbing::run_alone<Fast>(scene));
}

template <class Scene>
std::vector<Settled> only_bounded(const Scene& scene) {
  return climbing::settle_bounded(climbing::run_alone<Bounded>(scene));
}

template <class Scene>
std::vector<Settled> only_deep(const Scene& scene, long bits) {
  return climbing::settle_deep(climbing::run_alone<Deep>(scene, bits), bits);
}

template <class Scene>
Decision decide(const Scene& scene) {
  const auto question = [&]<class T>() { return sign(scene.template operator()<T>()); };
  climbing::FirstVerdict<Sign, decltype(question)> first(question);
  first.up_the_rungs();
  return {first.verdict, first.rung, first.reason};
}

template <class Scene>
Answer ask(const Scene& scene) {
  climbing::FirstVerdict<Truth, Scene> first(scene);
  first.up_the_rungs();
  return {first.verdict, first.rung, first.reason};
}

}  // namespace epure::geometry
