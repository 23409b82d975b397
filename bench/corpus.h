// Reads a text corpus of reference values: `case NAME`, `why TEXT`, `given NAME RATIONAL`, `choice NAME WORD`,
// `NAME VALUE`, # comments.
#pragma once

#include "geometry/numbers/number.h"

#include <map>
#include <string>
#include <vector>

namespace epure::bench {

struct Reference {
  std::string name;
  std::string value;  // decimal number, or a word
};

struct CorpusCase {
  std::string name, why;
  std::map<std::string, geometry::Rational> givens;
  std::map<std::string, std::string> choices;  // of a branch or side, in words
  std::vector<Reference> references;

  // The text of the value, empty when the case has no such reference.
  std::string reference(const std::string& wanted) const;
};

// Throws std::runtime_error for a file that cannot be read, holds no case, or a case without givens or references.
std::vector<CorpusCase> read_corpus(const std::string& path);

// "-1.5e-3" as an exact rational. Throws std::runtime_error for anything else.
geometry::Rational exact_decimal(const std::string& text);

}  // namespace epure::bench
