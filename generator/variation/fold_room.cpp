#include "generator/variation/fold_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/surface/sweep/profile.h"
#include "generator/variation/fold_samples.h"
#include "generator/variation/polar_curve.h"

namespace pomona {

namespace {

constexpr int rings = 9;                       // of a chamber, including its two poles
constexpr std::size_t azimuths_per_fold = 32;  // for the comparison of layers

/// A point of a swept chamber.
struct SweptPoint {
  double azimuth = 0, radius = 0, height = 0;
};

/// Points of a chamber where sweep() will place them, without the poles.
std::vector<SweptPoint> swept(const ProfileArcs& arcs, const Curve& loop, const SurfaceSketch& sketch) {
  PolarCurve polar = to_polar(loop.points);
  const auto [min, max] = std::minmax_element(polar.azimuth.begin(), polar.azimuth.end());
  const double center = 0.5 * (*min + *max);
  const ReferenceRadii reference = reference_radii(sketch);
  double widest = 0;
  for (std::size_t j = 0; j < arcs.share.size(); ++j) {
    widest = std::max(widest, glm::distance(arcs.inner[j], arcs.outer[j]));
  }
  std::vector<SweptPoint> points;
  for (std::size_t j = 1; j + 1 < arcs.share.size(); ++j) {
    const glm::dvec2 across = arcs.outer[j] - arcs.inner[j];
    const double narrowing = reproducible::pow(glm::length(across) / widest, sketch.taper);
    for (std::size_t i = 0; i < polar.size(); i += 2) {
      const double outness = (polar.radius[i] - reference.inner) / (reference.outer - reference.inner);
      const glm::dvec2 at = arcs.inner[j] + across * outness;
      points.push_back({center + narrowing * (polar.azimuth[i] - center), std::max(at.x, 0.0), at.y});
    }
  }
  return points;
}

}  // namespace

/// A layer's vertical curve in the half-plane of any azimuth.
class LayerInPlane {
 public:
  explicit LayerInPlane(const SurfaceSketch& sketch)
      : radius_of_(sketch.horizontal.front()), reference_(reference_radii(sketch).outer) {
    const Profile profile = sampled_profile(sketch.vertical, sketch.along);
    points_ = profile.points;
    for (const double share : profile.share) waviness_.push_back(1 - sketch.roundness(share));
    for (const glm::dvec2& p : points_) {
      lowest_ = std::min(lowest_, p.y);
      highest_ = std::max(highest_, p.y);
    }
  }

  /// Which of two points at the same azimuth and height lie between the layer and the axis: a ray from there away from
  /// the axis crosses the layer an odd number of times.
  std::array<bool, 2> encloses(const SweptPoint& p, const std::array<double, 2>& radii) const {
    std::array<bool, 2> inside{};
    if (p.height < lowest_ || p.height > highest_) return inside;
    const double swell = radius_of_(p.azimuth) / reference_ - 1;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const glm::dvec2& a = points_[i];
      const glm::dvec2& b = points_[i + 1];
      if ((a.y > p.height) == (b.y > p.height)) continue;
      const double ax = a.x * (1 + swell * waviness_[i]), bx = b.x * (1 + swell * waviness_[i + 1]);
      const double there = ax + (bx - ax) * ((p.height - a.y) / (b.y - a.y));
      for (std::size_t k = 0; k < 2; ++k) inside[k] = inside[k] != (there > radii[k]);
    }
    return inside;
  }

 private:
  std::vector<glm::dvec2> points_;
  std::vector<double> waviness_;  ///< 1 - roundness, at every point
  RadiusOf radius_of_;
  double reference_;
  double lowest_ = 1e9, highest_ = -1e9;
};

namespace {

/// The side on which all points lie with this margin; nothing if they lie on both.
std::optional<bool> common_side(const std::vector<SweptPoint>& points, const LayerInPlane& layer, double margin) {
  std::optional<bool> side;
  for (const SweptPoint& p : points) {
    const std::array<bool, 2> inside = layer.encloses(p, {p.radius * (1 - margin), p.radius * (1 + margin)});
    if (inside[0] != inside[1] || (side && *side != inside[0])) return std::nullopt;
    side = inside[0];
  }
  return side;
}

bool cross_each_other(const Curve& a, const Curve& b) {
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const glm::dvec2 p = a.points[i], pq = a.points[(i + 1) % a.points.size()] - p;
    for (std::size_t j = 0; j < b.points.size(); ++j) {
      const glm::dvec2 r = b.points[j], rs = b.points[(j + 1) % b.points.size()] - r;
      if (cross(pq, r - p) * cross(pq, r + rs - p) <= 0 && cross(rs, p - r) * cross(rs, p + pq - r) <= 0) return true;
    }
  }
  return false;
}

/// The loop, resampled if it has very many points: `nested` compares every edge with every other.
Curve few_points(const Curve& loop) {
  constexpr int max = 1024;
  return loop.points.size() > max ? resampled(loop, max) : loop;
}

/// True = the first is inside the second, false = they are apart, nothing = they cross or the second is inside the
/// first.
std::optional<bool> nested(const Curve& drawn_first, const Curve& drawn_second) {
  const Curve first = few_points(drawn_first), second = few_points(drawn_second);
  if (cross_each_other(first, second) || encloses(first, second.points.front())) return std::nullopt;
  return encloses(second, first.points.front());
}

/// The same answer for all folds that have both loops, or nothing.
std::optional<bool> nested_everywhere(const SurfaceSketch& first, const SurfaceSketch& second) {
  std::optional<bool> common;
  for (std::size_t k = 0; k < std::min(first.horizontal.size(), second.horizontal.size()); ++k) {
    if (first.horizontal[k].points.empty() || second.horizontal[k].points.empty()) continue;
    const std::optional<bool> here = nested(first.horizontal[k], second.horizontal[k]);
    if (!here || (common && *common != *here)) return std::nullopt;
    common = here;
  }
  return common;
}

}  // namespace

FoldRoom::FoldRoom(const Template& drawn) : layers_(layers_of(drawn)) {
  for (std::size_t s = 0; s < drawn.surfaces.size(); ++s) {
    const SurfaceSketch& sketch = drawn.surfaces[s];
    if (sketch.type == SurfaceType::in_fold) chambers_.push_back({s, sampled_arcs(sketch.vertical, rings)});
  }

  // Find on which side of each layer each chamber lies, and with which margin in the drawing.
  for (std::size_t c = 0; c < chambers_.size(); ++c) {
    const SurfaceSketch& sketch = drawn.surfaces[chambers_[c].surface];
    std::vector<SweptPoint> points;
    for (const Curve& loop : sketch.horizontal) {
      if (loop.points.empty()) continue;
      const std::vector<SweptPoint> more = swept(chambers_[c].arcs, resampled(loop, 64), sketch);
      points.insert(points.end(), more.begin(), more.end());
    }
    for (const std::size_t layer : layers_.surface) {
      const LayerInPlane plane(drawn.surfaces[layer]);
      for (const double margin : {0.03, 0.01, 0.0}) {
        const std::optional<bool> inside = common_side(points, plane, margin);
        if (!inside) continue;
        sides_.push_back({c, layer, *inside, 0.5 * margin});
        break;
      }
    }
  }

  // Find which loops of a fold are inside each other.
  for (const Chamber& a : chambers_) {
    for (const Chamber& b : chambers_) {
      const std::optional<bool> lies = nested_everywhere(drawn.surfaces[a.surface], drawn.surfaces[b.surface]);
      if (a.surface != b.surface && lies) neighbours_.push_back({a.surface, b.surface, *lies});
    }
  }
}

bool FoldRoom::are_sides_kept(const Template& variant, std::size_t fold, const LayerPlanes& planes) const {
  std::size_t last_chamber = chambers_.size();
  std::vector<SweptPoint> points;
  for (const ChamberSide& side : sides_) {
    const Chamber& chamber = chambers_[side.chamber];
    const SurfaceSketch& sketch = variant.surfaces[chamber.surface];
    if (sketch.horizontal[fold].points.empty()) continue;
    if (side.chamber != last_chamber) points = swept(chamber.arcs, sketch.horizontal[fold], sketch);
    last_chamber = side.chamber;
    if (common_side(points, planes.at(side.layer), side.margin) != side.inside) return false;
  }
  return true;
}

std::vector<bool> FoldRoom::is_sound(const Template& variant) const {
  const auto& symmetry = std::get<FoldSymmetry>(variant.symmetry);
  const std::vector<double> widths = fold_widths(symmetry);

  // The layers are the same for all folds.
  LayerPlanes planes;
  for (const ChamberSide& side : sides_) planes.try_emplace(side.layer, variant.surfaces[side.layer]);
  std::vector<double> azimuths;  // of one fold after the other
  for (std::size_t k = 0; k < widths.size(); ++k) {
    for (std::size_t i = 0; i <= azimuths_per_fold; ++i)
      azimuths.push_back(symmetry.fold_angles[k] + widths[k] * static_cast<double>(i) / azimuths_per_fold);
  }
  std::vector<std::vector<double>> swells_of_all;
  for (const std::size_t s : layers_.surface) {
    const SurfaceSketch& sketch = variant.surfaces[s];
    swells_of_all.push_back(swells(sketch.horizontal.front(), reference_radii(sketch).outer, azimuths));
  }

  // Check each fold.
  std::vector<bool> sound;
  for (std::size_t k = 0; k < widths.size(); ++k) {
    // Layers must stay apart over the whole fold.
    std::vector<std::vector<double>> layer_swells;
    for (const std::vector<double>& all : swells_of_all) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(k * (azimuths_per_fold + 1));
      layer_swells.emplace_back(first, first + azimuths_per_fold + 1);
    }
    bool fits = are_apart(layers_, layer_swells);

    // Chambers must stay on their sides of the layers, and inside or outside each other as drawn.
    fits = fits && are_sides_kept(variant, k, planes);
    for (const Neighbours& pair : neighbours_) {
      const Curve& first = variant.surfaces[pair.first].horizontal[k];
      const Curve& second = variant.surfaces[pair.second].horizontal[k];
      if (first.points.empty() || second.points.empty()) continue;
      fits = fits && nested(first, second) == pair.nested;
    }
    sound.push_back(fits);
  }
  return sound;
}

}  // namespace pomona
