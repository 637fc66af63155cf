#include "generator/template/read/read_symmetry.h"

#include <string>
#include <utility>
#include <vector>

#include "generator/base/units.h"

namespace pomona {

namespace {

std::vector<double> even_angles(int count) {
  std::vector<double> angles;
  for (int k = 0; k < count; ++k) angles.push_back(2 * pi * k / count);
  return angles;
}

std::vector<double> read_fold_angles(const TomlValue& value, int count) {
  if (!value.given()) return even_angles(count);
  const std::vector<TomlValue> listed = value.values();
  if (listed.size() != static_cast<std::size_t>(count)) {
    value.error("has " + std::to_string(listed.size()) + " angles for " + std::to_string(count) + " folds");
    return even_angles(count);
  }
  std::vector<double> angles;
  for (const TomlValue& angle : listed) {
    angles.push_back(angle.angle(0, {0, 360}));
    const std::size_t n = angles.size();
    if (n > 1 && angles[n - 1] - angles[n - 2] < radians(0.5)) {
      angle.error("does not ascend", "write where each fold begins, in degrees, one after another");
    }
  }
  if (angles.back() - angles.front() > radians(359.5)) value.error("span more than a full turn");
  return angles;
}

/// The fold lines of the sketch, or none.
std::vector<double> drawn_fold_angles(const TomlValue& folds, int count, const Sketch* sketch) {
  try {
    return sketch ? sketch->fold_angles(count) : std::vector<double>();
  } catch (const BadSketch& bad) {
    folds.error(bad.what(), bad.hint);
    return {};
  }
}

}  // namespace

Symmetry read_symmetry(const TomlTable& table, const Sketch* sketch) {
  const int kind = table.need("kind").choice({"cylindrical", "folds", "none"});
  if (kind == 0) return CylindricalSymmetry{};
  if (kind == 2) return NoSymmetry{};
  const TomlValue folds = table.need("folds"), angles = table.get("fold_angles");
  const int count = folds.integer(1, 1, most_folds);
  if (!angles.given()) {
    std::vector<double> drawn = drawn_fold_angles(folds, count, sketch);
    if (!drawn.empty()) return FoldSymmetry{std::move(drawn)};
  }
  return FoldSymmetry{read_fold_angles(angles, count)};
}

}  // namespace pomona
