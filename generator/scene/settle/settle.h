// Settling: pieces dropped into a bowl until they lie as things lie.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "generator/base/error.h"
#include "generator/base/parallel.h"
#include "generator/piece/pose.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/arrange.h"
#include "generator/scene/settle/fit_check.h"
#include "generator/scene/settle/heap.h"

namespace pomona {

/// One piece to be dropped, or set to a place.
struct SettleItem {
  int solid = 0;
  std::string name;      ///< for messages
  int order = 0;         ///< lower ones fall first; a garnish comes last
  bool face_up = false;  ///< dropped with its largest cut face up, else turned at random
  bool beside = false;   ///< onto the ground around the bowl
  bool upright = false;  ///< as it grew
  int arrangement = -1;  ///< index of SettleOptions::arrangements; -1 = dropped anywhere
  int fruit = 0;         ///< pieces of one cut fruit have the same
  SourcePlace place{};   ///< of what asks for it, for messages
};

struct SettleOptions {
  std::uint64_t seed = 0;
  double most_gap = 0.02;          ///< shares of a piece's size, the diagonal of its box:
  double most_penetration = 0.02;  ///< what a settled piece may have, measured on the real meshes,
  double most_of_few = 0.05;       ///< and what one may have of so many
  std::size_t few_of = 200;
  double fill = 0.92;   ///< share of the rim's radius into which pieces are dropped
  double spread = 0;    ///< metres: without a bowl, drops within so far of the axis; 0 = 4 times the widest
  double around = 1.8;  ///< pieces beside the bowl lie within this many of its radii
  int attempts = 5;     ///< how often what lies badly is dropped, the first time counted
  std::vector<PieceArrangement> arrangements{};
  HeapOptions heap{};
  Threads threads{};
  /// Told from the calling thread how many pieces of a stage are done: "settle", then "measure".
  std::function<void(const std::string& stage, std::size_t done, std::size_t total)> progress{};
};

struct Settled {
  std::vector<Pose> poses;  ///< one per item, rounded to 1e-6 so that a file holds them exactly
  std::vector<Fit> fits;    ///< measured at those poses
  int attempts = 0;
  int steps = 0;          ///< of the simulation
  std::size_t again = 0;  ///< so often a single piece was taken out and dropped once more
};

/// Sets what is to be set, then drops the other items, in an order and from places drawn from the seed, into the dish,
/// which stands on the ground (y = 0) and does not move; without a dish, onto the ground. The same poses for any number
/// of threads; heaps that have nothing to do with each other may settle at the same time.
/// \throws Error (some_items_failed) naming the pieces that keep a gap, overlap or lie outside the dish, (bad_data) if
/// the dish has no room for any: no hollow, or nothing that looks upwards to be strewn on.
Settled settle(std::span<const Solid> solids, std::span<const SettleItem> items, const DishForm& dish,
               const SettleOptions& options = {});

}  // namespace pomona
