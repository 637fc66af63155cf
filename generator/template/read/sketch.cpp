#include "generator/template/read/sketch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/template/read/sketch_words.h"
#include "generator/text/svg_path.h"

namespace pomona {

namespace {

constexpr int deepest_clone = 16;
constexpr std::size_t max_visits = 100000;  // limit of visited elements for one name, clones included

/// The text behind the word in "scale 60mm".
std::string length_in(std::string_view name) {
  name.remove_prefix(5);
  while (!name.empty() && std::string_view(" -_:=").find(name.front()) != std::string_view::npos) name.remove_prefix(1);
  return std::string(name);
}

glm::dvec2 middle_of_box(const Curve& curve) {
  glm::dvec2 low = curve.points.front(), high = low;
  for (const glm::dvec2& p : curve.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return 0.5 * (low + high);
}

}  // namespace

Sketch::Sketch(SvgDrawing drawing, std::optional<double> unit) : drawing_(std::move(drawing)), unit_(unit) {
  for (const SvgElement& element : drawing_.elements) {
    if (!element.id.empty()) by_id_.try_emplace(element.id, &element);
  }
  views_ = {find_view(SketchView::side), find_view(SketchView::top)};
  for (const SketchView view : {SketchView::side, SketchView::top}) {
    View& found = views_[view == SketchView::side ? 0 : 1];
    try {
      if (found.layer) found.frame = find_frame(view);
    } catch (const BadSketch& bad) {
      found.fault = bad;  // reported when a curve needs this view
    }
  }
}

// ---- Shapes ----

std::string Sketch::called(const SvgElement& element) const {
  const std::string& name = !element.label.empty() ? element.label : !element.id.empty() ? element.id : element.tag;
  return quoted_name(name) + " (" + place_of(drawing_, element) + ")";
}

std::string Sketch::called(const Placed& shape) const { return called(shape.clone ? *shape.clone : *shape.element); }

/// Clones may repeat clones, so count all visits, not only what is found.
struct Sketch::Walk {
  std::vector<Placed> found;
  std::size_t visits = 0;
};

void Sketch::visit_original(const SvgElement& clone, const Placed& from, int depth, Walk& walk) const {
  const std::string what = called(clone);
  const auto found = clone.href.starts_with("#") ? by_id_.find(clone.href.substr(1)) : by_id_.end();
  if (found == by_id_.end()) throw BadSketch(what + " is a clone of nothing", "unlink it, or draw it anew");
  const SvgElement& original = *found->second;

  // The original, moved into the clone's place.
  const auto out_of_there = inverse(original.around);
  if (!out_of_there) throw BadSketch(what + " repeats what a transform flattens", "draw it anew");
  const SvgTransform moved = from.to_page * clone.to_page * translation(clone.position) * *out_of_there;
  visit(original, {&original, moved, from.clone ? from.clone : &clone}, depth + 1, walk);
}

/// \param from the transform of the element, and the clone that shows it.
void Sketch::visit(const SvgElement& element, const Placed& from, int depth, Walk& walk) const {
  const std::string what = called(element);
  if (!element.fault.empty()) {
    throw BadSketch(what + " " + element.fault, "ungroup it, or draw it anew where nothing moves it");
  }
  if (depth > deepest_clone) throw BadSketch(what + " is a clone of itself", "unlink the clone (Edit > Clone)");
  if (++walk.visits > max_visits)
    throw BadSketch(what + " repeats too many shapes", "unlink its clones (Edit > Clone)");
  if (element.d) walk.found.push_back({&element, from.to_page * element.to_page, from.clone});
  if (element.tag == "use") visit_original(element, from, depth, walk);

  if (element.tag != "g" && element.tag != "symbol" && element.tag != "a") return;
  const auto index = static_cast<std::size_t>(&element - drawing_.elements.data());
  for (std::size_t i = index + 1; i < element.end; i = drawing_.elements[i].end) {
    visit(drawing_.elements[i], from, depth, walk);
  }
}

std::vector<Sketch::Placed> Sketch::shapes_of(const SvgElement& element) const {
  Walk walk;
  visit(element, {&element, {}}, 0, walk);
  return std::move(walk.found);
}

Sketch::Placed Sketch::shape_of(SketchView view, const std::string& name) const {
  const SvgElement& element = find(view, name);
  const std::vector<Placed> shapes = shapes_of(element);
  const std::string what = called(element);
  if (shapes.empty()) {
    throw BadSketch(what + " is no curve but <" + element.tag.substr(0, 40) + ">",
                    "draw it with the pen, or turn it into a path (Path > Object to Path)");
  }
  if (shapes.size() > 1) {
    throw BadSketch(what + " is a group of " + std::to_string(shapes.size()) + " curves where one is needed",
                    "name one of them, or join them");
  }
  return shapes.front();
}

Curve Sketch::on_page(const Placed& shape) const {
  const std::string what = called(shape);
  try {
    // Inkscape's unit is about a millimetre; nobody draws a hundredth of it.
    std::vector<Curve> curves =
        parse_svg_path(*shape.element->d, {.unit = 1, .tolerance = 1e-2, .transform = shape.to_page});
    Curve all;
    for (Curve& curve : curves) {
      if (curves.size() == 1) all.closed = curve.closed;
      for (const glm::dvec2& p : curve.points) all.points.push_back({p.x, -p.y});
    }
    if (all.points.empty()) throw BadSketch(what + " has no points", "draw it");
    return all;
  } catch (const BadPath& bad) {
    throw BadSketch(what + " " + bad.what(), bad.hint);
  }
}

// ---- Views ----

SvgTransform Sketch::side_axis() const {
  const Placed shape = shape_of(SketchView::side, "axis");
  const Curve line = on_page(shape);
  glm::dvec2 low = line.points.front(), high = line.points.back();
  if (low.y < high.y) std::swap(low, high);
  const double length = glm::length(high - low);
  const glm::dvec2 along = (low - high) / length;  // downwards, as y
  if (!(length > 0) || std::fabs(along.x) > along.y) {
    throw BadSketch(called(shape) + " does not stand upright",
                    "draw the axis of the side view as a line from the bottom of the fruit to its top");
  }
  const SvgTransform upright{along.y, along.x, -along.x, along.y, 0, 0};
  return upright * translation(-low);
}

glm::dvec2 Sketch::top_axis() const {
  const SvgElement& element = find(SketchView::top, "axis");
  const std::vector<Placed> shapes = shapes_of(element);
  if (shapes.size() == 1 && shapes[0].element->center) return shapes[0].to_page(*shapes[0].element->center);
  Curve all;  // all lines together, as of a cross
  for (const Placed& shape : shapes) {
    constexpr std::size_t max_points = 10'000;  // clones of clones may have any number
    const Curve curve = on_page(shape);
    if (all.points.size() + curve.points.size() > max_points)
      throw BadSketch(called(element) + " has too many points", "draw a small circle where the axis is");
    all.points.insert(all.points.end(), curve.points.begin(), curve.points.end());
  }
  if (all.points.empty()) {
    throw BadSketch(called(element) + " has no shape", "draw a small circle where the axis is");
  }
  return middle_of_box(all);
}

const SvgElement* Sketch::find_scale(SketchView view) const {
  const auto& named = view_of(view).named;
  const SvgElement* scale = nullptr;
  for (auto at = named.lower_bound("scale"); at != named.end() && at->first.starts_with("scale"); ++at) {
    // "scale 60mm", or without its length; but "outer scale" and "scales" may be curves of an onion.
    const std::string rest = length_in(at->first);
    if (!rest.empty() && std::string_view("0123456789.+").find(rest[0]) == std::string_view::npos) continue;
    const SvgElement& found = *at->second.front();
    if (scale || at->second.size() > 1)
      throw BadSketch(called(found) + " is one of several scale lines", "keep one in each view");
    scale = &found;
  }
  return scale;
}

double Sketch::unit_along(const SvgElement& scale) const {
  const bool by_label = plain_name(scale.label).starts_with("scale");
  const std::string length = length_in(by_label ? scale.label : scale.id);
  const std::optional<double> metres = length.ends_with("m") ? parse_length(length) : std::nullopt;
  if (!metres || !(*metres >= 1e-4 && *metres <= 10)) {
    throw BadSketch(called(scale) + " does not say how long it is",
                    "label it with its length, as in \"scale 60mm\"; if it is a curve, give it another name");
  }
  const std::vector<Placed> shapes = shapes_of(scale);
  if (shapes.size() != 1) throw BadSketch(called(scale) + " is not one line", "draw one line of that length");
  const Curve line = on_page(shapes.front());
  const double units = glm::length(line.points.back() - line.points.front());
  if (!(units > 0) || !(*metres / units >= 1e-6 && *metres / units <= 1)) {
    throw BadSketch(called(scale) + " has no length one could measure by",
                    "draw it as a line along something whose length you know");
  }
  return *metres / units;
}

double Sketch::unit_of(SketchView view) const {
  if (const SvgElement* scale = find_scale(view)) return unit_along(*scale);
  if (unit_) return *unit_;
  if (drawing_.page_unit) return *drawing_.page_unit;
  throw BadSketch(
      "does not say how large the fruit is: " + drawing_.file + " has no real size",
      "draw a line along the fruit and label it with its length, as in \"scale 60mm\", or write unit = \"1mm\"");
}

Sketch::Frame Sketch::frame_of(SketchView view) const {
  const View& found = view_of(view);
  if (found.fault) throw *found.fault;
  return *found.frame;
}

Sketch::Frame Sketch::find_frame(SketchView view) const {
  const double unit = unit_of(view);
  if (view == SketchView::side) return {side_axis(), unit};
  const glm::dvec2 axis = top_axis();
  const double turn = turn_of_folds(axis), c = reproducible::cos(turn), s = reproducible::sin(turn);
  return {SvgTransform{c, s, -s, c, 0, 0} * translation(-axis), unit};
}

std::optional<SvgTransform> Sketch::to_metres(SketchView view) const {
  const std::optional<Frame>& frame = views_[view == SketchView::side ? 0 : 1].frame;
  if (!frame) return {};
  return SvgTransform{frame->unit, 0, 0, -frame->unit, 0, 0} * frame->from_page;
}

// ---- Curves ----

DrawnCurve Sketch::drawn(const Placed& shape, const Frame& frame, std::size_t max_points) const {
  const std::string what = called(shape);
  try {
    const SvgPathOptions options{
        .unit = frame.unit, .max_points = max_points, .transform = frame.from_page * shape.to_page};
    std::vector<Curve> curves = parse_svg_path(*shape.element->d, options);
    // A subpath of one point is not a curve.
    if (curves.size() > 1) std::erase_if(curves, [](const Curve& curve) { return curve.points.size() < 2; });
    if (curves.empty()) throw BadSketch(what + " is empty", "draw it");
    if (curves.size() > 1) {
      throw BadSketch(what + " has several parts", "join them into one curve, or take them apart (Path > Break Apart)");
    }
    return {std::move(curves.front()), "curve " + what};
  } catch (const BadPath& bad) {
    throw BadSketch(what + " " + bad.what(), bad.hint);
  }
}

DrawnCurve Sketch::curve(SketchView view, const std::string& name, std::size_t max_points) const {
  return drawn(shape_of(view, name), frame_of(view), max_points);
}

std::vector<DrawnCurve> Sketch::group(SketchView view, const std::string& name, std::size_t max_points) const {
  const Frame frame = frame_of(view);
  std::vector<DrawnCurve> curves;
  std::size_t points = 0;
  for (const Placed& shape : shapes_of(find(view, name))) {
    curves.push_back(drawn(shape, frame, max_points - std::min(points, max_points)));
    points += curves.back().curve.points.size();
  }
  return curves;
}

std::vector<glm::dvec2> Sketch::page_points(const std::string& name, int count) const {
  const bool in_side = views_[0].layer && views_[0].named.contains(plain_name(name));
  Curve curve = on_page(shape_of(in_side || !views_[1].layer ? SketchView::side : SketchView::top, name));
  if (curve.points.size() < 2) throw BadSketch(quoted_name(name) + " is a dot", "draw a line over the colours");
  curve.closed = false;
  if (curve.points.front().y < curve.points.back().y) std::reverse(curve.points.begin(), curve.points.end());
  return resampled(curve, count).points;
}

}  // namespace pomona
