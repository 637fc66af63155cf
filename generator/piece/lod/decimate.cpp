#include "generator/piece/lod/decimate.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>

#include "generator/piece/lod/collapse.h"
#include "generator/piece/lod/collapse_cost.h"
#include "generator/piece/lod/collapse_rules.h"
#include "generator/piece/lod/level_cover.h"
#include "generator/piece/lod/patch_cover.h"

namespace pomona {
namespace {

/// The cheapest collapse of a vertex, as far as is known.
struct CheapestCollapse {
  double cost = 0;
  std::uint32_t fan = 0, to = 0;

  /// The greatest cost first, as heaps require; no two are equal.
  bool operator<(const CheapestCollapse& b) const { return cost != b.cost ? cost > b.cost : fan > b.fan; }
};

/// A vertex in the queue: at most once.
struct QueuedFan {
  bool is_locked = false;
  bool is_queued = false;
  bool is_stale = false;               ///< its ring has changed since it was put there
  std::vector<std::uint32_t> refused;  ///< neighbours it may not move to, until its ring changes
};

class Decimation {
 public:
  Decimation(const LevelSource& source, double metres_per_color, const std::vector<std::uint8_t>& locked)
      : source_(source),
        level_(level_mesh(source)),
        costs_(collapse_costs(source, level_, metres_per_color)),
        cover_(source),
        fans_(source.position.size()) {
    for (std::size_t f = 0; f < locked.size(); ++f) fans_[f].is_locked = locked[f] != 0;
  }

  const LevelMesh& level() const { return level_; }

  /// Per face: 1 if it has changed in the last level.
  const std::vector<std::uint8_t>& changed() const { return changed_; }

  void reach(const LevelTarget& target) {
    // With looser bounds, refused collapses are tried again.
    changed_.assign(source_.patch.size(), 0);
    for (std::uint32_t fan = 0; fan < fans_.size(); ++fan) {
      if (level_.mesh.has(fan)) renew(fan);
    }
    while (level_.faces > target.faces && !queue_.empty()) {
      const CheapestCollapse cheapest = queue_.top();
      queue_.pop();
      take(cheapest, target.bounds);
    }
  }

 private:
  void take(const CheapestCollapse& cheapest, const LevelBounds& bounds) {
    QueuedFan& queued = fans_[cheapest.fan];
    queued.is_queued = false;
    if (!level_.mesh.has(cheapest.fan)) return;
    if (!queued.is_stale) {
      std::optional<Collapse> collapse = collapse_of(source_, level_, cheapest.fan, cheapest.to);
      if (collapse && allows(source_, level_, bounds, cover_, *collapse)) {
        make(*collapse);
        return;
      }
      queued.refused.push_back(cheapest.to);
    }
    enqueue(cheapest.fan);
  }

  void make(const Collapse& collapse) {
    take_over_shape(costs_, source_, collapse.fan, collapse.to());
    for (const CollapseSector& sector : collapse.sector) {
      take_over_tint(costs_, sector.from, sector.to);
      for (const CollapseTarget& target : sector.target) changed_[target.face] = 1;
    }
    apply(level_, collapse);
    for (const Spoke& spoke : collapse.ring) renew(spoke.fan);
  }

  /// Called after a change at the vertex. Costs usually grow, so a queued collapse is evaluated again only when its
  /// turn comes.
  void renew(std::uint32_t fan) {
    fans_[fan].refused.clear();
    fans_[fan].is_stale = true;
    if (!fans_[fan].is_queued) enqueue(fan);
  }

  /// Enqueues the cheapest collapse that has not been refused. Vertices on a border move along it; where borders meet
  /// or end, vertices are kept.
  void enqueue(std::uint32_t fan) {
    QueuedFan& queued = fans_[fan];
    queued.is_stale = false;
    if (queued.is_locked) return;
    ring_ = ring_around(level_.mesh, fan, std::move(ring_));
    const auto on_border = [&](const Spoke& spoke) { return level_.is_border(spoke.half_edge); };
    const auto borders = std::count_if(ring_.begin(), ring_.end(), on_border);
    if (borders != 0 && borders != 2) return;
    CheapestCollapse best{.cost = std::numeric_limits<double>::infinity(), .fan = fan, .to = none};
    for (const Spoke& spoke : ring_) {
      if (borders != 0 && !on_border(spoke)) continue;
      if (std::find(queued.refused.begin(), queued.refused.end(), spoke.fan) != queued.refused.end()) continue;
      const double cost = cost_of(costs_, source_, level_, fan, spoke, borders != 0);
      if (cost < best.cost || (cost == best.cost && spoke.fan < best.to)) best.cost = cost, best.to = spoke.fan;
    }
    if (best.to == none) return;
    queued.is_queued = true;
    queue_.push(best);
  }

  const LevelSource& source_;
  LevelMesh level_;
  CollapseCosts costs_;
  PatchCover cover_;
  std::vector<QueuedFan> fans_;  // per fan
  std::vector<std::uint8_t> changed_;
  std::priority_queue<CheapestCollapse> queue_;
  Ring ring_;
};

}  // namespace

std::vector<std::vector<LevelFace>> decimated(const VertexFans& fans, const SolidMesh& solid,
                                              std::span<const LevelTarget> levels) {
  std::vector<std::vector<LevelFace>> faces;
  if (levels.empty()) return faces;
  const LevelSource source = level_source(fans, solid);
  const LevelBounds& bounds = levels.front().bounds;
  std::vector<std::uint8_t> locked = fans.is_locked;
  std::vector<std::uint32_t> uncovered;
  do {
    Decimation decimation(source, bounds.distance / bounds.color, locked);
    std::vector<std::uint32_t> near(source.patch.size());
    std::iota(near.begin(), near.end(), 0u);
    faces.clear();
    for (const LevelTarget& level : levels) {
      decimation.reach(level);
      uncovered = uncovered_faces(source, decimation.level(), level.bounds.distance, decimation.changed(), near);
      if (!uncovered.empty()) break;
      faces.push_back(faces_of(decimation.level(), fans));
    }
    // Corners of faces that are too far off are locked, and decimation starts again.
    for (const std::uint32_t face : uncovered)
      for (const std::uint32_t fan : source.mesh.corner[face]) locked[fan] = 1;
  } while (!uncovered.empty());
  return faces;
}

}  // namespace pomona
