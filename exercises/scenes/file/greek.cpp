#include "exercises/scenes/file/greek.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "words/replace_all.h"

namespace epure::scenes {
namespace {

constexpr std::pair<std::string_view, std::string_view> alphabet[] = {
    {"α", "alpha"},   {"β", "beta"},  {"γ", "gamma"}, {"δ", "delta"}, {"ε", "epsilon"}, {"ζ", "zeta"},
    {"η", "eta"},     {"θ", "theta"}, {"ι", "iota"},  {"κ", "kappa"}, {"λ", "lambda"},  {"μ", "mu"},
    {"ν", "nu"},      {"ξ", "xi"},    {"π", "pi"},    {"ρ", "rho"},   {"σ", "sigma"},   {"τ", "tau"},
    {"υ", "upsilon"}, {"φ", "phi"},   {"χ", "chi"},   {"ψ", "psi"},   {"ω", "omega"},   {"ϕ", "phi"},
    {"ϑ", "theta"},   {"Γ", "Gamma"}, {"Δ", "Delta"}, {"Θ", "Theta"}, {"Λ", "Lambda"},  {"Ξ", "Xi"},
    {"Π", "Pi"},      {"Σ", "Sigma"}, {"Φ", "Phi"},   {"Ψ", "Psi"},   {"Ω", "Omega"}};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string spelled_out(const std::string& text) {
  std::string written;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t taken = 0;
    for (const auto& [letter, name] : alphabet)
      if (std::string_view(text).substr(at).starts_with(letter)) {
        written += name;
        taken = letter.size();
        break;
      }
    if (taken == 0) {
      written += text[at];
      taken = 1;
    }
    at += taken;
  }
  return written;
}

std::string given_letters(const std::string& symbol) {
  const std::size_t script = std::min(symbol.find('_'), symbol.size());
  std::string stem = symbol.substr(0, script);
  const std::size_t digits = stem.find_last_not_of("0123456789") + 1;
  for (const auto& [letter, name] : alphabet)
    if (stem.substr(0, digits) == name) {
      stem = std::string(letter) + stem.substr(digits);
      break;
    }
  std::string written;
  for (std::size_t i = 0; i < stem.size(); ++i) {
    if (!is_digit(stem[i])) {
      written += stem[i];
      continue;
    }
    std::size_t end = i;
    while (end < stem.size() && is_digit(stem[end])) ++end;
    written += "_{" + stem.substr(i, end - i) + "}";
    i = end - 1;
  }
  const bool has_script = script + 1 < symbol.size();
  // One letter has one subscript.
  if (has_script && written.ends_with("}"))
    written.insert(written.size() - 1, symbol.substr(script + 1));
  else if (has_script)
    written += "_{" + symbol.substr(script + 1) + "}";
  return "$" + written + "$";
}

std::string italic_letters(const std::string& symbol) {
  std::string letters = given_letters(symbol);
  const std::size_t end = std::min(letters.find('_'), letters.size() - 1);
  return "$\\it{" + letters.substr(1, end - 1) + "}" + letters.substr(end);
}

std::string as_printed(std::string amount) {
  replace_all(amount, " deg", "°");
  replace_all(amount, "-", "−");
  return amount;
}

}  // namespace epure::scenes
