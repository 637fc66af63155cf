// Reads ramps and painted sides of template files.
#pragma once

#include <string>
#include <vector>

#include "generator/template/read/read_stops.h"
#include "generator/template/template.h"
#include "generator/text/toml_document.h"

namespace pomona {

/// Reads a ramp around a whole turn. Without a stop at 0 or at 1, values go on evenly from the last stop over the seam
/// to the first; a jump there needs stops at both.
template <typename Value, typename Read>
Ramp<Value> read_turn(const TomlValue& value, const Value& fallback, Read read) {
  Ramp<Value> ramp = read_ramp<Value>(value, fallback, read);
  const auto first = ramp.stops.front(), last = ramp.stops.back();
  const double after = 1 - last.at, gap = first.at + after;
  if (gap > 0) {
    // At one end there may be a stop; else evenly from the last over the seam to the first.
    const auto share = static_cast<float>(after / gap);
    const auto between = static_cast<Value>(last.value + (first.value - last.value) * share);
    const Value seam = first.at == 0 ? first.value : last.at == 1 ? last.value : between;
    if (first.at > 0) ramp.stops.insert(ramp.stops.begin(), {0.0, seam});
    if (last.at < 1) ramp.stops.push_back({1.0, seam});
  }
  return ramp;
}

/// Reads a length, a ramp of lengths along, or { along = ..., around = ..., turn = ... }.
PaintedBlur read_painted_blur(const TomlValue& value);

/// Reads the side of a grain, { part = "skin", color = ..., hidden = true }. The colour is "#rrggbb", a ramp along, or
/// { along = ..., around = ... }. `sample` and `stops` say where `pomona sketch --sample` took the colours along; they
/// are only checked here.
Side read_side(const TomlTable& table, const std::vector<std::string>& parts);

/// Reads `part` and `hidden` alone, for meshes that have colours of their own.
Side read_uncolored_side(const TomlTable& table, const std::vector<std::string>& parts);

/// Reads the colour of such a side alone.
PaintedColor read_painted_color(const TomlValue& value);

/// What paint of a surface is checked against.
struct PaintedSurface {
  SurfaceType type = SurfaceType::around_axis;
  int folds = 0;  ///< 0: the fruit is cylindrical
  std::vector<LawSketch> laws = {};
};

/// Reads the side of a surface, which besides has the colour's `turn` and `folds`, `coats` and `spots`.
Side read_surface_side(const TomlTable& table, const std::vector<std::string>& parts, const PaintedSurface& surface);

}  // namespace pomona
