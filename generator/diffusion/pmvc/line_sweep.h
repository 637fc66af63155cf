// One sweep: casts rays from all points along one line, in both directions.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "generator/diffusion/pmvc/line_directions.h"
#include "generator/diffusion/pmvc/packed_surfaces.h"

namespace pomona {

struct GroupBoxes;
struct SweepState;

/// Sums over lines, one entry per point.
struct SweepSums {
  std::vector<glm::vec4> color_and_weight;  ///< sums of c / d and of 1 / d, d normalised
  std::vector<float> fourth;                ///< the same of the surfaces' fourth value; empty if they have none
  std::vector<float> part_weight;           ///< points x used parts
};

/// Projects points and triangles onto the plane across a line. Every triangle tests the points that it covers, by a
/// grid of bins. Each point keeps its nearest hits ahead and behind.
///
/// The edge functions of two triangles that share an edge are exact negatives of each other, and 0 counts as inside: no
/// line slips through between them. Equal distances go to the smaller triangle index.
class LineSweep {
 public:
  /// `points` are normalised. `surfaces` and `boxes` must outlive this.
  /// \param follow_plane as in LinePlan.
  LineSweep(const PackedSurfaces& surfaces, const GroupBoxes& boxes, std::span<const glm::vec3> points,
            bool follow_plane);
  ~LineSweep();

  /// Casts the rays along `line` and adds their results to `sums`, which has an entry for every point.
  void add(const Line& line, SweepSums& sums);

 private:
  const PackedSurfaces& surfaces_;
  const GroupBoxes& boxes_;
  std::optional<glm::vec3> normal_;  ///< normal of the plane of the points, if they have one to follow
  std::unique_ptr<SweepState> state_;
};

}  // namespace pomona
