// Cutting sheets in two dimensions.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "generator/cut/cross_section.h"
#include "generator/cut/cut_planes.h"

namespace pomona {

/// u and v upright where the plane is; for level planes u = +X, v = -Z.
CutFace frame_of(const CuttingPlane& plane);
glm::dvec2 to_face(const CutFace& face, const glm::dvec3& point);
glm::dvec3 from_face(const CutFace& face, const glm::dvec2& point);

/// A cutting sheet in two dimensions: a plane as it is, or the facets of a stroke side by side, u along the stroke and
/// v = +Z.
class Unrolled {
 public:
  Unrolled() = default;
  Unrolled(const CutPlanes& planes, int sheet);

  int facet_at(double u) const;
  glm::dvec2 to_face(int facet, const glm::dvec3& point) const;
  glm::dvec3 from_face(const glm::dvec2& point) const;
  const CutFace& frame(int facet) const { return frames_[static_cast<std::size_t>(facet)]; }

 private:
  std::vector<CutFace> frames_;  // per facet
};

}  // namespace pomona
