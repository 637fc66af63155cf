// Blades in two dimensions.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "generator/cut/section/face_frame.h"
#include "generator/knife/cut_planes.h"

namespace pomona {

/// A cutting blade in two dimensions: a plane as it is, or the facets of a stroke side by side, u along the stroke and
/// v = +Z.
class UnrolledBlade {
 public:
  UnrolledBlade() = default;
  UnrolledBlade(const CutPlanes& planes, int blade);

  std::size_t facets() const { return frames_.size(); }
  int facet_at(double u) const;
  glm::dvec2 to_face(int facet, const glm::dvec3& point) const;
  glm::dvec3 from_face(const glm::dvec2& point) const;
  const CutFace& frame(int facet) const { return frames_[static_cast<std::size_t>(facet)]; }

  /// The normal: smooth over small creases (crease.h), where it is the same to the bit for both facets.
  glm::vec3 normal_at(std::size_t facet, const glm::dvec2& point) const;

 private:
  void find_bends();

  std::vector<CutFace> frames_;    // per facet
  std::vector<glm::dvec3> bends_;  // of a stroke, where each facet begins: the normal there; 0 at a crease
};

}  // namespace pomona
