#include "generator/surface/crossing_layers.h"

#include <algorithm>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/surface/crossings.h"

namespace pomona {

namespace {

constexpr double strand = 1 / 7.0;  ///< of the layer's width

bool is_layer(const SurfaceSketch& surface) {
  if (surface.type != SurfaceType::around_axis || surface.front.hidden || surface.back.hidden) return false;
  const Curve& vertical = surface.vertical;
  return !vertical.closed && glm::distance(vertical.points.front(), vertical.points.back()) > 1e-9;
}

/// The largest distance of the vertical curve from the axis, metres.
double width_of(const SurfaceSketch& surface) {
  double most = 0;
  for (const glm::dvec2& p : surface.vertical.points) most = std::max(most, p.x);
  return most;
}

bool should_be_apart(const SurfaceSketch& a, const SurfaceSketch& b) {
  const std::pair<double, double> widths = std::minmax({width_of(a), width_of(b)});
  return is_layer(a) && is_layer(b) && widths.first > strand * widths.second;
}

}  // namespace

std::vector<std::string> crossing_layer_warnings(const Template& fruit, const DiffusionSurfaces& swept) {
  std::set<CrossingKind> wanted;
  for (std::size_t a = 0; a < fruit.surfaces.size(); ++a) {
    for (std::size_t b = a + 1; b < fruit.surfaces.size(); ++b) {
      if (should_be_apart(fruit.surfaces[a], fruit.surfaces[b]))
        wanted.insert({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), false});
    }
  }
  std::vector<std::string> warnings;
  for (const auto& [a, b, same] : crossing_kinds_of(swept, wanted))
    warnings.push_back("layers cross, so that each lends the other its colours: \"" +
                       fruit.surfaces[static_cast<std::size_t>(a)].name + "\" and \"" +
                       fruit.surfaces[static_cast<std::size_t>(b)].name + "\"; draw one within the other");
  return warnings;
}

}  // namespace pomona
