#include "generator/surface/sweep/dart_throwing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/surface/sweep/dart_cells.h"
#include "generator/surface/sweep/grid_place.h"

namespace pomona {

namespace {

class DartThrower {
 public:
  DartThrower(std::vector<GrainTarget> targets, const GrainSketch& sketch, const GrainDraws& draws,
              std::span<const Dart> others)
      : sketch_(sketch),
        radius_(sketch.spacing.poisson_radius),
        draws_(draws),
        others_(others),
        cells_(radius_),
        other_cells_(radius_),
        bodies_(radius_),
        fresh_cells_(radius_) {
    for (std::size_t i = 0; i < others.size(); ++i) {
      other_cells_.add(others[i].center, others[i].spacing, i);
      if (sketch.spacing.solid) bodies_.add(others[i].center, diameter(others[i].pose), i);
    }
    for (GrainTarget& target : targets) add_target(target);
  }

  std::vector<Dart> throw_all() {
    // The first throw takes most places; the next ones aim at what is still free.
    throw_round(8);
    for (int round = 0; round < 6 && !targets_.empty(); ++round) {
      aim_at_free_places();
      throw_round(64);
    }
    return std::move(darts_);
  }

 private:
  struct Pending {
    GrainTarget target;
    bool aimed_at = false;  ///< and found not to be taken
  };

  void add_target(GrainTarget target) {
    target.most = most_density(sketch_, target);
    const double weight = area_of(target) * target.most;
    if (!(weight > 0)) return;
    weight_before_.push_back(weight_);
    weight_ += weight;
    targets_.push_back(target);
  }

  /// So many candidates for each disc of the Poisson diameter that the targets have room for.
  void throw_round(double per_disc) {
    const double disc = pi * radius_ * radius_ / 4;
    const std::uint64_t end = next_candidate_ + static_cast<std::uint64_t>(std::ceil(per_disc * weight_ / disc));
    for (; next_candidate_ < end; ++next_candidate_) {
      std::optional<Dart> dart = candidate(next_candidate_);
      if (!dart || !is_free(*dart)) continue;
      dart->pose = grain_pose(sketch_, *dart, draws_);
      if (!sketch_.spacing.solid || has_room(*dart)) keep(*dart);
    }
  }

  std::optional<Dart> candidate(std::uint64_t n) const {
    // A triangle by its weight, a point in it evenly [Osada et al. 2002].
    const double weight = draws_.places.uniform(draws_per_candidate * n) * weight_;
    const auto after = std::upper_bound(weight_before_.begin(), weight_before_.end(), weight);
    const GrainTarget& target = targets_[static_cast<std::size_t>(after - weight_before_.begin()) - 1];
    const double root = std::sqrt(draws_.places.uniform(draws_per_candidate * n + 1));
    const double share = draws_.places.uniform(draws_per_candidate * n + 2);
    const GrainPlace far = blend(target.corner[1], 1 - share, target.corner[2], share);
    const GrainPlace place = blend(target.corner[0], 1 - root, far, root);

    // Where grains are rarer than anywhere in the triangle, so are candidates.
    const double density = density_at(sketch_, place);
    if (density <= 0) return std::nullopt;
    if (density < target.most && draws_.places.uniform(draws_per_candidate * n + 5) * target.most >= density) {
      return std::nullopt;
    }

    std::optional<Dart> dart = dart_at(place, density);
    if (dart) {
      dart->number = n;
      dart->tangent = unit_across(target.uphill, dart->normal);
    }
    return dart;
  }

  std::optional<Dart> dart_at(const GrainPlace& place, double density) const {
    const double size = glm::length(place.normal);
    if (!(size > 0)) return std::nullopt;
    Dart dart;
    dart.normal = place.normal * ((sketch_.on_front ? 1 : -1) / size);
    dart.center = place.position - dart.normal * sketch_.stance.sink;
    dart.spacing = radius_ / std::sqrt(density);
    return dart;
  }

  /// Halves the targets along their longest edges down to an eighth of their spacing, and leaves out those that lie
  /// within the reach of one dart.
  void aim_at_free_places() {
    std::vector<Pending> pending;
    for (const GrainTarget& target : targets_) pending.push_back({target, has_aimed_});
    targets_.clear();
    weight_before_.clear();
    weight_ = 0;
    std::size_t splits_left = 4'000'000;  // slivers could go on much longer
    while (!pending.empty()) {
      auto [target, aimed_at] = pending.back();
      pending.pop_back();
      target.most = most_density(sketch_, target);
      if (target.most <= 0 || is_taken(target, aimed_at)) continue;
      const std::size_t edge = longest_edge(target);
      const GrainPlace &a = target.corner[edge], &b = target.corner[(edge + 1) % 3];
      if (splits_left == 0 || glm::distance(a.position, b.position) < radius_ / std::sqrt(target.most) / 8) {
        add_target(target);
        continue;
      }
      --splits_left;
      const GrainPlace middle = blend(a, 0.5, b, 0.5);
      pending.push_back({target, false});
      pending.back().target.corner[edge] = middle;
      pending.push_back({target, false});
      pending.back().target.corner[(edge + 1) % 3] = middle;
    }
    fresh_cells_.clear();
    has_aimed_ = true;
  }

  static std::size_t longest_edge(const GrainTarget& target) {
    std::array<double, 3> length{};
    for (std::size_t k = 0; k < 3; ++k) {
      length[k] = glm::distance(target.corner[k].position, target.corner[(k + 1) % 3].position);
    }
    return static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  }

  /// True only if no candidate in the target could be free, even where its spacing is smallest. Of what was aimed at
  /// before, the darts of that time are known not to reach all.
  bool is_taken(const GrainTarget& target, bool aimed_at) const {
    std::array<Dart, 3> dart;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<Dart> at_corner = dart_at(target.corner[k], target.most);
      if (!at_corner) return false;
      dart[k] = *at_corner;
    }
    const auto covers = [&](const Dart& known, bool any_facing) {
      return std::all_of(dart.begin(), dart.end(),
                         [&](const Dart& corner) { return is_too_near(known, corner, any_facing); });
    };
    if (!aimed_at) return any_near(dart[0], covers);
    return fresh_cells_.any_meets(dart[0].center, dart[0].spacing,
                                  [&](std::size_t i) { return covers(darts_[i], sketch_.spacing.any_facing); });
  }

  bool is_free(const Dart& dart) const {
    return !any_near(dart, [&](const Dart& known, bool any_facing) { return is_too_near(known, dart, any_facing); });
  }

  /// True if question(dart, whether its facing is all the same) holds for any dart that may be too near.
  template <typename Question>
  bool any_near(const Dart& dart, const Question& question) const {
    const auto own = [&](std::size_t i) { return question(darts_[i], sketch_.spacing.any_facing); };
    const auto other = [&](std::size_t i) { return question(others_[i], true); };
    return cells_.any_meets(dart.center, dart.spacing, own) || other_cells_.any_meets(dart.center, dart.spacing, other);
  }

  static bool is_too_near(const Dart& one, const Dart& other, bool any_facing) {
    return glm::distance(one.center, other.center) < 0.5 * (one.spacing + other.spacing) &&
           (any_facing || glm::dot(one.normal, other.normal) > 0);
  }

  static double diameter(const GrainPose& pose) {
    return 2 * std::max({glm::length(pose.thickness), glm::length(pose.length), glm::length(pose.width)});
  }

  /// True unless the ellipsoid of another grain is in the way. Bodies count the others first, then this kind.
  bool has_room(const Dart& dart) const {
    return !bodies_.any_meets(dart.center, diameter(dart.pose), [&](std::size_t i) {
      const Dart& known = i < others_.size() ? others_[i] : darts_[i - others_.size()];
      return ellipsoids_overlap(known.center, known.pose, dart.center, dart.pose);
    });
  }

  void keep(const Dart& dart) {
    cells_.add(dart.center, dart.spacing, darts_.size());
    fresh_cells_.add(dart.center, dart.spacing, darts_.size());
    if (sketch_.spacing.solid) bodies_.add(dart.center, diameter(dart.pose), others_.size() + darts_.size());
    darts_.push_back(dart);
  }

  const GrainSketch& sketch_;
  double radius_;
  const GrainDraws& draws_;
  std::span<const Dart> others_;
  std::vector<GrainTarget> targets_;
  std::vector<double> weight_before_;  ///< per target: area times `most` of all before it
  double weight_ = 0;
  std::uint64_t next_candidate_ = 0;
  DartCells cells_, other_cells_, bodies_;
  DartCells fresh_cells_;   ///< the darts since the last aim
  bool has_aimed_ = false;  ///< then all targets are those of the last aim
  std::vector<Dart> darts_;
};

}  // namespace

double room_for_grains(const std::vector<GrainTarget>& targets, const GrainSketch& sketch) {
  double weight = 0;
  for (const GrainTarget& target : targets) weight += area_of(target) * most_density(sketch, target);
  // A full surface has some 0.7 grains per squared radius.
  return 0.7 * weight / (sketch.spacing.poisson_radius * sketch.spacing.poisson_radius);
}

std::vector<Dart> thrown_darts(std::vector<GrainTarget> targets, const GrainSketch& sketch, const GrainDraws& draws,
                               std::span<const Dart> others) {
  return DartThrower(std::move(targets), sketch, draws, others).throw_all();
}

}  // namespace pomona
