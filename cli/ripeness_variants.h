// A cut fruit at several ripenesses, on one mesh: --ripeness-variants.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/fruit_source.h"
#include "cli/shared_options.h"
#include "cli/stage_times.h"
#include "generator/diffusion/diffuser.h"

namespace pomona {

/// The pieces once more, at another ripeness.
struct RipenessVariant {
  std::string name;  ///< "ripeness 0.3"
  std::vector<Solid> pieces;
};

/// "0.3,1,1.7": each from 0 to 2, none twice; nothing if none was asked for.
/// \throws Error (usage) for what is none, and where no textures are asked for, or levels of detail are.
std::vector<double> wanted_ripenesses(const SharedOptions& options);

/// \param pieces of the fruit as it is. \param fruit as it was named. \param diffuser none for what was not cut.
std::vector<RipenessVariant> ripeness_variants(std::span<const Solid> pieces, const FruitSource& source,
                                               const std::string& fruit, const SharedOptions& options,
                                               std::optional<int> folds, const Diffuser* diffuser, StageTimes& times);

}  // namespace pomona
