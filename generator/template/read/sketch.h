// A fruit drawn in an SVG editor over pictures of it (paper, section 4.1, Figures 5 to 7). Two layers hold the two
// views, "side view" and "top view"; in them layers, labels or ids name the curves, the axis, the fold lines and a
// line of known length.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/curve.h"
#include "generator/text/svg_drawing.h"

namespace pomona {

enum class SketchView {
  side,  ///< vertical curves: x = distance from the axis
  top,   ///< horizontal curves: the axis is a point
};

inline const char* name_of(SketchView view) { return view == SketchView::side ? "side view" : "top view"; }

struct DrawnCurve {
  Curve curve;        ///< metres; the axis at x = 0 or at 0,0, y upwards
  std::string title;  ///< its name in messages: curve "skin" (kiwi.svg:12:5)
};

/// A sketch that has been read but not checked. Names ignore case, and spaces, - and _ are the same. All functions
/// throw BadSketch, with the name and the place in the SVG, for what is missing or ambiguous.
class Sketch {
 public:
  /// \param unit metres of one unit of the page, for views without a line of known length ("scale 60mm"); without it
  /// the real size of the page counts.
  Sketch(SvgDrawing drawing, std::optional<double> unit);
  Sketch(Sketch&&) = default;

  /// The curve of this name in a view, in metres. Several subpaths are an error.
  DrawnCurve curve(SketchView view, const std::string& name, std::size_t max_points) const;

  /// Whether the name in this view is a group; group() gives its curves.
  bool is_group(SketchView view, const std::string& name) const;
  std::vector<DrawnCurve> group(SketchView view, const std::string& name, std::size_t max_points) const;

  /// Where the fold lines "fold 1" ... "fold N" run, radians, ascending from +X against the clock; on a grid of a
  /// thousandth of a degree. Empty if none is drawn. Where the first lies below the right, so that the others would
  /// ascend beyond a full turn, the whole view is turned until it lies at the right.
  std::vector<double> fold_angles(int folds) const;

  /// Maps from the page to the metres of curve(); nothing for a view that is missing or has no scale.
  std::optional<SvgTransform> to_metres(SketchView view) const;

  /// A shape with its place; a clone has another place than its original.
  struct Placed {
    const SvgElement* element;
    SvgTransform to_page;
    const SvgElement* clone = nullptr;  ///< the clone that draws it there, if any
  };

  /// The shapes that this path, shape or clone shows, in any layer.
  std::vector<Placed> shapes_of(const SvgElement& element) const;

  /// A curve of either view as `count` points of the page, evenly spaced along it, from the bottom up.
  std::vector<glm::dvec2> page_points(const std::string& name, int count) const;

  const SvgDrawing& drawing() const { return drawing_; }

 private:
  /// How a view lies on the page.
  struct Frame {
    SvgTransform from_page;  ///< the axis at 0,0 and upright; still in units of the page, y downwards
    double unit = 1e-3;      ///< metres of one unit
  };
  struct View {
    const SvgElement* layer = nullptr;
    std::map<std::string, std::vector<const SvgElement*>> named;
    std::optional<Frame> frame;
    std::optional<BadSketch> fault;  ///< why the view has no frame
  };

  View find_view(SketchView view) const;
  const View& view_of(SketchView view) const;
  const SvgElement& find(SketchView view, const std::string& name) const;
  const SvgElement* made_unique(SketchView view, const std::string& name) const;
  [[noreturn]] void fail_missing(SketchView view, const std::string& name) const;
  struct Walk;
  std::string called(const SvgElement& element) const;  ///< "skin" (kiwi.svg:12:5)
  std::string called(const Placed& shape) const;        ///< the same, with the clone
  const SvgElement* outside_the_views(const std::string& name) const;
  bool has_labels() const;
  void visit(const SvgElement& element, const Placed& from, int depth, Walk& walk) const;
  void visit_original(const SvgElement& clone, const Placed& from, int depth, Walk& walk) const;
  Placed shape_of(SketchView view, const std::string& name) const;
  Curve on_page(const Placed& shape) const;
  Frame frame_of(SketchView view) const;
  Frame find_frame(SketchView view) const;
  SvgTransform side_axis() const;
  glm::dvec2 top_axis() const;
  const SvgElement* find_scale(SketchView view) const;
  double unit_along(const SvgElement& scale) const;
  double unit_of(SketchView view) const;
  DrawnCurve drawn(const Placed& shape, const Frame& frame, std::size_t max_points) const;
  int count_folds() const;
  double fold_degrees(int fold, const glm::dvec2& axis) const;
  double turn_of_folds(const glm::dvec2& axis) const;

  SvgDrawing drawing_;
  std::optional<double> unit_;
  std::map<std::string, const SvgElement*> by_id_;
  std::array<View, 2> views_;
};

/// Reads the SVG that a template names.
/// \throws BadSketch, also for a path that leads out of `folder`.
Sketch read_sketch(const std::filesystem::path& folder, const std::string& name, std::optional<double> unit);

/// The same of a text that is not on disk yet, under that name.
Sketch read_sketch(const std::filesystem::path& folder, const std::string& name, std::optional<double> unit,
                   std::string_view svg);

}  // namespace pomona
