// A sentence in the languages epure speaks, and the exceptions that tell one. Every room may include this.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace epure {

enum class Language { english, italian };

struct Words {
  std::string english, italian;
  const std::string& in(Language language) const { return language == Language::english ? english : italian; }
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
