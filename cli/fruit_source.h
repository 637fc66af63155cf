// What `grow` and `cut` start from: a template's variant, or a surface file.
#pragma once

#include <optional>
#include <string>

#include "cli/shared_options.h"
#include "cli/stage_times.h"
#include "generator/piece/grow.h"

namespace pomona {

struct FruitSource {
  Template fruit;  ///< the variant; for a surface file, only a name and no curves
  GrownFruit grown;
  std::string name;  ///< of the template or file, without folder and ending
};

/// Reads, varies and sweeps; a path ending in .ply is read as surfaces. Adds the stages read, vary and sweep.
FruitSource open_fruit(const std::string& name_or_path, const SharedOptions& options, std::optional<int> folds,
                       StageTimes& times);

}  // namespace pomona
