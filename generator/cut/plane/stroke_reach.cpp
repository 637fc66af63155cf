#include "generator/cut/plane/stroke_reach.h"

#include <algorithm>
#include <numeric>

#include "generator/mesh/box.h"

namespace pomona {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

void sort_once(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

FlatStretch stretch_of(const Stroke::Facet& facet, double more, double farthest) {
  const double from = std::max(facet.from - more, -farthest), to = std::min(facet.to + more, farthest);
  return {facet.start + from * facet.direction, facet.start + to * facet.direction};
}

StrokeReach::StrokeReach(const SplitMesh& mesh, const glm::dvec2& low, const glm::dvec2& high)
    : grid_(low, high, mesh.triangle.size() / 4), point_begin_(mesh.point.size() + 2, 0) {
  whole_.resize(mesh.triangle.size());
  std::iota(whole_.begin(), whole_.end(), 0u);
  newest_ = whole_;
  before_.assign(whole_.size(), none);
  for (const std::uint32_t t : whole_) {
    const auto& v = mesh.triangle[t].vertex;
    corner_.push_back({mesh.point_of[v[0]], mesh.point_of[v[1]], mesh.point_of[v[2]]});
    const auto& [a, b, c] = corner_.back();
    const Box<double> box = box_around(mesh.point[a], mesh.point[b], mesh.point[c]);
    grid_.add(t, glm::dvec2(box.low), glm::dvec2(box.high));
    for (const std::uint32_t p : corner_.back()) ++point_begin_[p + 2];
  }
  // Counting sort: each entry moves to the end of its point's, which is the start of the next.
  std::partial_sum(point_begin_.begin(), point_begin_.end(), point_begin_.begin());
  at_point_.resize(3 * corner_.size());
  for (const std::uint32_t t : whole_)
    for (const std::uint32_t p : corner_[t]) at_point_[point_begin_[p + 1]++] = t;
}

void StrokeReach::add_part_of(std::uint32_t triangle) {
  const std::uint32_t whole = whole_[triangle];
  before_.push_back(newest_[whole]);
  newest_[whole] = static_cast<std::uint32_t>(whole_.size());
  whole_.push_back(whole);
}

std::vector<std::uint32_t> StrokeReach::parts_of(const std::vector<std::uint32_t>& wholes) const {
  std::vector<std::uint32_t> parts;
  for (const std::uint32_t whole : wholes)
    for (std::uint32_t t = newest_[whole]; t != none; t = before_[t]) parts.push_back(t);
  std::sort(parts.begin(), parts.end());
  return parts;
}

std::vector<std::uint32_t> StrokeReach::near(const FlatStretch& stretch, double margin) const {
  return parts_of(grid_.near(stretch.from, stretch.to, margin));
}

std::vector<std::uint32_t> StrokeReach::neighbours(const std::vector<std::uint32_t>& triangles) const {
  std::vector<std::uint32_t> wholes, around;
  for (const std::uint32_t t : triangles) wholes.push_back(whole_[t]);
  sort_once(wholes);
  for (const std::uint32_t whole : wholes)
    for (const std::uint32_t p : corner_[whole])
      around.insert(around.end(), at_point_.begin() + point_begin_[p], at_point_.begin() + point_begin_[p + 1]);
  sort_once(around);
  return parts_of(around);
}

}  // namespace pomona
