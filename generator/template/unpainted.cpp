#include "generator/template/unpainted.h"

namespace pomona {

Template unpainted(Template fruit) {
  for (SurfaceSketch& surface : fruit.surfaces) {
    for (Side* side : {&surface.front, &surface.back}) {
      side->coats.clear();
      side->spots.clear();
    }
  }
  return fruit;
}

}  // namespace pomona
