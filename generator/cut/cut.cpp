#include "generator/cut/cut.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "generator/cut/carve/carve.h"
#include "generator/cut/pieces.h"
#include "generator/cut/section/section.h"
#include "generator/knife/solid_knives.h"
#include "generator/mesh/welded_edges.h"

namespace pomona {

namespace {

void warn_of_misses(std::span<const Knife> knives, const CutPlanes& planes, const CrossSection& section,
                    std::vector<std::string>& warnings) {
  for (std::size_t k = 0; k < knives.size(); ++k) {
    const auto cuts = [&](const CutFace& face) { return face.knife == static_cast<int>(k); };
    const auto repeats = [&](const CutPlanes::Plane& p) {
      return p.knife == static_cast<int>(k) && planes[p.same_as].knife != p.knife;
    };
    if (std::any_of(section.faces.begin(), section.faces.end(), cuts)) continue;
    if (std::any_of(planes.planes.begin(), planes.planes.end(), repeats)) continue;
    warnings.push_back("knife \"" + knives[k].text + "\" misses the fruit");
  }
}

/// Stage by stage: planes and strokes all at once, then closed knives one after another on what those have left.
class Cutter {
 public:
  Cutter(const DiffusionSurfaces& surfaces, std::span<const Knife> knives, const CutOptions& options)
      : surfaces_(surfaces), knives_(knives), options_(options), planes_(placed(knives, bounds_of(surfaces))) {}

  Cut run() {
    CutFruit fruit = cut_by_planes();
    cut_by_solids(fruit);
    leave_out_collapsed(fruit.section);
    Cut result;
    result.pieces = pieces(fruit.mesh, fruit.surface, fruit.section, surfaces_, options_);
    result.warnings = bodies_.warnings;
    warn_of_misses(knives_, planes_, fruit.section.mesh, result.warnings);
    result.section = std::move(fruit.section.mesh);
    return result;
  }

 private:
  CutFruit cut_by_planes() {
    SplitMesh mesh(planes_);
    parallel_for(2, options_.threads, [&](std::size_t i) {
      if (i == 0)
        bodies_ = find_bodies(surfaces_);
      else
        mesh = split(surfaces_, planes_);
    });
    const FaceMeshes faces =
        triangulate(mesh, planes_, cut_segments(mesh, surfaces_, planes_.count()), surfaces_, bodies_, options_);
    std::vector<Regions> regions(faces.faces.size());
    parallel_for(regions.size(), options_.threads,
                 [&](std::size_t f) { regions[f] = find_regions(faces.faces[f], planes_, surfaces_, bodies_); });
    Section section = assemble_all(faces, regions, mesh, surfaces_, options_.threads);
    std::vector<SkinTriangle> surface =
        has_solids() ? clipped_surfaces(mesh, faces, surfaces_) : clipped_skin(mesh, faces, surfaces_);
    return {std::move(mesh), std::move(surface), std::move(section)};
  }

  bool has_solids() const {
    return std::any_of(knives_.begin(), knives_.end(), [](const Knife& knife) { return knife.is_solid(); });
  }

  void cut_by_solids(CutFruit& fruit) const {
    if (!has_solids()) return;
    const double size = glm::length(bounds_of(surfaces_).size());
    const SizeLimits limits{options_.coarsest * size, options_.finest * size, options_.grading, options_.contrast};
    for (std::size_t k = 0; k < knives_.size(); ++k) {
      if (!knives_[k].is_solid()) continue;
      join_points(fruit);
      ClosedKnife knife;
      knife.mesh = refined_for(fruit, knife_mesh(knife_solid(knives_[k], surfaces_), knives_[k].text), limits);
      knife.number = static_cast<int>(k);
      knife.plane = planes_.count() + knife.number;
      for (std::size_t later = k + 1; later < knives_.size(); ++later) {
        knife.stride *= static_cast<std::uint32_t>(planes_.knives[later].cell_count());
      }
      carve(fruit, knife, surfaces_, bodies_);
    }
  }

  /// Points at one place to the bit become one.
  static void join_points(CutFruit& fruit) {
    const std::vector<std::uint32_t> first = weld(fruit.mesh.point);
    for (std::uint32_t p = 0; p < first.size(); ++p) {
      fruit.mesh.planes_of[first[p]] = std::max(fruit.mesh.planes_of[first[p]], fruit.mesh.planes_of[p]);
    }
    for (std::uint32_t& p : fruit.mesh.point_of) p = first[p];
    for (Cap& cap : fruit.section.cap) {
      for (std::uint32_t& p : cap.point) p = first[p];
    }
  }

  const DiffusionSurfaces& surfaces_;
  std::span<const Knife> knives_;
  const CutOptions& options_;
  const CutPlanes planes_;
  Bodies bodies_;
};

}  // namespace

Cut cut(const DiffusionSurfaces& surfaces, std::span<const Knife> knives, const CutOptions& options) {
  return Cutter(surfaces, knives, options).run();
}

}  // namespace pomona
