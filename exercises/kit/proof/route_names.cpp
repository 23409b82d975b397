#include "exercises/kit/proof/route_names.h"

#include <map>

namespace epure {

Words route_in_words(const std::string& route) {
  static const std::map<std::string, std::string> italian = {
      {"analytic", "analitica"},
      {"construction", "costruzione"},
      {"constraint equations", "equazioni di vincolo"},
<<<<<<< HEAD
      {"elastic weights", "pesi elastici"},
      {"energy", "energia"},
      {"funicular polygon", "poligono funicolare"},
=======
      {"equilibrium equations", "equazioni di equilibrio"},
      {"force polygon", "poligono delle forze"},
>>>>>>> statics
      {"instant centres", "centri d'istantanea rotazione"},
      {"Mohr's circle", "cerchio di Mohr"},
      {"natural equation", "equazione naturale"},
      {"Newton-Euler", "Newton-Eulero"},
      {"polar diagram", "diagramma polare"},
      {"poles", "poli"},
      {"power balance", "bilancio delle potenze"},
      {"primitive", "primitiva"},
      {"quadrature", "quadratura"},
<<<<<<< HEAD
      {"second polygon", "secondo poligono"},
      {"stiffness matrix", "matrice di rigidezza"},
      {"virtual work", "lavori virtuali"},
=======
      {"velocity diagram", "diagramma delle velocità"},
>>>>>>> statics
  };
  const auto known = italian.find(route);
  return {route, known == italian.end() ? route : known->second};
}

}  // namespace epure
