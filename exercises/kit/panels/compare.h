// What a ruler reads off a sheet, and two methods held against each other.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exercises/kit/proof/checked.h"
#include "exercises/kit/proof/exercise.h"

namespace epure {

// Every quantity a sheet shows; of one shown twice, the first.
class Readings {
 public:
  explicit Readings(const DrawnSheet& drawn);
  bool has(const std::string& quantity) const { return shown_.contains(quantity); }
  double operator[](const std::string& quantity) const { return shown_.at(quantity).value; }
  // Shown at least a millimetre long: shorter, a ruler cannot make it the measure of others.
  bool is_unit(const std::string& quantity) const { return has(quantity) && is_unit((*this)[quantity], quantity); }
  // The same of a length found from others, at the scale of `like`, which is shown.
  bool is_unit(double length, const std::string& like) const;

 private:
  std::map<std::string, OnSheet> shown_;
};

struct Comparison {
  std::string quantity;  // rich text with its unit
  double first, second;
};

// quantity | first | second | difference in percent of the first
drawings::Table comparison_table(const std::vector<Comparison>& rows, const Words& first, const Words& second,
                                 Language language);

}  // namespace epure
