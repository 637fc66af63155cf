#include "generator/cut/carve/carve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/cut/carve/fineness.h"
#include "generator/cut/carve/knife_charts.h"
#include "generator/cut/carve/knife_face.h"
#include "generator/cut/carve/knife_regions.h"
#include "generator/cut/carve/labels.h"
#include "generator/cut/carve/part_windings.h"
#include "generator/cut/carve/split_surfaces.h"
#include "generator/mesh/crossings/intersections.h"
#include "generator/mesh/triangle_tree.h"

namespace pomona {

namespace {

Box<double> box_of(const KnifeMesh& knife) {
  Box<double> box;
  for (const KnifeMesh::Triangle& t : knife.triangle) {
    for (const std::uint32_t p : t.corner) box.add(knife.point[p]);
  }
  return box;
}

Box<double> box_of(const PlaceTriangle& t, const std::vector<glm::dvec3>& point) {
  Box<double> box;
  for (const std::uint32_t p : t) box.add(point[p]);
  return box;
}

PlaceTriangle places_of(const SurfaceTriangle& t, const SplitMesh& mesh) {
  return {mesh.point_of[t.vertex[0]], mesh.point_of[t.vertex[1]], mesh.point_of[t.vertex[2]]};
}

/// Arranges the fruit with the knife, splits it, and finds the face between.
class Carver {
 public:
  Carver(CutFruit fruit, const ClosedKnife& knife, const DiffusionSurfaces& surfaces, const Bodies& bodies)
      : fruit_(std::move(fruit)), knife_(knife), surfaces_(surfaces), bodies_(bodies) {}

  Cutting run() {
    take_triangles();
    take_places();
    const Arrangement all = arranged(fruit_triangle_, knife_triangle_, places_);
    Boundaries boundaries = boundaries_of(all);
    take_new_points(all);
    const std::vector<std::vector<int>> winding = windings_of_knife(all, places_);
    SplitFruit split =
        split_surfaces(std::move(fruit_), {all, winding, surface_, cap_, knife_.stride}, surfaces_, bodies_);

    // The knife's own surface, and what of the fruit lies on it.
    Face face = knife_face(all, knife_, split.traces, split.fruit.mesh);
    PartWindings windings(all, places_, face, std::move(boundaries));
    Regions regions = knife_regions(face, split.traces, knife_.stride, surfaces_, bodies_,
                                    [&](std::uint32_t triangle) { return windings.near(triangle); });
    face = charted(std::move(face), regions, knife_.number);

    Cutting cutting{std::move(split.fruit), {}, {}, std::move(split.traces.shared)};
    cutting.faces.push_back(std::move(face));
    cutting.regions.push_back(std::move(regions));
    return cutting;
  }

 private:
  /// Takes the triangles near the knife.
  void take_triangles() {
    const Box<double> box = box_of(knife_.mesh);
    const std::vector<glm::dvec3>& point = fruit_.mesh.point;
    const auto take = [&](const PlaceTriangle& t, std::uint32_t number, std::vector<std::uint32_t>& numbers) {
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || !box_of(t, point).meets(box)) return;
      fruit_triangle_.push_back(t);
      numbers.push_back(number);
    };
    for (std::uint32_t t = 0; t < fruit_.surface.size(); ++t)
      take(places_of(fruit_.surface[t], fruit_.mesh), t, surface_);
    for (std::uint32_t t = 0; t < fruit_.section.cap.size(); ++t) take(fruit_.section.cap[t].point, t, cap_);
  }

  void take_places() {
    std::vector<std::uint8_t> known(fruit_.mesh.point.size(), 0);
    for (const PlaceTriangle& t : fruit_triangle_) {
      for (const std::uint32_t p : t) known[p] = 1;
    }
    for (std::size_t p = 0; p < known.size(); ++p) places_.append(fruit_.mesh.point[p], known[p] != 0);
    std::vector<std::uint32_t> place;
    for (const glm::dvec3& p : knife_.mesh.point) place.push_back(places_.number_of(p));
    for (const KnifeMesh::Triangle& t : knife_.mesh.triangle) {
      knife_triangle_.push_back({place[t.corner[0]], place[t.corner[1]], place[t.corner[2]]});
    }
  }

  /// The boundaries of bodies along the arrangement, before the fruit is split.
  Boundaries boundaries_of(const Arrangement& all) const {
    Boundaries boundaries;
    boundaries.boundary_of_facet.resize(all.fruit_count);
    const auto add = [&](const PlaceTriangle& t, std::vector<CellBoundary> boundary) {
      const std::vector<glm::dvec3>& p = fruit_.mesh.point;
      boundaries.triangle.push_back({p[t[0]], p[t[1]], p[t[2]]});
      boundaries.boundary.push_back(std::move(boundary));
    };
    for (const SurfaceTriangle& t : fruit_.surface) {
      if (surfaces_.is_boundary(t.source)) add(places_of(t, fruit_.mesh), boundary_of(t, bodies_));
    }
    for (const Cap& cap : fruit_.section.cap) add(cap.point, boundary_of(cap));
    for (std::size_t i = 0; i < surface_.size(); ++i) {
      const SurfaceTriangle& t = fruit_.surface[surface_[i]];
      if (surfaces_.is_boundary(t.source)) boundaries.boundary_of_facet[i] = boundary_of(t, bodies_);
    }
    for (std::size_t i = 0; i < cap_.size(); ++i) {
      boundaries.boundary_of_facet[surface_.size() + i] = boundary_of(fruit_.section.cap[cap_[i]]);
    }
    return boundaries;
  }

  /// Takes the new points. All points on the knife count as lying on one more plane.
  void take_new_points(const Arrangement& all) {
    SplitMesh& mesh = fruit_.mesh;
    const int plane = knife_.plane;
    for (std::size_t p = mesh.point.size(); p < places_.count(); ++p) {
      mesh.add_point(places_.at(static_cast<std::uint32_t>(p)), mesh.sets.with(0, plane));
    }
    const auto mark = [&](std::uint32_t p) { mesh.planes_of[p] = mesh.sets.with(mesh.planes_of[p], plane); };
    for (const Arrangement::Segment& s : all.segment) {
      mark(s.from);
      mark(s.to);
      for (const std::uint32_t p : s.places) mark(p);
    }
  }

  CutFruit fruit_;
  const ClosedKnife& knife_;
  const DiffusionSurfaces& surfaces_;
  const Bodies& bodies_;
  ExactPoints places_;
  std::vector<PlaceTriangle> fruit_triangle_, knife_triangle_;
  std::vector<std::uint32_t> surface_, cap_;  // which of the fruit's triangles take part
};

}  // namespace

Cutting carve(CutFruit fruit, const ClosedKnife& knife, const DiffusionSurfaces& surfaces, const Bodies& bodies) {
  if (knife.mesh.triangle.empty()) return {std::move(fruit), {}, {}, {}};
  return Carver(std::move(fruit), knife, surfaces, bodies).run();
}

KnifeMesh refined_for(const CutFruit& fruit, KnifeMesh knife, const SizeLimits& limits) {
  // Find where the unrefined knife meets the surfaces, and how fine these are there.
  const Box<double> box = box_of(knife);
  Box<double> whole;
  std::vector<Corners> surface, own;
  for (const SurfaceTriangle& t : fruit.surface) {
    const PlaceTriangle p = places_of(t, fruit.mesh);
    for (const std::uint32_t place : p) whole.add(fruit.mesh.point[place]);
    if (!box_of(p, fruit.mesh.point).meets(box)) continue;
    surface.push_back({fruit.mesh.point[p[0]], fruit.mesh.point[p[1]], fruit.mesh.point[p[2]]});
  }
  for (std::size_t t = 0; t < knife.triangle.size(); ++t) own.push_back(knife.corners(t));
  std::vector<FinenessSource> sources;
  std::uint32_t last = 0;  // one more than the triangle of the latest source
  for (const Intersection& m : intersections(surface, own)) {
    if (m.fruit + 1 == last) continue;
    last = m.fruit + 1;
    const Corners& s = surface[m.fruit];
    const double length = (glm::distance(s[0], s[1]) + glm::distance(s[1], s[2]) + glm::distance(s[2], s[0])) / 3;
    sources.push_back({(s[0] + s[1] + s[2]) / 3.0, std::clamp(length, limits.finest, limits.coarsest)});
  }
  const Fineness fineness(std::move(sources), limits.grading);
  return refined(std::move(knife), [&](const glm::dvec3& p) {
    const glm::dvec3 outside = glm::max(glm::max(whole.low - p, p - whole.high), glm::dvec3(0));
    return fineness.at(p, limits.coarsest + glm::length(outside));
  });
}

}  // namespace pomona
