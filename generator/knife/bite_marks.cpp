#include "generator/knife/bite_marks.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/random.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/knife/solid_of_revolution.h"

namespace pomona {

namespace {

constexpr double flatness = 0.8;  // height and depth over width
constexpr double groove = 0.085;  // share of the distance from the middle by which teeth part
constexpr double focus = 0.9;     // where a row's grooves come from: this share of the height beyond the middle
constexpr double upper_tooth = 8e-3, lower_tooth = 6e-3;  // metres, about the width of incisors

/// 0 below -1, 1 above 1, smooth between.
double smooth_step(double x) {
  const double t = std::clamp(0.5 * (x + 1), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// One row of teeth: angles about the point its grooves come from.
class ToothRow {
 public:
  ToothRow(std::string_view purpose, double pitch) : draw_(VariantKey{}, purpose) {
    // From the middle outwards both ways: two large ones, then as they come.
    for (const int side : {1, -1}) {
      std::vector<double>& edge = side > 0 ? right_ : left_;
      const std::uint64_t first = side > 0 ? 0 : 1000;
      edge.push_back(0);
      while (edge.back() < most && edge.size() < 200) {
        const std::uint64_t n = edge.size();
        edge.push_back(edge.back() + pitch * (n == 1 ? 1.15 : 0.82 + 0.36 * draw_.uniform(first + n)));
      }
    }
  }

  struct Mark {
    double parting = 0;  ///< 0 in the middle of a groove, 1 where two meet
    double reach = 0;    ///< how much farther this tooth went, -1 to 1
  };
  Mark at(double angle) const {
    const std::vector<double>& edge = angle >= 0 ? right_ : left_;
    const double a = std::min(std::fabs(angle), edge.back());
    const auto after = std::upper_bound(edge.begin() + 1, edge.end() - 1, a);
    const auto n = static_cast<std::uint64_t>(after - edge.begin());
    const double t = std::fabs(2 * (a - *(after - 1)) / (*after - *(after - 1)) - 1);

    // A groove is round; where two meet, their edge is a little worn.
    constexpr double worn = 0.8;
    const double beyond = t - worn;
    const double parting = beyond < 0 ? t * t / worn : worn + 2 * beyond - beyond * beyond / (1 - worn);
    return {parting, 2 * draw_.uniform((angle >= 0 ? 2000 : 3000) + n) - 1};
  }

 private:
  static constexpr double most = 2;  // radians
  RandomStream draw_;
  std::vector<double> right_, left_;  // edges of teeth, growing from 0
};

/// Shares of the distance from the middle, for directions of unit length.
class BiteShape {
 public:
  explicit BiteShape(double width)
      : upper_("bite/upper teeth", upper_tooth / ((1 + focus) * 0.5 * flatness * width)),
        lower_("bite/lower teeth", lower_tooth / ((1 + focus) * 0.5 * flatness * width)),
        draw_(VariantKey{}, "bite/ridge"),
        tooth_share_(upper_tooth / width) {}

  double share(const glm::dvec3& direction) const {
    // The rows meet on a line that goes up and down from tooth to tooth, somewhat above the middle.
    const double x = direction.x, up = direction.z;
    const double meet = 0.1 + 0.1 * wave(x / tooth_share_ * 0.25);
    const double above = smooth_step((up - meet) / 0.1);
    const ToothRow::Mark upper = upper_.at(reproducible::atan2(x, std::max(up, -0.5) + focus));
    const ToothRow::Mark lower = lower_.at(reproducible::atan2(x, focus - std::min(up, 0.5)));
    const double inner = smooth_step(3 * direction.y - 1);  // torn flesh is within, not at the skin
    const double off = (up - meet) / 0.09, ridge = 0.09 * inner * reproducible::exp(-off * off);
    return 1 - above * taken(upper) - (1 - above) * taken(lower) - ridge;
  }

 private:
  static double taken(const ToothRow::Mark& mark) {
    return groove * mark.parting - 0.03 * mark.reach * (1 - mark.parting);
  }

  /// Between -1 and 1, going smoothly from one drawn value to the next.
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

}  // namespace

ClosedSurface bite_marks(double width) {
  // Triangles fine enough for the edges between teeth, as long as these are a 15th of the width or more.
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

}  // namespace pomona
