#include "generator/scene/settle_heaps.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "generator/base/parallel.h"

namespace pomona {

namespace {

/// The pieces in or on one dish.
struct HeapOfScene {
  int dish = -1;  ///< index; -1 = the ground
  bool on_top = false;
  std::vector<std::size_t> member;  ///< indices of the scene's items
  std::vector<SettleItem> items;
  Solid merged;  ///< the dish merged with its parts, if it has any
};

Pose inverse(const Pose& pose) {
  const glm::dquat back = glm::conjugate(pose.rotation);
  return {back, back * -pose.translation};
}

Pose chained(const Pose& outer, const Pose& inner) {
  return {outer.rotation * inner.rotation, outer.rotation * inner.translation + outer.translation};
}

/// Rounded as in a layout file.
Pose rounded(const Pose& pose) {
  const auto round = [](double value) { return std::round(value * 1e6) / 1e6 + 0.0; };
  const glm::dquat q = pose.rotation.w < 0 ? -pose.rotation : pose.rotation;
  const glm::dvec3& t = pose.translation;
  return {glm::dquat(round(q.w), round(q.x), round(q.y), round(q.z)), {round(t.x), round(t.y), round(t.z)}};
}

/// The meshes of a dish and its parts as one, in the dish's frame; empty if it has no parts.
Solid merged_with_parts(const SceneParts& parts, int dish) {
  const ScenePlacedDish& whole = parts.dishes[static_cast<std::size_t>(dish)];
  const auto is_part = [&](const ScenePlacedDish& other) { return other.part_of == dish; };
  Solid merged;
  if (std::none_of(parts.dishes.begin(), parts.dishes.end(), is_part)) return merged;
  const Pose back = inverse(whole.pose);
  for (const ScenePlacedDish& each : parts.dishes) {
    if (&each != &whole && !is_part(each)) continue;
    const Solid& solid = parts.solids[static_cast<std::size_t>(each.solid)];
    const Pose pose = chained(back, each.pose);
    const auto first = static_cast<unsigned>(merged.mesh.position.size());
    for (const glm::vec3& p : solid.mesh.position)
      merged.mesh.position.emplace_back(pose.rotation * glm::dvec3(p) + pose.translation);
    for (const glm::uvec3& t : solid.mesh.triangle) merged.mesh.triangle.push_back(t + first);
  }
  return merged;
}

std::vector<HeapOfScene> heaps_of(const SceneDescription& scene, const SceneParts& parts) {
  std::vector<HeapOfScene> heaps(parts.dishes.size() + 1);
  for (std::size_t i = 0; i < parts.items.size(); ++i) {
    HeapOfScene& heap = heaps[static_cast<std::size_t>(parts.dish_of[i] + 1)];
    heap.dish = parts.dish_of[i];
    heap.member.push_back(i);
    heap.items.push_back(parts.items[i]);
  }
  std::erase_if(heaps, [](const HeapOfScene& heap) { return heap.items.empty(); });
  for (HeapOfScene& heap : heaps) {
    if (heap.dish < 0) continue;
    const std::string& name = parts.dishes[static_cast<std::size_t>(heap.dish)].name;
    heap.merged = merged_with_parts(parts, heap.dish);
    heap.on_top = std::any_of(scene.pieces.begin(), scene.pieces.end(),
                              [&](const PiecesDescription& p) { return p.dish == name && p.on_top; });
  }
  return heaps;
}

DishForm form_of(const HeapOfScene& heap, const SceneParts& parts) {
  if (heap.dish < 0) return {};
  const ScenePlacedDish& dish = parts.dishes[static_cast<std::size_t>(heap.dish)];
  const bool is_merged = !heap.merged.mesh.triangle.empty();
  DishForm form(is_merged ? &heap.merged : &parts.solids[static_cast<std::size_t>(dish.solid)]);
  form.turned = dish.turned && !is_merged && !heap.on_top;
  form.on_top = heap.on_top;
  form.name = dish.name;
  return form;
}

/// Adds up the progress of the heaps, stage by stage, one call at a time.
class HeapsTeller {
 public:
  HeapsTeller(const ComposeOptions& options, std::size_t heaps, std::size_t total)
      : options_(options), settled_(heaps), measured_(heaps), total_(total) {}

  void tell(std::size_t heap, const std::string& stage, std::size_t done) {
    if (!options_.progress) return;
    const std::lock_guard lock(mutex_);
    (stage == "measure" ? measured_ : settled_)[heap] = done;
    if (stage == "measure") settled_[heap] = std::max(settled_[heap], done);
    const auto sum = [](const std::vector<std::size_t>& all) {
      std::size_t number = 0;
      for (const std::size_t each : all) number += each;
      return number;
    };
    // While any heap still falls, the stage is falling.
    const std::size_t settled = sum(settled_);
    if (settled < total_ || stage == "settle") return options_.progress("settle", settled, total_);
    options_.progress("measure", sum(measured_), total_);
  }

 private:
  const ComposeOptions& options_;
  std::vector<std::size_t> settled_, measured_;
  std::size_t total_;
  std::mutex mutex_;
};

}  // namespace

SettledHeaps settled_heaps(const SceneDescription& scene, const SceneParts& parts, const ComposeOptions& options) {
  const std::vector<HeapOfScene> heaps = heaps_of(scene, parts);
  HeapsTeller teller(options, heaps.size(), parts.items.size());
  std::vector<Settled> settled(heaps.size());
  parallel_for(heaps.size(), options.threads, [&](std::size_t k) {
    SettleOptions how;
    how.seed = scene.seed;
    how.fill = scene.fill;
    how.spread = scene.spread;
    how.around = scene.around;
    how.attempts = scene.attempts;
    how.world.friction = scene.friction;
    how.arrangements = parts.arrangements;
    how.threads = options.threads;
    how.progress = [&, k](const std::string& stage, std::size_t done, std::size_t) { teller.tell(k, stage, done); };
    settled[k] = settle(parts.solids, heaps[k].items, form_of(heaps[k], parts), how);
  });

  SettledHeaps result;
  result.heaps = heaps.size();
  for (const ScenePlacedDish& dish : parts.dishes) result.poses.push_back(rounded(dish.pose));
  const std::size_t first = result.poses.size();
  result.poses.resize(first + parts.items.size());
  result.fits.resize(parts.items.size());
  for (std::size_t k = 0; k < heaps.size(); ++k) {
    for (std::size_t i = 0; i < heaps[k].member.size(); ++i) {
      const Pose& own = settled[k].poses[i];
      const bool moved = heaps[k].dish >= 0 && heaps[k].member.size() > 0;
      const Pose& dish = moved ? parts.dishes[static_cast<std::size_t>(heaps[k].dish)].pose : Pose{};
      result.poses[first + heaps[k].member[i]] = rounded(chained(dish, own));
      result.fits[heaps[k].member[i]] = settled[k].fits[i];
    }
    result.attempts = std::max(result.attempts, settled[k].attempts);
    result.steps += settled[k].steps;
    result.again += settled[k].again;
  }
  return result;
}

}  // namespace pomona
