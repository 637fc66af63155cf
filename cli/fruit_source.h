// What `grow` and `cut` start from: a template's variant, or a surface file.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli/shared_options.h"
#include "cli/stage_times.h"
#include "generator/piece/grow.h"
#include "generator/piece/piece_origin.h"
#include "generator/piece/slice.h"

namespace pomona {

struct FruitSource {
  Template fruit;  ///< the variant; for a surface file, only a name and no curves
  GrownFruit grown;
  PieceOrigin origin;
  std::string name;  ///< of the template or file, without folder and ending
  std::string file;  ///< the template or file
};

/// What slice() is to do with it. \param piece this one alone, by its number; 0 = all.
SliceTask slice_task(const FruitSource& source, std::span<const Knife> knives, int piece);

/// slice(), where what is wrong with the fruit is told of its file.
Slices sliced(const FruitSource& source, const SliceTask& task, const Diffuser* diffuser,
              const SliceOptions& options = {});

/// \throws Error (usage) if there is no piece of this number.
void check_piece(int piece, const Slices& slices);

/// Varies and sweeps a template that has been read. \param word what named it. Adds the stages vary and sweep.
FruitSource fruit_of(const Template& drawn, const std::string& name, const std::string& word,
                     const SharedOptions& options, std::optional<int> folds, StageTimes& times);

/// Reads, varies and sweeps; a path ending in .ply is read as surfaces. Adds the stages read, vary and sweep.
FruitSource open_fruit(const std::string& name_or_path, const SharedOptions& options, std::optional<int> folds,
                       StageTimes& times);

}  // namespace pomona
