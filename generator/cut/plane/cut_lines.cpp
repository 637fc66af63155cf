#include "generator/cut/plane/cut_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Planes whose normals differ by less than this angle (radians) are taken as parallel.
constexpr double parallel = 1e-9;

void sort_along(CutLine& line, const SplitMesh& mesh) {
  const auto along = [&](std::uint32_t p) { return glm::dot(line.direction, mesh.point[p] - line.origin); };
  std::sort(line.points.begin(), line.points.end(),
            [&](std::uint32_t a, std::uint32_t b) { return along(a) != along(b) ? along(a) < along(b) : a < b; });
  line.points.erase(std::unique(line.points.begin(), line.points.end()), line.points.end());
}

/// The planes that all its points lie on, as a set of the mesh's.
std::uint32_t set_of(const CutLine& line, SplitMesh& mesh) {
  return mesh.sets.with(mesh.sets.with(0, line.planes[0]), line.planes[1]);
}

/// Finds the lines of all pairs of planes.
class CutLineFinder {
 public:
  CutLineFinder(SplitMesh mesh, const CutPlanes& planes, const std::vector<std::vector<CutSegment>>& segments,
                const Box<double>& bounds)
      : mesh_(std::move(mesh)), planes_(planes), center_(bounds.center()), reach_(0.5 * glm::length(bounds.size())) {
    for (int k = 0; k < planes.count(); ++k) {
      if (!segments[static_cast<std::size_t>(k)].empty()) used_.push_back(k);
    }
  }

  CutLines find() {
    find_lines();
    take_points();
    for (CutLine& line : lines_) add_intersections(line);
    for (CutLine& line : lines_) put_in_order(line);
    std::erase_if(lines_, [](const CutLine& line) { return line.points.size() < 2; });
    return {std::move(mesh_), std::move(lines_)};
  }

 private:
  void find_lines() {
    bool has_axis = false;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      for (std::size_t j = i + 1; j < used_.size(); ++j) {
        const int a = used_[i], b = used_[j];
        if (planes_[a].through_axis && planes_[b].through_axis) {
          if (!has_axis) add_axis();
          has_axis = true;
        } else if (planes_[a].blade != planes_[b].blade || b == a + 1) {
          add_line(a, b);
        }
      }
    }
  }

  void add_axis() {
    CutLine axis;
    for (const int k : used_) {
      if (planes_[k].through_axis) axis.planes.push_back(k);
    }
    axis.origin = {0, center_.y, 0};
    if (glm::distance(axis.origin, center_) < reach_) lines_.push_back(axis);
  }

  /// Adds the line of two planes. Its origin is its nearest point to the fruit's middle.
  void add_line(int a, int b) {
    const CuttingPlane &p = planes_[a].plane, &q = planes_[b].plane;
    const glm::dvec3 across = glm::cross(p.normal, q.normal);
    const double square = glm::dot(across, across);
    if (square < parallel * parallel) return;
    const double dp = p.offset - glm::dot(p.normal, center_), dq = q.offset - glm::dot(q.normal, center_);
    const glm::dvec3 foot = (dp * glm::cross(q.normal, across) + dq * glm::cross(across, p.normal)) / square;
    if (glm::length(foot) >= reach_) return;
    CutLine line;
    line.planes = {a, b};
    line.origin = center_ + foot;
    line.direction = across / std::sqrt(square);
    if (planes_[a].blade == planes_[b].blade || (clip(line, a) && clip(line, b))) lines_.push_back(line);
  }

  /// Shortens the line to where the plane is a facet; false if nothing of it is left.
  bool clip(CutLine& line, int plane) const {
    const Stroke::Facet* facet = planes_.facet(plane);
    if (facet == nullptr) return true;
    const double slope = glm::dot(glm::dvec2(line.direction), facet->direction);
    const double at_origin = facet->along_of(glm::dvec2(line.origin));
    if (std::fabs(slope) < parallel) return planes_.is_in_facet(plane, line.origin);
    const double from = (facet->from - at_origin) / slope, to = (facet->to - at_origin) / slope;
    line.low = std::max(line.low, std::min(from, to));
    line.high = std::min(line.high, std::max(from, to));
    return line.low < line.high && line.low < reach_ && line.high > -reach_;
  }

  /// True if the place lies, up to rounding, where both facets have the line in common.
  bool is_within(const CutLine& line, const glm::dvec3& place) const {
    const double along = glm::dot(line.direction, place - line.origin);
    return along >= line.low - planes_.tolerance && along <= line.high + planes_.tolerance;
  }

  /// Takes the points that lie on all planes of a line.
  void take_points() {
    std::map<std::uint32_t, std::vector<std::size_t>> lines_of_set;
    for (std::uint32_t p = 0; p < mesh_.point.size(); ++p) {
      const std::uint32_t set = mesh_.planes_of[p];
      if (mesh_.sets.planes_in(set).size() < 2) continue;
      const auto [entry, is_new] = lines_of_set.try_emplace(set);
      if (is_new) entry->second = lines_with(set);
      for (const std::size_t line : entry->second) {
        if (is_within(lines_[line], mesh_.point[p])) lines_[line].points.push_back(p);
      }
    }
  }

  std::vector<std::size_t> lines_with(std::uint32_t set) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (mesh_.sets.has(set, lines_[i].planes[0]) && mesh_.sets.has(set, lines_[i].planes[1])) found.push_back(i);
    }
    return found;
  }

  /// Adds the points where further planes pass through the line; each is made once for all lines that meet there.
  void add_intersections(CutLine& line) {
    for (const int k : used_) {
      if (std::find(line.planes.begin(), line.planes.end(), k) != line.planes.end()) continue;
      if (!may_meet(line, k)) continue;
      const CuttingPlane& plane = planes_[k].plane;
      const double slope = glm::dot(plane.normal, line.direction);
      if (std::fabs(slope) < parallel) continue;
      const glm::dvec3 place = line.origin - line.direction * (signed_distance(plane, line.origin) / slope);
      if (glm::distance(place, center_) > reach_) continue;
      if (!is_within(line, place) || !planes_.is_in_facet(k, place)) continue;

      const std::uint32_t set = mesh_.sets.with(mesh_.sets.with(mesh_.sets.with(0, line.planes[0]), line.planes[1]), k);
      const auto [entry, is_new] = intersection_.try_emplace(set, static_cast<std::uint32_t>(mesh_.point.size()));
      if (is_new) {
        mesh_.add_point(snapped_to_planes(place, mesh_.sets.planes_in(set), planes_), set);
      }
      line.points.push_back(entry->second);
    }
  }

  /// Whether the plane may meet the line: of a stroke's facets only neighbours do.
  bool may_meet(const CutLine& line, int plane) const {
    return std::all_of(line.planes.begin(), line.planes.end(),
                       [&](int k) { return planes_[k].blade != planes_[plane].blade || std::abs(k - plane) == 1; });
  }

  void put_in_order(CutLine& line) {
    sort_along(line, mesh_);
    if (line.begins_outside()) line.points.insert(line.points.begin(), far_end(line, -1));
    if (line.ends_outside()) line.points.push_back(far_end(line, 1));
  }

  std::uint32_t far_end(const CutLine& line, double sense) {
    return mesh_.add_point(line.origin + line.direction * (sense * 1.5 * reach_), set_of(line, mesh_));
  }

  SplitMesh mesh_;
  const CutPlanes& planes_;
  glm::dvec3 center_;
  double reach_;           // radius of a ball that holds the fruit
  std::vector<int> used_;  // planes that cut anything
  std::vector<CutLine> lines_;
  std::map<std::uint32_t, std::uint32_t> intersection_;  // set of planes -> point
};

/// Halves stretches that are too long; further ones wait on a stack.
std::vector<std::uint32_t> subdivided_points(const CutLine& line, SplitMesh& mesh, const CutPlanes& planes,
                                             const SizeOnPlane& size) {
  std::vector<std::uint32_t> done{line.points.front()}, waiting(line.points.rbegin(), line.points.rend() - 1);
  while (!waiting.empty()) {
    const glm::dvec3 a = mesh.point[done.back()], b = mesh.point[waiting.back()];
    const glm::dvec3 middle = 0.5 * (a + b);
    double longest = size(line.planes[0], middle);
    for (const int k : line.planes) longest = std::min(longest, size(k, middle));
    const bool outside = (done.size() == 1 && line.begins_outside()) || (waiting.size() == 1 && line.ends_outside());
    if (!outside && glm::distance(a, b) > 1.2 * longest) {
      const std::uint32_t set = set_of(line, mesh);
      waiting.push_back(mesh.add_point(snapped_to_planes(middle, mesh.sets.planes_in(set), planes), set));
    } else {
      done.push_back(waiting.back());
      waiting.pop_back();
    }
  }
  return done;
}

}  // namespace

CutLines cut_lines(SplitMesh mesh, const CutPlanes& planes, const std::vector<std::vector<CutSegment>>& segments,
                   const Box<double>& bounds) {
  return CutLineFinder(std::move(mesh), planes, segments, bounds).find();
}

CutLines subdivided(CutLines all, const CutPlanes& planes, const SizeOnPlane& size) {
  for (CutLine& line : all.lines) line.points = subdivided_points(line, all.mesh, planes, size);
  return all;
}

CutLines with_points(CutLines all, const Unshared& points) {
  SplitMesh& mesh = all.mesh;
  for (const auto& [number, on_line] : points) {
    CutLine& line = all.lines[number];
    for (const std::uint32_t p : on_line) {
      mesh.planes_of[p] = mesh.sets.with(mesh.sets.with(mesh.planes_of[p], line.planes[0]), line.planes[1]);
      line.points.push_back(p);
    }
    sort_along(line, mesh);
  }
  return all;
}

std::vector<std::uint32_t> points_between(const CutLine& line, std::uint32_t from, std::uint32_t to) {
  auto a = std::find(line.points.begin(), line.points.end(), from);
  auto b = std::find(line.points.begin(), line.points.end(), to);
  if (a == line.points.end() || b == line.points.end() || a == b) return {};
  if (a < b) return {a + 1, b};
  std::vector<std::uint32_t> between(b + 1, a);
  std::reverse(between.begin(), between.end());
  return between;
}

}  // namespace pomona
