// The items to settle, and the options.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "generator/base/error.h"
#include "generator/base/parallel.h"
#include "generator/scene/settle/arrange.h"
#include "generator/scene/settle/rigid_body_world.h"

namespace pomona {

/// One piece to be dropped or placed.
struct SettleItem {
  int solid = 0;         ///< index of its solid
  std::string name;      ///< for messages
  int order = 0;         ///< items with a lower order fall first; a garnish comes last
  bool face_up = false;  ///< it starts with its largest cut face up; else in a random rotation
  bool beside = false;   ///< it falls onto the ground around the bowl
  bool upright = false;  ///< it starts in the orientation in which it grew
  int arrangement = -1;  ///< index of SettleOptions::arrangements; -1 = dropped anywhere
  int fruit = 0;         ///< number of the fruit it was cut from
  SourcePlace place{};   ///< its place in the scene file, for messages
};

struct SettleOptions {
  std::uint64_t seed = 0;
  double max_gap = 0.02;          ///< largest gap of a settled piece, as a share of the diagonal of its box
  double max_penetration = 0.02;  ///< largest penetration of a settled piece, as a share of the same
  double max_rare_fault = 0.05;   ///< a larger gap or penetration, up to this share, is accepted of few pieces
  std::size_t rare_in = 200;      ///< it is accepted of one piece in this many
  double fill = 0.92;             ///< pieces are dropped within this share of the rim's radius
  double spread = 0;              ///< without a bowl: how far from the axis pieces fall, metres; 0 = 4 times the widest
  double around = 1.8;            ///< pieces beside the bowl lie within this many of its radii
  int attempts = 5;               ///< how often pieces that lie badly are dropped, the first drop included
  std::vector<PieceArrangement> arrangements{};
  WorldOptions world{};
  Threads threads{};
  /// Called from the calling thread with the stage, "settle" or "measure", and how many of its pieces are done.
  std::function<void(const std::string& stage, std::size_t done, std::size_t total)> progress{};
};

}  // namespace pomona
