// Surfaces sliced as a grown fruit would be.
#pragma once

#include <vector>

#include "generator/piece/slice.h"

namespace pomona::shapes {

/// slice() of surfaces that nothing has to be swept or scattered for.
Slices sliced(const DiffusionSurfaces& surfaces, const std::vector<Knife>& knives, const Template& fruit = {},
              const Diffuser* diffuser = nullptr, const SliceOptions& options = {});

}  // namespace pomona::shapes
