#include "exercises/kit/proof/route_names.h"

#include <map>

namespace epure {

Words route_in_words(const std::string& route) {
  static const std::map<std::string, std::string> italian = {
      {"Mohr's circle", "cerchio di Mohr"},
      {"Newton-Euler", "Newton-Eulero"},
      {"analytic", "analitica"},
      {"closed form", "forma chiusa"},
      {"constraint equations", "equazioni di vincolo"},
      {"construction", "costruzione"},
      {"elastic weights", "pesi elastici"},
      {"energy", "energia"},
      {"equilibrium equations", "equazioni di equilibrio"},
      {"force polygon", "poligono delle forze"},
      {"funicular polygon", "poligono funicolare"},
      {"graphical integration", "integrazione grafica"},
      {"instant centres", "centri d'istantanea rotazione"},
      {"moments", "momenti"},
      {"natural equation", "equazione naturale"},
      {"polar diagram", "diagramma polare"},
      {"poles", "poli"},
      {"power balance", "bilancio delle potenze"},
      {"primitive", "primitiva"},
      {"quadrature", "quadratura"},
      {"quadratic map", "mappa quadratica"},
      {"recursion", "ricorrenza"},
      {"second polygon", "secondo poligono"},
      {"stiffness matrix", "matrice di rigidezza"},
      {"sums", "somme"},
      {"velocity diagram", "diagramma delle velocità"},
      {"virtual work", "lavori virtuali"},
  };
  const auto known = italian.find(route);
  return {route, known == italian.end() ? route : known->second};
}

}  // namespace epure
