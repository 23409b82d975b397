// How the accelerations of a coupler are found by its pole K, step by step.
#pragma once

#include <string>
#include <vector>

#include "exercises/kit/panels/poles_panel.h"
#include "exercises/kit/statement/format_words.h"

namespace epure {

// `sheet`: the number of the one that finds K by the two circles. Told are the acceleration of `shown`, and γ at
// `at_gamma`.
inline std::vector<PolesStep> steps_to_coupler_accelerations(int sheet, const std::string& shown,
                                                             const std::string& at_gamma) {
  using Where = PolesStep::Where;
  return {{format_words("$K$ from the two circles (sheet {}). At $K$ the acceleration is zero.",
                        "$K$ dalle due circonferenze (tavola {}). In $K$ l'accelerazione è nulla.", sheet),
           Where::pole},
          {{"$a_{A}$ = $KA$·√($α^{2}_{3}$ + $ω^{4}_{3}$), known: the factor is $a_{A}$ / $KA$.",
            "$a_{A}$ = $KA$·√($α^{2}_{3}$ + $ω^{4}_{3}$), nota: il fattore è $a_{A}$ / $KA$."},
           Where::ray,
           "A"},
          {{"$a_{X}$ = ($KX$ / $KA$)·$a_{A}$ for every point $X$ of the coupler.",
            "$a_{X}$ = ($KX$ / $KA$)·$a_{A}$ per ogni punto $X$ della biella."},
           Where::tip,
           shown},
          {{"The same angle $γ$ leads from each acceleration to its ray $XK$, counter-clockwise when $α_{3}$ > 0: "
            "tan $γ$ = $α_{3}$ / $ω^{2}_{3}$.",
            "Lo stesso angolo $γ$ porta da ogni accelerazione al suo raggio $XK$, antiorario se $α_{3}$ > 0: tg $γ$ "
            "= $α_{3}$ / $ω^{2}_{3}$."},
           Where::point,
           at_gamma}};
}

}  // namespace epure
