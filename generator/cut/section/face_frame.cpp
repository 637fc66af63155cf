#include "generator/cut/section/face_frame.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

CutFace frame_of(const CuttingPlane& plane) {
  CutFace face;
  face.normal = plane.normal;
  face.origin = plane.normal * plane.offset;
  const glm::dvec3& n = plane.normal;
  if (std::fabs(n.y) < 0.9) {
    face.v = glm::normalize(glm::dvec3(0, 1, 0) - n * n.y);
    face.u = glm::cross(face.v, n);
  } else {
    face.u = glm::normalize(glm::dvec3(1, 0, 0) - n * n.x);
    face.v = glm::cross(n, face.u);
  }
  return face;
}

glm::dvec2 to_face(const CutFace& face, const glm::dvec3& point) {
  const glm::dvec3 p = point - face.origin;
  return {glm::dot(p, face.u), glm::dot(p, face.v)};
}

glm::dvec3 from_face(const CutFace& face, const glm::dvec2& point) {
  return face.origin + point.x * face.u + point.y * face.v;
}

}  // namespace pomona
