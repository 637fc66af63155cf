#include "generator/cut/cut.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/base/stop_watch.h"
#include "generator/cut/carve/carve.h"
#include "generator/cut/cut_observer.h"
#include "generator/cut/pieces.h"
#include "generator/cut/plane/clipped_surfaces.h"
#include "generator/cut/plane/plane_regions.h"
#include "generator/cut/plane/split.h"
#include "generator/cut/plane/triangulate.h"
#include "generator/cut/section/cut_fruit.h"
#include "generator/cut/spared.h"
#include "generator/cut/unite/united_bodies.h"
#include "generator/knife/closed_knives.h"
#include "generator/knife/knife_mesh.h"
#include "generator/mesh/closed_surface.h"
#include "generator/mesh/triangle_tree.h"
#include "generator/mesh/weld.h"
#include "generator/surface/bodies.h"
#include "generator/surface/outer_bodies.h"
#include "generator/surface/skin_depth.h"

namespace pomona {

namespace {

/// A fruit without the bodies that the knife does not cut, and these bodies.
struct HeldBack {
  CutFruit fruit;                         ///< without these bodies
  std::vector<SurfaceTriangle> triangle;  ///< of these bodies, in the cells to which they go
};

constexpr std::uint32_t unset = 0xffffffffu;

/// What corers push aside.
struct PushedAside {
  SkinDepth depth;  ///< of the fruit as it grew
  OuterBodies outer;
  std::vector<std::int32_t> body;  ///< per outer body: its number among the bodies

  std::int32_t number_of(std::int32_t of) const {
    const auto at = std::find(body.begin(), body.end(), of);
    return of == Bodies::none || at == body.end() ? OuterBodies::none : static_cast<std::int32_t>(at - body.begin());
  }
};

/// What corers push aside; nothing if no knife is a corer, or the skin is open.
std::optional<PushedAside> pushed_aside(const DiffusionSurfaces& surfaces, const Bodies& bodies,
                                        std::span<const Knife> knives) {
  const bool cores = std::any_of(knives.begin(), knives.end(), [](const Knife& knife) {
    return knife.is_closed() && std::holds_alternative<CoreKnife>(std::get<ClosedCut>(knife.cut));
  });
  if (!cores) return std::nullopt;
  SkinDepth depth(surfaces);
  if (!depth.is_closed()) return std::nullopt;
  OuterBodies outer = outer_bodies(surfaces, depth.skin());
  std::vector<std::int32_t> body(outer.body.size(), Bodies::none);
  for (std::size_t t = 0; t < outer.of_triangle.size(); ++t) {
    if (outer.of_triangle[t] != OuterBodies::none)
      body[static_cast<std::size_t>(outer.of_triangle[t])] = bodies.of_triangle[t];
  }
  return PushedAside{std::move(depth), std::move(outer), std::move(body)};
}

/// For each outer body, whether it lies in one cell and no cut face goes through it.
std::vector<std::uint8_t> whole_ones(const CutFruit& fruit, const PushedAside& aside, const Bodies& bodies) {
  const std::vector<std::int32_t>& body_of = aside.body;
  std::vector<std::uint8_t> whole(body_of.size(), 1);
  std::vector<std::uint32_t> cell(body_of.size(), unset);
  for (const SurfaceTriangle& t : fruit.surface) {
    const std::int32_t outer = aside.number_of(bodies.of_triangle[t.source]);
    if (outer == OuterBodies::none) continue;
    const auto number = static_cast<std::size_t>(outer);
    if (cell[number] != unset && cell[number] != t.cell) whole[number] = 0;
    cell[number] = t.cell;
  }
  for (const Cap& cap : fruit.section.cap) {
    for (const BodyWinding& inside : cap.closing.inside) {
      for (std::size_t b = 0; b < body_of.size(); ++b)
        if (body_of[b] == inside.body) whole[b] = 0;
    }
  }
  return whole;
}

/// True if most of the body goes inside the knife: of its part within the skin, or of all of it if there is none.
bool goes_inside(const TriangleTree& body, const TriangleTree& skin, const TriangleTree& knife) {
  double sunk = 0, sunk_inside = 0, all = 0, all_inside = 0;
  for (const TriangleTree::Corners& t : body.triangles()) {
    const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    const double area = glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
    const double inside = knife.contains(middle) ? area : 0;
    all += area, all_inside += inside;
    if (!skin.contains(middle)) continue;
    sunk += area, sunk_inside += inside;
  }
  return sunk > 0 ? sunk_inside > 0.5 * sunk : all_inside > 0.5 * all;
}

/// Takes out the bodies that stick out of the fruit, except those that other knives have cut. A body goes to the inside
/// or the outside of the knife, wherever the larger share of its part inside the fruit lies. \param stride the number
/// of a cell inside the knife is larger by this.
HeldBack held_back(CutFruit fruit, const ClosedSurface& knife, std::uint32_t stride, const PushedAside& aside,
                   const Bodies& bodies) {
  const std::vector<std::uint8_t> whole = whole_ones(fruit, aside, bodies);
  const std::vector<glm::vec3> points(knife.point.begin(), knife.point.end());
  const TriangleTree tree(points, knife.triangle);
  std::vector<std::uint8_t> inside;
  for (const TriangleTree& body : aside.outer.body)
    inside.push_back(goes_inside(body, aside.depth.skin(), tree) ? 1 : 0);

  HeldBack held{std::move(fruit), {}};
  std::vector<SurfaceTriangle> rest;
  for (SurfaceTriangle t : held.fruit.surface) {
    const std::int32_t number = aside.number_of(bodies.of_triangle[t.source]);
    if (number == OuterBodies::none || whole[static_cast<std::size_t>(number)] == 0) {
      rest.push_back(t);
      continue;
    }
    if (inside[static_cast<std::size_t>(number)] != 0) t.cell += stride;
    held.triangle.push_back(t);
  }
  held.fruit.surface = std::move(rest);
  return held;
}

/// Does the work and returns its result. Reports its time to the observer, if there is one.
template <typename Work>
auto watched(CutObserver* observer, std::string_view stage, Work&& work) {
  const StopWatch watch;
  auto result = std::forward<Work>(work)();
  if (observer) observer->took(stage, watch.milliseconds());
  return result;
}

/// Whether a surface has a point on one of the knife's planes.
bool meets_surfaces(int knife, const CutPlanes& planes, const SplitMesh& mesh) {
  for (std::size_t plane = 0; plane < planes.planes.size(); ++plane) {
    if (planes.planes[plane].knife != knife) continue;
    for (const std::uint32_t set : mesh.planes_of)
      if (mesh.sets.has(set, static_cast<int>(plane))) return true;
  }
  return false;
}

/// Knives that leave no cut face, and why.
std::vector<std::string> misses(std::span<const Knife> knives, const CutPlanes& planes, const CutFruit& fruit) {
  const CrossSection& section = fruit.section.mesh;
  std::vector<std::string> warnings;
  for (std::size_t k = 0; k < knives.size(); ++k) {
    const auto cuts = [&](const CutFace& face) { return face.knife == static_cast<int>(k); };
    const auto repeats = [&](const CutPlanes::Plane& p) {
      return p.knife == static_cast<int>(k) && planes[p.same_as].knife != p.knife;
    };
    if (std::any_of(section.faces.begin(), section.faces.end(), cuts)) continue;
    if (std::any_of(planes.planes.begin(), planes.planes.end(), repeats)) continue;
    const std::string name = "knife \"" + knives[k].text + "\" ";
    warnings.push_back(name + (meets_surfaces(static_cast<int>(k), planes, fruit.mesh)
                                   ? "leaves no cut face: the surfaces it meets hold no inside"
                                   : "cuts nothing: it misses the fruit, or holds all of it"));
  }
  return warnings;
}

/// The fruit with points of equal position joined.
CutFruit with_joined_points(CutFruit fruit) {
  SplitMesh& mesh = fruit.mesh;
  mesh.same_as = weld(mesh.point);
  const std::vector<std::uint32_t>& first = mesh.same_as;
  for (std::uint32_t p = 0; p < first.size(); ++p) {
    mesh.planes_of[first[p]] = std::max(mesh.planes_of[first[p]], mesh.planes_of[p]);
  }
  for (std::uint32_t& p : mesh.point_of) p = first[p];
  for (Cap& cap : fruit.section.cap) {
    for (std::uint32_t& p : cap.point) p = first[p];
  }
  return fruit;
}

/// The stages: planes and strokes all at once, then closed knives one after another.
class Cutter {
 public:
  Cutter(const DiffusionSurfaces& surfaces, std::span<const Knife> knives, const CutOptions& options,
         CutObserver* observer)
      : whole_(surfaces),
        knives_(knives),
        options_(options),
        observer_(observer),
        planes_(cut_planes(knives, bounds_of(surfaces))),
        known_(watched(observer, "bodies", [&] { return find_bodies(surfaces); })),
        aside_(pushed_aside(surfaces, known_, knives)),
        united_(watched(observer, "unite",
                        [&] {
                          return united_bodies(surfaces, known_,
                                               {.apart = aside_ ? std::span<const std::int32_t>(aside_->body)
                                                                : std::span<const std::int32_t>(),
                                                .threads = options.threads});
                        })),
        surfaces_(united_ ? united_->surfaces : whole_),
        bodies_(united_ ? united_->bodies : known_) {}

  Cut run() {
    CutFruit fruit = joined(cut_by_planes());
    for (std::size_t k = 0; k < knives_.size(); ++k) {
      if (knives_[k].is_closed()) fruit = joined(cut_by_closed_knife(std::move(fruit), k));
    }
    fruit.section = without_collapsed(std::move(fruit.section));

    Cut result;
    SparedFruit done = spared(std::move(fruit), surfaces_, options_.spared_parts);
    result.pieces = watched(observer_, "pieces", [&] { return pieces(done, surfaces_, options_); });
    result.warnings = known_.warnings;  // bodies that are united have none
    for (std::vector<std::string>& more : std::array{misses(knives_, planes_, done.fruit), done.warnings}) {
      for (std::string& warning : more) result.warnings.push_back(std::move(warning));
    }
    result.section = std::move(done.fruit.section.mesh);
    return result;
  }

 private:
  Cutting cut_by_planes() {
    // Split the surfaces where they pass through the planes (paper, Figure 3a).
    SplitMesh mesh = watched(observer_, "split", [&] { return split(surfaces_, planes_); });
    const auto segments =
        watched(observer_, "segments", [&] { return cut_segments(mesh, surfaces_, bodies_, planes_.count()); });
    if (observer_) observer_->sees(planes_, segments);

    // Triangulate the faces, and find which regions are section between which cells (Figure 3b).
    PlaneFaces made = watched(observer_, "triangulate", [&] {
      return triangulate(std::move(mesh), planes_, segments, surfaces_, bodies_, options_);
    });
    std::vector<Regions> regions = watched(observer_, "regions", [&] {
      std::vector<Regions> all(made.faces.size());
      parallel_for(all.size(), options_.threads,
                   [&](std::size_t f) { all[f] = plane_regions(made.faces[f], planes_, surfaces_, bodies_); });
      return all;
    });

    // Split the surfaces again, so that they meet the faces vertex to vertex.
    ClippedSurfaces clipped = watched(observer_, "clip", [&] {
      return clipped_surfaces(std::move(made.mesh), made.edge_point, surfaces_,
                              {.inner_too = has_closed_knives() || !options_.spared_parts.empty()});
    });
    return {{std::move(clipped.mesh), std::move(clipped.surface), empty_section(surfaces_)},
            std::move(made.faces),
            std::move(regions),
            {}};
  }

  bool has_closed_knives() const {
    return std::any_of(knives_.begin(), knives_.end(), [](const Knife& knife) { return knife.is_closed(); });
  }

  Cutting cut_by_closed_knife(CutFruit fruit, std::size_t number) const {
    const double size = glm::length(bounds_of(surfaces_).size());
    const SizeLimits limits{options_.coarsest * size, options_.finest * size, options_.grading, options_.contrast};
    return watched(observer_, "carve", [&] {
      fruit = with_joined_points(std::move(fruit));
      const Knife& shape = knives_[number];
      const ClosedCut& closed = std::get<ClosedCut>(shape.cut);
      const ClosedSurface surface = surface_of(closed, whole_);
      ClosedKnife knife;
      knife.number = static_cast<int>(number);
      knife.plane = planes_.count() + knife.number;
      for (std::size_t later = number + 1; later < knives_.size(); ++later) {
        knife.stride *= static_cast<std::uint32_t>(planes_.knives[later].cell_count());
      }
      // Hold back what a corer pushes aside.
      HeldBack held{std::move(fruit), {}};
      if (std::holds_alternative<CoreKnife>(closed) && aside_)
        held = held_back(std::move(held.fruit), surface, knife.stride, *aside_, bodies_);
      knife.mesh = refined_for(held.fruit, knife_mesh(surface, shape.text), limits);
      Cutting cutting = carve(std::move(held.fruit), knife, surfaces_, bodies_);
      std::vector<SurfaceTriangle>& all = cutting.fruit.surface;
      all.insert(all.end(), held.triangle.begin(), held.triangle.end());
      return cutting;
    });
  }

  /// The fruit after a cut, its faces joined to the section.
  CutFruit joined(Cutting cutting) const {
    if (observer_) observer_->sees(planes_, cutting);
    return watched(observer_, "assemble", [&] { return with_faces(std::move(cutting), surfaces_, options_.threads); });
  }

  const DiffusionSurfaces& whole_;  // as they grew
  std::span<const Knife> knives_;
  const CutOptions& options_;
  CutObserver* observer_;  // or none
  const CutPlanes planes_;
  const Bodies known_;  // of the whole
  const std::optional<PushedAside> aside_;
  const std::optional<UnitedBodies> united_;
  const DiffusionSurfaces& surfaces_;  // without overlaps
  const Bodies& bodies_;
};

}  // namespace

Cut cut(const DiffusionSurfaces& surfaces, std::span<const Knife> knives, const CutOptions& options,
        CutObserver* observer) {
  return Cutter(surfaces, knives, options, observer).run();
}

}  // namespace pomona
