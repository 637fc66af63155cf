// From a level to the solid: proves, without sampling, that every point of a triangle lies near the solid.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "generator/piece/lod/level_mesh.h"

namespace pomona {

/// A triangle of a level, and where to find the parts of the solid near it.
struct CoverQuery {
  TriangleCorners corner;
  std::uint32_t patch = 0;
  std::uint32_t fan = 0;                 ///< at one of its corners
  std::array<std::uint32_t, 3> chain{};  ///< the border along each side; none where there is none
  double bound = 0;                      ///< metres
};

/// The triangles of the solid above and below one of a level are found by walking from neighbour to neighbour.
/// The number of those that face up, less those that face down, is the same at every point of the triangle: it changes
/// only where the walk ends inside the triangle, and the walk ends only at a chain that a side of the triangle stands
/// for. So if the number is positive at one point, a triangle faces up at every point, no higher than the bound. The
/// other points lie between a side and its chain, and are as near to the chain as the chain is to the side.
class PatchCover {
 public:
  explicit PatchCover(const LevelSource& source) : source_(source), visit_(source.patch.size(), 0) {}

  /// True if each point of the triangle is within the bound of its patch of the solid, on the same side. The chains of
  /// its sides must be within the bound of these sides. False may also mean that there was no proof.
  bool covers(const CoverQuery& query, const BorderChains& chains);

 private:
  /// A point relative to the triangle: its distance inwards from each side, and its height; metres.
  struct Seen {
    std::array<double, 3> inside{};
    double height = 0;
  };
  /// An edge that the walk crosses, and the face beyond it.
  struct Step {
    std::uint32_t half_edge = 0;
    Seen from, to;
  };
  struct Frame;

  std::optional<int> enter(const Frame& frame, std::uint32_t face, const std::array<Seen, 3>& corner);
  static bool may_end_at(const Frame& frame, std::uint32_t a, std::uint32_t b);
  Seen seen(const Frame& frame, std::uint32_t fan) const;
  bool is_out_of_the_way_of_chains(const Frame& frame) const;
  static std::array<double, 3> weights_of_center(const CoverQuery& query);
  static double height_within(const Frame& frame, const std::array<Seen, 3>& corner);
  static int sheets_at_center(const Frame& frame, const std::array<Seen, 3>& corner);

  const LevelSource& source_;
  std::vector<std::uint32_t> visit_;  // per face: the number of the last walk that visited it
  std::uint32_t walk_ = 0;
  std::vector<Step> steps_;
  Ring ring_;
};

}  // namespace pomona
