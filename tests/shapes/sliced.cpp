#include "tests/shapes/sliced.h"

namespace pomona::shapes {

Slices sliced(const DiffusionSurfaces& surfaces, const std::vector<Knife>& knives, const Template& fruit,
              const Diffuser* diffuser, const SliceOptions& options) {
  const GrownFruit grown{surfaces, {}, surfaces};
  return slice({grown, fruit, knives}, diffuser, options);
}

}  // namespace pomona::shapes
