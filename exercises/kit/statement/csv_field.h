// What stands between two commas of a CSV file, as RFC 4180 has it.
#pragma once

#include <string>
#include <string_view>

namespace epure {

// In quotes where it holds what divides fields or records.
std::string csv_field(std::string_view text);
// With a decimal point and as few digits as read back as the same double.
std::string csv_field(double value);
// A column's name with its unit: "t (s)".
std::string csv_head(const std::string& name, const std::string& unit);

}  // namespace epure
