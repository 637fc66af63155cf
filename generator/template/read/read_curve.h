// Reads a curve of a template: path data, or "#name" of a curve in the sketch.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/template/curve_faults.h"
#include "generator/template/read/sketch.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// The sketch that "#name" refers to.
struct SketchOfTemplate {
  const Sketch* sketch = nullptr;  ///< null if the template has none
  bool named = false;              ///< whether the template names one; if it cannot be read, the fault has been noted
};

/// Reads curves one after another, and counts their points: all curves of a template may have a million. The sketch
/// must outlive this reader.
class CurveReader {
 public:
  /// \param unit metres of one unit of the template's own path data.
  CurveReader(double unit, const SketchOfTemplate& source)
      : unit_(unit), sketch_(source.sketch), sketch_named_(source.named) {}

  /// Returns nothing after a fault, which is noted. Ends of vertical curves of the sketch that almost touch the axis
  /// are put onto it.
  std::optional<DrawnCurve> read(const TomlValue& value, SketchView view);

  /// The curves of the group that the value names, in the order of the file, or nothing if it names no group.
  bool is_group(const TomlValue& value, SketchView view) const;
  std::vector<DrawnCurve> read_group(const TomlValue& value, SketchView view);

 private:
  std::optional<DrawnCurve> parse(const TomlValue& value, SketchView view) const;
  std::size_t points_allowed() const;
  void note_once(const TomlValue& value, const BadSketch& bad);

  double unit_;
  const Sketch* sketch_;
  bool sketch_named_;
  std::size_t points_left_ = 1000000;
  std::vector<std::string> noted_;  ///< faults of a view that were noted at its first curve, to be left out at the
                                    ///< others
};

/// Whether a text is a name in a sketch, not path data.
bool names_sketch(const TomlValue& value);

/// Moves ends of the curve that almost touch the axis onto it: no hand draws them there exactly.
Curve ended_on_axis(Curve curve);

/// Notes a fault of a curve at the value that gave it.
void note(const TomlValue& value, const DrawnCurve& curve, const std::optional<CurveFault>& fault);

}  // namespace pomona
