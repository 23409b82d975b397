#include "exercises/spool-slip/quantities.h"

#include "exercises/kit/statement/quantity_list.h"

namespace epure::spool_slip {
namespace {

const std::vector<Quantity> quantities{
    {"J", "$\\it{J}$", "kg*m^2", {"moment of inertia about G", "momento d'inerzia rispetto a G"}},
    {"u", "$u$", "m", {"offset of N while rolling", "spostamento di N nel rotolamento"}},
    {"N", "$\\it{N}$", "N", {"normal reaction", "reazione normale"}},
    {"weight_b", "$m_{b}g$", "N", {"weight of the counterweight", "peso del contrappeso"}},
    {"F_max", "$\\it{F}_{max}$", "N", {"friction at its limit", "attrito limite di aderenza"}},
    {"friction_cone_half_angle",
     "$φ_{a}$",
     "rad",
     {"half angle of the friction cone", "semiapertura del cono d'attrito"}},
    {"rope_to_centre_velocity_ratio",
     "$k$",
     "1",
     {"velocity of the rope over that of G", "velocità della fune su quella di G"}},
    {"inertia_force_height",
     "$h_{i}$",
     "m",
     {"height of the line of the inertia force while rolling",
      "altezza della retta della forza d'inerzia nel rotolamento"}},
    {"a", "$a$", "m/s^2", {"acceleration of the counterweight, downwards", "accelerazione del contrappeso, in giù"}},
    {"a_G", "$a'$", "m/s^2", {"acceleration of G, to the right", "accelerazione di G, verso destra"}},
    {"alpha", "$α$", "rad/s^2", {"angular acceleration, clockwise", "accelerazione angolare, oraria"}},
    {"T", "$\\it{T}$", "N", {"pull of the rope", "tiro della fune"}},
    {"F", "$\\it{F}$", "N", {"friction force, to the left", "forza d'attrito, verso sinistra"}},
    {"F_required",
     "$\\it{F}^{*}$",
     "N",
     {"friction that must hold if it is not to slip", "attrito che occorre perché non strisci"}},
    {"F_over_N",
     "$\\it{F}^{*}$/$\\it{N}$",
     "1",
     {"friction that must hold if it is not to slip, over N", "attrito che occorre perché non strisci, su N"}},
    {"ground_reaction", "$\\it{S}$", "N", {"reaction of the plane", "reazione del piano"}},
    {"ground_reaction_inclination",
     "$ψ$",
     "rad",
     {"its inclination from the vertical", "sua inclinazione sulla verticale"}},
    {"slip_margin",
     "$Δ\\it{F}$",
     "N",
     {"friction at its limit less what must hold if it is not to slip",
      "attrito limite meno quello che occorre perché non strisci"}},
    {"inertia_force", "$\\it{F}_{i}$", "N", {"force of inertia", "forza d'inerzia"}},
    {"inertia_couple", "$\\it{M}_{i}$", "N*m", {"couple of inertia", "coppia d'inerzia"}},
    {"resultant_height",
     "$h_{r}$",
     "m",
     {"height at which pull and inertia together cross the vertical of G",
      "altezza a cui tiro e inerzia insieme tagliano la verticale di G"}},
    {"slips", "$s$", "1", {"slips (1) or not (0)", "striscia (1) o no (0)"}},
    {"starts", "$p$", "1", {"starts (1) or stays at rest (0)", "parte (1) o resta in quiete (0)"}},
    {"mass_ratio_slip", "$μ_{s}$", "1", {"mass ratio from which it slips", "rapporto di masse oltre cui striscia"}},
    {"m_b_slip", "$m_{b,s}$", "kg", {"counterweight from which it slips", "contrappeso oltre cui striscia"}},
    {"mass_ratio_start", "$μ_{p}$", "1", {"mass ratio from which it moves", "rapporto di masse oltre cui si muove"}},
    {"m_b_start", "$m_{b,p}$", "kg", {"counterweight from which it moves", "contrappeso oltre cui si muove"}},
    {"slip_acceleration",
     "$a_{C}$",
     "m/s^2",
     {"acceleration of slipping at the contact", "accelerazione di strisciamento al contatto"}},
    {"u_required", "$u'$", "m", {"offset of N", "spostamento di N"}},
};

}  // namespace

const Quantity& quantity(const std::string& name) { return named(quantities, name); }

}  // namespace epure::spool_slip
