#include "generator/template/read_grains.h"

#include <string>
#include <vector>

#include "generator/template/read_paint.h"

namespace pomona {

namespace {

void read_grain_shape(const TomlTable& table, GrainSketch& grain) {
  const Within size{1e-5, 0.2};
  grain.poisson_radius = table.need("spacing").length(1e-3, size);
  grain.length = table.need("length").length(1e-3, size);
  grain.width = table.need("width").length(1e-3, size);
  grain.thickness = table.need("thickness").length(1e-3, size);
  grain.sink = table.get("sink").length(0, {-0.1, 0.1});
  grain.size_jitter = table.get("size_jitter").number(0, {0, 0.9});
  grain.angle_jitter = table.get("angle_jitter").angle(0, {0, 180});
  grain.tilt = table.get("tilt").angle(0, {-90, 90});
  grain.pointedness = table.get("pointedness").number(0, {0, 1});
}

void read_band(const TomlValue& value, GrainSketch& grain) {
  if (!value.given()) return;
  const std::vector<TomlValue> ends = value.values();
  if (ends.size() != 2) return value.error("must be two places along the vertical curve, as in [0.2, 0.8]");
  grain.along_from = ends[0].number(0, {0, 1});
  grain.along_to = ends[1].number(1, {0, 1});
  if (grain.along_from >= grain.along_to) value.error("is empty", "write the lower end first");
}

}  // namespace

GrainSketch read_grains(const TomlTable& table, const Template& fruit) {
  GrainSketch grain;
  std::vector<std::string> names;
  for (const SurfaceSketch& surface : fruit.surfaces) names.push_back(surface.name);
  grain.surface = table.need("surface").choice(names);
  grain.on_front = table.get("side").choice({"front", "back"}) == 0;
  read_grain_shape(table, grain);
  read_band(table.get("band"), grain);
  grain.front = read_side(table.need("front").table(), fruit.parts);
  grain.back = read_side(table.need("back").table(), fruit.parts);
  if (grain.front.hidden && grain.back.hidden)
    table.error("have both sides hidden", "hide only the side that faces air");
  grain.blur = table.get("blur").length(0, {0, 0.1});
  grain.around = table.get("around").integer(grain.around, 3, 64);
  grain.along = table.get("along").integer(grain.along, 2, 64);
  return grain;
}

}  // namespace pomona
