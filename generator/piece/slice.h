// Slices a fruit: from a grown fruit and knives to coloured, browned pieces. This is the second half of the road.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/base/stage_clock.h"
#include "generator/compose/grow.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/diffuser.h"
#include "generator/piece/piece_origin.h"
#include "generator/piece/solid.h"

namespace pomona {

/// The wanted pieces of a fruit. Cut faces that none of them has are not diffused.
struct PieceChoice {
  double smallest = 0, largest = 1;  ///< limits of the volume, as a share of the whole's volume
  int take = 0;                      ///< number of pieces, the largest first; 0 = all
  int only = 0;                      ///< only this piece: its number in the order of cutting, from 1; may be a crumb
};

/// One fruit, and how to cut it. All that it refers to must outlive the call.
struct SliceTask {
  const GrownFruit& grown;
  const Template& variant;                 ///< the variant that was grown: for browning, detail and materials
  std::span<const Knife> knives = {};      ///< in their order; none = the fruit stays whole
  std::string name = "fruit";              ///< prefix of the pieces' names
  std::optional<PieceChoice> choice = {};  ///< nothing = all pieces
  PieceOrigin origin = {};                 ///< origin of the variant; slice() adds how the pieces were cut
  bool crumbs = false;                     ///< keep crumbs: pieces that together are less than CutOptions::crumb, and
                                           ///< those of the section (section_crumbs.h)
};

struct SliceOptions {
  CutOptions cut{};
  bool pieces = true;  ///< false = only the section
  /// For textures: every piece keeps its SectionColors. The diffuser must then outlive the pieces.
  bool keep_section_colors = false;
  bool organs = false;  ///< volumes and masses of organs, too (organs.h), for lists, records and ground truth
  Threads threads{};    ///< for many fruits at once; the result does not depend on them
  std::function<void()> one_done = {};  ///< called for each fruit when it is finished, by any thread
};

struct Slices {
  CrossSection section;               ///< with the diffused colours, without crumbs
  CrossSection styled;                ///< the same, browned and with guides: as the pieces show it
  std::vector<Solid> pieces;          ///< in the order in which they were cut
  std::size_t piece_count = 0;        ///< number of pieces, also if SliceOptions::pieces is false
  std::vector<std::string> warnings;  ///< open boundaries, knives that miss
  StageClock times;                   ///< cut, diffuse, style
};

/// \param diffuser null if cut faces are not visible: they keep the colours of their rims.
/// \throws Error as cut() and Diffuser::field() do.
Slices slice(const SliceTask& task, const Diffuser* diffuser, const SliceOptions& options = {});

/// Many fruits: each is cut by itself; the faces of all are diffused as one batch. The result for each is the same as
/// alone. The time of the batch is added to that of the first fruit.
std::vector<Slices> slice(std::span<const SliceTask> tasks, const Diffuser* diffuser, const SliceOptions& options = {});

}  // namespace pomona
