#include "generator/cut/unrolled.h"

#include <algorithm>
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

Unrolled::Unrolled(const CutPlanes& planes, int sheet) {
  const CutPlanes::Sheet& all = planes.sheets[static_cast<std::size_t>(sheet)];
  for (int i = 0; i < all.count; ++i) {
    const int plane = all.first + i;
    CutFace frame = frame_of(planes[plane].plane);
    if (const Stroke::Facet* facet = planes.facet(plane)) {
      frame.origin = glm::dvec3(facet->start, 0);
      frame.u = glm::dvec3(facet->direction, 0);
      frame.v = {0, 0, 1};
      frame.stroke = sheet;
      frame.along = facet->along;
    }
    frame.knife = planes[plane].knife;
    frames_.push_back(frame);
  }
}

int Unrolled::facet_at(double u) const {
  const auto after = std::upper_bound(frames_.begin() + 1, frames_.end(), u,
                                      [](double at, const CutFace& frame) { return at < frame.along; });
  return static_cast<int>(after - frames_.begin()) - 1;
}

glm::dvec2 Unrolled::to_face(int facet, const glm::dvec3& point) const {
  return pomona::to_face(frame(facet), point) + glm::dvec2(frame(facet).along, 0);
}

glm::dvec3 Unrolled::from_face(const glm::dvec2& point) const {
  const CutFace& face = frame(facet_at(point.x));
  return pomona::from_face(face, point - glm::dvec2(face.along, 0));
}

}  // namespace pomona
