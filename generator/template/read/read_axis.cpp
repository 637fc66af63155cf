#include "generator/template/read/read_axis.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/template/bend_strain.h"
#include "generator/template/read/read_stops.h"

namespace pomona {

namespace {

constexpr int stretches = 64;  // of the table of leans; their joints are rounded

/// The mean of each lean and its two neighbours: takes away the corners of the chords into which a curve was divided.
std::vector<double> smoothed(const std::vector<double>& leans) {
  std::vector<double> result = leans;
  for (std::size_t i = 1; i + 1 < leans.size(); ++i) result[i] = 0.25 * (leans[i - 1] + 2 * leans[i] + leans[i + 1]);
  return result;
}

/// The angle between the line and upwards at evenly spaced places, without jumps.
std::vector<double> leans_of(const Curve& line) {
  const std::vector<glm::dvec2> points = resampled(line, stretches + 1).points;
  std::vector<double> leans;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec2 way = points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0];
    const double lean = reproducible::atan2(way.x, way.y);
    leans.push_back(i == 0 ? lean : lean - 2 * pi * std::round((lean - leans.back()) / (2 * pi)));
  }
  for (int pass = 0; pass < 4; ++pass) leans = smoothed(leans);
  return leans;
}

void read_line(const TomlValue& value, CurveReader& curves, AxisBend& bend) {
  const std::optional<DrawnCurve> drawn = curves.read(value, SketchView::side);
  if (!drawn) return;
  if (drawn->curve.closed || drawn->curve.points.size() < 2 || !(length(drawn->curve) > 0)) {
    return value.error(drawn->title + " is no line", "draw it from the bottom of the fruit to its top");
  }
  bend.line = leans_of(drawn->curve);
}

void read_bend(const TomlTable& table, AxisBend& bend) {
  bend.angle = table.get("angle").angle(0, {-150, 150});
  bend.swing = table.get("swing").angle(0, {-150, 150});
  bend.direction = table.get("direction").angle(0, {-360, 360});
}

/// Notes whether the axis leaves no room, at the table that is to blame.
bool has_room(const TomlValue& value, const Template& fruit) {
  const BendStrain strain = bend_strain(fruit);
  if (strain.pressing <= max_strain.pressing && strain.lean <= max_strain.lean) return true;
  const bool folds = strain.pressing > max_strain.pressing, drawn = !fruit.bend.line.empty();
  value.error(folds   ? "folds the fruit where it is wide"
              : drawn ? "turns the axis by more than 150 degrees"
                      : "turns the axis by more than 75 degrees from upright",
              drawn ? "draw the line less bent" : "make angle and swing smaller");
  return false;
}

bool fits_meshes(const TomlValue& value, const Template& fruit) {
  if (fruit.meshes.empty()) return true;
  value.error("bends drawn curves only, but there are meshes", "bend them all in the modelling tool");
  return false;
}

}  // namespace

void read_axis_of(const TomlTable& root, CurveReader& curves, Template& fruit) {
  const TomlValue axis = root.get("axis"), bend = root.get("bend");
  if (axis.given()) {
    const TomlTable table = axis.table();
    if (table.has("line")) read_line(table.get("line"), curves, fruit.bend);
    const auto angle = [](const TomlValue& stop) { return stop.angle(0, {-3600, 3600}); };
    fruit.bend.twist = read_ramp<double>(table.get("twist"), 0.0, angle);
    if (!fits_meshes(axis, fruit) || !has_room(axis, fruit)) fruit.bend = {};
  }
  if (!bend.given()) return;
  const AxisBend drawn = fruit.bend;
  read_bend(bend.table(), fruit.bend);
  if (!fits_meshes(bend, fruit) || !has_room(bend, fruit)) fruit.bend = drawn;
}

}  // namespace pomona
