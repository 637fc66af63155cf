#include "generator/template/half_wall.h"

#include <algorithm>
#include <cmath>

#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr double nearest = radians(2);

/// A wall separates two tissues; a leaf or a stalk is a body of its own.
bool is_chamber(const SurfaceSketch& surface) {
  return surface.type == SurfaceType::in_fold && surface.front.part != surface.back.part;
}

bool has_chambers_beside(const Template& fruit, std::size_t line, std::size_t lines) {
  return std::any_of(fruit.surfaces.begin(), fruit.surfaces.end(), [&](const SurfaceSketch& surface) {
    if (!is_chamber(surface) || surface.horizontal.size() != lines) return false;
    return !surface.horizontal[line].points.empty() && !surface.horizontal[(line + lines - 1) % lines].points.empty();
  });
}

}  // namespace

std::vector<std::string> half_wall_warnings(const Template& fruit) {
  std::vector<std::string> warnings;
  const auto* symmetry = std::get_if<FoldSymmetry>(&fruit.symmetry);
  if (!symmetry) return warnings;
  const std::vector<double>& lines = symmetry->fold_angles;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double halves = lines[k] / pi;
    if (pi * std::fabs(halves - std::round(halves)) > nearest || !has_chambers_beside(fruit, k, lines.size())) continue;
    warnings.push_back("half cuts along the wall where fold " + std::to_string(k + 1) +
                       " begins: turn the drawing, so that no fold line lies at 0 or 180 degrees");
  }
  return warnings;
}

}  // namespace pomona
