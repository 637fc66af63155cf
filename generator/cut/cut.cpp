#include "generator/cut/cut.h"

#include <algorithm>

#include "generator/cut/pieces.h"
#include "generator/cut/section.h"

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

}  // namespace

Cut cut(const DiffusionSurfaces& surfaces, std::span<const Knife> knives, const CutOptions& options) {
  const CutPlanes planes = placed(knives, bounds_of(surfaces));
  Bodies bodies;
  SplitMesh mesh(planes);
  parallel_for(2, options.threads, [&](std::size_t i) {
    if (i == 0)
      bodies = find_bodies(surfaces);
    else
      mesh = split(surfaces, planes);
  });
  const FaceMeshes faces =
      triangulate(mesh, planes, cut_segments(mesh, surfaces, planes.count()), surfaces, bodies, options);
  std::vector<Regions> regions(faces.faces.size());
  parallel_for(regions.size(), options.threads,
               [&](std::size_t f) { regions[f] = find_regions(faces.faces[f], planes, surfaces, bodies); });
  Section section = assemble(faces, regions, mesh, surfaces, planes);

  Cut result;
  result.pieces = pieces(mesh, faces, section, surfaces, options);
  result.warnings = bodies.warnings;
  warn_of_misses(knives, planes, section.mesh, result.warnings);
  result.section = std::move(section.mesh);
  return result;
}

}  // namespace pomona
