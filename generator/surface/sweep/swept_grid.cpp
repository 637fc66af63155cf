#include "generator/surface/sweep/swept_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

void refuse(const Template& fruit, const SurfaceSketch& sketch, const std::string& why, const std::string& hint) {
  refuse_entry(fruit, "surface", sketch.name, why, hint);
}

int refined(int count, double detail, int min) { return std::max(min, static_cast<int>(std::lround(count * detail))); }

double turn_of(double azimuth) {
  const double turns = azimuth / (2 * pi);
  const double turn = turns - std::floor(turns);
  constexpr double rounding = 1e-9;  // the angle 0 must not become a whole turn
  return turn > 1 - rounding ? 0 : turn;
}

namespace {

/// The vertex of each ring and spoke, poles collapsed.
class GridIndex {
 public:
  explicit GridIndex(const GridShape& shape) : shape_(shape) {}

  std::uint32_t operator()(int ring, int spoke) const {
    if (shape_.closed_along) ring %= shape_.rings;
    if (ring == 0 && shape_.starts_in_pole) return 0;
    const int before = shape_.starts_in_pole ? 1 + (ring - 1) * shape_.around : ring * shape_.around;
    const bool last_pole = ring == shape_.rings - 1 && shape_.ends_in_pole;
    return static_cast<std::uint32_t>(last_pole ? before : before + spoke % shape_.around);
  }

 private:
  GridShape shape_;
};

}  // namespace

std::vector<glm::uvec3> grid_triangles(const GridShape& shape) {
  const GridIndex at(shape);
  const int bands = shape.closed_along ? shape.rings : shape.rings - 1;
  std::vector<glm::uvec3> triangles;
  for (int j = 0; j < bands; ++j) {
    const bool from_pole = j == 0 && shape.starts_in_pole;
    const bool to_pole = j == shape.rings - 2 && shape.ends_in_pole;
    for (int i = 0; i < shape.around; ++i) {
      if (!from_pole) triangles.emplace_back(at(j, i), at(j, i + 1), at(j + 1, i + 1));
      if (!to_pole) triangles.emplace_back(at(j, i), at(j + 1, i + 1), at(j + 1, i));
    }
  }
  return triangles;
}

}  // namespace pomona
