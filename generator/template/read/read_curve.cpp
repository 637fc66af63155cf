#include "generator/template/read/read_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/text/svg_path.h"

namespace pomona {

namespace {

constexpr double largest_radius = 10;  // metres; a template is a fruit, or a bowl, or a volcano on a table

bool fits(const Curve& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(),
                     [](const glm::dvec2& p) { return std::max(std::abs(p.x), std::abs(p.y)) <= largest_radius; });
}

void put_start_on_axis(std::vector<glm::dvec2>& points, double near) {
  if (points.empty() || std::abs(points.front().x) > near) return;
  // Removes points that waver about the axis before the curve leaves it.
  std::size_t first = 0;
  while (first + 2 < points.size() && points[first + 1].x <= 0 && points[first + 1].x >= -near) ++first;
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
  points.front().x = 0;
}

}  // namespace

bool names_sketch(const TomlValue& value) { return value.is(TomlNode::Kind::string) && value.text().starts_with("#"); }

Curve ended_on_axis(Curve curve) {
  if (curve.closed) return curve;
  double width = 0;
  for (const glm::dvec2& p : curve.points) width = std::max(width, std::abs(p.x));
  const double near = 0.01 * width;
  put_start_on_axis(curve.points, near);
  std::reverse(curve.points.begin(), curve.points.end());
  put_start_on_axis(curve.points, near);
  std::reverse(curve.points.begin(), curve.points.end());
  return curve;
}

void CurveReader::note_once(const TomlValue& value, const BadSketch& bad) {
  if (std::find(noted_.begin(), noted_.end(), bad.what()) != noted_.end()) return;
  noted_.emplace_back(bad.what());
  value.error(bad.what(), bad.hint);
}

void note(const TomlValue& value, const DrawnCurve& curve, const std::optional<CurveFault>& fault) {
  if (fault) value.error(curve.title + " " + fault->message, fault->hint);
}

std::size_t CurveReader::points_allowed() const { return std::min(SvgPathOptions{}.max_points, points_left_); }

std::optional<DrawnCurve> CurveReader::parse(const TomlValue& value, SketchView view) const {
  if (names_sketch(value)) {
    if (sketch_) return sketch_->curve(view, value.text().substr(1), points_allowed());
    if (sketch_named_) return {};
    value.error("is a name in a sketch, but there is none", "write sketch = \"NAME.svg\" at the top of the template");
    return {};
  }
  std::vector<Curve> curves = parse_svg_path(value.text(), {.unit = unit_, .max_points = points_allowed()});
  if (curves.size() == 1) return DrawnCurve{std::move(curves.front()), "curve"};
  if (curves.empty()) value.error("curve is empty", "draw it: SVG path data, as in \"M 0 40 C 20 40 30 25 30 0\"");
  if (curves.size() > 1) value.error("curve has several parts", "keep one M at its start");
  return {};
}

std::optional<DrawnCurve> CurveReader::read(const TomlValue& value, SketchView view) {
  if (!value.given()) return {};
  if (!value.is(TomlNode::Kind::string)) {
    value.text();  // notes a fault if it is not a text
    return {};
  }
  try {
    std::optional<DrawnCurve> drawn = parse(value, view);
    if (!drawn) return {};
    if (fits(drawn->curve)) {
      points_left_ -= std::min(points_left_, drawn->curve.points.size());
      return drawn;
    }
    value.error(drawn->title + " lies more than 10 m from the axis", "check the unit");
  } catch (const BadPath& bad) {
    value.error(std::string("curve ") + bad.what(), bad.hint);
  } catch (const BadSketch& bad) {
    note_once(value, bad);
  }
  return {};
}

bool CurveReader::is_group(const TomlValue& value, SketchView view) const {
  if (!sketch_ || !names_sketch(value)) return false;
  try {
    return sketch_->is_group(view, value.text().substr(1));
  } catch (const BadSketch&) {
    return false;  // reading it as a curve notes the fault
  }
}

std::vector<DrawnCurve> CurveReader::read_group(const TomlValue& value, SketchView view) {
  try {
    std::vector<DrawnCurve> curves = sketch_->group(view, value.text().substr(1), points_allowed());
    for (const DrawnCurve& drawn : curves) {
      points_left_ -= std::min(points_left_, drawn.curve.points.size());
      if (!fits(drawn.curve)) value.error(drawn.title + " lies more than 10 m from the axis", "check the unit");
    }
    if (curves.empty()) value.error(value.text() + " is a group without curves", "draw one in each fold");
    return curves;
  } catch (const BadSketch& bad) {
    note_once(value, bad);
    return {};
  }
}

}  // namespace pomona
