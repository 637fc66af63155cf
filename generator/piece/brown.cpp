#include "generator/piece/brown.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "generator/base/gradient_noise.h"
#include "generator/base/parallel.h"
#include "generator/base/reproducible.h"
#include "generator/mesh/triangle_tree.h"
#include "generator/surface/skin_depth.h"

namespace pomona {

namespace {

/// The triangles of one surface, by its name.
TriangleTree tree_of_surface(const DiffusionSurfaces& surfaces, const std::string& name) {
  std::vector<glm::uvec3> triangles;
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    if (surfaces.surface_names[static_cast<std::size_t>(surfaces.surface[i])] == name)
      triangles.push_back(surfaces.triangle[i]);
  }
  return {surfaces.position, triangles};
}

/// The speed at which each place of a fruit browns, and its final colour.
class Browning {
 public:
  Browning(const DiffusionSurfaces& surfaces, const Template& fruit)
      : sketch_(fruit.browning), individual_(fruit.individual), skin_(surfaces), of_part_(fruit.parts.size()) {
    for (const BrowningSketch::Part& part : sketch_.parts) of_part_[static_cast<std::size_t>(part.part)] = part;
    if (sketch_.near)
      near_ = tree_of_surface(surfaces, fruit.surfaces[static_cast<std::size_t>(sketch_.near->surface)].name);
  }

  Color operator()(const Color& color, std::int32_t part, const glm::dvec3& place) const {
    if (part < 0 || static_cast<std::size_t>(part) >= of_part_.size()) return color;
    const std::optional<BrowningSketch::Part>& how = of_part_[static_cast<std::size_t>(part)];
    if (!how) return color;
    const double share = how->max * (1 - reproducible::exp(-3 * individual_.browning * how->rate * speed_at(place)));
    if (share == 0) return color;
    const glm::dvec3 fresh(to_oklab(color)), brown(to_oklab(how->color));
    return from_oklab_within_gamut(glm::vec3(fresh + share * (brown - fresh)));
  }

 private:
  double speed_at(const glm::dvec3& place) const {
    double speed = sketch_.depth(skin_.depth(place));
    if (sketch_.near) {
      const double distance = near_.nearest(place, sketch_.near->within).distance;
      const double nearness = std::max(0.0, 1 - distance / sketch_.near->within);
      speed *= 1 + (sketch_.near->faster - 1) * nearness;
    }
    if (sketch_.patches > 0)
      speed *= 1 + sketch_.patches * gradient_noise(place / sketch_.patch_size, individual_.patches);
    return speed;
  }

  const BrowningSketch& sketch_;
  const Individual& individual_;
  SkinDepth skin_;
  TriangleTree near_;
  std::vector<std::optional<BrowningSketch::Part>> of_part_;
};

bool turns_brown(const Template& fruit) { return fruit.individual.browning != 0 && fruit.browning.declared(); }

}  // namespace

CrossSection browned(CrossSection section, const DiffusionSurfaces& surfaces, const Template& fruit, Threads threads) {
  if (!turns_brown(fruit) || section.position.empty()) return section;
  const Browning browning(surfaces, fruit);
  parallel_for(section.position.size(), threads, [&](std::size_t v) {
    section.color[v] = browning(section.color[v], section.part[v], glm::dvec3(section.position[v]));
  });
  return section;
}

DiffusedColors browned(DiffusedColors colors, std::span<const glm::vec3> points, const DiffusionSurfaces& surfaces,
                       const Template& fruit) {
  if (!turns_brown(fruit) || points.empty()) return colors;
  const Browning browning(surfaces, fruit);
  parallel_for(points.size(), {}, [&](std::size_t i) {
    colors.color[i] = browning(colors.color[i], colors.part[i], glm::dvec3(points[i]));
  });
  return colors;
}

std::vector<CutPiece> browned(std::vector<CutPiece> pieces, const DiffusionSurfaces& surfaces, const Template& fruit) {
  const auto has_bared = [](const CutPiece& piece) {
    return std::find(piece.bared.begin(), piece.bared.end(), std::uint8_t{1}) != piece.bared.end();
  };
  if (!turns_brown(fruit) || std::none_of(pieces.begin(), pieces.end(), has_bared)) return pieces;
  const Browning browning(surfaces, fruit);
  for (CutPiece& piece : pieces) {
    parallel_for(piece.bared.size(), {}, [&](std::size_t v) {
      if (piece.bared[v]) piece.color[v] = browning(piece.color[v], piece.part[v], glm::dvec3(piece.position[v]));
    });
  }
  return pieces;
}

}  // namespace pomona
