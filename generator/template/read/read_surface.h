// Reads one [[surface]] table of a template file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/template/read/read_curve.h"
#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads surfaces one after another. They share the drawing's curves, parts, folds and laws.
class SketchSurfaceReader {
 public:
  SketchSurfaceReader(CurveReader curves, std::vector<std::string> parts, Symmetry symmetry,
                      std::vector<LawSketch> laws)
      : curves_(curves), parts_(std::move(parts)), symmetry_(std::move(symmetry)), laws_(std::move(laws)) {}

  /// Notes faults in the table's document. Vertical curves keep the height at which they were drawn.
  SurfaceSketch read(const TomlTable& table);

 private:
  void read_vertical(const TomlTable& table, SurfaceSketch& sketch);
  void read_stops_around_axis(const TomlValue& value, SurfaceSketch& sketch);
  void read_around_axis(const TomlTable& table, SurfaceSketch& sketch);
  void read_in_fold(const TomlTable& table, SurfaceSketch& sketch);
  void read_fold_loop(const TomlValue& value, std::size_t fold, SurfaceSketch& sketch);
  void read_fold_group(const TomlValue& value, SurfaceSketch& sketch);
  void read_paint(const TomlTable& table, SurfaceSketch& sketch) const;

  CurveReader curves_;
  std::vector<std::string> parts_;
  Symmetry symmetry_;
  std::vector<LawSketch> laws_;
};

}  // namespace pomona
