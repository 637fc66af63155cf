// Parts that stand proud of cut faces or are sunk in them, and how far places lie from the rims of their parts: what
// pictures and baked maps know of the depth of a face. No vertex moves.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// Of a place on a cut face.
struct RimPlace {
  double rim = 0.004;   ///< metres to where the place's part ends on the face, at most FaceRelief::reach
  double height = 0;    ///< metres, along the face's normal
  glm::dvec3 slope{0};  ///< of the height, metres per metre, within the face
};

/// The borders of parts on a solid's cut faces. A part of relief r rises from its border as a quarter of a circle does,
/// drawn out: after a way w = 2 |r| it is at its height,
///   h(d) = r (1 - (1 - d / w)^2) with d the distance to the border, and r from d = w on.
/// So the slope at the border is 1 whatever the relief; what borders on the part lies level.
class FaceRelief {
 public:
  static constexpr double reach = 0.004;  ///< metres: farther in all places are alike

  /// Only the borders of parts that `material_of` gives a relief, or light that goes deep.
  explicit FaceRelief(const Solid& solid);

  /// Whether any part of a cut face has something to show; else at() gives what RimPlace has by default.
  bool empty() const { return segments_.empty(); }

  /// A place of a triangle on a cut face.
  RimPlace at(std::uint32_t triangle, const glm::dvec3& place) const;

  /// At every vertex: of those on cut faces the mean of what their triangles say; else the default.
  std::vector<RimPlace> at_vertices() const;

 private:
  struct Segment {
    glm::dvec3 from{0}, to{0};
    glm::dvec3 inwards{0};  // unit, in the face, away from what borders on the part
  };
  struct Group {                                                          // a part on a face
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells;  // looked up, never walked over
    double relief = 0;
  };

  void group_triangles();
  void find_borders();
  void add(Group& group, const Segment& segment);

  const Solid& solid_;
  std::vector<Segment> segments_;
  std::vector<Group> groups_;
  std::vector<std::int32_t> group_of_;  // per triangle, or -1
};

/// Whether a part's place on a cut face is to be known: it has a relief, or light goes deep into it.
bool shows_rim(const MaterialSketch& material);

}  // namespace pomona
