// One family with every number: how long a result takes, how far off it is, what was promised.
#pragma once

#include "bench/family.h"
#include "bench/measured.h"
#include "bench/results.h"
#include "bench/timing.h"

#include <cmath>
#include <optional>

namespace epure::bench {

inline constexpr long comparing_bits = 1024;  // more than the 110 to 120 digits of the references have

// |x - reference| / |reference|, and the half width of x by |reference|. Of a reference that is not zero.
struct Compared {
  double value = 0, error = 0;
  std::optional<double> bound = {};
};
Compared compared(Fast x, const Rational& reference);
Compared compared(const Bounded& x, const Rational& reference);
Compared compared(const Deep& x, const Rational& reference);
Compared compared(const Exact& x, const Rational& reference);

// Which number proved it.
void count(const Decided& decided, DecisionResult& result);

inline constexpr double deep_asks = 1e-30;

// Collects what one number says of one result after the other.
class Account {
 public:
  Account(const char* family, const char* number) { result_.family = family, result_.number = number; }

  // The number gave up the whole case, with these results.
  void give_up(const CorpusCase& c, const std::vector<std::string>& names) {
    result_.results += names.size();
    handed_ += names.size();
    if (result_.number != "fast") return;
    for (const std::string& name : names)
      if (c.reference(name) != "absent") ++result_.wrong;
  }

  // Returns whether the number settled the result.
  template <class T>
  bool take(const CorpusCase& c, const std::string& name, const Reading<T>& reading) {
    ++result_.results;
    const bool settled = weigh(c.name + ": " + name, c.reference(name), reading);
    if (!settled) ++handed_;
    return settled;
  }

  // With the median of the errors, and what was handed over.
  FamilyResult result() const;

 private:
  template <class T>
  bool weigh(const std::string& what, const std::string& reference, const Reading<T>& reading) {
    constexpr bool is_fast = std::same_as<T, Fast>;
    if (reference == "absent") {
      if (is_fast && reading.value()) ++result_.wrong;
      return is_fast || reading.is_absent();
    }
    if (!reading.value()) {
      if (is_fast || reading.is_absent()) ++result_.wrong;
      return false;
    }
    const Rational truth = exact_decimal(reference);
    if (truth == 0) {
      const Sign said = sign(*reading.value());
      if (said == Sign::negative || said == Sign::positive) ++result_.wrong;
      return is_fast || said == Sign::zero;
    }
    return note(what, compared(*reading.value(), truth), truth, is_fast);
  }

  bool note(const std::string& what, const Compared& x, const Rational& truth, bool is_fast);

  FamilyResult result_;
  std::size_t handed_ = 0;
  std::vector<double> errors_;
};

template <class Family>
struct CaseOf {
  const CorpusCase* from;
  typename Family::Givens givens;
};

// The results that each case has: those of any case that Deep can tell all of.
template <class Family>
std::vector<std::string> results_in(const std::vector<CaseOf<Family>>& cases) {
  const Arithmetic<Deep> scope(2048);
  for (const CaseOf<Family>& each : cases) {
    try {
      return readings<Family, Deep>(each.givens).names;
    } catch (const std::runtime_error&) {
    }
  }
  throw std::runtime_error(std::string(Family::name) + ": a corpus without a case that has results");
}

// A result that the clock waits for and nobody reads.
template <class T>
struct Computed {
  template <class Computation>
  void operator()(const char*, const Computation& computation) const {
    try {
      keep(computation());
    } catch (const std::runtime_error&) {  // undecided, impossible, beyond the tower: it costs what it costs
    }
  }
};

// One number on one case. Returns whether it settled all results, and all of them have values: then it is timed.
template <class Family, class T>
bool take_case(const CaseOf<Family>& of, const std::vector<std::string>& results, Account& account) {
  const Arithmetic<T> scope;
  bool all = true;
  try {
    const Readings<T> said = readings<Family, T>(of.givens);
    for (std::size_t i = 0; i < said.values.size(); ++i)
      all = account.take(*of.from, said.names[i], said.values[i]) && said.values[i].value() && all;
    return all;
  } catch (const Undecided&) {
  } catch (const Impossible&) {
  } catch (const LeavesTheTower&) {
  }
  account.give_up(*of.from, results);
  return false;
}

// From exact givens, inside a scope.
template <class Family, class T>
void run_from_givens(const typename Family::Givens& of) {
  try {
    const typename Family::template On<T> read(of);
    const Computed<T> clock;
    Family::template results<T>(read, clock);
  } catch (const std::runtime_error&) {
  }
}

inline bool is_settled(const std::string& reference, const Reading<Deep>& reading) {
  if (reference == "absent") return reading.is_absent();
  if (!reading.value()) return false;
  const Rational truth = exact_decimal(reference);
  if (truth == 0) return sign(*reading.value()) == Sign::zero;
  return compared(*reading.value(), truth).bound.value_or(1) <= deep_asks;
}

// The bits with which Deep settles every result of a case; none when 2048 are too few.
template <class Family>
std::optional<long> bits_for(const CaseOf<Family>& of) {
  for (const long bits : {128L, 256L, 512L, 1024L, 2048L}) {
    const Arithmetic<Deep> scope(bits);
    try {
      const Readings<Deep> said = readings<Family, Deep>(of.givens);
      bool all = true;
      for (std::size_t i = 0; i < said.values.size(); ++i)
        all = all && is_settled(of.from->reference(said.names[i]), said.values[i]);
      if (all) return bits;
    } catch (const std::runtime_error&) {  // with more bits perhaps
    }
  }
  return {};
}

// Fast and Bounded read the givens beforehand. Exact numbers are made in a tower of their own for each case, which
// ends with it: so reading is part of the price.
template <class Family, class T>
double seconds_for(const std::vector<const CaseOf<Family>*>& cases, double budget) {
  if constexpr (std::same_as<T, Exact>) {
    const auto all = [&] {
      for (const CaseOf<Family>* each : cases) {
        const Arithmetic<T> tower;
        run_from_givens<Family, T>(each->givens);
      }
    };
    return seconds_per_call(all, budget);
  } else {
    const Arithmetic<T> scope;
    std::vector<typename Family::template On<T>> read;
    for (const CaseOf<Family>* each : cases) read.emplace_back(each->givens);
    const Computed<T> clock;
    const auto all = [&] {
      for (const auto& each : read) {
        try {
          Family::template results<T>(each, clock);
        } catch (const std::runtime_error&) {
        }
      }
    };
    return seconds_per_call(all, budget);
  }
}

// The whole family with one number, timed over the cases it settles (over all when it settles none).
template <class Family, class T>
FamilyResult measure(const char* number, const std::vector<CaseOf<Family>>& cases, double budget) {
  Account account(Family::name, number);
  const std::vector<std::string> results = results_in(cases);
  std::vector<const CaseOf<Family>*> timed;
  for (const CaseOf<Family>& each : cases)
    if (take_case<Family, T>(each, results, account)) timed.push_back(&each);
  if (timed.empty())
    for (const CaseOf<Family>& each : cases) timed.push_back(&each);
  FamilyResult result = account.result();
  const double seconds = seconds_for<Family, T>(timed, budget);
  result.ns_per_result = 1e9 * seconds / static_cast<double>(results.size() * timed.size());
  return result;
}

// Climbing to the bits that suffice is part of the price, and a result that takes more than the first 128 counts as
// handed over.
template <class Family>
FamilyResult measure_deep(const std::vector<CaseOf<Family>>& cases, double budget) {
  Account account(Family::name, "deep");
  std::vector<std::pair<const CaseOf<Family>*, long>> timed;
  const std::vector<std::string> results = results_in(cases);
  std::size_t handed_over = 0;
  for (const CaseOf<Family>& each : cases) {
    const std::optional<long> bits = bits_for(each);
    if (bits != 128) handed_over += results.size();
    const Arithmetic<Deep> scope(bits.value_or(2048));
    try {
      bool all = bits.has_value();
      const Readings<Deep> said = readings<Family, Deep>(each.givens);
      for (std::size_t i = 0; i < said.values.size(); ++i)
        all = account.take(*each.from, said.names[i], said.values[i]) && said.values[i].value() && all;
      if (all) timed.emplace_back(&each, *bits);
    } catch (const std::runtime_error&) {
      account.give_up(*each.from, results);
    }
  }
  FamilyResult result = account.result();
  result.handed_over =
      static_cast<double>(handed_over) / static_cast<double>(std::max<std::size_t>(result.results, 1));
  const auto all = [&] {
    for (const auto& [each, last] : timed)
      for (long bits = 128; bits <= last; bits *= 2) {
        const Arithmetic<Deep> scope(bits);
        run_from_givens<Family, Deep>(each->givens);
      }
  };
  if (!timed.empty())
    result.ns_per_result = 1e9 * seconds_per_call(all, budget) / static_cast<double>(results.size() * timed.size());
  return result;
}

// Every question of the corpus, put thrice: the fastest counts.
template <class Family>
DecisionResult measure_decisions(const std::string& corpora) {
  DecisionResult result{.family = Family::name};
  for (const CorpusCase& each : read_corpus(corpora + "/" + Family::corpus))
    for (const Question& question : Family::questions(Family::givens(each))) {
      Decided decided;
      const double ms = 1e3 * least_seconds([&] { decided = question.ask(); }, 3);
      count(decided, result);
      if (ms <= result.slowest_ms) continue;
      result.slowest_ms = ms;
      result.slowest = each.name + ": " + question.name;
    }
  return result;
}

// fast, bounded, deep, exact. `budget`: seconds for each of them. Cases in which nothing exists are left out: there
// is nothing to be wrong about.
template <class Family>
std::vector<FamilyResult> measure_family(const std::string& corpora, double budget) {
  const std::vector<CorpusCase> corpus = read_corpus(corpora + "/" + Family::corpus);
  std::vector<CaseOf<Family>> cases;
  for (const CorpusCase& each : corpus)
    if (each.reference(Family::name) != "impossible") cases.push_back({&each, Family::givens(each)});
  return {measure<Family, Fast>("fast", cases, budget), measure<Family, Bounded>("bounded", cases, budget),
          measure_deep<Family>(cases, budget), measure<Family, Exact>("exact", cases, budget)};
}

template <class Family>
FamilyJob job() {
  return {Family::name, measure_family<Family>, measure_decisions<Family>};
}

}  // namespace epure::bench
