// M[J[R, color[Green], P[0.0, 0.0], L[ground, L1]], J[RP, A[30.0], P[65, -45], L[ground, L2]], ...]: joints, their
// kinds (R a hinge; RP a pin in a slot of the first link; P blocks in it), where they are drawn, and their links. The
// grammar is that of pyslvs/expression_parser.py of KmolYuan/pyslvs.
#include <algorithm>
#include <string_view>

#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/import/drawn_linkage.h"

namespace epure::scenes {
namespace {

class Expression {
 public:
  explicit Expression(const std::string& text) : text_(text) {}

  DrawnLinkage linkage() {
    DrawnLinkage read{.source = {"after an expression of pyslvs", "da un'espressione di pyslvs"},
                      .length_unit = "mm"};
    read.notes.push_back({"pyslvs tells no unit: lengths are in mm; see units: in the file",
                          "pyslvs non dice unità: le lunghezze sono in mm; vedere units: nel file"});
    open("M");
    while (!takes("]")) {
      joint(read);
      if (!takes(",") && !is_next("]")) refuse({"a comma or ] is missing", "manca una virgola o ]"});
    }
    if (at_ < text_.size())
      refuse({"nothing is expected behind the mechanism", "dopo il meccanismo non si attende altro"});
    return read;
  }

 private:
  void joint(DrawnLinkage& read) {
    open("J");
    const std::string kind = word();
    if (kind != "R" && kind != "RP" && kind != "P")
      refuse({"a joint is of kind R, RP or P", "un nodo è di tipo R, RP o P"});
    demand(",");
    std::string angle;
    if (kind != "R") {
      open("A");
      angle = number() + " deg";
      demand("]");
      demand(",");
    }
    skip_colour();
    open("P");
    const std::string x = number();
    demand(",");
    const std::string y = number();
    demand("]");
    demand(",");
    std::vector<std::string> links = names();
    demand("]");
    if (links.size() < (kind == "R" ? 1 : 2))
      refuse({"the joint has too few links", "il nodo ha troppo pochi membri"});
    if (kind == "R") return read.joints.push_back({x, y, links});
    DrawnSlide slide{.carrier = links.front(), .x = x, .y = y, .along = angle};
    links.erase(links.begin());
    if (kind == "P") {
      slide.blocks = links;
    } else {
      slide.pin = read.joints.size();
      read.joints.push_back({x, y, links});
    }
    read.slides.push_back(slide);
  }
  std::vector<std::string> names() {
    std::vector<std::string> all;
    open("L");
    while (!takes("]")) {
      all.push_back(word());
      if (std::find(all.begin(), all.end() - 1, all.back()) != all.end() - 1)
        refuse({"the joint names a link twice", "il nodo nomina due volte un membro"});
      if (!takes(",") && !is_next("]")) refuse({"a comma or ] is missing", "manca una virgola o ]"});
    }
    return all;
  }
  void skip_colour() {
    if (!takes("color")) return;
    demand("[");
    const std::size_t end = text_.find(']', at_);
    if (end == std::string_view::npos) refuse({"] is missing", "manca ]"});
    at_ = end + 1;
    demand(",");
  }

  // --- what the text is made of; blanks and comments between are skipped ---
  void skip() {
    while (at_ < text_.size()) {
      if (text_[at_] == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else if (blanks.find(text_[at_]) != std::string_view::npos)
        ++at_;
      else
        return;
    }
  }
  bool is_next(std::string_view what) {
    skip();
    return text_.substr(at_).starts_with(what);
  }
  bool takes(std::string_view what) {
    if (!is_next(what)) return false;
    at_ += what.size();
    skip();
    return true;
  }
  void demand(std::string_view what) {
    if (!takes(what)) refuse(format_words("{} is missing", "manca {}", std::string(what)));
  }
  void open(const std::string& of) {
    if (!takes(of) || !takes("[")) refuse(format_words("{}[ is missing", "manca {}[", of));
  }
  std::string of_letters(std::string_view of, std::size_t most, const Words& what) {
    skip();
    const std::size_t end = std::min(text_.find_first_not_of(of, at_), text_.size());
    if (end == at_ || end - at_ > most) refuse(what);
    const std::string found(text_.substr(at_, end - at_));
    at_ = end;
    skip();
    return found;
  }
  std::string word() {
    return of_letters("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", 60,
                      {"a name of at most 60 letters is asked", "si chiede un nome di al più 60 lettere"});
  }
  std::string number() { return of_letters("+-.0123456789eE", 60, {"a number is asked", "si chiede un numero"}); }
  [[noreturn]] void refuse(const Words& sentence) const {
    throw BadScene(
        format_words("the expression, character {}: {}", "l'espressione, carattere {}: {}", at_ + 1, sentence));
  }

  static constexpr std::string_view blanks = " \t\r\n";
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

DrawnLinkage read_pyslvs(const std::string& expression) { return Expression(expression).linkage(); }

}  // namespace epure::scenes
