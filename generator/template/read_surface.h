// One [[surface]] of a template file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/template/template.h"
#include "generator/template/toml_document.h"

namespace pomona {

/// Reads surfaces one after another; what they share is the drawing: its unit, parts and folds, and the points
/// it may have in all.
class SurfaceReader {
 public:
  SurfaceReader(double unit, std::vector<std::string> parts, Symmetry symmetry)
      : unit_(unit), parts_(std::move(parts)), symmetry_(std::move(symmetry)) {}

  /// Notes what is wrong in the table's document. Vertical curves keep the height at which they were drawn.
  SurfaceSketch read(const TomlTable& table);

 private:
  std::optional<Curve> read_curve(const TomlValue& value);
  void read_vertical(const TomlTable& table, SurfaceSketch& sketch);
  void read_around_axis(const TomlTable& table, SurfaceSketch& sketch);
  void read_in_fold(const TomlTable& table, SurfaceSketch& sketch);
  void read_fold_loop(const TomlValue& value, std::size_t fold, SurfaceSketch& sketch);
  void read_paint(const TomlTable& table, SurfaceSketch& sketch) const;

  double unit_;
  std::vector<std::string> parts_;
  Symmetry symmetry_;
  std::size_t points_left_ = 1000000;
};

}  // namespace pomona
