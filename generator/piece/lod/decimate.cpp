#include "generator/piece/lod/decimate.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

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
  std::uint32_t fan = 0, to = none;

  bool operator==(const CheapestCollapse&) const = default;

  /// The greatest cost first, as heaps require; no two are equal.
  bool operator<(const CheapestCollapse& b) const {
    return cost != b.cost ? cost > b.cost : fan != b.fan ? fan > b.fan : to > b.to;
  }
};

struct QueuedFan {
  bool is_locked = false;
  bool is_stale = true;                  ///< its ring has changed since its collapses were listed
  std::uint32_t listed = 0;              ///< how often they were
  std::vector<CheapestCollapse> choice;  ///< the cheapest last; what was refused is not there
  CheapestCollapse queued;               ///< to none if it is not in the queue; what else the queue has is outdated
};

/// A collapse that exceeded the bounds. It is tried again with looser ones.
struct ExceedingCollapse {
  CheapestCollapse collapse;
  std::uint32_t listed = 0;  ///< as often was the vertex, then
};

class Decimation {
 public:
  Decimation(const LevelSource& source, double metres_per_color, const std::vector<std::uint8_t>& locked)
      : source_(source),
        level_(level_mesh(source)),
        costs_(collapse_costs(source, level_, metres_per_color)),
        cover_(source),
        fans_(source.position.size()) {
    for (std::uint32_t fan = 0; fan < locked.size(); ++fan) {
      fans_[fan].is_locked = locked[fan] != 0;
      enqueue(fan);
    }
  }

  const LevelMesh& level() const { return level_; }

  /// Per face: 1 if it has changed in the last level.
  const std::vector<std::uint8_t>& changed() const { return changed_; }

  void reach(const LevelTarget& target) {
    changed_.assign(source_.patch.size(), 0);
    try_exceeding_again();
    while (level_.faces > target.faces && !queue_.empty()) {
      const CheapestCollapse cheapest = queue_.top();
      queue_.pop();
      CheapestCollapse& queued = fans_[cheapest.fan].queued;
      if (!level_.mesh.has(cheapest.fan) || cheapest != queued) continue;
      queued = {};
      take(cheapest, target.bounds);
    }
  }

 private:
  /// After a refusal, the next collapse of the vertex takes its place in the queue.
  void take(const CheapestCollapse& cheapest, const LevelBounds& bounds) {
    QueuedFan& queued = fans_[cheapest.fan];
    if (!queued.is_stale) {
      queued.choice.pop_back();
      ring_ = ring_of_collapse(level_, cheapest.fan, cheapest.to, std::move(ring_));
      if (!ring_.empty() && keeps_sides(source_, level_, ring_)) {
        std::optional<Collapse> collapse = collapse_of(source_, level_, cheapest.fan, ring_);
        if (collapse && allows(source_, level_, bounds, cover_, *collapse)) return make(*collapse);
        if (collapse) exceeding_.push_back({cheapest, queued.listed});
      }
    }
    enqueue(cheapest.fan);
  }

  void try_exceeding_again() {
    for (const auto& [collapse, listed] : std::exchange(exceeding_, {})) {
      QueuedFan& queued = fans_[collapse.fan];
      if (!level_.mesh.has(collapse.fan) || queued.is_stale || queued.listed != listed) continue;
      queued.choice.insert(std::lower_bound(queued.choice.begin(), queued.choice.end(), collapse), collapse);
      if (queued.queued != queued.choice.back()) enqueue(collapse.fan);
    }
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
    fans_[fan].is_stale = true;
    if (fans_[fan].queued.to == none) enqueue(fan);
  }

  void enqueue(std::uint32_t fan) {
    QueuedFan& queued = fans_[fan];
    if (queued.is_locked) return;
    if (queued.is_stale) list_choices(fan);
    if (queued.choice.empty()) return;
    queued.queued = queued.choice.back();
    queue_.push(queued.queued);
  }

  /// Vertices on a border move along it; where borders meet or end, vertices are kept.
  void list_choices(std::uint32_t fan) {
    QueuedFan& queued = fans_[fan];
    queued.is_stale = false;
    ++queued.listed;
    queued.choice.clear();
    ring_ = ring_around(level_.mesh, fan, std::move(ring_));
    const auto on_border = [&](const Spoke& spoke) { return level_.is_border(spoke.half_edge); };
    const auto borders = std::count_if(ring_.begin(), ring_.end(), on_border);
    if (borders != 0 && borders != 2) return;
    for (const Spoke& spoke : ring_) {
      if (borders == 0 || on_border(spoke))
        queued.choice.push_back({cost_of(costs_, source_, level_, fan, spoke, borders != 0), fan, spoke.fan});
    }
    std::sort(queued.choice.begin(), queued.choice.end());
  }

  const LevelSource& source_;
  LevelMesh level_;
  CollapseCosts costs_;
  PatchCover cover_;
  std::vector<QueuedFan> fans_;  // per fan
  std::vector<std::uint8_t> changed_;
  std::priority_queue<CheapestCollapse> queue_;
  std::vector<ExceedingCollapse> exceeding_;
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
