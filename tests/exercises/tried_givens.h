// Givens with which what every sheet must show is tried: as stated, and at what makes it change.
#pragma once

#include "tests/exercises/held_against_corpus.h"

namespace epure::tests {

inline const std::vector<std::pair<std::string, std::vector<Assignments>>>& tried_givens() {
  static const std::vector<std::pair<std::string, std::vector<Assignments>>> all{
      {"gear-pair",
       {{},
        {"z1=8"},
        {"x1=0.5", "x2=0.3", "z1=17", "z2=35"},
        {"kind=internal", "z1=20", "z2=60"},
        {"kind=rack", "alpha=20"},
        {"ha=0.5", "alpha=28"},
        {"z1=60", "z2=10", "ha=1.2", "hf=1.45", "alpha=15"}}},
      {"velocity-centre",
       {{}, {"phi=200", "omega=-2.7"}, {"V=0"}, {"omega=0"}, {"omega=0", "omega_dot=0"}, {"phi=90"}, {"L=0.37"}}},
      {"pin-in-slot",
       {{}, {"OB=0.2"}, {"omega=-1", "omega_dot=1"}, {"omega_dot=-20"}, {"omega=0"}, {"OB=0.25"}, {"J2=0", "M1=0"}}},
      {"four-bar",
       {{},
        {"branch=left", "n=-50"},
        {"C_side=left", "alpha_2=3"},
        {"t=0.42"},
        {"A0A=0.2", "B0B=0.4", "AB=0.74", "x_B0=0.5", "y_B0=0.24", "AC=0.5", "t=0"},
        {"A0A=0.3", "AB=0.35", "B0B=0.32", "x_B0=0.1", "y_B0=0.05", "AC=0.21"}}},
      {"slider-crank-velocity",
       {{}, {"phi=200"}, {"phi=90"}, {"phi=0"}, {"e=0.05"}, {"delta=20", "phi=-33"}, {"n=-41"}}},
      {"four-bar-constraints",
       {{},
        {"theta_3_start=-1.4", "theta_4_start=0.6"},
        {"theta_3_start=0.5", "theta_4_start=-1.8"},
        {"theta_3_start=100", "theta_4_start=3"},
        {"n=-300", "alpha_2=50", "theta_2=200"},
        {"A0B0=800", "A0A=200", "AB=500", "B0B=700"}}},
      {"slider-crank-acceleration",
       {{},
        {"phi=0"},
        {"phi=90"},
        {"r=0.03", "phi=2"},
        {"alpha_2=300", "e=0.05"},
        {"delta=20", "phi=110", "alpha_2=20"},
        {"n=-200"}}},
      {"rivals-polygons", {{}, {"phi=0"}, {"phi=90"}, {"n=-100", "phi=200"}, {"AG=-0.2", "alpha_2=900"}, {"AG=0"}}},
      {"four-bar-analytic",
       {{},
        {"branch=right"},
        {"n=-400", "alpha_2=300"},
        {"theta_2=240"},
        {"A0B0=0.2", "A0A=0.6"},
        {"A0B0=0.5", "A0A=0.4", "AB=0.2", "B0B=0.45", "theta_2=60"},
        {"AP_along=0.7", "AP_across=-0.3"}}},
      {"roulette",
       {{},
        {"phi=480"},
        {"how=circle_on_line", "d=0.3", "alpha=3"},
        {"how=circle_on_line", "d=0.075", "phi=60"},
        {"how=circle_inside_circle", "R=0.3", "omega=-2"},
        {"how=line_on_circle", "d=0"},
        {"omega=0", "alpha=4"}}},
      {"cycloid-involute",
       {{},
        {"phi=0", "s=0", "t1=0"},
        {"phi=90", "s=1"},
        {"phi=500", "s=6", "t1=0.2", "t2=0.1"},
        {"d=1.4", "d_0=3", "omega_1=3000", "t1=0.0001"},
        {"d=40", "s=1000", "d_0=0.05"}}}};
  return all;
}

}  // namespace epure::tests
