// The one file that knows lib2geom, which reads the path data; curves are flattened here.
#include "generator/text/svg_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <2geom/path-sink.h>
#include <2geom/svg-path-parser.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr double largest_coordinate = 1e6;  // SVG units; beyond it a drawing is a mistake
constexpr double largest_placed = 1e9;      // after transforms

/// An elliptical arc as SVG states it, and the same by its centre (SVG 1.1, appendix F.6.5).
struct EndpointArc {
  glm::dvec2 from, to, radii;
  double turn = 0;  ///< angle of the ellipse's x axis, radians
  bool large = false, sweep = false;
};

class CenteredArc {
 public:
  explicit CenteredArc(const EndpointArc& arc)
      : cos_(reproducible::cos(arc.turn)), sin_(reproducible::sin(arc.turn)), radii_(glm::abs(arc.radii)) {
    const glm::dvec2 half = 0.5 * (arc.from - arc.to);
    const glm::dvec2 p(cos_ * half.x + sin_ * half.y, cos_ * half.y - sin_ * half.x);

    // Radii that are too small to span the ends grow until they do.
    const double reach = glm::dot(p / radii_, p / radii_);
    if (reach > 1) radii_ *= std::sqrt(reach);

    const glm::dvec2 q(radii_.x * p.y, radii_.y * p.x);
    const double rest = std::max(0.0, radii_.x * radii_.x * radii_.y * radii_.y - glm::dot(q, q));
    const double scale = (arc.large == arc.sweep ? -1 : 1) * std::sqrt(rest / glm::dot(q, q));
    const glm::dvec2 center(scale * radii_.x * p.y / radii_.y, -scale * radii_.y * p.x / radii_.x);
    center_ = turned(center) + 0.5 * (arc.from + arc.to);

    const glm::dvec2 start = (p - center) / radii_, end = (-p - center) / radii_;
    start_ = reproducible::atan2(start.y, start.x);
    angle_ = reproducible::atan2(end.y, end.x) - start_;
    if (arc.sweep && angle_ < 0) angle_ += 2 * pi;
    if (!arc.sweep && angle_ > 0) angle_ -= 2 * pi;
  }

  glm::dvec2 at(double t) const {
    const double a = start_ + t * angle_;
    return center_ + turned({radii_.x * reproducible::cos(a), radii_.y * reproducible::sin(a)});
  }

  double angle() const { return angle_; }
  double largest_radius() const { return std::max(radii_.x, radii_.y); }

 private:
  glm::dvec2 turned(const glm::dvec2& p) const { return {cos_ * p.x - sin_ * p.y, sin_ * p.x + cos_ * p.y}; }

  double cos_, sin_;
  glm::dvec2 radii_, center_{0};
  double start_ = 0, angle_ = 0;
};

/// Makes polylines of a path's segments.
class Flattener {
 public:
  explicit Flattener(const SvgPathOptions& options)
      : options_(options), scale_(options.unit * largest_stretch(options.transform)) {}

  void move_to(const Geom::Point& p) {
    finish();
    start_ = checked(p);
    begin();
  }

  void line_to(const Geom::Point& p) {
    begin();
    add(checked(p));
  }

  void quadratic_to(const Geom::Point& c, const Geom::Point& p) {
    begin();
    // The same curve, one degree higher.
    const glm::dvec2 a = current_, q = checked(c), b = checked(p);
    add_cubic(a, a + (q - a) * (2.0 / 3), b + (q - b) * (2.0 / 3), b);
  }

  void cubic_to(const Geom::Point& c0, const Geom::Point& c1, const Geom::Point& p) {
    begin();
    add_cubic(current_, checked(c0), checked(c1), checked(p));
  }

  void arc_to(const Geom::Point& size, double angle, bool large, bool sweep, const Geom::Point& p) {
    begin();
    const glm::dvec2 to = checked(p);
    const glm::dvec2 radii = checked(size);
    if (to == current_) return;
    if (radii.x == 0 || radii.y == 0) return add(to);
    const CenteredArc arc({current_, to, radii, angle, large, sweep});
    // A chord over the angle a is r (1 - cos(a / 2)) < r a^2 / 8 from its arc.
    const double steps = std::fabs(arc.angle()) * std::sqrt(arc.largest_radius() * scale_ / (8 * options_.tolerance));
    const std::size_t count = checked_steps(steps);
    for (std::size_t i = 1; i < count; ++i) add(arc.at(static_cast<double>(i) / static_cast<double>(count)));
    add(to);
  }

  void close() {
    if (!open_) return;
    curves_.back().closed = true;
    current_ = start_;
    open_ = false;
  }

  void finish() { open_ = false; }

  std::vector<Curve> curves() && {
    for (Curve& curve : curves_) {
      std::vector<glm::dvec2>& points = curve.points;
      if (points.size() < 2 || points.front() != points.back()) continue;
      curve.closed = true;
      points.pop_back();
    }
    return std::move(curves_);
  }

 private:
  static glm::dvec2 checked(const Geom::Point& p) {
    const bool fits = std::fabs(p.x()) <= largest_coordinate && std::fabs(p.y()) <= largest_coordinate;
    if (!fits) throw BadPath("holds a coordinate beyond 1 000 000", "check its numbers");
    return {p.x(), p.y()};
  }

  std::size_t checked_steps(double steps) const {
    if (!(steps < static_cast<double>(options_.max_points))) {
      throw BadPath("has a curve too long to draw", "check the unit and the path's numbers");
    }
    return static_cast<std::size_t>(std::max(1.0, std::ceil(steps)));
  }

  /// Starts a curve where none is open: at first, and after a Z that no M follows.
  void begin() {
    if (open_) return;
    open_ = true;
    curves_.emplace_back();
    add(start_);
  }

  /// Even steps of the parameter, as many as Wang's bound (second differences) requires: equal segments give equal
  /// points.
  void add_cubic(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    const double bend = std::max(glm::length(a - 2.0 * b + c), glm::length(b - 2.0 * c + d)) * scale_;
    const std::size_t count = checked_steps(std::sqrt(0.75 * bend / options_.tolerance));
    for (std::size_t i = 1; i < count; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(count), s = 1 - t;
      add(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
    }
    add(d);
  }

  void add(const glm::dvec2& p) {
    current_ = p;
    // lib2geom scales the radii of arcs with the C library's sine, whose last bits differ between processors; rounding
    // to a grid of a nanometre removes these. It also puts points on the axis exactly there, and equal points at one
    // place.
    const auto snapped = [](double metres) { return std::floor(metres * 0x1p30 + 0.5) * 0x1p-30; };
    const glm::dvec2 placed = options_.transform(p);
    const bool fits = std::fabs(placed.x) <= largest_placed && std::fabs(placed.y) <= largest_placed;
    if (!fits) throw BadPath("is moved too far by its transforms", "ungroup it, or draw it anew");
    const glm::dvec2 point(snapped(placed.x * options_.unit), snapped(-placed.y * options_.unit));
    std::vector<glm::dvec2>& points = curves_.back().points;
    if (!points.empty() && points.back() == point) return;
    if (++count_ > options_.max_points) {
      throw BadPath("flattens to more than " + std::to_string(options_.max_points) + " points", "draw it simpler");
    }
    points.push_back(point);
  }

  SvgPathOptions options_;
  double scale_;  ///< the most metres that a unit of the path's coordinates spans
  std::vector<Curve> curves_;
  glm::dvec2 start_{0}, current_{0};
  bool open_ = false;
  std::size_t count_ = 0;
};

/// Passes what lib2geom reads to a Flattener. Its parser leaks memory when a sink throws, so this keeps the first fault
/// and ignores the rest of the path.
class Listener final : public Geom::PathSink {
 public:
  explicit Listener(const SvgPathOptions& options) : flattener_(options) {}

  void moveTo(const Geom::Point& p) override {
    guarded([&] { flattener_.move_to(p); });
  }
  void lineTo(const Geom::Point& p) override {
    guarded([&] { flattener_.line_to(p); });
  }
  void quadTo(const Geom::Point& c, const Geom::Point& p) override {
    guarded([&] { flattener_.quadratic_to(c, p); });
  }
  void curveTo(const Geom::Point& c0, const Geom::Point& c1, const Geom::Point& p) override {
    guarded([&] { flattener_.cubic_to(c0, c1, p); });
  }
  void arcTo(Geom::Coord rx, Geom::Coord ry, Geom::Coord angle, bool large, bool sweep, const Geom::Point& p) override {
    guarded([&] { flattener_.arc_to({rx, ry}, angle, large, sweep, p); });
  }
  void closePath() override { flattener_.close(); }
  void flush() override { flattener_.finish(); }
  using Geom::PathSink::feed;

  std::vector<Curve> curves() && {
    if (fault_) throw BadPath(*fault_);
    return std::move(flattener_).curves();
  }

 private:
  template <typename Step>
  void guarded(const Step& step) {
    if (fault_) return;
    try {
      step();
    } catch (const BadPath& bad) {
      fault_ = bad;
    }
  }

  Flattener flattener_;
  std::optional<BadPath> fault_;
};

/// lib2geom does not say what is wrong; this names a stray character.
void check_characters(std::string_view data) {
  constexpr std::string_view allowed = "MmZzLlHhVvCcSsQqTtAa0123456789+-.eE, \t\r\n";
  const std::size_t stray = data.find_first_not_of(allowed);
  if (stray == std::string_view::npos) return;
  const char c = data[stray];
  const std::string shown = c > ' ' && c < 127 ? std::string("\"") + c + "\"" : std::string("a strange character");
  throw BadPath("is not SVG path data: " + shown + " after " + std::to_string(stray) + " characters",
                "copy the d attribute of an SVG path, as in \"M 0 40 C 20 40 30 25 30 0\"");
}

}  // namespace

std::vector<Curve> parse_svg_path(std::string_view data, const SvgPathOptions& options) {
  check_characters(data);
  Listener listener(options);
  try {
    Geom::SVGPathParser parser(listener);
    parser.setZSnapThreshold(0);
    parser.parse(std::string(data));
  } catch (const std::exception&) {
    throw BadPath("is not SVG path data: a command or a number is missing or out of place",
                  "every letter needs its numbers: two for M and L, six for C, four for S and Q, seven for A");
  }
  return std::move(listener).curves();
}

}  // namespace pomona
