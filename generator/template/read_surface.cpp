#include "generator/template/read_surface.h"

#include <algorithm>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/template/curve_faults.h"
#include "generator/template/read_paint.h"
#include "generator/template/svg_path.h"

namespace pomona {

namespace {

constexpr double largest_radius = 10;  // metres; a template is a fruit, or a bowl, or a volcano on a table

Curve circle(double radius) {
  constexpr int corners = 256;
  Curve curve;
  curve.closed = true;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    curve.points.push_back(radius * glm::dvec2(reproducible::cos(angle), reproducible::sin(angle)));
  }
  return curve;
}

Curve turned(const Curve& curve, double angle) {
  const double c = reproducible::cos(angle), s = reproducible::sin(angle);
  Curve result = curve;
  for (glm::dvec2& p : result.points) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  return result;
}

double largest_x(const Curve& curve) {
  double largest = 0;
  for (const glm::dvec2& p : curve.points) largest = std::max(largest, p.x);
  return largest;
}

bool fits(const Curve& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(),
                     [](const glm::dvec2& p) { return std::max(std::abs(p.x), std::abs(p.y)) <= largest_radius; });
}

void note(const TomlValue& value, const std::optional<CurveFault>& fault) {
  if (fault) value.error("curve " + fault->message, fault->hint);
}

}  // namespace

std::optional<Curve> SurfaceReader::read_curve(const TomlValue& value) {
  if (!value.given()) return {};
  if (!value.is(TomlNode::Kind::string)) {
    value.text();  // notes that it is none
    return {};
  }
  try {
    const SvgPathOptions limits;
    std::vector<Curve> curves =
        parse_svg_path(value.text(), {.unit = unit_, .most_points = std::min(limits.most_points, points_left_)});
    if (curves.size() == 1 && fits(curves[0])) {
      points_left_ -= std::min(points_left_, curves[0].points.size());
      return std::move(curves[0]);
    }
    if (curves.empty()) value.error("curve is empty", "draw it: SVG path data, as in \"M 0 40 C 20 40 30 25 30 0\"");
    if (curves.size() > 1) value.error("curve has several parts", "keep one M at its start");
    if (curves.size() == 1) value.error("curve lies more than 10 m from the axis", "check the unit");
  } catch (const BadPath& bad) {
    value.error(std::string("curve ") + bad.what(), bad.hint);
  }
  return {};
}

void SurfaceReader::read_vertical(const TomlTable& table, SurfaceSketch& sketch) {
  const TomlValue value = table.need("vertical");
  const std::optional<Curve> curve = read_curve(value);
  if (!curve) return;
  sketch.vertical = *curve;
  note(value, fault_of_vertical(sketch.vertical, sketch.type));

  // Ramps along start at the bottom, whichever way the curve was drawn.
  std::vector<glm::dvec2>& points = sketch.vertical.points;
  const bool downwards = !sketch.vertical.closed && !points.empty() && points.front().y > points.back().y;
  if (downwards) std::reverse(points.begin(), points.end());
}

void SurfaceReader::read_around_axis(const TomlTable& table, SurfaceSketch& sketch) {
  const TomlValue value = table.get("horizontal");
  if (!value.given()) {
    sketch.horizontal = {circle(std::max(largest_x(sketch.vertical), 1e-3))};
    return;
  }
  const std::optional<Curve> loop = read_curve(value);
  if (!loop) return;
  sketch.horizontal = {counter_clockwise(*loop)};
  note(value, fault_of_loop_around_axis(*loop, symmetry_));
}

void SurfaceReader::read_fold_loop(const TomlValue& value, std::size_t fold, SurfaceSketch& sketch) {
  sketch.horizontal.emplace_back();
  if (value.is(TomlNode::Kind::string) && value.text().empty()) return;  // nothing in this fold
  const std::optional<Curve> loop = read_curve(value);
  if (!loop) return;
  sketch.horizontal.back() = counter_clockwise(*loop);
  note(value, fault_of_loop_in_fold(*loop, std::get<FoldSymmetry>(symmetry_), fold));
}

void SurfaceReader::read_in_fold(const TomlTable& table, SurfaceSketch& sketch) {
  const TomlValue value = table.need("horizontal");
  const auto* folds = std::get_if<FoldSymmetry>(&symmetry_);
  if (!folds) {
    table.error("lies in a fold, but the fruit has none",
                "write kind = \"folds\" under [symmetry], or type = \"around-axis\" here");
    return;
  }
  if (!value.given()) return;
  const std::vector<double>& angles = folds->fold_angles;

  // One loop, drawn in fold 0, is the same in every fold.
  if (!value.is(TomlNode::Kind::array)) {
    read_fold_loop(value, 0, sketch);
    for (std::size_t k = 1; k < angles.size(); ++k) {
      sketch.horizontal.push_back(turned(sketch.horizontal[0], angles[k] - angles[0]));
    }
    return;
  }
  const std::vector<TomlValue> loops = value.values();
  if (loops.size() != angles.size()) {
    value.error("has " + std::to_string(loops.size()) + " curves for " + std::to_string(angles.size()) + " folds",
                "draw one in each fold; \"\" leaves a fold without");
    return;
  }
  for (std::size_t k = 0; k < loops.size(); ++k) read_fold_loop(loops[k], k, sketch);
}

void SurfaceReader::read_paint(const TomlTable& table, SurfaceSketch& sketch) const {
  const auto length = [](const TomlValue& value) { return value.length(0, {0, 0.1}); };
  const auto share = [](const TomlValue& value) { return value.number(0, {0, 1}); };
  sketch.blur = read_ramp<double>(table.get("blur"), 0.0, length);
  sketch.roundness = read_ramp<double>(table.get("roundness"), 0.0, share);
  sketch.front = read_side(table.need("front").table(), parts_);
  sketch.back = read_side(table.need("back").table(), parts_);
  if (sketch.front.hidden && sketch.back.hidden) {
    table.error("has both sides hidden", "hide only the side that faces air");
  }
}

SurfaceSketch SurfaceReader::read(const TomlTable& table) {
  SurfaceSketch sketch;
  sketch.name = table.get("name").text();
  sketch.type =
      table.need("type").choice({"around-axis", "in-fold"}) == 0 ? SurfaceType::around_axis : SurfaceType::in_fold;
  read_vertical(table, sketch);
  if (sketch.type == SurfaceType::around_axis) {
    read_around_axis(table, sketch);
  } else {
    read_in_fold(table, sketch);
  }
  if (table.has("reference_azimuth")) sketch.reference_azimuth = table.get("reference_azimuth").angle(0, {-360, 360});
  sketch.taper = table.get("taper").number(sketch.taper, {0.05, 4});
  read_paint(table, sketch);
  sketch.around = table.get("around").integer(sketch.around, 3, 1024);
  sketch.along = table.get("along").integer(sketch.along, 2, 1024);
  sketch.varies = table.get("varies").boolean(sketch.varies);
  return sketch;
}

}  // namespace pomona
