#include "generator/surface/sweep/profile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

/// The curve without points that repeat their predecessor; a closed curve's first point is repeated at the end.
std::vector<glm::dvec2> distinct_points(const Curve& curve) {
  std::vector<glm::dvec2> points;
  for (const glm::dvec2& p : curve.points) {
    if (points.empty() || p != points.back()) points.push_back(p);
  }
  if (curve.closed && points.front() != points.back()) points.push_back(points.front());
  return points;
}

/// Indices of the two ends and of the sharpest corners, at most `max` corners, ascending.
std::vector<std::size_t> stretch_ends(const std::vector<glm::dvec2>& points, std::size_t max) {
  // Flattened smooth curves turn by a few degrees per point; hand-drawn corners by much more.
  constexpr double cos_of_35_degrees = 0.819;
  struct Corner {
    double straightness;
    std::size_t at;
  };
  std::vector<Corner> corners;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double cos_turn =
        glm::dot(glm::normalize(points[i] - points[i - 1]), glm::normalize(points[i + 1] - points[i]));
    if (cos_turn < cos_of_35_degrees) corners.push_back({cos_turn, i});
  }
  std::stable_sort(corners.begin(), corners.end(),
                   [](const Corner& l, const Corner& r) { return l.straightness < r.straightness; });
  if (corners.size() > max) corners.resize(max);

  std::vector<std::size_t> ends{0, points.size() - 1};
  for (const Corner& corner : corners) ends.push_back(corner.at);
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// Shares `steps` out in proportion to the lengths, at least one each, the remainder to the largest fractions.
std::vector<int> shared_out(int steps, const std::vector<double>& lengths) {
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const int spare = steps - static_cast<int>(lengths.size());
  std::vector<int> count(lengths.size(), 1);
  std::vector<double> fraction(lengths.size(), 0.0);
  int left = spare;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double wanted = whole > 0 ? spare * lengths[i] / whole : 0;
    const int floor = static_cast<int>(wanted);
    count[i] += floor;
    left -= floor;
    fraction[i] = wanted - floor;
  }
  std::vector<std::size_t> order(lengths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) { return fraction[l] > fraction[r]; });
  for (int i = 0; i < left; ++i) ++count[order[static_cast<std::size_t>(i) % order.size()]];
  return count;
}

void settle_on_axis(Profile& profile) {
  double widest = 0;
  for (const glm::dvec2& p : profile.points) widest = std::max(widest, p.x);
  for (glm::dvec2& p : profile.points) {
    if (std::fabs(p.x) <= 1e-9 * widest) p.x = 0;
  }
  profile.starts_on_axis = !profile.closed && profile.points.front().x == 0;
  profile.ends_on_axis = !profile.closed && profile.points.back().x == 0;
}

/// The point in the middle of the run of points as high as `at`, as a new point of the loop if need be.
std::size_t middle_of_flat_run(Curve& loop, std::size_t at) {
  const std::size_t n = loop.points.size();
  const double y = loop.points[at].y;
  std::size_t before = at, after = at;
  while (loop.points[(before + n - 1) % n].y == y && (before + n - 1) % n != at) before = (before + n - 1) % n;
  while (loop.points[(after + 1) % n].y == y && (after + 1) % n != before) after = (after + 1) % n;
  if (before == after) return at;

  const glm::dvec2 middle = 0.5 * (loop.points[before] + loop.points[after]);
  std::size_t edge = before;
  const double reach = glm::distance(loop.points[before], middle);
  while (glm::distance(loop.points[before], loop.points[(edge + 1) % n]) < reach) edge = (edge + 1) % n;
  loop.points.insert(loop.points.begin() + static_cast<std::ptrdiff_t>(edge) + 1, middle);
  return edge + 1;
}

std::size_t lowest(const Curve& loop) {
  const auto found = std::min_element(loop.points.begin(), loop.points.end(),
                                      [](const glm::dvec2& l, const glm::dvec2& r) { return l.y < r.y; });
  return static_cast<std::size_t>(found - loop.points.begin());
}

std::size_t highest(const Curve& loop) {
  const auto found = std::max_element(loop.points.begin(), loop.points.end(),
                                      [](const glm::dvec2& l, const glm::dvec2& r) { return l.y < r.y; });
  return static_cast<std::size_t>(found - loop.points.begin());
}

double mean_radius(const Curve& arc) {
  double sum = 0;
  for (const glm::dvec2& p : resampled(arc, 64).points) sum += p.x;
  return sum / 64;
}

}  // namespace

Profile sampled_profile(const Curve& vertical, int count) {
  // Divides the curve at its corners, which get points of their own.
  const std::vector<glm::dvec2> points = distinct_points(vertical);
  const int steps = vertical.closed ? count : count - 1;
  const std::vector<std::size_t> ends = stretch_ends(points, static_cast<std::size_t>(steps / 2));
  std::vector<Curve> stretches;
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const auto from = points.begin() + static_cast<std::ptrdiff_t>(ends[i]);
    const auto to = points.begin() + static_cast<std::ptrdiff_t>(ends[i + 1]) + 1;
    stretches.push_back({{from, to}, false});
    lengths.push_back(length(stretches.back()));
  }

  // Samples each stretch evenly.
  const std::vector<int> share_of = shared_out(steps, lengths);
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  Profile profile;
  profile.closed = vertical.closed;
  double before = 0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Curve even = resampled(stretches[i], share_of[i] + 1);
    for (int k = 0; k < share_of[i]; ++k) {
      profile.points.push_back(even.points[static_cast<std::size_t>(k)]);
      profile.share.push_back((before + lengths[i] * k / share_of[i]) / whole);
    }
    before += lengths[i];
  }
  if (!vertical.closed) {
    profile.points.push_back(points.back());
    profile.share.push_back(1);
  }
  settle_on_axis(profile);
  return profile;
}

double outward(const Profile& profile) {
  const std::vector<glm::dvec2>& p = profile.points;
  double sum = 0;
  for (std::size_t i = 0; i + (profile.closed ? 0 : 1) < p.size(); ++i) {
    const glm::dvec2 &a = p[i], &b = p[(i + 1) % p.size()];
    sum += (b.y - a.y) * (a.x * a.x + a.x * b.x + b.x * b.x) / 3;
  }
  return sum;
}

ProfileArcs sampled_arcs(const Curve& closed_vertical, int count) {
  // Turns the loop so that it starts at its bottom, then finds its top.
  Curve loop = counter_clockwise(closed_vertical);
  const std::size_t bottom = middle_of_flat_run(loop, lowest(loop));
  std::rotate(loop.points.begin(), loop.points.begin() + static_cast<std::ptrdiff_t>(bottom), loop.points.end());
  const std::size_t top = middle_of_flat_run(loop, highest(loop));

  const auto middle = loop.points.begin() + static_cast<std::ptrdiff_t>(top);
  Curve right{{loop.points.begin(), middle + 1}, false};
  Curve left{{middle, loop.points.end()}, false};
  left.points.push_back(loop.points.front());
  std::reverse(left.points.begin(), left.points.end());
  if (mean_radius(left) > mean_radius(right)) std::swap(left, right);

  // The mean of even steps and of the heights of a circle at even angles.
  ProfileArcs arcs;
  for (int j = 0; j < count; ++j) {
    const double t = static_cast<double>(j) / (count - 1);
    const double share = j == 0 ? 0 : j == count - 1 ? 1 : 0.5 * (t + 0.5 * (1 - reproducible::cos(pi * t)));
    arcs.share.push_back(share);
    arcs.inner.push_back(point_at(left, share));
    arcs.outer.push_back(point_at(right, share));
  }
  return arcs;
}

}  // namespace pomona
