#include "generator/template/read/read_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/template/curve_faults.h"
#include "generator/template/read/read_paint.h"

namespace pomona {

namespace {

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

bool faces_air(const TomlTable& surface) {
  const auto is_hidden = [&](const char* side) {
    const TomlValue value = surface.get(side);
    return value.is(TomlNode::Kind::table) && value.table().get("hidden").boolean(false);
  };
  return is_hidden("front") || is_hidden("back");
}

Curve scaled_by(Curve curve, double factor) {
  for (glm::dvec2& p : curve.points) p *= factor;
  return curve;
}

constexpr std::size_t max_loops = 16;

/// [x, z] from the axis, or stops of such.
void read_off(const TomlValue& value, SurfaceSketch& sketch) {
  constexpr Within reach{-1, 1};  // metres
  if (sketch.type == SurfaceType::in_fold) {
    return value.error("is for surfaces around the axis", "draw the loops of a surface in folds where it lies");
  }
  const auto both = [&](const TomlValue& pair) -> std::pair<double, double> {
    const std::vector<TomlValue> lengths = pair.values();
    if (lengths.size() == 2) return {lengths[0].length(0, reach), lengths[1].length(0, reach)};
    if (pair.is(TomlNode::Kind::array)) pair.error("must be two lengths, x and z, as in [\"4mm\", \"0mm\"]");
    return {0, 0};
  };
  const std::vector<TomlValue> listed = value.values();
  if (!listed.empty() && listed.front().is(TomlNode::Kind::string)) {
    const auto is_ramp = [](const TomlValue& length) { return length.is(TomlNode::Kind::array); };
    if (std::any_of(listed.begin(), listed.end(), is_ramp))
      return value.error("has a ramp for one of its lengths",
                         "write stops of both, as in [[0.0, [\"4mm\", \"0mm\"]], [1.0, [\"4mm\", \"2mm\"]]]");
    const auto [x, z] = both(value);
    sketch.off = {Ramp<double>::constant(x), Ramp<double>::constant(z)};
    return;
  }
  const auto place = [](const TomlValue& at) { return at.number(0, {0, 1}); };
  const auto stops =
      read_stops<std::pair<double, double>>(value, place, both,
                                            {.one = "write [place, [x, z]], as in [0.5, [\"4mm\", \"0mm\"]]",
                                             .all = "write [x, z], as in [\"4mm\", \"0mm\"]"});
  if (stops.empty()) return;
  sketch.off = {};
  sketch.off.x.stops.clear();
  sketch.off.z.stops.clear();
  for (const auto& [at, lengths] : stops) {
    sketch.off.x.stops.push_back({at, lengths.first});
    sketch.off.z.stops.push_back({at, lengths.second});
  }
}

double largest_x(const Curve& curve) {
  double largest = 0;
  for (const glm::dvec2& p : curve.points) largest = std::max(largest, p.x);
  return largest;
}

/// The fold that holds most of the loop between its two lines.
std::size_t fold_of(const Curve& loop, const std::vector<double>& angles) {
  glm::dvec2 sum(0);
  for (const glm::dvec2& p : loop.points) sum += p;
  double angle = reproducible::atan2(sum.y, sum.x) - angles.front();
  if (angle < 0) angle += 2 * pi;
  std::size_t fold = 0;
  while (fold + 1 < angles.size() && angles[fold + 1] - angles.front() <= angle) ++fold;
  return fold;
}

}  // namespace

void SketchSurfaceReader::read_vertical(const TomlTable& table, SurfaceSketch& sketch) {
  const TomlValue value = table.need("vertical");
  std::optional<DrawnCurve> drawn = curves_.read(value, SketchView::side);
  if (!drawn) return;
  if (names_sketch(value) && sketch.type == SurfaceType::around_axis) drawn->curve = ended_on_axis(drawn->curve);
  sketch.vertical = drawn->curve;
  std::optional<CurveFault> fault = fault_of_vertical(sketch.vertical, sketch.type);
  if (!fault && names_sketch(value) && sketch.type == SurfaceType::around_axis && faces_air(table)) {
    fault = fault_of_open_ends(sketch.vertical);
  }
  note(value, *drawn, fault);

  // Ramps along start at the bottom, so turn curves that were drawn downwards.
  std::vector<glm::dvec2>& points = sketch.vertical.points;
  const bool downwards = !sketch.vertical.closed && !points.empty() && points.front().y > points.back().y;
  if (downwards) std::reverse(points.begin(), points.end());
}

void SketchSurfaceReader::read_stops_around_axis(const TomlValue& value, SurfaceSketch& sketch) {
  const auto place = [](const TomlValue& at) { return at.number(0, {0, 1}); };
  const auto loop = [&](const TomlValue& stop) {
    const std::optional<DrawnCurve> drawn = curves_.read(stop, SketchView::top);
    if (!drawn) return Curve{};
    note(stop, *drawn, fault_of_loop_around_axis(drawn->curve, symmetry_));
    return counter_clockwise(drawn->curve);
  };
  const std::vector<TomlValue> listed = value.values();
  if (listed.size() > max_loops) {
    return value.error("has more than " + std::to_string(max_loops) + " stops", "leave some out: loops blend between");
  }
  for (auto& stop : read_stops<Curve>(value, place, loop,
                                      {.one = "write [place, curve] with a place from 0 to 1, as in [0.4, \"#ridges\"]",
                                      .all = "write one curve, or one for each of several places"})) {
    sketch.stops.push_back(stop.at);
    sketch.horizontal.push_back(std::move(stop.value));
  }
  if (std::any_of(sketch.horizontal.begin(), sketch.horizontal.end(), [](auto& c) { return c.points.empty(); })) return;

  // How large each is does not matter: the vertical curve says it.
  SurfaceSketch alone = sketch;
  const double size = reference_radii(sketch).outer;
  for (Curve& curve : sketch.horizontal) {
    alone.horizontal = {curve};
    const double factor = size / reference_radii(alone).outer;
    if (factor != 1 && std::isfinite(factor)) curve = scaled_by(std::move(curve), factor);
  }
}

void SketchSurfaceReader::read_around_axis(const TomlTable& table, SurfaceSketch& sketch) {
  const TomlValue value = table.get("horizontal");
  if (!value.given()) {
    sketch.horizontal = {circle(std::max(largest_x(sketch.vertical), 1e-3))};
    return;
  }
  if (value.is(TomlNode::Kind::array)) return read_stops_around_axis(value, sketch);
  const std::optional<DrawnCurve> loop = curves_.read(value, SketchView::top);
  if (!loop) return;
  sketch.horizontal = {counter_clockwise(loop->curve)};
  note(value, *loop, fault_of_loop_around_axis(loop->curve, symmetry_));
}

void SketchSurfaceReader::read_fold_loop(const TomlValue& value, std::size_t fold, SurfaceSketch& sketch) {
  sketch.horizontal.emplace_back();
  if (value.is(TomlNode::Kind::string) && value.text().empty()) return;  // nothing in this fold
  const std::optional<DrawnCurve> loop = curves_.read(value, SketchView::top);
  if (!loop) return;
  sketch.horizontal.back() = counter_clockwise(loop->curve);
  note(value, *loop, fault_of_loop_in_fold(loop->curve, std::get<FoldSymmetry>(symmetry_), fold));
}

void SketchSurfaceReader::read_fold_group(const TomlValue& value, SurfaceSketch& sketch) {
  const auto& folds = std::get<FoldSymmetry>(symmetry_);
  sketch.horizontal.resize(folds.fold_angles.size());
  std::vector<std::string> titles(folds.fold_angles.size());
  for (const DrawnCurve& loop : curves_.read_group(value, SketchView::top)) {
    if (loop.curve.points.empty()) continue;
    const std::size_t k = fold_of(loop.curve, folds.fold_angles);
    if (!titles[k].empty()) {
      value.error(loop.title + " lies in fold " + std::to_string(k + 1) + ", where " + titles[k] + " lies already",
                  "draw one loop in each fold, or take one of them out of the group");
      continue;
    }
    titles[k] = loop.title;
    sketch.horizontal[k] = counter_clockwise(loop.curve);
    note(value, loop, fault_of_loop_in_fold(loop.curve, folds, k));
  }
}

void SketchSurfaceReader::read_in_fold(const TomlTable& table, SurfaceSketch& sketch) {
  const TomlValue value = table.need("horizontal");
  const auto* folds = std::get_if<FoldSymmetry>(&symmetry_);
  if (!folds) {
    table.error("lies in a fold, but the fruit has none",
                "write kind = \"folds\" under [symmetry], or type = \"around-axis\" here");
    return;
  }
  if (!value.given()) return;
  const std::vector<double>& angles = folds->fold_angles;
  if (curves_.is_group(value, SketchView::top)) return read_fold_group(value, sketch);

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

void SketchSurfaceReader::read_paint(const TomlTable& table, SurfaceSketch& sketch) const {
  const auto share = [](const TomlValue& value) { return value.number(0, {0, 1}); };
  const auto* folds = std::get_if<FoldSymmetry>(&symmetry_);
  const PaintedSurface surface{sketch.type, folds ? static_cast<int>(folds->fold_angles.size()) : 0, laws_};
  sketch.blur = read_painted_blur(table.get("blur"));
  sketch.roundness = read_ramp<double>(table.get("roundness"), 0.0, share);
  sketch.front = read_surface_side(table.need("front").table(), parts_, surface);
  sketch.back = read_surface_side(table.need("back").table(), parts_, surface);
  if (sketch.front.hidden && sketch.back.hidden) {
    table.error("has both sides hidden", "hide only the side that faces air");
  }
  const auto raises = [](const Side& side) {
    return side.cells && std::any_of(side.cells->raise.stops.begin(), side.cells->raise.stops.end(),
                                     [](const Ramp<double>::Stop& stop) { return stop.value != 0; });
  };
  if (raises(sketch.front) && raises(sketch.back)) {
    table.get("back").table().get("cells").table().get("raise").error("is given beside that of the front",
                                                                      "leave one of the two out");
  }
}

SurfaceSketch SketchSurfaceReader::read(const TomlTable& table) {
  SurfaceSketch sketch;
  sketch.name = table.get("name").text();
  sketch.type =
      table.need("type").choice({"around-axis", "in-fold"}) == 0 ? SurfaceType::around_axis : SurfaceType::in_fold;
  if (table.has("reference_azimuth")) sketch.reference_azimuth = table.get("reference_azimuth").angle(0, {-360, 360});
  read_vertical(table, sketch);
  if (sketch.type == SurfaceType::around_axis) {
    read_around_axis(table, sketch);
  } else {
    read_in_fold(table, sketch);
  }
  if (table.has("off")) read_off(table.get("off"), sketch);
  sketch.taper = table.get("taper").number(sketch.taper, {0.05, 4});
  read_paint(table, sketch);
  sketch.around = table.get("around").integer(sketch.around, 3, 1024);
  sketch.along = table.get("along").integer(sketch.along, 2, 1024);
  sketch.varies = table.get("varies").boolean(sketch.varies);
  sketch.guide = table.get("guide").boolean(sketch.guide);
  return sketch;
}

}  // namespace pomona
