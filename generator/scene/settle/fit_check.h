// The exact check: how settled pieces touch, measured on their real meshes.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/mesh/box.h"
#include "generator/piece/pose.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/real_contact.h"

namespace pomona {

/// How one piece fits into a heap, as shares of its size. Penetration: the deepest overlap with any other mesh. Gap:
/// the distance to the nearest other mesh, which is what keeps it from falling; 0 if they overlap, and nothing farther
/// away than `farthest_gap` is looked for.
struct Fit {
  double gap = 0;
  double penetration = 0;
};
constexpr double farthest_gap = 0.1;

/// Measures again and again; what has not moved since, it remembers.
class FitCheck {
 public:
  /// \param solid_of index of each piece's solid.
  FitCheck(std::span<const Solid> solids, std::vector<std::size_t> solid_of, const PlacedMesh& stand, Threads threads);

  /// One fit per piece, among the others and the stand. Memory holds the meshes of a few hundred pieces at a time.
  /// \param absent the pieces that lie nowhere, by number, rising: their poses mean nothing, and nothing touches them.
  /// \param progress is told how many pieces have been measured; from this thread.
  std::vector<Fit> measure(std::span<const Pose> poses, std::span<const std::size_t> absent = {},
                           const std::function<void(std::size_t)>& progress = {});

 private:
  /// Two pieces that may touch, or a piece and the stand, whose number is that of the pieces.
  struct Pair {
    std::size_t first = 0, second = 0;
    std::optional<double> depth;     ///< metres of overlap, 0 where they are apart
    std::optional<double> distance;  ///< metres, if they are apart; infinite beyond what is looked for
  };
  enum class Question { depth, distance };
  using Progress = std::function<void(std::size_t)>;
  Box<double> box_at(std::size_t piece, const Pose& pose) const;
  std::vector<Pair> pairs_near(std::span<const Pose> poses, std::span<const std::size_t> absent) const;
  void remember(std::span<const Pose> poses, std::vector<Pair>& pairs) const;
  void ask(Question question, std::span<const Pose> poses, std::vector<Pair*> pairs, const Progress& progress) const;
  void ask_chunk(Question question, std::span<const Pose> poses, std::span<Pair* const> pairs) const;
  double size(std::size_t piece) const { return glm::length(boxes_[solid_of_[piece]].size()); }

  std::span<const Solid> solids_;
  std::vector<std::size_t> solid_of_;
  const PlacedMesh& stand_;
  Threads threads_;
  std::vector<Box<double>> boxes_;    ///< of solids
  std::vector<Pose> measured_;        ///< poses of the last measurement,
  std::vector<Pair> measured_pairs_;  ///< and what came of it, sorted
};

}  // namespace pomona
