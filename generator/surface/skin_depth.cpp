#include "generator/surface/skin_depth.h"

#include <algorithm>
#include <cmath>

#include "generator/surface/shell_geometry.h"

namespace pomona {

SkinDepth::SkinDepth(const DiffusionSurfaces& surfaces) {
  const std::vector<Shell> shells = measured_shells(surfaces, find_shells(surfaces));
  const auto skin = std::max_element(shells.begin(), shells.end(), [](const Shell& a, const Shell& b) {
    return std::fabs(a.volume) < std::fabs(b.volume);
  });
  if (skin == shells.end()) return;
  skin_ = TriangleTree(surfaces.position, skin->triangles);
  distance_ = DistanceTree(skin_);
  closed_ = skin->closed;
}

double SkinDepth::depth(const glm::dvec3& point) const { return skin_.empty() ? 0 : distance_.nearest(point).distance; }

std::vector<double> SkinDepth::depths(std::span<const glm::dvec3> points, double reach, Threads threads) const {
  if (skin_.empty()) return std::vector<double>(points.size(), 0.0);
  return distance_.distances(points, reach, threads);
}

double SkinDepth::height(const glm::dvec3& point) const {
  if (skin_.empty()) return 0;
  const double low = skin_.box().low.y, high = skin_.box().high.y;
  return high > low ? std::clamp((point.y - low) / (high - low), 0.0, 1.0) : 0;
}

}  // namespace pomona
