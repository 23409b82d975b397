#include "exercises/crane-welds/quantities.h"

#include "exercises/kit/statement/quantity_list.h"

namespace epure::crane_welds {
namespace {

const std::vector<Quantity> quantities{
    {"A_1", "$\\it{A}_{1}$", "m^2", {"area of the beam's section", "area della sezione della trave"}},
    {"A_v1", "$\\it{A}_{v1}$", "m^2", {"area of the beam's web", "area dell'anima della trave"}},
    {"J_x1",
     "$\\it{J}_{x1}$",
     "m^4",
     {"moment of inertia of the beam's section", "momento d'inerzia della sezione della trave"}},
    {"S_x1", "$\\it{S}_{f1}$", "m^3", {"static moment of a flange", "momento statico della piattabanda"}},
    {"a", "$a$", "m", {"throat of the fillet", "sezione di gola del cordone"}},
    {"T_1", "$\\it{T}_{1}$", "N", {"shear just left of C", "taglio subito a sinistra di C"}},
    {"M_C", "$\\it{M}_{C}$", "N*m", {"bending moment at C", "momento flettente in C"}},
    {"sigma_par_M", "$σ_{∥M}$", "Pa", {"bending stress at the joint", "tensione di flessione al giunto"}},
    {"tau_par_T", "$τ_{∥T}$", "Pa", {"shear over the web", "taglio medio sull'anima"}},
    {"tau_par_Jour",
     "$τ_{∥J}$",
     "Pa",
     {"Jourawsky's shear in the web at the joint", "taglio di Jourawsky nell'anima al giunto"}},
    {"sigma_eq", "$σ_{eq}$", "Pa", {"equivalent stress (von Mises)", "tensione equivalente (von Mises)"}},
    {"sigma_eq_Jour",
     "$σ_{eq,J}$",
     "Pa",
     {"equivalent stress with Jourawsky's shear", "tensione equivalente con il taglio di Jourawsky"}},
    {"sigma_amm_W",
     "$σ_{ammW}$",
     "Pa",
     {"allowable stress of the full-penetration weld", "tensione ammissibile della saldatura a piena penetrazione"}},
    {"full_penetration_utilisation",
     "$u$",
     "1",
     {"utilisation of the full-penetration weld", "grado di utilizzo della saldatura a piena penetrazione"}},
    {"Mohr_centre", "$c$", "Pa", {"centre of Mohr's circle", "centro del cerchio di Mohr"}},
    {"Mohr_radius", "$r$", "Pa", {"radius of Mohr's circle", "raggio del cerchio di Mohr"}},
    {"sigma_I", "$σ_{I}$", "Pa", {"greater principal stress", "tensione principale maggiore"}},
    {"sigma_II", "$σ_{II}$", "Pa", {"lesser principal stress", "tensione principale minore"}},
    {"principal_direction",
     "$φ_{I}$",
     "rad",
     {"angle of the greater principal stress with the beam",
      "angolo della tensione principale maggiore con la trave"}},
    {"q", "$q$", "N/m", {"shear flow at the joint", "flusso di taglio al giunto"}},
    {"tau_fillet", "$τ_{a}$", "Pa", {"shear on the two throats", "taglio sulle due sezioni di gola"}},
    {"fillet_stress_1",
     "$s_{1f}$",
     "Pa",
     {"stress of the first check of the fillets", "tensione della prima verifica dei cordoni"}},
    {"fillet_stress_2",
     "$s_{2f}$",
     "Pa",
     {"stress of the second check of the fillets", "tensione della seconda verifica dei cordoni"}},
    {"fillet_allowable_1",
     "$f_{1}σ_{amm}$",
     "Pa",
     {"allowable stress of the first check", "tensione ammissibile della prima verifica"}},
    {"fillet_allowable_2",
     "$f_{2}σ_{amm}$",
     "Pa",
     {"allowable stress of the second check", "tensione ammissibile della seconda verifica"}},
    {"fillet_utilisation",
     "$u_{f}$",
     "1",
     {"utilisation of the fillets, as the source has it", "grado di utilizzo dei cordoni, secondo la fonte"}},
    {"fillet_throat_utilisation",
     "$u_{a}$",
     "1",
     {"utilisation of the throats", "grado di utilizzo delle sezioni di gola"}},
};

}  // namespace

const Quantity& quantity(const std::string& name) { return named(quantities, name); }

}  // namespace epure::crane_welds
