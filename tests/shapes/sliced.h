// Slices given surfaces like a grown fruit.
#pragma once

#include <vector>

#include "generator/piece/slice.h"

namespace pomona::shapes {

/// slice() of given surfaces, without sweeping and scattering.
Slices sliced(const DiffusionSurfaces& surfaces, const std::vector<Knife>& knives, const Template& fruit = {},
              const Diffuser* diffuser = nullptr, const SliceOptions& options = {});

}  // namespace pomona::shapes
