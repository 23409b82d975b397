#include "bench/corpus.h"

#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace epure::bench {

std::string CorpusCase::reference(const std::string& wanted) const {
  for (const Reference& r : references)
    if (r.name == wanted) return r.value;
  return {};
}

geometry::Rational exact_decimal(const std::string& text) {
  static const std::regex form(R"((-?)([0-9]+)(?:\.([0-9]+))?(?:e([+-]?[0-9]{1,6}))?)");
  std::smatch m;
  if (!std::regex_match(text, m, form)) throw std::runtime_error("no decimal number: " + text);
  const std::string fraction = m[3];
  const int shift = (m[4].matched ? std::stoi(m[4]) : 0) - static_cast<int>(fraction.size());
  geometry::Rational power(1);
  for (int i = 0; i < std::abs(shift); ++i) power *= 10;
  // GMP reads a leading zero as decimal only when the base is named.
  geometry::Rational value(CGAL::Gmpz(m[2].str() + fraction, 10));
  value = shift < 0 ? geometry::Rational(value / power) : geometry::Rational(value * power);
  return m[1].length() == 0 ? value : geometry::Rational(-value);
}

namespace {

geometry::Rational exact_fraction(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return exact_decimal(text);
  return exact_decimal(text.substr(0, slash)) / exact_decimal(text.substr(slash + 1));
}

void read_line(const std::string& line, std::vector<CorpusCase>& cases) {
  std::istringstream words(line);
  std::string first, second, third;
  words >> first >> second;
  if (first == "case") {
    cases.push_back({second, {}, {}, {}, {}});
    return;
  }
  if (cases.empty()) throw std::runtime_error("a line before the first case: " + line);
  CorpusCase& current = cases.back();
  if (first == "why") {
    current.why = line.substr(4);
  } else if (first == "given") {
    words >> third;
    current.givens[second] = exact_fraction(third);
  } else if (first == "choice") {
    words >> current.choices[second];
  } else {
    current.references.push_back({first, second});
  }
}

}  // namespace

std::vector<CorpusCase> read_corpus(const std::string& path) {
  std::ifstream file(path);
  std::vector<CorpusCase> cases;
  for (std::string line; std::getline(file, line);)
    if (!line.empty() && line[0] != '#') read_line(line, cases);
  if (cases.empty()) throw std::runtime_error("no case in " + path);
  for (const CorpusCase& c : cases)
    if (c.givens.empty() || c.references.empty() || c.why.empty()) throw std::runtime_error("empty case " + c.name);
  return cases;
}

}  // namespace epure::bench
