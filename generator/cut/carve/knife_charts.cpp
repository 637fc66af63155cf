#include "generator/cut/carve/knife_charts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/cut/section/face_frame.h"

namespace pomona {

namespace {

/// Where normals add up to less than this share of the area, they have no useful mean direction.
constexpr double min_mean = 0.25;

constexpr int max_subdivisions = 8;

/// Divides part after part: what faces one way on the whole, then the rest.
class Charter {
 public:
  Charter(Face face, int knife) : face_(std::move(face)), knife_(knife) {
    for (const glm::uvec3& t : face_.triangle) {
      const glm::dvec3 &a = face_.place[t.x], &b = face_.place[t.y], &c = face_.place[t.z];
      area_.push_back(0.5 * glm::cross(b - a, c - a));
    }
  }

  Face run(const Regions& regions) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> of_face;
    for (std::uint32_t t = 0; t < face_.triangle.size(); ++t) {
      if (regions.is_section(t)) of_face[std::exchange(face_.facet[t], 0)].push_back(t);
    }
    for (auto& [number, triangles] : of_face) part(std::move(triangles), 0);
    if (face_.frame.empty()) face_.frame.emplace_back();
    return std::move(face_);
  }

 private:
  void part(std::vector<std::uint32_t> triangles, int subdivisions) {
    // Find the direction in which they face on the whole, or the axis around which those of a tube face.
    if (triangles.empty()) return;
    glm::dvec3 sum(0);
    double area = 0;
    for (const std::uint32_t t : triangles) {
      sum += area_[t];
      area += glm::length(area_[t]);
    }
    const double size = glm::length(sum);
    const bool has_direction = size > min_mean * area;
    const glm::dvec3 direction = has_direction ? sum / size : main_axis(triangles);

    // What faces that way is one face; the rest is divided again.
    std::vector<std::uint32_t> seen, others;
    for (const std::uint32_t t : triangles) (glm::dot(area_[t], direction) > 0 ? seen : others).push_back(t);
    if (seen.empty() || subdivisions >= max_subdivisions) {
      add(triangles, direction);
      return;
    }
    add(seen, direction);
    if (has_direction)
      part(std::move(others), subdivisions + 1);
    else
      part_away_from(direction, std::move(others), subdivisions + 1);
  }

  /// Divides what faces both ways along an axis: takes the other half.
  void part_away_from(const glm::dvec3& axis, std::vector<std::uint32_t> triangles, int subdivisions) {
    std::vector<std::uint32_t> seen, others;
    for (const std::uint32_t t : triangles) (glm::dot(area_[t], axis) < 0 ? seen : others).push_back(t);
    if (!seen.empty()) add(seen, -axis);
    part(std::move(others), subdivisions);
  }

  /// The axis of the frame along which most of the area faces, in either direction.
  glm::dvec3 main_axis(const std::vector<std::uint32_t>& triangles) const {
    glm::dvec3 along(0);
    for (const std::uint32_t t : triangles) {
      const double size = glm::length(area_[t]);
      if (size > 0) along += area_[t] * area_[t] / size;
    }
    if (along.z >= along.x && along.z >= along.y) return {0, 0, 1};
    return along.x >= along.y ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  }

  void add(const std::vector<std::uint32_t>& triangles, const glm::dvec3& direction) {
    glm::dvec3 middle(0);
    double area = 0;
    bool curved = false;
    for (const std::uint32_t t : triangles) {
      const double size = glm::length(area_[t]);
      const glm::uvec3& c = face_.triangle[t];
      middle += size / 3 * (face_.place[c.x] + face_.place[c.y] + face_.place[c.z]);
      area += size;
      for (const glm::vec3& n : face_.normal[t]) curved = curved || glm::distance(glm::dvec3(n), direction) > 1e-5;
      face_.facet[t] = static_cast<std::uint32_t>(face_.frame.size());
    }
    CuttingPlane plane{direction, area > 0 ? glm::dot(direction, middle) / area : 0};
    CutFace frame = frame_of(plane);
    frame.knife = knife_;
    frame.curved = curved;
    face_.frame.push_back(frame);
  }

  Face face_;
  int knife_;
  std::vector<glm::dvec3> area_;  // per triangle, along its normal
};

}  // namespace

Face charted(Face face, const Regions& regions, int knife) { return Charter(std::move(face), knife).run(regions); }

}  // namespace pomona
