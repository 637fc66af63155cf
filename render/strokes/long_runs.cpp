#include "render/strokes/long_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

int rank(LineKind kind) {
  switch (kind) {
    case LineKind::rim:
      return 0;
    case LineKind::contour:
    case LineKind::fold:
    case LineKind::border:
      return 1;
    case LineKind::ridge:
      return 2;
    case LineKind::crease:
      return 3;
    case LineKind::seam:
      return 4;
    case LineKind::inner:
      return 5;
  }
  return 6;
}

double mean_distance(const VisibleRun& run) {
  double sum = 0;
  for (const RunPoint& point : run.points) sum += point.distance;
  return sum / static_cast<double>(run.points.size());
}

/// The direction of the run at a point, over a few pixels; a unit vector, or (0, 0).
glm::dvec2 direction(const VisibleRun& run, std::size_t i) {
  constexpr std::size_t reach = 3;
  const std::size_t last = run.points.size() - 1;
  const glm::dvec2 d = run.points[std::min(i + reach, last)].at - run.points[i > reach ? i - reach : 0].at;
  const double size = glm::length(d);
  return size > 0 ? d / size : glm::dvec2(0);
}

/// Points of the lines so far, by position.
class DrawnPlaces {
 public:
  DrawnPlaces(int width, int height, double cell)
      : cell_(cell), columns_(static_cast<int>(width / cell) + 1), rows_(static_cast<int>(height / cell) + 1) {
    cells_.resize(static_cast<std::size_t>(columns_) * rows_);
  }

  void add(const glm::dvec2& at, const glm::dvec2& way) {
    cells_[static_cast<std::size_t>(row(at.y)) * columns_ + column(at.x)].push_back({at, way});
  }

  /// Whether a line has the same direction within `reach` (at most a cell's side).
  bool has_beside(const glm::dvec2& at, const glm::dvec2& way, double reach) const {
    for (int y = row(at.y - reach); y <= row(at.y + reach); ++y) {
      for (int x = column(at.x - reach); x <= column(at.x + reach); ++x) {
        for (const Place& place : cells_[static_cast<std::size_t>(y) * columns_ + x]) {
          const glm::dvec2 d = place.at - at;
          if (glm::dot(d, d) < reach * reach && std::fabs(glm::dot(place.way, way)) > 0.85) return true;
        }
      }
    }
    return false;
  }

 private:
  struct Place {
    glm::dvec2 at, way;
  };
  int column(double x) const { return static_cast<int>(std::clamp(x / cell_, 0.0, columns_ - 1.0)); }
  int row(double y) const { return static_cast<int>(std::clamp(y / cell_, 0.0, rows_ - 1.0)); }

  double cell_;
  int columns_, rows_;
  std::vector<std::vector<Place>> cells_;
};

/// The stretches of the run without a line beside it, and a little more at each end.
std::vector<VisibleRun> free_stretches(const VisibleRun& run, const DrawnPlaces& drawn, double reach) {
  // Marks where no line lies beside the run; very short stretches follow their neighbours.
  const std::size_t count = run.points.size();
  std::vector<std::uint8_t> keep(count);
  for (std::size_t i = 0; i < count; ++i) {
    keep[i] = drawn.has_beside(run.points[i].at, direction(run, i), reach) ? 0 : 1;
  }
  close_gaps(keep, 1, 2 * reach, run.closed);
  close_gaps(keep, 0, 3 * reach, run.closed);
  if (std::find(keep.begin(), keep.end(), 1) == keep.end()) return {};

  // Kept stretches reach a little into the others, and very short ones are dropped.
  const auto more = static_cast<std::size_t>(1.5 * reach);
  std::vector<std::uint8_t> wider = keep;
  for (std::size_t i = 0; i < count; ++i) {
    if (keep[i] == 0) continue;
    for (std::size_t k = 1; k <= more; ++k) {
      if (run.closed || i >= k) wider[(i + count - k % count) % count] = 1;
      if (run.closed || i + k < count) wider[(i + k) % count] = 1;
    }
  }
  std::vector<VisibleRun> stretches = kept_stretches(run, wider);
  std::erase_if(stretches, [&](const VisibleRun& s) { return static_cast<double>(s.points.size()) < 5 * reach + 2; });
  return stretches;
}

}  // namespace

std::vector<VisibleRun> without_overlaps(std::vector<VisibleRun> runs, std::span<const PenWidths> pens, int width,
                                         int height) {
  std::vector<std::tuple<int, double, std::size_t>> order;
  for (std::size_t i = 0; i < runs.size(); ++i) order.emplace_back(rank(runs[i].kind), mean_distance(runs[i]), i);
  std::sort(order.begin(), order.end());

  double widest = 1;
  for (const PenWidths& pen : pens) widest = std::max(widest, pen.outline);
  DrawnPlaces drawn(width, height, widest);
  std::vector<VisibleRun> kept;
  for (const auto& [of_kind, distance, index] : order) {
    const VisibleRun& run = runs[index];
    const PenWidths& pen = pens[run.instance];
    const double reach = std::max(1.5, is_inner(run.kind) ? 0.6 * pen.outline : 0.45 * pen.outline);
    for (VisibleRun& stretch : free_stretches(run, drawn, std::min(reach, widest))) {
      for (std::size_t i = 0; i < stretch.points.size(); ++i) drawn.add(stretch.points[i].at, direction(stretch, i));
      kept.push_back(std::move(stretch));
    }
  }
  return kept;
}

namespace {

/// An end of a run; `outwards` is the direction in which it would go on.
struct RunEnd {
  std::size_t run = 0;
  bool front = false;
  glm::dvec2 at{0}, onwards{0};
};

RunEnd end_of(const std::vector<VisibleRun>& runs, std::size_t run, bool front) {
  const std::vector<RunPoint>& points = runs[run].points;
  const std::size_t back = std::min<std::size_t>(6, points.size() - 1);
  const glm::dvec2 at = front ? points.front().at : points.back().at;
  const glm::dvec2 d = at - (front ? points[back].at : points[points.size() - 1 - back].at);
  const double size = glm::length(d);
  return {run, front, at, size > 0 ? d / size : glm::dvec2(0)};
}

/// How well two ends continue each other: smaller is better; nothing if they do not.
struct Joint {
  double badness = 0;
  std::size_t a = 0, b = 0;  // 2 run + (front ? 0 : 1)
};

std::vector<Joint> possible_joints(const std::vector<VisibleRun>& runs, double reach) {
  // Sorts ends that may be joined next to each other, and from left to right.
  std::vector<RunEnd> ends;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].closed || runs[i].points.size() < 2) continue;
    for (const bool front : {true, false}) ends.push_back(end_of(runs, i, front));
  }
  const auto group = [&](const RunEnd& e) { return std::tuple(runs[e.run].instance, is_inner(runs[e.run].kind)); };
  std::sort(ends.begin(), ends.end(), [&](const RunEnd& x, const RunEnd& y) {
    return std::tuple(group(x), x.at.x, x.run, x.front) < std::tuple(group(y), y.at.x, y.run, y.front);
  });

  // Two ends that are near and point at each other, within 60 degrees.
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const RunEnd &x = ends[i], &y = ends[j];
      if (group(x) != group(y) || y.at.x - x.at.x > reach) break;
      const double gap = glm::distance(x.at, y.at);
      const double straight = -glm::dot(x.onwards, y.onwards);
      if (gap > reach || straight < 0.5) continue;
      const std::size_t a = 2 * x.run + (x.front ? 0 : 1), b = 2 * y.run + (y.front ? 0 : 1);
      joints.push_back({1 - straight + 0.3 * gap / reach, std::min(a, b), std::max(a, b)});
    }
  }

  // The best first; ties by index.
  std::sort(joints.begin(), joints.end(), [](const Joint& x, const Joint& y) {
    return std::tie(x.badness, x.a, x.b) < std::tie(y.badness, y.a, y.b);
  });
  return joints;
}

}  // namespace

std::vector<VisibleRun> joined_runs(std::vector<VisibleRun> runs, double reach) {
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> partner(2 * runs.size(), none);
  for (const Joint& joint : possible_joints(runs, reach)) {
    if (partner[joint.a] != none || partner[joint.b] != none) continue;
    partner[joint.a] = joint.b;
    partner[joint.b] = joint.a;
  }

  // Starts at the ends that stay ends; the rest are loops.
  std::vector<std::uint8_t> taken(runs.size(), 0);
  std::vector<VisibleRun> result;
  const auto walk = [&](std::size_t entered) {
    VisibleRun line = runs[entered / 2];
    line.points.clear();
    while (taken[entered / 2] == 0) {
      taken[entered / 2] = 1;
      std::vector<RunPoint>& points = runs[entered / 2].points;
      if (entered % 2 == 1) std::reverse(points.begin(), points.end());
      line.points.insert(line.points.end(), points.begin(), points.end());
      const std::size_t next = partner[entered ^ 1];
      if (next == none) break;
      line.closed = taken[next / 2] != 0;
      entered = next;
    }
    result.push_back(std::move(line));
  };
  for (std::size_t end = 0; end < partner.size(); ++end) {
    if (taken[end / 2] == 0 && partner[end] == none) walk(end);
  }
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (taken[run] == 0) walk(2 * run);
  }
  return result;
}

}  // namespace pomona
