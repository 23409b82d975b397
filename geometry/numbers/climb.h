// From one number to the next, until every quantity of a scene is certain.
//
// A scene is a construction that can run on any number:
//   const auto scene = [&]<class T>() -> std::vector<Reading<T>> { ... };
// It returns the same quantities in the same order for every T, and may throw Undecided (nothing of it can be said
// with this number), LeavesTheTower (Exact only) or Impossible (which goes through to the caller of the climb).
//
// The rungs:
//   Bounded                       settles what comes out as a point, and what is proved absent
//   Deep 128, 256, ... 2048       each settles what has become certain, and narrows the rest
//   Exact, or Calcium if the scene leaves the tower: once, after Deep 256, when a quantity may still be zero or has
//   no
//     enclosure, and is worth a proof (Calcium may take minutes). Of this run only two things are used: that a
//     quantity is zero, and that it is absent. A scene may therefore run on Exact and Calcium with other units than
//     on Bounded and Deep (unit crank speed, so that π stays out), as long as zeros and absences are the same.
#pragma once

#include "geometry/numbers/enclosure.h"
#include "geometry/numbers/numbers.h"

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
  static Reading absent(std::string reason) { return Reading({}, true, std::move(reason)); }
  // The reason is kept for the case that no number can tell.
  static Reading undecided(std::string reason) { return Reading({}, false, std::move(reason)); }

  // The reading of one quantity of several: an Undecided or Impossible thrown while computing it concerns it alone.
  template <class Computation>
  static Reading from(const Computation& computation) {
    try {
      return of(computation());
    } catch (const Undecided& open) {
      return undecided(open.what());
    } catch (const Impossible& proved) {
      return absent(proved.what());
    }
  }

  const std::optional<T>& value() const { return value_; }
  bool is_absent() const { return is_absent_; }
  const std::string& reason() const { return reason_; }

 private:
  Reading(std::optional<T> value, bool is_absent, std::string reason)
      : value_(std::move(value)), is_absent_(is_absent), reason_(std::move(reason)) {}

  std::optional<T> value_;
  bool is_absent_;
  std::string reason_;
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
  std::string reason = {};
  std::string rung =
      {};  // which number settled or last narrowed it: "Fast", "Bounded", "Deep 128", ..., "Exact", "Calcium"
};

// Throws Undecided when no number could run the scene at all.
template <class Scene>
std::vector<Settled> climb(const Scene& scene);
// The same, where `is_worth_a_proof(i, so_far)` says whether quantity i is to be proved zero or absent, given what is
// known of all of them: not when another route has settled it already.
template <class Scene, class Worth>
std::vector<Settled> climb(const Scene& scene, const Worth& is_worth_a_proof);

// One rung alone, to compare speed and error. Both throw Undecided as the scene does.
template <class Scene>
std::vector<Settled> only_fast(const Scene& scene);
template <class Scene>
std::vector<Settled> only_bounded(const Scene& scene);

// The sign of one quantity. Rungs: Bounded, Deep 128, Deep 256, Exact, Deep 512, 1024, 2048, Calcium. (More bits
// before Calcium because they cost microseconds where Calcium may take a second.)
struct Decision {
  Sign sign = Sign::undecided;
  std::string rung = {};    // which number answered; empty when none did
  std::string reason = {};  // why the last one could not, when none did
};
// The scene returns the quantity: []<class T>() -> T.
template <class Scene>
Decision decide(const Scene& scene);

// A question that turns on several signs.
struct Answer {
  Truth truth = Truth::undecided;
  std::string rung = {};
  std::string reason = {};
};
// The scene returns the answer: []<class T>() -> Truth. Rungs as in decide.
template <class Scene>
Answer ask(const Scene& scene);

// ---------------------------------------------------------------------------------------------------------------------

namespace climbing {

// What a rung says of a quantity, once the number type is left behind.
struct Finding {
  enum class Kind { value, absent, undecided };
  Kind kind = Kind::undecided;
  Enclosure enclosure = {};            // of a value, from an enclosing number
  std::optional<double> certain = {};  // the double nearest to the value, when that is certain
  bool proved_zero = false;            // from an exact number
  std::string reason = {};             // of absent, undecided
};

// A whole run: the findings, or why there are none.
struct Run {
  std::vector<Finding> findings = {};
  std::optional<std::string> failure = {};
};

// The state of the climb.
class Ledger {
 public:
  void take_enclosures(const std::string& rung, const Run& run);
  void take_proofs(const std::string& rung, const Run& run);

  bool is_settled() const;
  bool has_run() const { return has_run_; }
  std::size_t size() const { return entries_.size(); }
  // Quantity i may be zero or has no enclosure.
  bool needs_proof(std::size_t i) const;
  std::vector<Settled> result() const;

 private:
  struct Entry {
    Settled settled;
    bool is_final = false;
    bool has_enclosure = false;
  };
  bool accept(const std::string& rung, const Run& run);
  static void narrow(Entry& entry, const std::string& rung, const Finding& finding);

  std::vector<Entry> entries_;
  std::string failure_;  // of the last run that said nothing
  bool has_run_ = false;
};

inline Finding finding_of(Fast x) {
  const bool is_number = x - x == 0;  // neither infinite nor NaN
  if (!is_number) return {.reason = "the computed value is not a number"};
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

inline Finding finding_of(const Exact& x) { return {.kind = Finding::Kind::value, .proved_zero = x.is_zero()}; }

inline Finding finding_of(const Calcium& x) {
  return {.kind = Finding::Kind::value, .proved_zero = sign(x) == Sign::zero};
}

template <class T>
Finding finding_of(const Reading<T>& reading) {
  if (reading.value()) return finding_of(*reading.value());
  const auto kind = reading.is_absent() ? Finding::Kind::absent : Finding::Kind::undecided;
  return {.kind = kind, .reason = reading.reason()};
}

// Runs the scene on T, inside the scope that is open. A reading that is not wanted is not looked at: with Calcium a
// look may be dear.
template <class T, class Scene, class Wanted>
Run run(const Scene& scene, const Wanted& wanted) {
  try {
    const std::vector<Reading<T>> readings = scene.template operator()<T>();
    Run result;
    for (std::size_t i = 0; i < readings.size(); ++i)
      result.findings.push_back(wanted(i) ? finding_of<T>(readings[i]) : Finding{});
    return result;
  } catch (const Undecided& open) {
    return {{}, open.what()};
  }
}

template <class T, class Scene>
Run run(const Scene& scene) {
  return run<T>(scene, [](std::size_t) { return true; });
}

template <class Scene>
void run_deep(Ledger& ledger, const Scene& scene, long bits) {
  const Arithmetic<Deep> scope(bits);
  ledger.take_enclosures("Deep " + std::to_string(bits), run<Deep>(scene));
}

// Before any run nothing is known, not even how many quantities there are: everything is wanted.
template <class Scene, class Worth>
void run_exactly(Ledger& ledger, const Scene& scene, const Worth& is_worth_a_proof) {
  const auto wanted = [&](std::size_t i) {
    return ledger.needs_proof(i) && (!ledger.has_run() || is_worth_a_proof(i, ledger.result()));
  };
  bool is_any_wanted = !ledger.has_run();
  for (std::size_t i = 0; i < ledger.size(); ++i) is_any_wanted = is_any_wanted || wanted(i);
  if (!is_any_wanted) return;
  try {
    const Arithmetic<Exact> scope;
    ledger.take_proofs("Exact", run<Exact>(scene, wanted));
  } catch (const LeavesTheTower&) {
    const Arithmetic<Calcium> scope;
    ledger.take_proofs("Calcium", run<Calcium>(scene, wanted));
  }
}

// One rung alone; what it throws goes through.
template <class T, class Scene>
std::vector<Finding> run_alone(const Scene& scene) {
  const Arithmetic<T> scope;
  const std::vector<Reading<T>> readings = scene.template operator()<T>();
  std::vector<Finding> findings;
  for (const Reading<T>& reading : readings) findings.push_back(finding_of<T>(reading));
  return findings;
}

std::vector<Settled> settle_fast(const std::vector<Finding>& findings);
std::vector<Settled> settle_bounded(const std::vector<Finding>& findings);

// The first verdict that is not undecided. The question is []<class T>() -> Verdict.
template <class Verdict, class Question>
class FirstVerdict {
 public:
  explicit FirstVerdict(const Question& question) : question_(question) {}

  void up_the_rungs() {
    if (on<Bounded>("Bounded")) return;
    for (const long bits : {128L, 256L})
      if (on<Deep>("Deep " + std::to_string(bits), bits)) return;
    if (on<Exact>("Exact")) return;
    for (const long bits : {512L, 1024L, 2048L})
      if (on<Deep>("Deep " + std::to_string(bits), bits)) return;
    on<Calcium>("Calcium");
  }

  Verdict verdict = Verdict::undecided;
  std::string rung;
  std::string reason;

 private:
  template <class T, class... Scope>
  bool on(const std::string& name, Scope... scope_argument) {
    const Arithmetic<T> scope(scope_argument...);
    reason = "the sign of a quantity that may be zero";
    try {
      verdict = question_.template operator()<T>();
    } catch (const Undecided& open) {
      reason = open.what();
    } catch (const LeavesTheTower& outside) {
      reason = outside.what();
    }
    if (verdict == Verdict::undecided) return false;
    rung = name;
    reason.clear();
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
  for (const long bits : {128L, 256L, 512L, 1024L, 2048L}) {
    if (ledger.is_settled()) break;
    climbing::run_deep(ledger, scene, bits);
    if (bits == 256) climbing::run_exactly(ledger, scene, is_worth_a_proof);
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
