#include "generator/cut/section/face_mesh.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pomona {

std::span<const EdgeUse> FaceMesh::uses(std::uint32_t p, std::uint32_t q) const {
  const auto less = [](const EdgeUse& a, const EdgeUse& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; };
  const EdgeUse key{std::min(p, q), std::max(p, q), 0, false};
  const auto range = std::equal_range(edges.begin(), edges.end(), key, less);
  return {range.first, range.second};
}

double FaceMesh::distance(std::uint32_t p, std::uint32_t q) const {
  return solid ? glm::distance(solid->place[p], solid->place[q]) : glm::distance(mesh.point[p], mesh.point[q]);
}

std::size_t FaceMesh::facets() const { return solid ? solid->frame.size() : sheet.facets(); }

/// No triangle reaches over a crease.
std::size_t FaceMesh::facet_of(std::size_t triangle) const {
  if (solid) return solid->facet[triangle];
  double u = 0;
  for (int i = 0; i < 3; ++i) u += mesh.point[mesh.triangle[triangle][i]].x / 3;
  return static_cast<std::size_t>(sheet.facet_at(u));
}

const CutFace& FaceMesh::frame(std::size_t facet) const {
  return solid ? solid->frame[facet] : sheet.frame(static_cast<int>(facet));
}

std::array<glm::vec3, 3> FaceMesh::normals(std::size_t triangle) const {
  if (solid) return solid->normal[triangle];
  std::array<glm::vec3, 3> all{};
  for (std::size_t i = 0; i < 3; ++i) {
    all[i] = sheet.normal_at(facet_of(triangle), mesh.point[mesh.triangle[triangle][static_cast<int>(i)]]);
  }
  return all;
}

}  // namespace pomona
