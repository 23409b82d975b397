// What a checked exercise is told in, to people on a terminal and to readers of a document alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/proof/checked.h"

namespace epure {

// Enough to be held against any printed number; --json has all digits.
Words shown_digits(double value);
std::string with_unit(const std::string& number, const std::string& unit);
// Of a number whose last digit is a hundredth of a per cent at best.
Words percent(const std::optional<double>& value);

// The value without its unit, as a number or, where its bounds differ in these digits, both of them; or that there is
// none, or none is known.
Words number_in_words(const CheckedQuantity& quantity);
// The same with its unit.
Words value_in_words(const CheckedQuantity& quantity);

// What lies within the resolution of zero is zero as far as a sheet can tell.
Words on_sheet_in_words(const OnSheet& on);

Words in_words(Verdict verdict);
// "0,1 to 20,0 (200 rows) wrong, 3 of them right all the same: the first strip is missing"
Words block_in_words(const TableAudit& of, const AuditedBlock& block);

// Remarks in the order they were first made, each with all it applies to: one slip often explains several numbers.
class Remarks {
 public:
  struct Entry {
    std::string subjects, remark;
  };
  void add(const std::string& subject, const std::string& remark);
  const std::vector<Entry>& all() const { return all_; }

 private:
  std::vector<Entry> all_;
};

}  // namespace epure
