// The direct and the retrograde motion beside the ideal one, as the sheets show them.
#pragma once

#include "exercises/friction-efficiency/motion.h"
#include "exercises/kit/linkages/loaded_figures.h"
#include "exercises/kit/panels/chained_polygons_panel.h"

namespace epure::friction_efficiency {

using namespace loaded;
using Arrow = FreeBodyPanel::Arrow;
using Joint = Mechanism::Joint;

inline const std::string direct = "_direct", retrograde = "_retrograde";

Motion motion_of(const std::string& suffix);
VectorQuantity moving(const VectorQuantity& quantity, const std::string& suffix);
VectorQuantity P_of(const std::string& suffix);
// What body i does to body j, known from the polygon before: the same force the other way, or passed on by a link.
PolygonSide passed_on(const PolygonSide& force, const VectorQuantity& known, int i, int j, const std::string& suffix,
                      const std::string& tip = {});

// "φ from r₂": turned by the friction angle.
std::string turned_from(const std::string& normal, Language language);

// A contact's force that presses on a body in X from outside: its angle with the normal, which stands on the same
// side and may have letters. `v` is the sliding of body j on body i, "ji", against which the force is turned.
void press(FreeBodyPanel& panel, const Case& of, const PolygonSide& R, const Place& X, double normal, const Arrow2& v,
           const std::string& ji, const std::string& letters_of_normal = {});

inline const Words the_other_way{"Retrograde motion: forces turned the other way.",
                                 "Moto retrogrado: forze ruotate dall'altra parte."};
// The same where lines of action are to be found anew.
Words other_lines(const std::string& english, const std::string& italian);
// What the retrograde motion has in place of something.
std::string prime(const std::string& suffix);
// The same of letters with an index, above which it stands as in R'₁₃.
std::string below_prime(const std::string& index, const std::string& suffix);

// Where the polygon of a body begins.
std::string origin(const std::string& body, const std::string& suffix);

// A chain of vectors from the origin on, for what lies under a polygon.
std::vector<Arrow2> laid_end_to_end(const std::vector<Arrow2>& vectors);

// Two bodies in one chain: the load Q, the contact's force, the reaction on the loaded body; back the contact's
// force, the effort, the reaction on the driven one.
struct Chain {
  std::string loaded, driven;                    // letters of the bodies
  VectorQuantity contact, on_loaded, on_driven;  // R_ij
  int passed_by;  // the body that acts on the driven one by the contact's force turned round
  std::string along_Q, along_contact, along_loaded, along_driven, along_P;
  Words other_way = the_other_way;
};
struct Sides {
  PolygonSide Q, contact, on_loaded, back, P, on_driven;

  VectorPolygon first(const Chain& chain) const { return force_polygon(chain.loaded, {on_loaded}, {Q, contact}); }
  VectorPolygon second(const Chain& chain) const {
    VectorPolygon polygon = force_polygon(chain.driven, {on_driven}, {back, P});
    polygon.origin = "$b$";
    return polygon;
  }
};
Sides sides(const Case& of, const Chain& chain, const std::string& suffix);
ChainedPolygonsPanel polygons(const Case& of, const Chain& chain, const std::string& suffix);

// What the friction angles are at which it ends to work.
inline const Words locks_from{"From $φ_{R}$ on it locks.", "Da $φ_{R}$ in poi è irreversibile."},
    locks_from_and_jams{"From $φ_{R}$ it locks, at $φ_{D}$ it jams.",
                        "Da $φ_{R}$ è irreversibile, a $φ_{D}$ s'impunta."};

std::vector<Result> efficiencies(const Case& of, const std::string& effort, Language language);
inline const Words turned_against{
    "The force on $j$ is turned by $φ$ against its sliding on $i$, $\\vec{v}_{ji}$. Dashed polygons: no "
    "friction.",
    "La forza su $j$ è ruotata di $φ$ contro il suo strisciamento su $i$, $\\vec{v}_{ji}$. Poligoni a tratti: "
    "senza attrito."};

}  // namespace epure::friction_efficiency
