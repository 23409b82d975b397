// Which quantities are asked of an exercise, and by how many routes.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace epure {

// In this thread all of them, unless a scope is open that names those. What is not asked for is not written down, and
// no number is spent on it; what is found on the way to others may be found all the same. Nothing is then found for
// drawings alone.
class Asked {
 public:
  // `names` must outlive the scope.
  explicit Asked(const std::vector<std::string>& names) : outer_(std::exchange(names_, &names)) {}
  // All of them again: for what is found once and kept.
  Asked() : outer_(std::exchange(names_, nullptr)) {}
  ~Asked() { names_ = outer_; }
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;

  static bool for_all() { return !names_; }
  // Of how many, where not of all.
  static std::size_t count() { return names_->size(); }
  static bool for_quantity(const std::string& name) {
    return for_all() || std::find(names_->begin(), names_->end(), name) != names_->end();
  }

 private:
  inline static thread_local const std::vector<std::string>* names_ = nullptr;
  const std::vector<std::string>* outer_;
};

// While one lives, what its name says holds in this thread.
template <class What>
class Holding {
 public:
  explicit Holding(bool holds) : outer_(std::exchange(holds_, holds)) {}
  ~Holding() { holds_ = outer_; }
  Holding(const Holding&) = delete;
  Holding& operator=(const Holding&) = delete;

  static bool holds() { return holds_; }

 private:
  inline static thread_local bool holds_ = false;
  bool outer_;
};

// A quantity is found by the first route that knows it; the others are not asked.
using FirstRouteOnly = Holding<struct FirstRouteOnlyHolds>;
// What drawings alone show is found too.
using ForDrawings = Holding<struct ForDrawingsHolds>;
// What would be found is written down, and nothing is found.
using NamesOnly = Holding<struct NamesOnlyHolds>;

}  // namespace epure
