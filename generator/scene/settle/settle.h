// Settling: pieces dropped into a bowl until they lie as things lie.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/piece/pose.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/convex_parts.h"
#include "generator/scene/settle/pile.h"
#include "generator/scene/settle/real_contact.h"
#include "generator/scene/settle/seat.h"

namespace pomona {

/// One piece to be dropped.
struct SettleItem {
  int solid = 0;
  std::string name;      ///< for messages
  int order = 0;         ///< lower ones fall first; a garnish comes last
  bool face_up = false;  ///< dropped with its largest cut face up, else turned at random
  bool beside = false;   ///< onto the ground around the bowl
};

struct SettleOptions {
  std::uint64_t seed = 0;
  double most_gap = 0.02;          ///< shares of a piece's size, the diagonal of its box:
  double most_penetration = 0.02;  ///< what a settled piece may have, measured on the real meshes
  double fill = 0.92;              ///< share of the rim's radius into which pieces are dropped
  double spread = 0;               ///< metres: without a bowl, drops within so far of the axis; 0 = 4 times the widest
  double around = 1.8;             ///< pieces beside the bowl lie within this many of its radii
  int attempts = 5;                ///< each with another draw, until all pieces fit
  ConvexPartsOptions parts{};
  PileOptions pile{};
  SeatOptions seat{};
  Threads threads{};
};

struct Settled {
  std::vector<Pose> poses;  ///< one per item, rounded to 1e-6 so that a file holds them exactly
  std::vector<Fit> fits;    ///< measured at those poses
  int attempts = 0;
  int steps = 0;  ///< of the simulation, last attempt
};

/// Drops the items, in an order and from places drawn from the seed, into the bowl, which stands on the ground
/// (y = 0) about the axis and does not move; without a bowl, onto the ground.
/// \throws Error (some_items_failed) naming the pieces that keep a gap, overlap or lie outside the bowl.
Settled settle(std::span<const Solid> solids, std::span<const SettleItem> items, const Solid* bowl,
               const SettleOptions& options = {});

}  // namespace pomona
