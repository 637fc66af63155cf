#include "generator/template/read/surface_names.h"

namespace pomona {

std::vector<std::string> surface_names(const Template& fruit) {
  std::vector<std::string> names;
  for (const SurfaceSketch& surface : fruit.surfaces) names.push_back(surface.name);
  return names;
}

}  // namespace pomona
