#include "generator/variation/fold_samples.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr int steps_per_fold = 64;   // around the axis
constexpr int points_per_loop = 64;  // within a fold

/// Azimuths as shares of the fold that starts at `from`; the first lies within half a turn of `near`.
PolarCurve canonical(const std::vector<glm::dvec2>& points, double from, double width, double near) {
  PolarCurve curve = to_polar(points);
  const glm::dvec2 ray = polar_point(near, 1);
  const double first = near + reproducible::atan2(cross(ray, points.front()), glm::dot(ray, points.front()));
  const double offset = first - curve.azimuth.front() - from;
  for (double& azimuth : curve.azimuth) azimuth = (azimuth + offset) / width;
  return curve;
}

/// The part of a loop around the axis between its last crossings of two fold lines.
PolarCurve open_sample(const Curve& loop, double from, double width) {
  Curve part;
  part.points = walk(loop, outermost_hit(loop, from), outermost_hit(loop, from + width));
  PolarCurve sample = canonical(resampled(part, steps_per_fold + 1).points, from, width, from);

  // The crossings of a loop that turns back over a fold line may be in the wrong order. Then sample along rays.
  if (std::abs(sample.azimuth.front()) > 1e-6 || std::abs(sample.azimuth.back() - 1) > 1e-6) {
    for (std::size_t i = 0; i < sample.size(); ++i) {
      sample.azimuth[i] = static_cast<double>(i) / steps_per_fold;
      sample.radius[i] = outermost_hit(loop, from + width * sample.azimuth[i]).radius;
    }
  }
  sample.azimuth.front() = 0;
  sample.azimuth.back() = 1;
  return sample;
}

PolarCurve closed_sample(const Curve& loop, double from, double width) {
  const Curve even = resampled(counter_clockwise(loop), points_per_loop);
  return canonical(even.points, from, width, from + 0.5 * width);
}

/// The sample in a pie of angle 2 pi / folds around +X.
std::vector<glm::dvec2> in_pie(const PolarCurve& sample, std::size_t folds) {
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    points.push_back(polar_point((sample.azimuth[i] - 0.5) * 2 * pi / static_cast<double>(folds), sample.radius[i]));
  }
  return points;
}

void rotate_by(std::vector<double>& values, std::size_t shift) {
  std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(shift), values.end());
}

/// Makes all loops of a surface start where they are nearest to their common mean. Each round can only shorten the
/// distances; a few rounds are enough.
void align(std::vector<PolarCurve>& samples) {
  std::vector<glm::dvec2> reference;
  for (int round = 0; round < 5; ++round) {
    // Rotate each loop's start to where it is nearest to the reference; the first reference is the first loop.
    bool moved = false;
    std::vector<glm::dvec2> sum(points_per_loop, glm::dvec2(0));
    double count = 0;
    for (PolarCurve& sample : samples) {
      if (sample.size() == 0) continue;
      if (reference.empty()) reference = in_pie(sample, samples.size());
      const std::size_t shift = best_shift(reference, in_pie(sample, samples.size()));
      rotate_by(sample.azimuth, shift);
      rotate_by(sample.radius, shift);
      moved = moved || shift != 0;
      const std::vector<glm::dvec2> points = in_pie(sample, samples.size());
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += points[i];
      count += 1;
    }

    // The mean of the rotated loops is the next reference.
    if (!moved) return;
    reference = sum;
    for (glm::dvec2& p : reference) p /= count;
  }
}

}  // namespace

std::vector<FoldSamples> fold_samples(const Template& fruit) {
  const auto& lines = std::get<FoldSymmetry>(fruit.symmetry).fold_angles;
  const std::vector<double> widths = fold_widths(std::get<FoldSymmetry>(fruit.symmetry));
  std::vector<FoldSamples> all;
  for (std::size_t s = 0; s < fruit.surfaces.size(); ++s) {
    const SurfaceSketch& surface = fruit.surfaces[s];
    FoldSamples samples{s, 0, surface.type == SurfaceType::in_fold, std::vector<PolarCurve>(lines.size())};
    if (samples.closed) {
      // A surface in folds gives whole loops; a fold may have none.
      for (std::size_t k = 0; k < std::min(lines.size(), surface.horizontal.size()); ++k) {
        const Curve& loop = surface.horizontal[k];
        if (loop.points.size() >= 3) samples.fold[k] = closed_sample(loop, lines[k], widths[k]);
      }
      align(samples.fold);
      all.push_back(std::move(samples));
    } else {
      // A curve around the axis is divided at the fold lines; one that does not vary gives no samples.
      if (!surface.varies || surface.horizontal.empty() || !encloses(surface.horizontal.front(), {0, 0})) continue;
      for (samples.loop = 0; samples.loop < surface.horizontal.size(); ++samples.loop) {
        const Curve loop = counter_clockwise(surface.horizontal[samples.loop]);
        for (std::size_t k = 0; k < lines.size(); ++k) samples.fold[k] = open_sample(loop, lines[k], widths[k]);
        all.push_back(samples);
      }
    }
  }
  return all;
}

std::vector<double> fold_widths(const FoldSymmetry& symmetry) {
  const std::vector<double>& lines = symmetry.fold_angles;
  std::vector<double> widths;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) widths.push_back(lines[k + 1] - lines[k]);
  widths.push_back(lines.front() + 2 * pi - lines.back());
  return widths;
}

std::size_t best_shift(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b) {
  std::size_t best = 0;
  double min = -1;
  for (std::size_t shift = 0; shift < b.size(); ++shift) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += glm::distance(a[i], b[(i + shift) % b.size()]);
    if (min < 0 || sum < min) {
      min = sum;
      best = shift;
    }
  }
  return best;
}

}  // namespace pomona
