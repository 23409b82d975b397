#include "geometry/numbers/climb.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace epure::geometry::climbing {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool contains_zero(const Enclosure& x) { return x.lower <= 0 && x.upper >= 0; }

Settled certain_point(double value, const std::string& rung) {
  return {Settled::Kind::certain, {value, value, value}, {}, rung};
}

Settled without_value(const Finding& finding, const std::string& rung) {
  const auto kind = finding.kind == Finding::Kind::absent ? Settled::Kind::absent : Settled::Kind::undecided;
  return {kind, {}, finding.reason, rung};
}

// What no double bounds is not known by any: a number beyond the largest of them cannot be told, nor drawn.
Settled in_doubles(Settled settled) {
  if (settled.kind != Settled::Kind::enclosed) return settled;
  if (std::isfinite(settled.enclosure.lower) && std::isfinite(settled.enclosure.upper)) return settled;
  return {Settled::Kind::undecided,
          {},
          {"it may be larger than any double, 1.8·10^308", "può superare ogni double, 1,8·10^308"},
          settled.rung};
}

// The numbers that were tried, as who only wants to know of the answer may read it: the rungs of one kind once, by
// the last of them.
Words in_words(const std::vector<std::string>& rungs) {
  const std::string deep = "Deep ";
  const auto kind = [&](const std::string& rung) -> Words {
    if (rung == "Bounded") return {"intervals of doubles", "intervalli di double"};
    if (rung.starts_with(deep)) {
      const std::string bits = rung.substr(deep.size());
      return {"balls of up to " + bits + " bits", "intervalli fino a " + bits + " bit"};
    }
    if (rung == "Exact") return {"exact square roots", "radici quadrate esatte"};
    if (rung == "Generic") return {"the crank at any angle", "la manovella ad angolo qualsiasi"};
    return {"exact algebraic numbers", "numeri algebrici esatti"};
  };
  Words list;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    const bool is_deep = rungs[i].starts_with(deep);
    if (is_deep && std::any_of(rungs.begin() + static_cast<std::ptrdiff_t>(i) + 1, rungs.end(),
                               [&](const std::string& later) { return later.starts_with(deep); }))
      continue;
    list = list + (list.empty() ? "" : ", ") + kind(rungs[i]);
  }
  return list;
}

}  // namespace

// False when the run says nothing. The first run that does fixes how many quantities there are.
bool Ledger::accept(const std::string& rung, const Run& run) {
  tried_.push_back(rung);
  if (run.failure) {
    failure_ = *run.failure;
    for (Entry& entry : entries_)
      if (!entry.is_final) entry.settled.reason = failure_;
    return false;
  }
  if (!has_run_) entries_.resize(run.findings.size());
  has_run_ = true;
  assert(entries_.size() == run.findings.size() && "a scene reports the same quantities on every number");
  return true;
}

void Ledger::take_enclosures(const std::string& rung, const Run& run) {
  if (!accept(rung, run)) return;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[i];
    const Finding& finding = run.findings[i];
    if (entry.is_final) continue;
    if (finding.kind == Finding::Kind::value) {
      narrow(entry, rung, finding);
    } else if (finding.kind == Finding::Kind::absent) {
      entry = {without_value(finding, rung), true, false};
    } else if (!entry.has_enclosure) {
      entry.settled = without_value(finding, rung);
    }
  }
}

// Both enclosures contain the true value, hence also what they have in common.
void Ledger::narrow(Entry& entry, const std::string& rung, const Finding& finding) {
  Enclosure& known = entry.settled.enclosure;
  const double lower = entry.has_enclosure ? std::max(known.lower, finding.enclosure.lower) : finding.enclosure.lower;
  const double upper = entry.has_enclosure ? std::min(known.upper, finding.enclosure.upper) : finding.enclosure.upper;
  assert(lower <= upper && "two enclosures of one quantity have nothing in common");
  const bool is_narrower = !entry.has_enclosure || lower > known.lower || upper < known.upper;
  if (is_narrower || finding.certain) entry.settled.rung = rung;
  known = {lower, std::clamp(finding.certain.value_or(finding.enclosure.value), lower, upper), upper};
  entry.has_enclosure = true;
  entry.is_final = finding.certain.has_value();
  entry.settled.kind = entry.is_final ? Settled::Kind::certain : Settled::Kind::enclosed;
  entry.settled.reason = entry.is_final ? Words{}
                                        : Words{"the nearest double is not certain from the enclosure",
                                                "l'intervallo non dice con certezza il double più vicino"};
}

void Ledger::take_proofs(const std::string& rung, const Run& run) {
  if (!accept(rung, run)) return;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (!needs_proof(i)) continue;
    const Finding& finding = run.findings[i];
    if (finding.proved == Sign::zero) {
      entries_[i] = {certain_point(0, rung), true, true};
    } else if (finding.proved != Sign::undecided) {
      entries_[i].is_not_zero = true;
    } else if (finding.kind == Finding::Kind::absent) {
      entries_[i] = {without_value(finding, rung), true, false};
    } else if (!entries_[i].has_enclosure && entries_[i].settled.reason.empty()) {
      entries_[i].settled.reason = failure_;
    }
  }
}

bool Ledger::is_settled() const {
  return has_run_ && std::all_of(entries_.begin(), entries_.end(), [](const Entry& e) { return e.is_final; });
}

std::vector<bool> Ledger::open() const {
  std::vector<bool> all;
  for (const Entry& entry : entries_) all.push_back(!entry.is_final);
  return all;
}

bool Ledger::needs_proof(std::size_t i) const {
  if (!has_run_) return true;
  const Entry& entry = entries_.at(i);
  return !entry.is_final && !entry.is_not_zero && (!entry.has_enclosure || contains_zero(entry.settled.enclosure));
}

std::vector<Settled> Ledger::result() const {
  if (!has_run_) throw Undecided(failure_);
  std::vector<Settled> result;
  for (const Entry& entry : entries_) {
    result.push_back(in_doubles(entry.settled));
    if (entry.settled.kind == Settled::Kind::undecided)
      result.back().reason = result.back().reason + Words{" (tried: ", " (tentati: "} + in_words(tried_) + ")";
  }
  return result;
}

std::vector<Settled> settle_fast(const std::vector<Finding>& findings) {
  std::vector<Settled> result;
  for (const Finding& finding : findings) {
    if (finding.kind == Finding::Kind::value)
      result.push_back({Settled::Kind::unbounded, {-infinity, finding.enclosure.value, infinity}, {}, "Fast"});
    else
      result.push_back(without_value(finding, "Fast"));
  }
  return result;
}

std::vector<Settled> settle_bounded(const std::vector<Finding>& findings) {
  std::vector<Settled> result;
  for (const Finding& finding : findings) {
    if (finding.kind != Finding::Kind::value)
      result.push_back(without_value(finding, "Bounded"));
    else if (finding.certain)
      result.push_back(certain_point(*finding.certain, "Bounded"));
    else
      result.push_back(in_doubles({Settled::Kind::enclosed, finding.enclosure, {}, "Bounded"}));
  }
  return result;
}

std::vector<Settled> settle_deep(const std::vector<Finding>& findings, long bits) {
  const std::string rung = "Deep " + std::to_string(bits);
  std::vector<Settled> result;
  for (const Finding& finding : findings) {
    if (finding.kind != Finding::Kind::value)
      result.push_back(without_value(finding, rung));
    else
      result.push_back(in_doubles(
          {finding.certain ? Settled::Kind::certain : Settled::Kind::enclosed, finding.enclosure, {}, rung}));
  }
  return result;
}

}  // namespace epure::geometry::climbing
