// Givens with which what every sheet must show is tried: as stated, and at what makes it change.
#pragma once

#include "exercises/kit/proof/solution.h"
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
      {"friction-efficiency",
       {{},
        {"phi=12"},
        {"phi=0"},
        {"wedge_collar.theta=25", "wedge_collar.w=0.05", "double_slider.l=2"},
        {"sliding_levers.direction_P=73", "fairbairn.theta=10", "double_slider_pins.r=0.03"}}},
      {"velocity-centre",
       {{}, {"phi=200", "omega=-2.7"}, {"V=0"}, {"omega=0"}, {"omega=0", "omega_dot=0"}, {"phi=90"}, {"L=0.37"}}},
      {"michell-bearing",
       {{},
        {"h_1=0.32"},
        {"h_1=0.17", "l=0.3", "x_3=0.25"},
        {"h_1=2", "dx=0.02"},
        {"x_N=0.05", "P=300000"},
        {"pads=6", "b=0.08"}}},
      {"michell-thrust",
       {{}, {"z=6"}, {"x_N_over_l=0.6", "n_g=300"}, {"D_i=0.5"}, {"x_N_over_l=0.548", "Q=7"}, {"mu=0.035", "d=10"}}},
      {"point-mass",
       {{},
        {"A=0.3", "B=-7.1", "C=31", "m=7", "t_1=1.5", "t_2=7", "t_3=16", "dt=0.25", "strip=3"},
        {"A=0.1", "B=1", "C=5", "dt=0.5"},
        {"A=0", "B=0", "C=0"},
        {"A=0", "B=-3", "C=20", "t_1=1", "t_2=10", "t_3=11"},
        {"m=0.002", "C=-80", "dt=1"}}},
      {"oscillator-pendulum",
       {{},
        {"zeta=0.3", "theta_0=150"},
        {"zeta=1", "theta_0=30"},
        {"zeta=0", "theta_0=-100"},
        {"zeta=8", "v_0=-0.3", "dt=0.25"},
        {"omega_n=2", "dt=0.4", "theta_0=179", "dt_p=0.004"}}},
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
      {"rivals-polygons",
       {{},
        {"phi=0"},
        {"phi=90"},
        {"n=-100", "phi=200"},
        {"AG=-0.2", "alpha_2=900"},
        {"AG=0"},
        {"phi=250", "alpha_2=-700", "AG=0.45"}}},  // vectors so short that they tell their values
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
        {"d=40", "s=1000", "d_0=0.05"}}},
      {"boat-crane",
       {{},
        {"W_b=600"},
        {"L=2", "H_0=1.5", "W_b=2t"},
        {"H_2=90mm", "b_2=200", "s_2=8", "H_0=3"},
        {"W_b=1370", "H_1=0.2m", "sigma_S=355", "Psi=1.1"}}},
      {"crane-welds",
       {{}, {"W_b=600"}, {"b=10mm", "s_1=12"}, {"f_1=0.5", "f_2=0.9"}, {"L=100mm", "H_1=900", "W_b=20t"}}},
      {"frame-deflection",
       {{},
        {"L_1=400", "L_2=1500", "phi=20"},
        {"s_r=80", "H_r=20", "P=5000"},
        {"L_1=2000", "L_2=200", "phi=12mm"},
        {"nu=0", "E=70GPa", "P=12.5"}}},
      {"truss",
       {{},
        {"n=8", "delta=20", "P=12.5kN"},
        {"shape=polonceau", "W=400", "beta=-60"},
        {"shape=warren", "n=5"},
        {"shape=pratt", "n=6", "h=2"},
        {"shape=howe", "P=-250", "W=100"},
        {"shape=bracket", "L=3", "h=2"},
        {"shape=crane", "L=6", "h=4"}}},
      {"spool-slip",
       {{},
        {"m_b=60"},
        {"m_b=0", "f_v=0"},
        {"f_a=0.5", "f_r=0.4", "f_v=0.1", "r=0.1", "m_b_light=5"},
        {"f_v=3", "m_b=15"},
        {"m_b_heavy=2000", "f_a=3"}}},
      {"cam-dynamics",
       {{},
        {"e=-0.035", "n=-77", "phi=200"},
        {"e=0", "phi=90"},
        {"P=-30"},
        {"r_r=0", "r=0.15"},
        {"n=0", "n_lift=0"},
        {"A0A=0.08", "m_3=0", "phi=300"}}},
      {"aircraft-landing",
       {{}, {"c_y=-2"}, {"v_0=180", "rim_0=40"}, {"J_r=400", "Delta_t=0.7"}, {"c_x=0", "f_v=0", "v_0=77"}}},
      {"pump-flywheel",
       {{}, {"m=0"}, {"m=300"}, {"p_a=5", "D=150"}, {"J_m=1", "i=0.5"}, {"Q=900", "n_m=1450", "n_0=1500"}}},
      {"ideal-statics",
       {{},
        {"wedge_collar.theta=20", "double_slider.theta=30"},
        {"wedge_collar.Q=1234", "wedge_collar.y_lower=-0.01", "double_slider.l=2"},
        {"sliding_levers.direction_P=73", "fairbairn.theta=10"},
        {"sliding_levers.y_C=0", "fairbairn.AB=0.5", "sliding_levers_Q_on_2.x_Q=0.4"}}}};
  return all;
}

struct TriedSolution {
  std::string id;
  Assignments assignments;
  const Exercise& exercise;
  Solution solution;
};

// visit(const TriedSolution&) with each of them.
template <class Visit>
void for_each_tried(const Visit& visit) {
  for (const auto& [id, sets] : tried_givens())
    for (const Assignments& assignments : sets) {
      CAPTURE(id, assignments);
      const Exercise& exercise = find_exercise(catalogue(), id);
      visit(TriedSolution{id, assignments, exercise, exercise.solution(Tried(id).givens(assignments))});
    }
}

// visit(const TriedSolution&, name of the sheet) with each sheet of each.
template <class Visit>
void for_each_tried_sheet(const Visit& visit) {
  for_each_tried([&](const TriedSolution& tried) {
    for (const SheetSpec& spec : tried.exercise.about().sheets) {
      CAPTURE(spec.name);
      visit(tried, spec.name);
    }
  });
}

}  // namespace epure::tests
