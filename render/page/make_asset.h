// Makes an asset of a grown fruit.
#pragma once

#include <cstdint>
#include <string>

#include "generator/compose/grow.h"
#include "generator/diffusion/diffuser.h"
#include "generator/template/template.h"
#include "render/page/asset.h"

namespace pomona {

struct AssetTask {
  const GrownFruit& grown;
  const Template& variant;  ///< its variant, for noise, detail and materials
  std::string name = "fruit";
  std::uint64_t seed = 0;
};

struct MakeAssetOptions {
  /// The quality of the grid: draft has 64 nodes along the side of a cube as large as the fruit, final 112.
  Quality quality = Quality::final;

  /// The diffuser of the nodes; null: the solution on the grid itself, true diffusion.
  const Diffuser* diffuser = nullptr;
  Threads threads{};
};

/// \throws Error (bad_data) for surfaces without a boundary to air, with an open one, so that inside is not defined, or
/// with too many parts.
Asset make_asset(const AssetTask& task, const MakeAssetOptions& options = {});

}  // namespace pomona
