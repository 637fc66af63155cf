#include "generator/surface/sweep/dart_throwing.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/surface/sweep/dart_cells.h"
#include "generator/surface/sweep/grid_place.h"

namespace pomona {

namespace {

/// The number of candidates that threads share before the next are drawn, and of those in one part. Parts should be
/// many; candidates few enough that most do not conflict with each other.
constexpr std::uint64_t candidates_at_once = 8192, candidates_of_a_part = 512;

constexpr std::size_t targets_of_a_part = 128;

/// Up to this number of darts, testing each is faster than looking up cells.
constexpr std::size_t few = 24;

/// Limit of targets in a round, because slivers could be halved much longer.
constexpr std::size_t max_splits = 4'000'000;

class DartThrower {
 public:
  DartThrower(std::vector<GrainTarget> targets, const GrainSketch& sketch, const GrainDraws& draws, Threads threads,
              std::span<const Dart> others)
      : sketch_(sketch),
        radius_(sketch.spacing.poisson_radius),
        draws_(draws),
        threads_(threads),
        others_(others),
        cells_(radius_),
        other_cells_(radius_),
        bodies_(radius_),
        fresh_cells_(radius_) {
    for (std::size_t i = 0; i < others.size(); ++i) {
      other_cells_.add(others[i].center, others[i].spacing, i);
      if (sketch.spacing.solid) bodies_.add(others[i].center, diameter(others[i].pose), i);
    }
    for (GrainTarget& target : targets) {
      target.max = max_density(sketch_, target);
      add_target(target);
    }
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
    bool aimed_at = false;  ///< the target was found to have room
  };

  /// Targets with a known `max`.
  void add_target(const GrainTarget& target) {
    const double weight = area_of(target) * target.max;
    if (!(weight > 0)) return;
    weight_before_.push_back(weight_);
    weight_ += weight;
    targets_.push_back(target);
  }

  /// The number of candidates for each disc of the Poisson diameter for which the targets have room.
  void throw_round(double per_disc) {
    const double disc = pi * radius_ * radius_ / 4;
    const std::uint64_t end = next_candidate_ + static_cast<std::uint64_t>(std::ceil(per_disc * weight_ / disc));
    while (next_candidate_ < end) {
      const std::uint64_t count = std::min<std::uint64_t>(end - next_candidate_, candidates_at_once);
      const std::size_t before = darts_.size();
      for (const std::vector<Dart>& some : hopeful(next_candidate_, count)) {
        for (const Dart& dart : some) {
          if (darts_.size() == before || fits(dart)) keep(dart);
        }
      }
      next_candidate_ += count;
    }
  }

  /// The candidates that do not conflict with any dart so far, in their order. Darts are never removed, so threads may
  /// test candidates independently; conflicts among them are tested later.
  std::vector<std::vector<Dart>> hopeful(std::uint64_t first, std::uint64_t count) const {
    std::vector<std::vector<Dart>> parts((count + candidates_of_a_part - 1) / candidates_of_a_part);
    parallel_for(parts.size(), threads_, [&](std::size_t part) {
      const std::uint64_t begin = first + part * candidates_of_a_part;
      const std::uint64_t end = std::min(begin + candidates_of_a_part, first + count);
      for (std::uint64_t n = begin; n < end; ++n) {
        std::optional<Dart> dart = candidate(n);
        if (!dart || !is_free(*dart)) continue;
        dart->pose = grain_pose(sketch_, *dart, draws_);
        if (!sketch_.spacing.solid || has_room(*dart)) parts[part].push_back(*dart);
      }
    });
    return parts;
  }

  bool fits(const Dart& dart) const { return is_free(dart) && (!sketch_.spacing.solid || has_room(dart)); }

  std::optional<Dart> candidate(std::uint64_t n) const {
    // A random triangle by weight, and a uniform point in it [Osada et al. 2002].
    const double weight = draws_.places.uniform(draws_per_candidate * n) * weight_;
    const auto after = std::upper_bound(weight_before_.begin(), weight_before_.end(), weight);
    const GrainTarget& target = targets_[static_cast<std::size_t>(after - weight_before_.begin()) - 1];
    const double root = std::sqrt(draws_.places.uniform(draws_per_candidate * n + 1));
    const double share = draws_.places.uniform(draws_per_candidate * n + 2);
    const GrainPlace far = blend(target.corner[1], 1 - share, target.corner[2], share);
    const GrainPlace place = blend(target.corner[0], 1 - root, far, root);

    // Candidates are as rare as grains at this place.
    const double density = density_at(sketch_, place);
    if (density <= 0) return std::nullopt;
    if (density < target.max && draws_.places.uniform(draws_per_candidate * n + 5) * target.max >= density) {
      return std::nullopt;
    }

    const std::optional<Footing> footing = footing_at(place, spacing_for(density));
    if (!footing) return std::nullopt;
    Dart dart;
    dart.center = footing->center;
    dart.normal = footing->normal;
    dart.spacing = footing->spacing;
    dart.number = n;
    dart.along = place.along;
    dart.tangent = unit_across(target.uphill, dart.normal);
    return dart;
  }

  /// The part of a dart that decides whether it is too near. It is small, because pieces of targets are many.
  struct Footing {
    glm::dvec3 center, normal;
    double spacing;
  };

  std::optional<Footing> footing_at(const GrainPlace& place, double spacing) const {
    const double size = glm::length(place.normal);
    if (!(size > 0)) return std::nullopt;
    const glm::dvec3 normal = place.normal * ((sketch_.on_front ? 1 : -1) / size);
    return Footing{place.position - normal * sketch_.stance.sink, normal, spacing};
  }

  double spacing_for(double density) const { return radius_ / std::sqrt(density); }

  /// Halves the targets along their longest edges down to an eighth of their spacing, and leaves out those that lie
  /// within the reach of one dart.
  void aim_at_free_places() {
    // Threads share the targets in runs, the last target first. If slivers are halved too often, what is left out
    // depends on the order, so then one thread works alone.
    std::vector<std::vector<GrainTarget>> free((targets_.size() + targets_of_a_part - 1) / targets_of_a_part);
    std::atomic<std::size_t> splits = 0;
    parallel_for(free.size(), threads_, [&](std::size_t part) {
      const std::size_t end = targets_.size() - part * targets_of_a_part;
      const std::size_t begin = end > targets_of_a_part ? end - targets_of_a_part : 0;
      for (std::size_t i = end; i-- > begin;) add_free_pieces(targets_[i], splits, free[part]);
    });
    if (splits > max_splits) {
      splits = 0;
      free.assign(1, {});
      for (std::size_t i = targets_.size(); i-- > 0;) add_free_pieces(targets_[i], splits, free.front());
    }

    targets_.clear();
    weight_before_.clear();
    weight_ = 0;
    for (std::vector<GrainTarget>& some : free) {
      for (const GrainTarget& target : some) add_target(target);
      some = {};  // frees what may be a gigabyte of slivers before it is copied
    }
    fresh_cells_.clear();
    first_fresh_ = darts_.size();
    has_aimed_ = true;
  }

  /// The pieces of a target, the last first, in which a dart may find a place.
  void add_free_pieces(const GrainTarget& whole, std::atomic<std::size_t>& splits,
                       std::vector<GrainTarget>& free) const {
    std::vector<Pending> pending{{whole, has_aimed_}};
    while (!pending.empty()) {
      auto& [target, aimed_at] = pending.back();
      if (!aimed_at) target.max = max_density(sketch_, target);
      if (target.max <= 0 || is_taken(target, aimed_at)) {
        pending.pop_back();
        continue;
      }
      const std::size_t edge = longest_edge(target);
      const GrainPlace &a = target.corner[edge], &b = target.corner[(edge + 1) % 3];
      const bool is_small = glm::distance(a.position, b.position) < spacing_for(target.max) / 8;
      if (is_small || ++splits > max_splits) {
        free.push_back(target);
        pending.pop_back();
        continue;
      }
      const GrainPlace middle = blend(a, 0.5, b, 0.5);
      aimed_at = false;
      pending.push_back(pending.back());
      pending.end()[-2].target.corner[edge] = middle;
      pending.back().target.corner[(edge + 1) % 3] = middle;
    }
  }

  static std::size_t longest_edge(const GrainTarget& target) {
    std::array<double, 3> length{};
    for (std::size_t k = 0; k < 3; ++k) {
      length[k] = glm::distance(target.corner[k].position, target.corner[(k + 1) % 3].position);
    }
    return static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  }

  /// True only if no candidate in the target could be free, even with the smallest spacing. For a target that was aimed
  /// at before, only newer darts need a test.
  bool is_taken(const GrainTarget& target, bool aimed_at) const {
    const double spacing = spacing_for(target.max);
    const std::optional<Footing> first = footing_at(target.corner[0], spacing);
    if (!first) return false;
    const auto covers = [&](const Dart& known, bool any_facing) {
      // Most darts are not near the first corner; then the other corners need no test.
      if (!is_too_near(known, *first, any_facing)) return false;
      return std::all_of(target.corner.begin() + 1, target.corner.end(), [&](const GrainPlace& place) {
        const std::optional<Footing> footing = footing_at(place, spacing);
        return footing && is_too_near(known, *footing, any_facing);
      });
    };
    if (!aimed_at) return any_near(*first, covers);
    const auto fresh_covers = [&](std::size_t i) { return covers(darts_[i], sketch_.spacing.any_facing); };
    if (darts_.size() - first_fresh_ > few) return fresh_cells_.any_meets(first->center, spacing, fresh_covers);
    for (std::size_t i = first_fresh_; i < darts_.size(); ++i) {
      if (fresh_covers(i)) return true;
    }
    return false;
  }

  bool is_free(const Dart& dart) const {
    const Footing footing{dart.center, dart.normal, dart.spacing};
    return !any_near(footing,
                     [&](const Dart& known, bool any_facing) { return is_too_near(known, footing, any_facing); });
  }

  /// True if question(dart, whether its facing does not matter) holds for any dart that may be too near.
  template <typename Question>
  bool any_near(const Footing& footing, const Question& question) const {
    const auto own = [&](std::size_t i) { return question(darts_[i], sketch_.spacing.any_facing); };
    const auto other = [&](std::size_t i) { return question(others_[i], true); };
    return cells_.any_meets(footing.center, footing.spacing, own) ||
           other_cells_.any_meets(footing.center, footing.spacing, other);
  }

  static bool is_too_near(const Dart& one, const Footing& other, bool any_facing) {
    return glm::distance(one.center, other.center) < 0.5 * (one.spacing + other.spacing) &&
           (any_facing || glm::dot(one.normal, other.normal) > 0);
  }

  static double diameter(const GrainPose& pose) { return 2 * max_radius(pose); }

  /// True unless it overlaps the ellipsoid of another grain. Bodies number the others first, then this kind.
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
  Threads threads_;
  std::span<const Dart> others_;
  std::vector<GrainTarget> targets_;
  std::vector<double> weight_before_;  ///< per target: area times `max` of all before it
  double weight_ = 0;
  std::uint64_t next_candidate_ = 0;
  DartCells cells_, other_cells_, bodies_;
  DartCells fresh_cells_;  ///< the darts since the last aim
  std::size_t first_fresh_ = 0;
  bool has_aimed_ = false;  ///< whether all targets are those of the last aim
  std::vector<Dart> darts_;
};

}  // namespace

double room_for_grains(const std::vector<GrainTarget>& targets, const GrainSketch& sketch) {
  double weight = 0;
  for (const GrainTarget& target : targets) weight += area_of(target) * max_density(sketch, target);
  // A full surface has some 0.7 grains per squared radius.
  return 0.7 * weight / (sketch.spacing.poisson_radius * sketch.spacing.poisson_radius);
}

std::vector<Dart> thrown_darts(std::vector<GrainTarget> targets, const GrainSketch& sketch, const GrainDraws& draws,
                               Threads threads, std::span<const Dart> others) {
  return DartThrower(std::move(targets), sketch, draws, threads, others).throw_all();
}

}  // namespace pomona
