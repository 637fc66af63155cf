#include "generator/knife/closed_knives.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/knife/skin_offset.h"
#include "generator/knife/solid_of_revolution.h"

namespace pomona {

namespace {

constexpr double flatness = 0.8;  // height and depth of a bite over its width
constexpr double groove = 0.085;  // depth of grooves between teeth, as a share of the distance from the middle
constexpr double focus = 0.9;     // the point from which a row's grooves fan out: this share of the height beyond the
                                  // middle
constexpr double upper_tooth = 8e-3, lower_tooth = 6e-3;  // metres, about the width of incisors

/// 0 below -1, 1 above 1, smooth between.
double smooth_step(double x) {
  const double t = std::clamp(0.5 * (x + 1), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// One row of teeth: angles about the point from which its grooves fan out.
class ToothRow {
 public:
  ToothRow(std::string_view purpose, double pitch) : draw_(VariantKey{}, purpose) {
    // From the middle outwards: two large teeth, then random ones.
    for (const int side : {1, -1}) {
      std::vector<double>& edge = side > 0 ? right_ : left_;
      const std::uint64_t first = side > 0 ? 0 : 1000;
      edge.push_back(0);
      while (edge.back() < max && edge.size() < 200) {
        const std::uint64_t n = edge.size();
        edge.push_back(edge.back() + pitch * (n == 1 ? 1.15 : 0.82 + 0.36 * draw_.uniform(first + n)));
      }
    }
  }

  struct Mark {
    double parting = 0;  ///< 0 in the middle of a groove, 1 where two meet
    double reach = 0;    ///< how much deeper this tooth bites, -1 to 1
  };
  Mark at(double angle) const {
    const std::vector<double>& edge = angle >= 0 ? right_ : left_;
    const double a = std::min(std::fabs(angle), edge.back());
    const auto after = std::upper_bound(edge.begin() + 1, edge.end() - 1, a);
    const auto n = static_cast<std::uint64_t>(after - edge.begin());
    const double t = std::fabs(2 * (a - *(after - 1)) / (*after - *(after - 1)) - 1);

    // A groove is round; the edge between two is a little worn.
    constexpr double worn = 0.8;
    const double beyond = t - worn;
    const double parting = beyond < 0 ? t * t / worn : worn + 2 * beyond - beyond * beyond / (1 - worn);
    return {parting, 2 * draw_.uniform((angle >= 0 ? 2000 : 3000) + n) - 1};
  }

 private:
  static constexpr double max = 2;  // radians
  RandomStream draw_;
  std::vector<double> right_, left_;  // edges of teeth, growing from 0
};

/// Distances from the middle, as shares of the width, for unit directions.
class BiteShape {
 public:
  explicit BiteShape(double width)
      : upper_("bite/upper teeth", upper_tooth / ((1 + focus) * 0.5 * flatness * width)),
        lower_("bite/lower teeth", lower_tooth / ((1 + focus) * 0.5 * flatness * width)),
        draw_(VariantKey{}, "bite/ridge"),
        tooth_share_(upper_tooth / width) {}

  double share(const glm::dvec3& direction) const {
    // The rows meet on a line that varies from tooth to tooth, somewhat above the middle.
    const double x = direction.x, up = direction.z;
    const double meet = 0.1 + 0.1 * wave(x / tooth_share_ * 0.25);
    const double above = smooth_step((up - meet) / 0.1);
    const ToothRow::Mark upper = upper_.at(reproducible::atan2(x, std::max(up, -0.5) + focus));
    const ToothRow::Mark lower = lower_.at(reproducible::atan2(x, focus - std::min(up, 0.5)));
    const double inner = smooth_step(3 * direction.y - 1);  // flesh is torn inside, not at the skin
    const double off = (up - meet) / 0.09, ridge = 0.09 * inner * reproducible::exp(-off * off);
    return 1 - above * taken(upper) - (1 - above) * taken(lower) - ridge;
  }

 private:
  static double taken(const ToothRow::Mark& mark) {
    return groove * mark.parting - 0.03 * mark.reach * (1 - mark.parting);
  }

  /// A smooth curve through random values between -1 and 1.
  double wave(double x) const {
    const double cell = std::floor(x);
    const auto n = static_cast<std::uint64_t>(cell + 500);
    const double t = x - cell, a = draw_.uniform(n), b = draw_.uniform(n + 1);
    return 2 * (a + (b - a) * t * t * (3 - 2 * t)) - 1;
  }

  ToothRow upper_, lower_;
  RandomStream draw_;
  double tooth_share_;
};

/// A bite around the origin: +Y points into the fruit, +Z is up. Its height and its depth are four fifths of its width.
/// Two rows of teeth have left grooves; the upper ones are broader. Each row fans out from a point beyond the middle,
/// and the rows meet in a ridge. No two teeth are equal, but the same width always gives the same teeth. The surface is
/// closed, and every ray from the origin meets it once.
/// \param width metres
ClosedSurface bite_marks(double width) {
  // Triangles are fine enough for edges between teeth of a 15th of the width or more.
  const double cell = std::max(6e-4, width / 120), radius = 0.5 * width;
  const double tolerance = std::min(cell, radius / 8) * std::min(cell, radius / 8) / (8 * radius);
  ClosedSurface bite = revolved(half_circle(radius, tolerance), {.tolerance = tolerance});
  const BiteShape shape(width);
  for (glm::dvec3& p : bite.point) {
    const glm::dvec3 direction = glm::normalize(p);
    p = radius * shape.share(direction) * direction * glm::dvec3(1, flatness, flatness);
  }
  return bite;
}

/// Largest distance of chords from circles, as a share of a knife's size: 0.012 mm on a ball of 24 mm.
constexpr double roughness = 5e-4;

/// The point where the level line from the front (along z) to the axis at half the fruit's height enters the skin;
/// without a hit, the front of the fruit's bounds.
glm::dvec3 front_of(const DiffusionSurfaces& surfaces) {
  const Box<double> bounds = bounds_of(surfaces);
  const glm::dvec2 line(0, bounds.center().y);
  std::optional<double> front;
  for (std::size_t i = 0; i < surfaces.triangle_count(); ++i) {
    if (!surfaces.is_boundary(i)) continue;
    const glm::uvec3& t = surfaces.triangle[i];

    // Seen along the line, the line is a point. It lies in the triangle if the three triangles that it makes with the
    // edges have the same orientation; their areas are the barycentric weights.
    const glm::dvec3 a(surfaces.position[t.x]), b(surfaces.position[t.y]), c(surfaces.position[t.z]);
    const auto area = [&](const glm::dvec3& p, const glm::dvec3& q) {
      return (p.x - line.x) * (q.y - line.y) - (p.y - line.y) * (q.x - line.x);
    };
    const double of_a = area(b, c), of_b = area(c, a), of_c = area(a, b), sum = of_a + of_b + of_c;
    const bool meets = (of_a >= 0 && of_b >= 0 && of_c >= 0) || (of_a <= 0 && of_b <= 0 && of_c <= 0);
    if (!meets || sum == 0) continue;
    const double z = (of_a * a.z + of_b * b.z + of_c * c.z) / sum;
    front = std::max(front.value_or(z), z);
  }
  return {line, front.value_or(bounds.high.z)};
}

/// Upright at the fruit's origin, unless the knife says where.
SolidPose pose_at(const std::optional<glm::dvec3>& at, const std::optional<glm::dvec3>& axis) {
  SolidPose pose;
  pose.at = at.value_or(pose.at);
  pose.axis = axis.value_or(pose.axis);
  pose.up = level_beside(pose.axis);
  return pose;
}

/// The heights of the lowest and highest vertex along the pose's axis, metres from its origin; 0 and 0 for no vertices.
std::pair<double, double> heights_along(const SolidPose& pose, const DiffusionSurfaces& surfaces) {
  double low = INFINITY, high = -INFINITY;
  for (const glm::uvec3& t : surfaces.triangle) {
    for (int i = 0; i < 3; ++i) {
      const double height = glm::dot(pose.axis, glm::dvec3(surfaces.position[t[i]]) - pose.at);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  if (!(low <= high)) return {0, 0};
  return {low, high};
}

/// Makes the surface of a closed knife, by std::visit.
struct SurfaceMaker {
  const DiffusionSurfaces& surfaces;

  ClosedSurface operator()(const BallKnife& knife) const {
    const double tolerance = roughness * knife.diameter;
    const Curve outline = half_circle(0.5 * knife.diameter, tolerance);
    return posed(revolved(outline, {.tolerance = tolerance}), {.at = knife.at ? *knife.at : front_of(surfaces)});
  }

  /// It bites level towards the axis, the teeth above and below.
  ClosedSurface operator()(const BiteKnife& knife) const {
    // On the axis no level direction exists, so it bites downwards.
    SolidPose pose;
    pose.at = knife.at ? *knife.at : front_of(surfaces);
    const glm::dvec3 inwards(-pose.at.x, 0, -pose.at.z);
    pose.axis = glm::length(inwards) > 1e-6 ? glm::normalize(inwards) : glm::dvec3(0, -1, 0);
    pose.up = glm::cross(pose.axis, level_beside(pose.axis));
    return posed(bite_marks(knife.width), pose);
  }

  /// A cylinder along the axis. It stands out of the fruit at the top, and at the bottom unless it has a depth.
  ClosedSurface operator()(const CoreKnife& knife) const {
    const SolidPose pose = pose_at(knife.at, knife.axis);
    const auto [low, high] = heights_along(pose, surfaces);
    const double beyond = 0.05 * (high - low) + knife.diameter, radius = 0.5 * knife.diameter;
    const bool through = !knife.depth || *knife.depth >= high - low;
    const Curve side{{{radius, through ? low - beyond : high - *knife.depth}, {radius, high + beyond}}, false};
    return posed(revolved(side, {.tolerance = roughness * knife.diameter}), pose);
  }

  ClosedSurface operator()(const RevolveKnife& knife) const {
    double widest = 0;
    for (const glm::dvec2& p : knife.profile.points) widest = std::max(widest, p.x);
    const RevolveOptions options{.tolerance = 2 * roughness * widest};
    return posed(revolved(knife.profile, options), pose_at(knife.at, knife.axis));
  }

  ClosedSurface operator()(const PeelKnife& knife) const {
    return peeled(surfaces, {.thickness = knife.thickness, .strip = knife.strip.value_or(0)});
  }

  ClosedSurface operator()(const SurfaceKnife& knife) const { return *knife.surface; }
};

}  // namespace

ClosedSurface surface_of(const ClosedCut& knife, const DiffusionSurfaces& surfaces) {
  return std::visit(SurfaceMaker{surfaces}, knife);
}

}  // namespace pomona
