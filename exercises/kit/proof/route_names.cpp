#include "exercises/kit/proof/route_names.h"

#include <map>

namespace epure {

Words route_in_words(const std::string& route) {
  static const std::map<std::string, std::string> italian = {
      {"Cremona's plan", "diagramma cremoniano"},
      {"Euler-Maclaurin", "Eulero-Maclaurin"},
      {"Mohr's circle", "cerchio di Mohr"},
      {"Newton-Euler", "Newton-Eulero"},
      {"analytic", "analitica"},
      {"branch and bound", "ramificazione e limitazione"},
      {"closed form", "forma chiusa"},
      {"constraint equations", "equazioni di vincolo"},
      {"construction", "costruzione"},
      {"elastic weights", "pesi elastici"},
      {"energy", "energia"},
      {"energy integral", "integrale dell'energia"},
      {"equilibrium equations", "equazioni di equilibrio"},
      {"equivalent mechanism", "meccanismo equivalente"},
      {"force polygon", "poligono delle forze"},
      {"free bodies", "corpi isolati"},
      {"funicular polygon", "poligono funicolare"},
      {"graphical integration", "integrazione grafica"},
      {"instant centres", "centri d'istantanea rotazione"},
      {"joint equations", "equazioni dei vincoli"},
      {"matrix powers", "potenze della matrice"},
      {"moments", "momenti"},
      {"natural equation", "equazione naturale"},
      {"phase plane", "piano delle fasi"},
      {"polar diagram", "diagramma polare"},
      {"poles", "poli"},
      {"power balance", "bilancio delle potenze"},
      {"primitive", "primitiva"},
      {"quadratic map", "mappa quadratica"},
      {"quadrature", "quadratura"},
      {"recursion", "ricorrenza"},
      {"roots of the derivative", "radici della derivata"},
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
