#include "exercises/kit/proof/route_names.h"

#include <map>

namespace epure {

Words route_in_words(const std::string& route) {
  static const std::map<std::string, std::string> italian = {
      {"analytic", "analitica"},
      {"closed form", "forma chiusa"},
      {"construction", "costruzione"},
      {"constraint equations", "equazioni di vincolo"},
      {"funicular polygon", "poligono funicolare"},
      {"graphical integration", "integrazione grafica"},
      {"instant centres", "centri d'istantanea rotazione"},
      {"moments", "momenti"},
      {"natural equation", "equazione naturale"},
      {"Newton-Euler", "Newton-Eulero"},
      {"polar diagram", "diagramma polare"},
      {"poles", "poli"},
      {"power balance", "bilancio delle potenze"},
      {"primitive", "primitiva"},
      {"quadrature", "quadratura"},
      {"sums", "somme"},
  };
  const auto known = italian.find(route);
  return {route, known == italian.end() ? route : known->second};
}

}  // namespace epure
