// From a grown fruit and knives to coloured, browned, guided pieces: the second half of the road in one verb.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/base/stage_clock.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/diffuser.h"
#include "generator/piece/grow.h"
#include "generator/piece/piece_origin.h"
#include "generator/piece/solid.h"

namespace pomona {

/// Which pieces of a fruit are wanted. Of cut faces that none of them has, nothing is diffused.
struct PieceChoice {
  double smallest = 0, largest = 1;  ///< share of the whole's volume
  int take = 0;                      ///< so many, the largest; 0 = all
  int only = 0;                      ///< this one alone, by its number in the order of cutting, from 1; crumbs too
};

/// One fruit and what is to be done to it. All that it refers to must outlive the call it is passed to.
struct SliceTask {
  const GrownFruit& grown;
  const Template& variant;                 ///< that it was grown from: how it turns brown, its detail, its materials
  std::span<const Knife> knives = {};      ///< one after another; none leave it whole
  std::string name = "fruit";              ///< becomes the prefix of the pieces' names
  std::optional<PieceChoice> choice = {};  ///< none: all pieces
  PieceOrigin origin = {};                 ///< what is known of the variant's; slice() adds how the pieces were cut
  bool crumbs = false;                     ///< whether crumbs are kept: they are less than CutOptions::crumb together
};

struct SliceOptions {
  CutOptions cut{};
  bool pieces = true;  ///< false where the section alone is wanted
  /// For textures: every piece keeps what coloured its cut faces (section_colors.h). The diffuser must then outlive
  /// the pieces.
  bool keep_section_colors = false;
  Threads threads{};                    ///< for many fruits at once; the result does not depend on them
  std::function<void()> one_done = {};  ///< called for each fruit when it is finished, by any thread
};

struct Slices {
  CrossSection section;               ///< the colours as they diffused
  CrossSection styled;                ///< the same, browned by the air and guided along the surfaces, as pieces show it
  std::vector<Solid> pieces;          ///< in the order in which they were cut
  std::size_t piece_count = 0;        ///< also where pieces were not asked for
  std::vector<std::string> warnings;  ///< open boundaries, knives that miss
  StageClock times;                   ///< cut, diffuse, style
};

/// \param diffuser none where nobody looks at cut faces: they keep the colours of their rims.
/// \throws Error as cut() and Diffuser::field() do.
Slices slice(const SliceTask& task, const Diffuser* diffuser, const SliceOptions& options = {});

/// Many fruits: each cut by itself, the faces of all diffused as one batch. Each comes out as it would alone. The time
/// of the batch counts with the first.
std::vector<Slices> slice(std::span<const SliceTask> tasks, const Diffuser* diffuser, const SliceOptions& options = {});

}  // namespace pomona
