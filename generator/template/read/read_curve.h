// A curve as a template gives it: path data on the spot, or "#name" of a curve in the sketch.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/template/curve_faults.h"
#include "generator/template/read/sketch.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// What "#name" refers to.
struct SketchOfTemplate {
  const Sketch* sketch = nullptr;  ///< null where there is none
  bool named = false;              ///< the template names one; if it cannot be read, that has been noted
};

/// Reads curves one after another, and counts their points: all of a template's together may have a million.
/// The sketch must outlive it.
class CurveReader {
 public:
  /// \param unit metres of one unit of path data on the spot.
  CurveReader(double unit, const SketchOfTemplate& source)
      : unit_(unit), sketch_(source.sketch), sketch_named_(source.named) {}

  /// Notes what is wrong and returns nothing then. What the sketch says stands nearest to the axis is put onto it, at
  /// the ends of vertical curves around the axis.
  std::optional<DrawnCurve> read(const TomlValue& value, SketchView view);

  /// Whether the value names a group of the sketch; its curves in the order of the file.
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
  std::vector<std::string> noted_;  ///< what a view lacks is told at its first curve, not at all of them
};

/// Whether a text is a name in a sketch and no path data.
bool names_sketch(const TomlValue& value);

/// The curve with ends that almost touch the axis put onto it: nobody's hand is steady enough to end there.
Curve ended_on_axis(Curve curve);

/// Notes a fault of a curve at the value that gave it.
void note(const TomlValue& value, const DrawnCurve& curve, const std::optional<CurveFault>& fault);

}  // namespace pomona
