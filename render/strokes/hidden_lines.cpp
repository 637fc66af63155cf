#include "render/strokes/hidden_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr double beside = 1.25;  // distance from the line, pixels, at which to look for what lies there

/// A line in steps of about a pixel, with the data that decide whether it is visible.
struct SteppedLine {
  VisibleRun run;
  std::vector<double> slope;
  std::vector<std::uint8_t> on_picture;
};

class LineWalker {
 public:
  LineWalker(const IdentityBuffer& buffer, const Lens& lens) : buffer_(buffer), lens_(lens) {}

  SteppedLine stepped(const ObjectLine& line) const;
  bool is_visible(const SteppedLine& line, std::size_t i) const;
  double heft(const VisibleRun& run, const RunPoint& point) const;

 private:
  bool is_near_picture(const glm::dvec3& seen) const {
    const double margin = 0.05 * std::max(buffer_.width, buffer_.height);
    return seen.z > 0 && seen.x > -margin && seen.y > -margin && seen.x < buffer_.width + margin &&
           seen.y < buffer_.height + margin;
  }
  bool is_clear(const glm::dvec2& at, double distance) const {
    return static_cast<double>(buffer_.nearness[buffer_.pixel_at(at)]) * distance <= 1;
  }
  /// Whether a line lies on the visible surface, or before it. Pixels hold the depth at their middles, and a face seen
  /// at a slant comes much nearer within a pixel or two: a line's own face may lie before it by that, another face by
  /// at most three pixels.
  bool lies_on(const glm::dvec2& at, const RunPoint& point, std::uint32_t instance, double slope) const {
    const bool own = buffer_.instance[buffer_.pixel_at(at)] == instance + 1;
    const double slack = 1.5 + (own ? 2 * slope : std::min(2 * slope, 1.5));  // pixels
    return is_clear(at, point.distance - slack * lens_.pixel_size(point.distance));
  }

  const IdentityBuffer& buffer_;
  const Lens& lens_;
};

SteppedLine LineWalker::stepped(const ObjectLine& line) const {
  SteppedLine result{.run = {.points = {}, .closed = line.closed, .kind = line.kind, .instance = line.instance},
                     .slope = {},
                     .on_picture = {}};

  // A closed line has one more edge, from its last point to its first.
  const std::size_t count = line.points.size();
  const std::size_t edges = line.closed ? count : count - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    // An edge on the picture takes steps of at most a pixel; any other takes one.
    const LinePoint &a = line.points[i], &b = line.points[(i + 1) % count];
    const bool seen = is_near_picture(a.seen) && is_near_picture(b.seen);
    const double length = glm::distance(glm::dvec2(a.seen), glm::dvec2(b.seen));
    const int steps = seen ? std::max(1, static_cast<int>(std::ceil(length))) : 1;
    const bool last = !line.closed && i + 1 == edges;

    // An edge leaves its far end to the next one, unless it is the last of an open line.
    for (int k = 0; k < steps + (last ? 1 : 0); ++k) {
      const double t = static_cast<double>(k) / steps;
      const glm::dvec3 at = a.seen + (b.seen - a.seen) * t;
      result.run.points.push_back({.at = glm::dvec2(at),
                                   .distance = at.z,
                                   .own = a.own + (b.own - a.own) * t,
                                   .outwards = a.outwards + (b.outwards - a.outwards) * t,
                                   .opacity = a.opacity + (b.opacity - a.opacity) * t});
      result.slope.push_back(a.slope + (b.slope - a.slope) * t);
      result.on_picture.push_back(seen ? 1 : 0);
    }
  }
  return result;
}

bool LineWalker::is_visible(const SteppedLine& line, std::size_t i) const {
  if (line.on_picture[i] == 0) return false;
  const std::vector<RunPoint>& points = line.run.points;
  const RunPoint& point = points[i];
  if (line.run.kind == LineKind::contour) {
    return is_clear(point.at + beside * point.outwards, point.distance - 3 * lens_.pixel_size(point.distance));
  }
  const glm::dvec2 d = points[std::min(i + 1, points.size() - 1)].at - points[i > 0 ? i - 1 : 0].at;
  const double size = glm::length(d);
  const glm::dvec2 across = size > 0 ? glm::dvec2(-d.y, d.x) * (beside / size) : glm::dvec2(0);
  const auto lies_at = [&](const glm::dvec2& at) { return lies_on(at, point, line.run.instance, line.slope[i]); };
  return lies_at(point.at) || lies_at(point.at + across) || lies_at(point.at - across);
}

double LineWalker::heft(const VisibleRun& run, const RunPoint& point) const {
  if (is_inner(run.kind)) return 1;
  const std::uint32_t behind = buffer_.instance[buffer_.pixel_at(point.at + (beside + 1) * point.outwards)];
  if (behind != run.instance + 1) return 1;
  switch (run.kind) {
    case LineKind::rim:
      return 0.75 * (0.45 + 0.55 * point.opacity);  // finer lines are fainter
    case LineKind::ridge:
      return 0.6;
    default:
      return 0.8;
  }
}

/// Smooths the width from pixel to pixel.
void even_out_heft(std::vector<RunPoint>& points, bool closed) {
  const int count = static_cast<int>(points.size());
  const int reach = std::min(10, (count - 1) / 2);
  std::vector<double> sums{0};
  const auto index = [&](int i) { return closed ? (i + count) % count : std::clamp(i, 0, count - 1); };
  for (int i = -reach; i < count + reach; ++i) sums.push_back(sums.back() + points[index(i)].heft);
  for (int i = 0; i < count; ++i) points[i].heft = (sums[i + 2 * reach + 1] - sums[i]) / (2 * reach + 1);
}

}  // namespace

void close_gaps(std::vector<std::uint8_t>& flags, std::uint8_t value, double min, bool closed) {
  const std::size_t count = flags.size();
  const auto first = std::find(flags.begin(), flags.end(), value);
  if (first == flags.end()) return;

  // From one flag that is set to the next, around the end of a closed line.
  const auto start = static_cast<std::size_t>(first - flags.begin());
  std::size_t before = start;
  for (std::size_t k = start + 1; k <= (closed ? start + count : count - 1); ++k) {
    if (flags[k % count] != value) continue;
    if (static_cast<double>(k - before - 1) < min) {
      for (std::size_t i = before + 1; i < k; ++i) flags[i % count] = value;
    }
    before = k;
  }
}

std::vector<VisibleRun> kept_stretches(const VisibleRun& line, const std::vector<std::uint8_t>& keep) {
  const std::size_t count = line.points.size();
  const auto hidden = std::find(keep.begin(), keep.end(), 0);
  if (hidden == keep.end()) return {line};

  // Starts a closed line where it is hidden.
  const std::size_t start = line.closed ? static_cast<std::size_t>(hidden - keep.begin()) : 0;
  std::vector<VisibleRun> stretches;
  bool open = false;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (start + k) % count;
    if (keep[i] != 0 && !open) stretches.push_back({.points = {}, .kind = line.kind, .instance = line.instance});
    open = keep[i] != 0;
    if (open) stretches.back().points.push_back(line.points[i]);
  }
  return stretches;
}

std::vector<VisibleRun> visible_runs(std::span<const ObjectLine> lines, const IdentityBuffer& buffer, const Lens& lens,
                                     const VisibilityOptions& options) {
  const LineWalker walker(buffer, lens);
  std::vector<VisibleRun> runs;
  for (const ObjectLine& line : lines) {
    if (line.points.size() < 2) continue;
    const SteppedLine stepped = walker.stepped(line);
    std::vector<std::uint8_t> seen(stepped.run.points.size());
    for (std::size_t i = 0; i < seen.size(); ++i) seen[i] = walker.is_visible(stepped, i) ? 1 : 0;
    close_gaps(seen, 1, options.gap, line.closed);
    for (VisibleRun& run : kept_stretches(stepped.run, seen)) {
      if (static_cast<double>(run.points.size()) < options.min) continue;
      for (RunPoint& point : run.points) point.heft = walker.heft(run, point);
      even_out_heft(run.points, run.closed);
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace pomona
