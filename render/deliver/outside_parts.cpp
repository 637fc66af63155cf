#include "render/deliver/outside_parts.h"

#include <string>

namespace pomona {

OutsideParts outside_parts(const Template& fruit) {
  OutsideParts parts;
  for (const SurfaceSketch& surface : fruit.surfaces) {
    for (const Side& side : {surface.front, surface.back}) {
      if (side.hidden) parts[surface.name] = fruit.parts.at(side.part);
    }
  }
  return parts;
}

}  // namespace pomona
