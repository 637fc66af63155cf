// From a grown fruit to what can be cut elsewhere.
#pragma once

#include <cstdint>
#include <string>

#include "generator/diffusion/diffuser.h"
#include "generator/piece/grow.h"
#include "generator/template/template.h"
#include "render/page/asset.h"

namespace pomona {

struct AssetTask {
  const GrownFruit& grown;
  const Template& variant;  ///< that it was grown from: noise, detail, materials
  std::string name = "fruit";
  std::uint64_t seed = 0;
};

struct MakeAssetOptions {
  /// Of the grid: draft has nodes 64 along the side of a cube as large as the fruit, final 112.
  Quality quality = Quality::final;

  /// What colours the nodes; none: the solution on the grid itself, true diffusion.
  const Diffuser* diffuser = nullptr;
  Threads threads{};
};

/// \throws Error (bad_data) for surfaces without a boundary to air, with an open one, or with more parts than an asset
/// holds: which points are inside could not be told.
Asset make_asset(const AssetTask& task, const MakeAssetOptions& options = {});

}  // namespace pomona
