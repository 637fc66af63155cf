#include "generator/cut/plane/unrolled_blade.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/knife/crease.h"

namespace pomona {

UnrolledBlade::UnrolledBlade(const CutPlanes& planes, int blade) {
  const CutPlanes::Blade& all = planes.blades[static_cast<std::size_t>(blade)];
  for (int i = 0; i < all.count; ++i) {
    const int plane = all.first + i;
    CutFace frame = frame_of(planes[plane].plane);
    if (const Stroke::Facet* facet = planes.facet(plane)) {
      frame.origin = glm::dvec3(facet->start, 0);
      frame.u = glm::dvec3(facet->direction, 0);
      frame.v = {0, 0, 1};
      frame.stroke = blade;
      frame.along = facet->along;
    }
    frame.knife = planes[plane].knife;
    frames_.push_back(frame);
  }
  if (all.stroke) find_bends();
}

void UnrolledBlade::find_bends() {
  bends_.assign(frames_.size() + 1, glm::dvec3(0));
  for (std::size_t i = 1; i < frames_.size(); ++i) {
    if (glm::dot(frames_[i - 1].normal, frames_[i].normal) <= smooth_cosine) continue;
    bends_[i] = glm::normalize(frames_[i - 1].normal + frames_[i].normal);
    frames_[i - 1].curved = frames_[i].curved = true;
  }
}

glm::vec3 UnrolledBlade::normal_at(std::size_t facet, const glm::dvec2& point) const {
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

int UnrolledBlade::facet_at(double u) const {
  const auto after = std::upper_bound(frames_.begin() + 1, frames_.end(), u,
                                      [](double at, const CutFace& frame) { return at < frame.along; });
  return static_cast<int>(after - frames_.begin()) - 1;
}

glm::dvec2 UnrolledBlade::to_face(int facet, const glm::dvec3& point) const {
  return pomona::to_face(frame(facet), point) + glm::dvec2(frame(facet).along, 0);
}

glm::dvec3 UnrolledBlade::from_face(const glm::dvec2& point) const {
  const CutFace& face = frame(facet_at(point.x));
  return pomona::from_face(face, point - glm::dvec2(face.along, 0));
}

}  // namespace pomona
