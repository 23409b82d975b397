// A sentence in the languages epure speaks, and the exceptions that tell one. Every room may include this.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace epure {

enum class Language { english, italian };

struct Words {
  std::string english, italian;
  const std::string& in(Language language) const { return language == Language::english ? english : italian; }
  bool empty() const { return english.empty(); }
  friend bool operator==(const Words&, const Words&) = default;
};

// Names and numbers are the same in every language.
inline Words operator+(const Words& a, const Words& b) { return {a.english + b.english, a.italian + b.italian}; }
inline Words operator+(const Words& a, const std::string& b) { return {a.english + b, a.italian + b}; }
inline Words operator+(const std::string& a, const Words& b) { return {a + b.english, a + b.italian}; }

// A number written with a decimal point, or a formula of such numbers: Italian has commas.
inline Words decimal(std::string numbers) {
  Words words{numbers, std::move(numbers)};
  std::replace(words.italian.begin(), words.italian.end(), '.', ',');
  return words;
}

// The same as literals: handed on, it costs nothing until it is told.
struct Phrase {
  const char *english, *italian;
  operator Words() const { return {english, italian}; }
};

// Thrown with a sentence, or the end of one, for the user. Whoever shows it chooses the language; what() is English.
class Told : public std::runtime_error {
 public:
  // The same in every language.
  explicit Told(const std::string& sentence) : Told(Words{sentence, sentence}) {}
  explicit Told(Words words) : std::runtime_error(words.english), words_(std::move(words)) {}
  Told(std::string english, std::string italian) : Told(Words{std::move(english), std::move(italian)}) {}
  const Words& words() const { return words_; }

 private:
  Words words_;
};

}  // namespace epure
