#include "render/picture/stroke.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "render/picture/inked_pixels.h"
#include "render/style/noise.h"

namespace pomona {

namespace {

double size_of(const glm::dvec2& v) { return std::sqrt(glm::dot(v, v)); }

double mix(double a, double b, double t) { return a + (b - a) * t; }

/// A line's point with all its attributes.
struct PenPoint {
  glm::dvec2 at{0};
  double opacity = 1;
  double heft = 1;
  glm::dvec3 place{0};
  glm::dvec2 outwards{0};
};

PenPoint blend(const PenPoint& a, const PenPoint& b, double t) {
  return {a.at + (b.at - a.at) * t, mix(a.opacity, b.opacity, t), mix(a.heft, b.heft, t),
          a.place + (b.place - a.place) * t, a.outwards + (b.outwards - a.outwards) * t};
}

PenPoint point_of(const PenLine& line, std::size_t i) {
  PenPoint point{.at = line.points[i], .opacity = line.opacity[i]};
  if (!line.heft.empty()) point.heft = line.heft[i];
  if (!line.place.empty()) point.place = line.place[i];
  if (!line.outwards.empty()) point.outwards = line.outwards[i];
  return point;
}

/// Points about `spacing` apart along the line; a closed line comes back with its first point repeated at the end.
std::vector<PenPoint> evenly_spaced(const PenLine& line, double spacing) {
  // All corners, the first again at the end of a closed line.
  std::vector<PenPoint> corners;
  for (std::size_t i = 0; i < line.points.size(); ++i) corners.push_back(point_of(line, i));
  if (line.closed) corners.push_back(PenPoint(corners.front()));

  // The number of steps follows from the line's length, at least two.
  double total = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) total += size_of(corners[i].at - corners[i - 1].at);
  const int steps = std::max(2, static_cast<int>(std::ceil(total / spacing)));

  // Goes along the line once, with points at equal distances.
  std::vector<PenPoint> even;
  double walked = 0;
  std::size_t i = 1;
  for (int k = 0; k <= steps; ++k) {
    const double wanted = total * k / steps;
    double edge = size_of(corners[i].at - corners[i - 1].at);
    while (i + 1 < corners.size() && walked + edge < wanted) {
      walked += edge;
      ++i;
      edge = size_of(corners[i].at - corners[i - 1].at);
    }
    const double t = edge > 0 ? std::clamp((wanted - walked) / edge, 0.0, 1.0) : 0.0;
    even.push_back(blend(corners[i - 1], corners[i], t));
  }
  return even;
}

/// One pass of (1 2 1) / 4. Open ends stay; a closed line (last point = first) is smoothed across its seam.
void smooth(std::vector<PenPoint>& points, bool closed) {
  const std::vector<PenPoint> old = points;
  const std::size_t last = points.size() - 1;
  const auto blended = [](const PenPoint& a, const PenPoint& b, const PenPoint& c) {
    return PenPoint{(a.at + 2.0 * b.at + c.at) * 0.25, (a.opacity + 2.0 * b.opacity + c.opacity) * 0.25,
                    (a.heft + 2.0 * b.heft + c.heft) * 0.25, b.place,
                    (a.outwards + 2.0 * b.outwards + c.outwards) * 0.25};
  };
  for (std::size_t i = 1; i < last; ++i) points[i] = blended(old[i - 1], old[i], old[i + 1]);
  if (closed) points.front() = points.back() = blended(old[last - 1], old[0], old[1]);
}

/// A loop starts at its upper left and overlaps its start a little.
void begin_upper_left(std::vector<PenPoint>& loop, double overlap, double spacing) {
  loop.pop_back();
  const auto first = std::min_element(
      loop.begin(), loop.end(), [](const PenPoint& a, const PenPoint& b) { return a.at.x + a.at.y < b.at.x + b.at.y; });
  std::rotate(loop.begin(), first, loop.end());
  const auto more = std::min(loop.size(), static_cast<std::size_t>(overlap / spacing) + 1);
  for (std::size_t i = 0; i < more; ++i) loop.push_back(PenPoint(loop[i]));
}

glm::dvec2 normal_at(const std::vector<PenPoint>& points, std::size_t i) {
  const glm::dvec2 d = points[std::min(i + 1, points.size() - 1)].at - points[i > 0 ? i - 1 : 0].at;
  const double size = size_of(d);
  return size > 0 ? glm::dvec2(-d.y, d.x) / size : glm::dvec2(0);
}

double length_of(const PenLine& line) {
  double total = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) total += size_of(line.points[i] - line.points[i - 1]);
  return total;
}

}  // namespace

std::vector<StrokePoint> drawn(const PenLine& line, const PenOptions& options) {
  if (line.points.size() < 2) return {};

  // Distance of points in pixels; smaller on short lines, which smoothing would shrink.
  const double spacing = std::clamp(length_of(line) / 32, 0.25, 1.5);
  std::vector<PenPoint> points = evenly_spaced(line, spacing);
  for (int pass = 0; pass < 3; ++pass) smooth(points, line.closed);
  const double loop = spacing * static_cast<double>(points.size() - 1);
  const double taper = std::min(options.taper, loop / 3);
  if (line.closed) begin_upper_left(points, 0.8 * taper, spacing);

  // The width: the hand's tremble, a heavier line away from the light, tapered ends.
  const double total = spacing * static_cast<double>(points.size() - 1);
  std::vector<StrokePoint> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PenPoint& point = points[i];
    const double s = spacing * static_cast<double>(i);
    const glm::dvec2 normal = normal_at(points, i);
    const double row = 7.31 * line.key + 0.5;
    const glm::dvec3 along = line.place.empty() ? glm::dvec3(s / options.wavelength + 0.3, row, 0.5) : point.place;
    const glm::dvec3 slowly =
        line.place.empty() ? glm::dvec3(s / (1.7 * options.wavelength), row, 0.25) : point.place / 1.7;
    const double tremble = 1.6 * gradient_noise(along, 101);
    const double shade = line.outwards.empty() ? line.weighted_side * glm::dot(normal, options.from_light)
                                               : glm::dot(point.outwards, options.from_light);
    const double end = taper > 0 ? std::min({1.0, s / taper, (total - s) / taper}) : 1.0;
    const double width = options.width * (0.72 + options.wander * tremble + 0.28 * shade);
    const double heavy = std::max(point.heft * std::max(width, 0.25 * options.width), options.min);
    const double radius = 0.5 * heavy * std::sqrt(std::max(end, 0.02));

    // If the outward direction is known, the hand sways along it, whatever the direction of the line.
    const glm::dvec2 side = line.place.empty() ? normal : point.outwards;
    result.push_back({point.at + side * (options.sway * gradient_noise(slowly, 102)), radius, point.opacity});
  }
  return result;
}

InkLayer::InkLayer(int width, PictureRows rows)
    : width_(width),
      rows_(rows),
      samples_(static_cast<std::size_t>(width) * (rows.to - rows.from), 0),
      opacity_(samples_.size(), 0.0f) {}

void InkLayer::draw(const std::vector<StrokePoint>& stroke) {
  for (std::size_t i = 1; i < stroke.size(); ++i) draw_piece(stroke[i - 1], stroke[i]);
}

void InkLayer::draw_piece(const StrokePoint& a, const StrokePoint& b) {
  const auto opacity = static_cast<float>(0.5 * (a.opacity + b.opacity));
  for_inked_pixels(a, b, width_, rows_, [&](int x, int y, std::uint16_t hits) {
    const std::size_t pixel = index_of(x, y);
    samples_[pixel] = static_cast<std::uint16_t>(samples_[pixel] | hits);
    opacity_[pixel] = std::max(opacity_[pixel], opacity);
  });
}

double InkLayer::at(int x, int y) const {
  const std::size_t pixel = index_of(x, y);
  return static_cast<double>(opacity_[pixel]) * std::popcount(samples_[pixel]) / 16.0;
}

}  // namespace pomona
