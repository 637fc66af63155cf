// The relief of parts on cut faces, and distances to the rims of parts, for pictures and baked maps. No vertex moves.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// A place on a cut face.
struct RimPlace {
  double rim = 0.004;   ///< distance to where the place's part ends on the face, metres, at most FaceRelief::reach
  double height = 0;    ///< metres, along the face's normal
  glm::dvec3 slope{0};  ///< slope of the height, metres per metre, within the face
};

/// The borders of parts on a solid's cut faces. A part of relief r rises from its border like a stretched quarter of a
/// circle, over a width w = 2 |r|:
/// h(d) = r (1 - (1 - d / w)^2) with d the distance to the border, and r from d = w on. So the slope at the border is 1
/// for every relief; neighbouring parts lie level.
class FaceRelief {
 public:
  static constexpr double reach = 0.004;  ///< metres; places farther from a border are all alike

  /// Uses only the borders of parts whose `material_of` has a relief, or lets light in deep.
  explicit FaceRelief(const Solid& solid);

  /// Whether any part of a cut face has a relief or gel; else at() returns a default RimPlace.
  bool empty() const { return segments_.empty(); }

  /// The relief at a place of a triangle on a cut face.
  RimPlace at(std::uint32_t triangle, const glm::dvec3& place) const;

  /// The relief at every vertex: on cut faces the mean over its triangles, elsewhere the default.
  std::vector<RimPlace> at_vertices() const;

 private:
  struct Segment {
    glm::dvec3 from{0}, to{0};
    glm::dvec3 inwards{0};  // unit vector in the face, from the border into the part
  };
  struct Group {                                                          // a part on a face
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells;  // for look-ups only, because its order is not
                                                                          // defined
    double relief = 0;
  };

  void group_triangles();
  void find_borders();
  void add(Group& group, const Segment& segment);

  const Solid& solid_;
  std::vector<Segment> segments_;
  std::vector<Group> groups_;
  std::vector<std::int32_t> group_of_;  // group of each triangle, or -1
};

/// Whether a part needs its places on a cut face: it has a relief, or light goes deep into it.
bool shows_rim(const MaterialSketch& material);

}  // namespace pomona
