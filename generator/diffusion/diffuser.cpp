#include "generator/diffusion/diffuser.h"

namespace pomona {

CrossSection colored(CrossSection section, const DiffusionSurfaces& surfaces, const Diffuser& diffuser) {
  // Gather the interior vertices, diffuse at them, and put the colours back.
  std::vector<std::size_t> vertex;
  std::vector<glm::vec3> point;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    if (!section.interior[v]) continue;
    vertex.push_back(v);
    point.push_back(section.position[v]);
  }
  if (point.empty()) return section;

  const DiffusedColors diffused = diffuser.diffuse(surfaces, point);
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    section.color[vertex[i]] = diffused.color[i];
    section.part[vertex[i]] = diffused.part[i];
  }
  return section;
}

}  // namespace pomona
