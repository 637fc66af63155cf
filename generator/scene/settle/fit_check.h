// The exact check of settled pieces: gaps and penetrations, measured on the meshes themselves.
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

/// A gap is measured up to this share of a piece's size.
constexpr double farthest_gap = 0.1;

/// How one piece fits into a heap, in shares of its size.
struct Fit {
  double gap = 0;          ///< distance to the nearest other mesh; 0 if they overlap, at most `farthest_gap`
  double penetration = 0;  ///< depth of the deepest overlap with any other mesh
};

/// Measures a heap again and again. It keeps the results of pairs that have not moved.
class FitCheck {
 public:
  /// \param solid_of index of each piece's solid.
  FitCheck(std::span<const Solid> solids, std::vector<std::size_t> solid_of, const PlacedMesh& stand, Threads threads);

  /// One fit for each piece, with respect to all others and the stand. Memory holds the meshes of a few hundred pieces
  /// at a time.
  /// \param absent sorted indices of pieces that are not in the heap; their poses are not used.
  /// \param progress is called from this thread with the number of pieces measured so far.
  std::vector<Fit> measure(std::span<const Pose> poses, std::span<const std::size_t> absent = {},
                           const std::function<void(std::size_t)>& progress = {});

 private:
  /// Two pieces that may touch, or a piece and the stand.
  struct Pair {
    std::size_t first = 0, second = 0;  ///< indices of pieces; the number of pieces stands for the stand
    std::optional<double> depth;        ///< depth of the overlap, metres; 0 where they are apart
    std::optional<double> distance;     ///< metres, if they are apart; infinite where it is not near
  };
  enum class Quantity { depth, distance };
  using Progress = std::function<void(std::size_t)>;
  Box<double> box_at(std::size_t piece, const Pose& pose) const;
  std::vector<Pair> near_pairs(std::span<const Pose> poses, std::span<const std::size_t> absent) const;
  void reuse_measured(std::span<const Pose> poses, std::vector<Pair>& pairs) const;
  void measure_pairs(Quantity quantity, std::span<const Pose> poses, std::vector<Pair*> pairs,
                     const Progress& progress) const;
  void measure_chunk(Quantity quantity, std::span<const Pose> poses, std::span<Pair* const> pairs) const;
  double size(std::size_t piece) const { return glm::length(boxes_[solid_of_[piece]].size()); }

  std::span<const Solid> solids_;
  std::vector<std::size_t> solid_of_;
  const PlacedMesh& stand_;
  Threads threads_;
  std::vector<Box<double>> boxes_;    ///< boxes of the solids, metres
  std::vector<Pose> measured_;        ///< the poses of the last measurement
  std::vector<Pair> measured_pairs_;  ///< the results of the last measurement, sorted
};

}  // namespace pomona
