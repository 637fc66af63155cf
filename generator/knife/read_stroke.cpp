#include "generator/knife/read_stroke.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/nearest_name.h"
#include "generator/knife/stroke.h"
#include "generator/template/read/sketch.h"
#include "generator/template/read/sketch_fault.h"
#include "generator/text/svg_drawing.h"
#include "generator/text/svg_path.h"

namespace pomona {

namespace {

constexpr std::size_t max_bytes = std::size_t{64} << 20;
constexpr const char* too_large = "keep the paths, and link pictures instead of embedding them";
constexpr std::size_t max_points = 4096;

/// Reports a fault of the drawing as a whole at its first line.
/// \throws Error (bad_data) as BadSketch says, whose message begins with its place in the file.
Sketch drawing_of(std::string_view svg, const std::string& file) {
  try {
    return Sketch(parse_svg(svg, file), {});
  } catch (const BadSketch& bad) {
    throw Error(ExitStatus::bad_data, {placed_fault(bad, file)});
  }
}

/// The path, shape or clone with this id or label, preferably one that is drawn.
/// \throws Error (bad_data) if there are several, or none, with the most similar name.
const SvgElement& element_called(const SvgDrawing& drawing, const std::string& id) {
  std::vector<std::string> known;
  std::vector<const SvgElement*> found;
  for (const SvgElement& element : drawing.elements) {
    if (!element.d && element.tag != "use") continue;
    if (element.id == id || element.label == id) found.push_back(&element);
    if (!element.id.empty()) known.push_back(element.id);
    if (!element.label.empty()) known.push_back(element.label);
  }
  const auto end_of_drawn =
      std::stable_partition(found.begin(), found.end(), [](const SvgElement* element) { return element->drawn; });
  if (end_of_drawn != found.begin()) found.erase(end_of_drawn, found.end());
  if (found.size() > 1) {
    throw Error(ExitStatus::bad_data, {{{drawing.file, found[1]->line, found[1]->column, ""},
                                        "\"" + id.substr(0, 200) + "\" is drawn " + std::to_string(found.size()) +
                                            " times, first at " + place_of(drawing, *found[0]),
                                        "delete all but one, or give each a name of its own"}});
  }
  if (!found.empty()) return *found.front();
  const std::optional<std::string> meant = nearest_name(id, known);
  const std::string hint =
      meant ? "did you mean \"" + *meant + "\"?" : "name a path in Inkscape's Objects dialog, or by its id";
  throw Error(ExitStatus::bad_data,
              {{{drawing.file, 1, 1, ""}, "there is no path \"" + id.substr(0, 200) + "\"", hint}});
}

/// Reports a fault of the path at its place in the file.
struct Complaint {
  SourcePlace place;
  std::string name;

  [[noreturn]] void operator()(const std::string& what, const std::string& hint) const {
    throw Error(ExitStatus::bad_data, {{place, name + " " + what, hint}});
  }
};

/// The one curve of the path, or of a clone's original, cleaned.
Curve curve_of(const Sketch& sketch, const SvgElement& element, double scale, const Complaint& fail) {
  if (!element.fault.empty()) fail(element.fault, "");
  const std::vector<Sketch::Placed> shapes = sketch.shapes_of(element);
  if (shapes.size() != 1) fail("is a clone of " + std::to_string(shapes.size()) + " shapes", "clone one path");
  SvgPathOptions options;
  options.unit = scale;
  options.transform = shapes.front().to_page;
  std::vector<Curve> curves = parse_svg_path(*shapes.front().element->d, options);
  // A subpath of one point is not a curve.
  if (curves.size() > 1) std::erase_if(curves, [](const Curve& curve) { return cleaned(curve.points).size() < 2; });
  if (curves.empty()) fail("is empty", "draw a line");
  if (curves.size() != 1) fail("is not one line but " + std::to_string(curves.size()), "break the path apart");
  Curve curve{cleaned(curves[0].points), curves[0].closed};
  if (curve.points.size() < 2) fail("has no length", "draw a line");
  if (curve.points.size() > max_points) fail("has more than 4096 points", "simplify the path");
  return curve;
}

/// Finds the path and passes it to `check`, with a function that reports faults; all errors name the file and the
/// place.
template <typename Check>
Curve curve_called(const std::string& id, std::string_view svg, const std::string& file, double scale,
                   const std::string& what, const Check& check) {
  const Sketch sketch = drawing_of(svg, file);
  const SvgElement& element = element_called(sketch.drawing(), id);
  const Complaint fail{{file, element.line, element.column, ""}, what + " \"" + id.substr(0, 200) + "\""};
  try {
    Curve curve = curve_of(sketch, element, scale, fail);
    check(curve, fail);
    return curve;
  } catch (const BadPath& bad) {
    fail(bad.what(), bad.hint);
  } catch (const BadSketch& bad) {
    fail(std::string(": ") + bad.what(), bad.hint);
  }
}

void check_stroke(const Curve& curve, const Complaint& fail) {
  if (curve.closed) fail("is closed", "a knife goes in on one side and out on the other: open the path");
  if (crosses_itself(curve.points, {0, 0}, 0)) fail("crosses itself", "a knife's stroke must not meet itself");
}

/// Puts points next to the axis onto it exactly, and refuses what cannot be revolved.
void check_profile(Curve& curve, const Complaint& fail) {
  // Puts points onto the axis that are nearer to it than a ten thousandth of the profile's extent.
  glm::dvec2 low = curve.points.front(), high = low;
  for (const glm::dvec2& p : curve.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double near = 1e-4 * glm::length(high - low);
  for (glm::dvec2& p : curve.points) p.x = std::fabs(p.x) <= near ? 0 : p.x;

  // Only the ends of an open profile may lie on the axis, and nothing beyond it.
  const std::size_t ends = curve.closed ? 0 : 1;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const double x = curve.points[i].x;
    if (x < 0) fail("crosses its axis, the drawing's x = 0", "draw it to the right of the axis");
    if (x == 0 && i >= ends && i + ends < curve.points.size()) {
      fail("meets its axis, the drawing's x = 0, on its way", "only the ends of an open path may lie on it");
    }
  }
  if (curve.points.size() < 3 && (curve.closed || high.x <= 0)) fail("encloses nothing", "draw it beside the axis");

  // The ends of an open profile are joined to the axis by level lines, which must not meet the profile either.
  Curve whole = curve.closed ? curve : joined_to_axis(curve);
  whole.closed = true;
  if (whole.points.size() < 3 || !is_simple(whole)) {
    fail("crosses itself", "a profile, its ends joined to the axis, must not meet itself");
  }
}

}  // namespace

std::vector<glm::dvec2> parse_stroke(std::string_view svg, const std::string& file, const std::string& id,
                                     double scale) {
  return curve_called(id, svg, file, scale, "stroke", check_stroke).points;
}

Curve parse_profile(std::string_view svg, const std::string& file, const std::string& id, double scale) {
  return curve_called(id, svg, file, scale, "profile", check_profile);
}

std::vector<glm::dvec2> read_stroke(const std::filesystem::path& file, const std::string& id, double scale) {
  return parse_stroke(file_bytes(file, max_bytes, too_large), file.string(), id, scale);
}

Curve read_profile(const std::filesystem::path& file, const std::string& id, double scale) {
  return parse_profile(file_bytes(file, max_bytes, too_large), file.string(), id, scale);
}

}  // namespace pomona
