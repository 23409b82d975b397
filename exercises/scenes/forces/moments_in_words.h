// Equations of moments as the sheets of forces write them.
#pragma once

#include <string>

#include "exercises/scenes/forces/force_figures.h"

namespace epure::scenes {

// An equation of moments in words: what is sought on the left, the other terms with the signs that they then have.
class MomentsInWords {
 public:
  MomentsInWords(const ForceFigures& of, const Built& built, const Moments& moments)
      : of_(of), built_(built), moments_(moments) {}

  Words all() const {
    const std::string right = terms();
    return format_words("Link {0}, moments about {1}: {2} = {3}.", "Membro {0}, momenti rispetto a {1}: {2} = {3}.",
                        of_.number(moments_.link), of_.about_in_words(moments_.about), left(),
                        right.empty() ? "0" : right);
  }

 private:
  static int sign_of_term(double moment, double letters) { return (moment < 0) != (letters < 0) ? -1 : 1; }

  std::string left() const {
    if (const auto* of_rod = std::get_if<AcrossRod>(&moments_.sought)) {
      const std::string arm = of_.letter(of_rod->pin), joint = of_.letter(of_rod->joint);
      return letters_of_force(built_, of_rod->force, ForcePart::across) + "·" + arm + joint;
    }
    if (const auto* arm = std::get_if<Arm>(&moments_.sought)) return product(*arm);
    return of_.symbol(std::get<ActingCouple>(moments_.sought));
  }
  // By which sign what is sought stands among the moments.
  int sign_of_sought() const {
    if (const auto* of_rod = std::get_if<AcrossRod>(&moments_.sought)) {
      const Arrow2 lever = of_.at(of_rod->pin) - of_.place(moments_.about);
      return cross(lever, of_.side(of_rod->force, ForcePart::across).v) < 0 ? -1 : 1;
    }
    if (const auto* arm = std::get_if<Arm>(&moments_.sought))
      return sign_of_term(of_.moment(arm->force, moments_.about), of_.value_of_letters(arm->force));
    return std::get<ActingCouple>(moments_.sought).is_opposite ? -1 : 1;
  }
  std::string product(const Arm& arm) const { return letters_of_force(built_, arm.force) + "·" + arm.length.symbol; }
  std::string terms() const {
    const int other_side = -sign_of_sought();
    std::string written;
    const auto add = [&](double moment, double letters, const std::string& what) {
      if (moment == 0) return;
      const bool is_minus = other_side * sign_of_term(moment, letters) < 0;
      written += written.empty() ? (is_minus ? "−" : "") : (is_minus ? " − " : " + ");
      written += what;
    };
    for (const Arm& arm : moments_.arms)
      if (of_.has_arm(arm)) add(of_.moment(arm.force, moments_.about), of_.value_of_letters(arm.force), product(arm));
    for (const ActingCouple& each : moments_.couples)
      add(of_.value(each), of_.value_of_letters(each), of_.symbol(each));
    return written;
  }

  const ForceFigures& of_;
  const Built& built_;
  const Moments& moments_;
};

}  // namespace epure::scenes
