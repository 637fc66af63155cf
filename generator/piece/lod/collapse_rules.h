// Rules for edge collapses of a solid: limits for the surface, borders and colours, and what is forbidden.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/mesh/edge_map.h"
#include "generator/mesh/triangle_distance.h"
#include "generator/mesh/triangle_tree.h"
#include "generator/piece/lod/vertex_fans.h"
#include "generator/piece/solid.h"

namespace pomona {

/// The largest differences of a level from the solid.
struct CollapseBounds {
  double distance = 0;  ///< metres: of surface and borders
  double color = 0;     ///< 0..1, of the square root of linear light, which is near sRGB; of each channel
};

/// The neighbourhood of the vertex that a half-edge collapse removes, counter-clockwise seen from the air.
struct CollapseRing {
  std::uint32_t removed = 0;         ///< it moves to the first neighbour
  std::vector<std::uint32_t> spoke;  ///< its neighbours
  std::vector<std::int32_t> face;    ///< between neighbour i and the next; -1: none, the solid is open there
};

/// For every face of the half-edge mesh, this stores the vertices of the solid that are its corners, and the removed
/// vertices that lie on it. So each collapse is compared with the original solid, not with the level before.
///
/// A border is an edge where the cut face or surface changes, or where a corner has two colours, two parts or very
/// different normals. A vertex on a border moves only along it; where borders meet or end, it does not move.
class CollapseRules {
 public:
  CollapseRules(const Solid& solid, const VertexFans& fans);

  /// The cost of a collapse: the changes of colours and borders, and long edges, as an area times a squared distance.
  /// Nothing if the cost is not below `limit`, or if the collapse is forbidden: it would exceed a bound, turn a
  /// triangle over or make it a needle.
  std::optional<double> cost(const CollapseRing& ring, double limit) const;

  /// Sets the bounds of all later collapses. Before this call no collapse is allowed.
  void set_bounds(const CollapseBounds& bounds) { bounds_ = bounds; }

  /// Records a collapse.
  void collapse(const CollapseRing& ring);

  std::size_t face_count() const { return faces_left_; }

  /// A triangle as it is now.
  struct Face {
    std::uint32_t source = 0;  ///< the triangle of the solid it grew from
    glm::uvec3 vertex{0};      ///< vertex of the solid
  };
  std::vector<Face> faces() const;

 private:
  /// The faces of a vertex that is removed: all of them, or those on one side of its border.
  struct Sector {
    std::vector<std::uint32_t> kept;  ///< faces that turn to the other vertex
    std::vector<std::uint32_t> lost;  ///< faces that vanish
    std::uint32_t from = 0, to = 0;   ///< vertices of the solid
  };
  struct Change {
    std::vector<Sector> sectors;
    std::optional<std::uint32_t> border_end;  ///< the other neighbour along the border
  };
  /// A vertex that was removed: its number in the solid, and its fan.
  struct Removed {
    std::uint32_t vertex = 0, fan = 0;
  };
  struct CornerFace {
    std::array<std::uint32_t, 3> fan{};
    std::array<std::uint32_t, 3> vertex{};  ///< vertex of the solid
    bool is_there = true;
    std::vector<Removed> removed;  ///< they lie on it now
  };
  /// A face as a collapse would leave it.
  struct Target {
    TriangleCorners corner;
    std::array<std::uint32_t, 3> vertex{};
  };
  struct Nearest {
    std::size_t target = 0;
    glm::dvec3 point{0};
    double squared_distance = std::numeric_limits<double>::infinity();
  };

  void plant_trees();
  double bound() const;
  std::uint32_t vertex_at(std::uint32_t face, std::uint32_t fan) const;
  bool looks_alike(std::uint32_t a, std::uint32_t b) const;
  bool is_border(std::int32_t left, std::int32_t right, std::uint32_t from, std::uint32_t to) const;
  std::optional<Change> change_by(const CollapseRing& ring) const;
  bool add_sector(const CollapseRing& ring, std::size_t first, std::size_t last, Change& change) const;
  bool keeps_its_side(std::uint32_t face, const Target& target) const;
  std::optional<double> cost_of_border(const CollapseRing& ring, const Change& change) const;
  std::optional<double> cost_of_sector(const CollapseRing& ring, const Sector& sector, double limit) const;
  std::optional<double> cost_of_removed(const Removed& removed, const std::vector<Target>& targets) const;
  Nearest nearest_target(const Removed& removed, const std::vector<Target>& targets) const;
  bool lies_near(std::uint32_t face, const Target& target) const;
  glm::dvec3 color_on(const Target& target, const glm::dvec3& point) const;
  std::vector<Removed> removed_in(const CollapseRing& ring, const Sector& sector) const;
  std::vector<std::uint32_t> gone_from_border(const CollapseRing& ring, const Change& change) const;
  std::vector<Target> targets_of(const CollapseRing& ring, const Sector& sector) const;

  const SolidMesh& mesh_;
  std::vector<TriangleTree> trees_;     // a tree of each cut face and surface of the solid
  std::vector<std::uint32_t> tree_of_;  // per face: that in which it lay
  CollapseBounds bounds_;
  std::vector<std::uint32_t> source_;
  std::vector<CornerFace> face_;
  std::vector<glm::dvec3> normal_;                 // per face: of the triangle it grew from, as long as twice its area
  std::vector<glm::dvec3> position_;               // per fan
  std::vector<glm::dvec3> seen_;                   // per vertex of the solid: its colour's square root
  std::vector<double> area_;                       // per fan, square metres: a third of the triangles around it
  EdgeMap<std::vector<std::uint32_t>> gone_from_;  // per border edge: fans that lay along it
  std::size_t faces_left_ = 0;
};

}  // namespace pomona
