#include "generator/cut/face_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/cut/regions.h"
#include "generator/cut/size_field.h"

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

std::span<const EdgeUse> FaceMesh::uses(std::uint32_t p, std::uint32_t q) const {
  const auto less = [](const EdgeUse& a, const EdgeUse& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; };
  const EdgeUse key{std::min(p, q), std::max(p, q), 0, false};
  const auto range = std::equal_range(edges.begin(), edges.end(), key, less);
  return {range.first, range.second};
}

namespace {

/// Triangulates one plane step by step.
class FaceBuilder {
 public:
  FaceBuilder(SplitMesh& mesh, const CutPlanes& planes, int plane, std::vector<Segment> segments)
      : mesh_(mesh), planes_(planes) {
    face_.plane = plane;
    face_.frame = frame_of(planes[plane].plane);
    face_.segment = std::move(segments);
    take_segments();
    surround();
    triangulation_ = std::make_unique<PlaneTriangulation>(uv_, constraint_);
  }

  void conform(double shortest) { triangulation_->conform(shortest); }

  /// Points spread inside the section, finer near cut segments.
  void sample(const SizeLimits& limits, const DiffusionSurfaces& surfaces, const Bodies& bodies) {
    update();
    std::vector<SizeSource> sources;
    for (const std::vector<std::uint32_t>& chain : face_.mesh.chain) {
      for (std::size_t i = 1; i < chain.size(); ++i) {
        sources.push_back({face_.mesh.point[chain[i - 1]], face_.mesh.point[chain[i]]});
      }
    }
    const std::vector<glm::dvec2> candidates = SizeField(sources, limits).samples();
    const Regions regions = find_regions(face_, mesh_, planes_, surfaces, bodies);
    const std::vector<std::int32_t> triangle = triangulation_->locate(candidates);
    std::vector<glm::dvec2> chosen;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (triangle[i] >= 0 && regions.is_section(static_cast<std::size_t>(triangle[i])))
        chosen.push_back(candidates[i]);
    }
    triangulation_->insert(chosen);
  }

  /// Takes over the triangulation's present state; its new points become points of the split mesh.
  void update() {
    face_.mesh = triangulation_->state();
    for (std::size_t v = face_.point.size(); v < face_.mesh.point.size(); ++v) {
      face_.point.push_back(static_cast<std::uint32_t>(mesh_.point.size()));
      mesh_.point.push_back(lifted(face_.mesh.point[v]));
      mesh_.planes_of.push_back(mesh_.sets.with(0, face_.plane));
    }
    face_.edges.clear();
    for (std::size_t c = 0; c < constraint_.size(); ++c) list_uses(c);
    std::sort(face_.edges.begin(), face_.edges.end(), [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
    });
  }

  FaceMesh finish(FaceMeshes& all) {
    update();
    for (std::size_t c = 0; c < constraint_.size(); ++c) list_edge_points(c, all.edge_point);
    return std::move(face_);
  }

 private:
  void take_segments() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> constraint_of;
    std::map<std::uint32_t, std::uint32_t> vertex_of;
    const auto vertex = [&](std::uint32_t point) {
      const auto [entry, is_new] = vertex_of.try_emplace(point, static_cast<std::uint32_t>(uv_.size()));
      if (is_new) {
        uv_.push_back(to_face(face_.frame, mesh_.point[point]));
        face_.point.push_back(point);
      }
      return entry->second;
    };
    for (std::uint32_t s = 0; s < face_.segment.size(); ++s) {
      const std::uint32_t low = std::min(face_.segment[s].from, face_.segment[s].to);
      const std::uint32_t high = std::max(face_.segment[s].from, face_.segment[s].to);
      const auto [entry, is_new] =
          constraint_of.try_emplace({low, high}, static_cast<std::uint32_t>(constraint_.size()));
      if (is_new) {
        const std::uint32_t a = vertex(low), b = vertex(high);
        constraint_.push_back({a, b, true});
        segments_of_.emplace_back();
      }
      segments_of_[entry->second].push_back(s);
    }
  }

  /// Four points far outside, so that no constraint lies on the hull.
  void surround() {
    glm::dvec2 low(0), high(0);
    for (std::size_t i = 0; i < uv_.size(); ++i) {
      low = i == 0 ? uv_[i] : glm::min(low, uv_[i]);
      high = i == 0 ? uv_[i] : glm::max(high, uv_[i]);
    }
    const glm::dvec2 center = 0.5 * (low + high);
    const double reach = 2 * std::max(high.x - low.x, high.y - low.y) + 1e-6;
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
      uv_.push_back(center + reach * corner);
      face_.point.push_back(static_cast<std::uint32_t>(mesh_.point.size()));
      mesh_.point.push_back(from_face(face_.frame, uv_.back()));
      mesh_.planes_of.push_back(mesh_.sets.with(0, face_.plane));
    }
  }

  glm::dvec3 lifted(const glm::dvec2& uv) const {
    glm::dvec3 p = from_face(face_.frame, uv);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fabs(face_.frame.normal[axis]) == 1) p[axis] = face_.frame.origin[axis];
    }
    return p;
  }

  void list_uses(std::size_t constraint) {
    const std::vector<std::uint32_t>& chain = face_.mesh.chain[constraint];
    for (const std::uint32_t s : segments_of_[constraint]) {
      const bool forward = face_.segment[s].from < face_.segment[s].to;  // chains run from the low to the high point
      for (std::size_t i = 1; i < chain.size(); ++i) {
        const std::uint32_t p = chain[i - 1], q = chain[i];
        face_.edges.push_back({std::min(p, q), std::max(p, q), s, forward == (p < q)});
      }
    }
  }

  void list_edge_points(std::size_t constraint, std::vector<EdgePoint>& edge_points) const {
    const std::vector<std::uint32_t>& chain = face_.mesh.chain[constraint];
    const std::uint32_t low = face_.point[constraint_[constraint].a], high = face_.point[constraint_[constraint].b];
    const double length = glm::distance(mesh_.point[low], mesh_.point[high]);
    double share = 0;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const std::uint32_t point = face_.point[chain[i]];
      const double measured = glm::distance(mesh_.point[low], mesh_.point[point]) / length;
      share = std::max(measured, std::nextafter(share, 2.0));  // the order along the chain, whatever rounding says
      edge_points.push_back({low, high, share, point});
    }
  }

  SplitMesh& mesh_;
  const CutPlanes& planes_;
  FaceMesh face_;
  std::vector<glm::dvec2> uv_;
  std::vector<PlaneConstraint> constraint_;
  std::vector<std::vector<std::uint32_t>> segments_of_;  // per constraint
  std::unique_ptr<PlaneTriangulation> triangulation_;
};

/// Pairs of points that are one place in a plane's triangulation.
std::vector<std::pair<std::uint32_t, std::uint32_t>> twins_in(const FaceMesh& face) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t v = 0; v < face.mesh.stand_in.size(); ++v) {
    if (face.mesh.stand_in[v] != v) pairs.emplace_back(face.point[face.mesh.stand_in[v]], face.point[v]);
  }
  return pairs;
}

/// For each of `count` points the first of those it shares its place with.
std::vector<std::uint32_t> first_twins(std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs) {
  std::vector<std::uint32_t> parent(count);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t p) {
    while (parent[p] != p) p = parent[p] = parent[parent[p]];
    return p;
  };
  for (const auto& [a, b] : pairs) {
    const std::uint32_t ra = root(a), rb = root(b);
    parent[std::max(ra, rb)] = std::min(ra, rb);
  }
  for (std::uint32_t p = 0; p < count; ++p) parent[p] = root(p);
  return parent;
}

}  // namespace

FaceMeshes triangulate(SplitMesh& mesh, const CutPlanes& planes, std::vector<std::vector<Segment>> segments,
                       const DiffusionSurfaces& surfaces, const Bodies& bodies, const CutOptions& options) {
  FaceMeshes all;
  const double size = glm::length(bounds_of(surfaces).size());
  const SizeLimits limits{options.coarsest * size, options.finest * size, options.grading};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> twins;
  for (int plane = 0; plane < planes.count(); ++plane) {
    std::vector<Segment>& own = segments[static_cast<std::size_t>(plane)];
    if (own.empty()) continue;
    FaceBuilder builder(mesh, planes, plane, std::move(own));
    builder.conform(0.25 * limits.finest);
    builder.sample(limits, surfaces, bodies);
    builder.conform(0.25 * limits.finest);
    all.faces.push_back(builder.finish(all));
    const auto more = twins_in(all.faces.back());
    twins.insert(twins.end(), more.begin(), more.end());
  }
  std::sort(all.edge_point.begin(), all.edge_point.end());
  all.same_as = first_twins(mesh.point.size(), std::move(twins));
  return all;
}

}  // namespace pomona
