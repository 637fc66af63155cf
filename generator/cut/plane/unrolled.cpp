#include "generator/cut/plane/unrolled.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/knife/crease.h"

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
  if (all.stroke) find_bends();
}

void Unrolled::find_bends() {
  bends_.assign(frames_.size() + 1, glm::dvec3(0));
  for (std::size_t i = 1; i < frames_.size(); ++i) {
    if (glm::dot(frames_[i - 1].normal, frames_[i].normal) <= smooth_cosine) continue;
    bends_[i] = glm::normalize(frames_[i - 1].normal + frames_[i].normal);
    frames_[i - 1].curved = frames_[i].curved = true;
  }
}

glm::vec3 Unrolled::normal_at(std::size_t facet, const glm::dvec2& point) const {
  const CutFace& frame = frames_[facet];
  if (!frame.curved) return glm::vec3(frame.normal);
  const auto at = [&](std::size_t bend) { return bends_[bend] == glm::dvec3(0) ? frame.normal : bends_[bend]; };

  // The last facet is taken to be as long as the one before.
  const std::size_t from = facet + 1 < frames_.size() ? facet : facet - 1;
  const double length = frames_[from + 1].along - frames_[from].along;
  const double share = std::clamp((point.x - frame.along) / length, 0.0, 1.0);
  constexpr double rounding = 1e-6;
  if (share < rounding) return glm::vec3(at(facet));
  if (share > 1 - rounding) return glm::vec3(at(facet + 1));
  return glm::vec3(glm::normalize(glm::mix(at(facet), at(facet + 1), share)));
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
