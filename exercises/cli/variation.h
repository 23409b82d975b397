// The values that a given takes one after the other.
//
//   phi=0deg..360deg/361      from one end to the other, so many values, both ends among them
//   r=0.18..0.22/0.01         from one end to the other by this step
//   n=300|360|400             these
//
// What follows the last slash that stands before a number is a count when it is a whole number and nothing else, 2 or
// more; with a decimal point (or comma), an exponent or a unit it is a step: "/5" are five values, "/5.0" and "/5deg"
// is a step of five. A step divides its interval. Values are read as --set reads them, and are exact; a unit may
// stand on one of them only, and is the given's own when it stands on none. Of a given of words a list of words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exercises/kit/statement/givens.h"

namespace epure {

class Variation {
 public:
  // `text`: what stands behind the =. Throws WrongUsage, in a sentence that begins with the symbol.
  Variation(const GivenSpec& given, const std::string& text);

  const GivenSpec& given() const { return given_; }
  // Of all values; "1" of a pure number and of words.
  const std::string& unit() const { return unit_; }
  std::uint64_t size() const { return size_; }

  // The value at this place, counted from 0, in the unit: as a decimal, "0.25", where it has one, else as a fraction;
  // or the word.
  std::string text(std::uint64_t place) const;
  // The same as --set takes it: "phi=22.5deg".
  std::string assignment(std::uint64_t place) const;
  // The nearest double to the value. Not of words.
  double number(std::uint64_t place) const;

  bool is_of_words() const { return !given_.choices.empty(); }

 private:
  void read_list(const std::vector<std::string>& texts);
  void read_words(const std::vector<std::string>& texts);
  void read_range(const std::string& text);
  void read_count(const std::string& digits);
  void read_step(const std::string& text);
  [[noreturn]] void refuse_step(const Rational& step, const Rational& whole) const;
  Rational value(std::uint64_t place) const;

  GivenSpec given_;
  std::string unit_ = "1";
  std::uint64_t size_ = 0;
  std::vector<Rational> listed_;    // of a list
  std::vector<std::string> words_;  // of a list of words
  Rational from_ = 0, by_ = 0;      // of a range
};

// More values than this no range or list has.
inline constexpr std::uint64_t most_values = 1'000'000'000;

// As a decimal where it has an end, else as a fraction: "0.25", "-12", "40/111". It reads back as the same number.
std::string exact_text(const Rational& value);

}  // namespace epure
