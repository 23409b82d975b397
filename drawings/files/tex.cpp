#include "drawings/files/tex.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "drawings/files/check_page.h"
#include "drawings/text/rich_text.h"
#include "drawings/text/text.h"
#include "drawings/text/unicode.h"

namespace epure::drawings {
namespace {

constexpr double tex_points_per_mm = 72.27 / 25.4;

struct Written {
  char32_t character;
  std::string_view tex;
};

// What TeX does not take for itself in text.
constexpr std::array in_text{Written{U'\\', "\\textbackslash{}"},
                             Written{U'{', "\\{"},
                             Written{U'}', "\\}"},
                             Written{U'$', "\\$"},
                             Written{U'&', "\\&"},
                             Written{U'#', "\\#"},
                             Written{U'%', "\\%"},
                             Written{U'_', "\\_"},
                             Written{U'^', "\\textasciicircum{}"},
                             Written{U'~', "\\textasciitilde{}"},
                             Written{U'-', "-{}"},  // two of them are no dash
                             Written{U'`', "{`}"},
                             Written{U'\'', "{'}"},
                             Written{U'"', "{''}"},
                             Written{U'\u00a0', "~"},
                             Written{U'–', "--"},
                             Written{U'—', "---"},
                             Written{U'…', "\\ldots{}"}};

constexpr std::array in_mathematics_only{Written{U'<', "<"},
                                         Written{U'>', ">"},
                                         Written{U'|', "|"},
                                         Written{U'−', "-"},
                                         Written{U'·', "\\cdot "},
                                         Written{U'×', "\\times "},
                                         Written{U'±', "\\pm "},
                                         Written{U'°', "{}^{\\circ}"},
                                         Written{U'′', "'"},
                                         Written{U'″', "''"},
                                         Written{U'²', "{}^{2}"},
                                         Written{U'³', "{}^{3}"},
                                         Written{U'₀', "{}_{0}"},
                                         Written{U'₁', "{}_{1}"},
                                         Written{U'₂', "{}_{2}"},
                                         Written{U'₃', "{}_{3}"},
                                         Written{U'₄', "{}_{4}"},
                                         Written{U'₅', "{}_{5}"},
                                         Written{U'₆', "{}_{6}"},
                                         Written{U'₇', "{}_{7}"},
                                         Written{U'₈', "{}_{8}"},
                                         Written{U'₉', "{}_{9}"},
                                         Written{U'⁰', "{}^{0}"},
                                         Written{U'¹', "{}^{1}"},
                                         Written{U'⁴', "{}^{4}"},
                                         Written{U'⁷', "{}^{7}"},
                                         Written{U'⁻', "{}^{-}"},
                                         Written{U'½', "\\frac{1}{2}"},
                                         Written{U'⅓', "\\frac{1}{3}"},
                                         Written{U'≡', "\\equiv "},
                                         Written{U'←', "\\leftarrow "},
                                         Written{U'↑', "\\uparrow "},
                                         Written{U'↓', "\\downarrow "},
                                         Written{U'𝑊', "W"},
                                         Written{U'⊥', "\\perp "},
                                         Written{U'∥', "\\parallel "},
                                         Written{U'≙', "\\mathrel{\\stackrel{\\wedge}{=}}"},
                                         Written{U'≈', "\\approx "},
                                         Written{U'≠', "\\neq "},
                                         Written{U'≤', "\\leq "},
                                         Written{U'≥', "\\geq "},
                                         Written{U'→', "\\to "},
                                         Written{U'∞', "\\infty "},
                                         Written{U'√', "\\surd "},
                                         Written{U'∫', "\\int "},
                                         Written{U'∑', "\\sum "},
                                         Written{U'Σ', "\\Sigma "},
                                         Written{U'∂', "\\partial "},
                                         Written{U'∠', "\\angle "},
                                         Written{U'α', "\\alpha "},
                                         Written{U'β', "\\beta "},
                                         Written{U'γ', "\\gamma "},
                                         Written{U'δ', "\\delta "},
                                         Written{U'ε', "\\varepsilon "},
                                         Written{U'ϵ', "\\epsilon "},
                                         Written{U'ζ', "\\zeta "},
                                         Written{U'η', "\\eta "},
                                         Written{U'θ', "\\theta "},
                                         Written{U'ϑ', "\\vartheta "},
                                         Written{U'ι', "\\iota "},
                                         Written{U'κ', "\\kappa "},
                                         Written{U'λ', "\\lambda "},
                                         Written{U'μ', "\\mu "},
                                         Written{U'ν', "\\nu "},
                                         Written{U'ξ', "\\xi "},
                                         Written{U'π', "\\pi "},
                                         Written{U'ρ', "\\rho "},
                                         Written{U'σ', "\\sigma "},
                                         Written{U'τ', "\\tau "},
                                         Written{U'υ', "\\upsilon "},
                                         Written{U'φ', "\\varphi "},
                                         Written{U'ϕ', "\\phi "},
                                         Written{U'χ', "\\chi "},
                                         Written{U'ψ', "\\psi "},
                                         Written{U'ω', "\\omega "},
                                         Written{U'Γ', "\\Gamma "},
                                         Written{U'Δ', "\\Delta "},
                                         Written{U'Θ', "\\Theta "},
                                         Written{U'Λ', "\\Lambda "},
                                         Written{U'Ξ', "\\Xi "},
                                         Written{U'Π', "\\Pi "},
                                         Written{U'Φ', "\\Phi "},
                                         Written{U'Ψ', "\\Psi "},
                                         Written{U'Ω', "\\Omega "}};

template <std::size_t N>
const Written* found_in(const std::array<Written, N>& all, char32_t c) {
  for (const Written& each : all)
    if (each.character == c) return &each;
  return nullptr;
}

// What is in no table goes as it is: TeX reads UTF-8.
std::string text_of(const std::string& letters) {
  std::string tex;
  for (const char32_t c : characters(letters)) {
    if (const Written* known = found_in(in_text, c))
      tex += known->tex;
    else if (const Written* symbol = found_in(in_mathematics_only, c))
      tex += fmt::format("\\ensuremath{{{}}}", symbol->tex);
    else
      tex += utf8(c);
  }
  return tex;
}

// Scripts that are letters of their own stand on what is before them: on nothing, {}, Word and LibreOffice put an
// empty box. One after another they are one script; of a third, or a prime after an exponent, TeX wants a base again.
class ScriptsOfLetters {
 public:
  bool add(std::string_view symbol, std::string& tex) {
    const bool is_prime = symbol[0] == '\'';
    if (!symbol.starts_with("{}") && !is_prime) return false;
    const std::string_view script = is_prime ? symbol : symbol.substr(2);
    if (!is_prime && !kinds_.empty() && kinds_.back() == script[0]) {
      tex.pop_back();
      tex += script.substr(script.find('{') + 1);
      return true;
    }
    const char kind = is_prime ? '^' : script[0];
    if (tex.empty() || kinds_.find(kind) != std::string::npos) {
      tex += "{}";
      kinds_.clear();
    }
    tex += script;
    if (!is_prime) kinds_ += kind;
    return true;
  }
  void end() { kinds_.clear(); }

 private:
  std::string kinds_;  // those that the base has, "_" and "^"
};

// Letters within mathematics; upright ones stand in \mathrm, and what mathematics cannot set in \mbox.
std::string mathematics_of(const std::string& letters, bool italic) {
  std::string tex;
  bool is_upright = false;
  ScriptsOfLetters scripts;
  for (const char32_t c : characters(letters)) {
    const bool is_letter = c < 128 && ((c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z'));
    const bool is_sign =
        c < 128 && std::u32string_view(U"0123456789+=/()[]:;!*").find(c) != std::u32string_view::npos;
    if (std::exchange(is_upright, is_letter && !italic) != is_upright) tex += is_upright ? "\\mathrm{" : "}";
    const Written* const symbol = found_in(in_mathematics_only, c);
    if (symbol && scripts.add(symbol->tex, tex)) continue;
    scripts.end();
    if (is_letter)
      tex += utf8(c);
    else if (symbol)
      tex += symbol->tex;
    else if (c == U'.' || c == U',')  // of a number: no space follows
      tex += fmt::format("{{{}}}", utf8(c));
    else if (c == U' ' || c == U'\u00a0')
      tex += "\\ ";
    else
      tex += is_sign ? utf8(c) : fmt::format("\\mbox{{{}}}", text_of(utf8(c)));
  }
  return is_upright ? tex + "}" : tex;
}

std::string mathematics_of(const std::vector<Node>& nodes) {
  std::string tex;
  for (const Node& node : nodes) {
    std::string nucleus = mathematics_of(node.letters, node.italic) + mathematics_of(node.group);
    const bool is_long = node.group.size() > 1 || (node.group.size() == 1 && node.group[0].letters.size() > 2);
    if (node.arrow) nucleus = fmt::format("{}{{{}}}", is_long ? "\\overrightarrow" : "\\vec", nucleus);
    const bool has_scripts = !node.below.empty() || !node.above.empty();
    tex += has_scripts ? fmt::format("{{{}}}", nucleus) : nucleus;
    if (!node.below.empty()) tex += fmt::format("_{{{}}}", mathematics_of(node.below));
    if (!node.above.empty()) tex += fmt::format("^{{{}}}", mathematics_of(node.above));
  }
  return tex;
}

std::string in_colour(const Colour& c, const std::string& tex) {
  if (c == Colour{}) return tex;
  return fmt::format("\\epureink{{{:.3f},{:.3f},{:.3f}}}{{{}}}", c.red, c.green, c.blue, tex);
}

std::string placed(const PlacedText& text, const Box& extent) {
  const double fixed = text.baseline.x + text.anchor * measure(text.text, text.size, text.weight).width;
  const char* const by = text.anchor == 0 ? "bl" : text.anchor == 1 ? "br" : "b";
  const double points = std::max(5.0, std::round(text.size * tex_points_per_mm));
  const std::string tex = text.weight == Weight::bold ? "\\bfseries " + tex_of(text.text) : tex_of(text.text);
  return fmt::format(
      "\\put({:.3f},{:.3f}){{\\makebox(0,0)[{}]{{\\smash{{\\fontsize{{{}}}{{{:.1f}}}\\selectfont {}}}}}}}%\n",
      fixed - extent.low.x, text.baseline.y - extent.low.y, by, points, 1.2 * points, in_colour(text.colour, tex));
}

}  // namespace

Page without_letters(Page page) {
  std::erase_if(page.primitives, [](const Primitive& each) { return std::holds_alternative<PlacedText>(each); });
  return page;
}

bool is_text(const Node& node) {
  return !node.italic && node.group.empty() && node.below.empty() && node.above.empty();
}

bool is_mathematics_only(char32_t character) {
  constexpr std::u32string_view in_fonts_of_text = U"·×±°²³¹½";
  return character > 127 && in_fonts_of_text.find(character) == std::u32string_view::npos &&
         found_in(in_mathematics_only, character);
}

std::string tex_of_mathematics(const std::vector<Node>& nodes) { return mathematics_of(nodes); }

std::string tex_of(const std::string& rich_text) {
  std::string tex;
  for (const Node& node : parse(rich_text))
    tex += is_text(node) ? text_of(node.letters) : "$" + mathematics_of(std::vector{node}) + "$";
  return tex;
}

std::string write_tex(const Page& page, const std::string& picture) {
  check(page);
  std::string tex = fmt::format(
      "% A figure of epure for \\input; needs \\usepackage{{graphicx}}, and color or xcolor for its colours.\n"
      "% It is {:.2f} mm wide and true to scale: do not resize it.\n"
      "\\begingroup\\setlength{{\\unitlength}}{{1mm}}%\n"
      "\\providecommand{{\\epureink}}[2]{{\\ifdefined\\textcolor\\textcolor[rgb]{{#1}}{{#2}}\\else#2\\fi}}%\n"
      "\\begin{{picture}}({:.3f},{:.3f})%\n"
      "\\put(0,0){{\\includegraphics{{{}}}}}%\n",
      page.extent.width(), page.extent.width(), page.extent.height(), picture);
  for (const Primitive& primitive : page.primitives)
    if (const auto* text = std::get_if<PlacedText>(&primitive)) tex += placed(*text, page.extent);
  return tex + "\\end{picture}\\endgroup%\n";
}

}  // namespace epure::drawings
