#include "generator/scene/compose.h"

#include <optional>
#include <utility>

#include "generator/base/stage_clock.h"
#include "generator/scene/layout_file.h"
#include "generator/scene/settle_heaps.h"

namespace pomona {

namespace {

std::vector<Instance> unplaced(const SceneParts& parts) {
  std::vector<Instance> instances;
  for (const ScenePlacedDish& dish : parts.dishes) instances.push_back({dish.solid, {}, dish.name});
  for (const SettleItem& item : parts.items) instances.push_back({item.solid, {}, item.name});
  return instances;
}

std::vector<Pose> settled_poses(const SceneDescription& scene, const SceneParts& parts, const ComposeOptions& options,
                                ComposeReport& report) {
  SettledHeaps settled = settled_heaps(scene, parts, options);
  report.fits = std::move(settled.fits);
  report.counts["settle_attempts"] = settled.attempts;
  report.counts["settle_steps"] = settled.steps;
  report.counts["settle_again"] = static_cast<std::int64_t>(settled.again);
  report.counts["heaps"] = static_cast<std::int64_t>(settled.heaps);
  return std::move(settled.poses);
}

}  // namespace

Scene placed(const SceneDescription& scene, SceneParts parts, const std::vector<Pose>& poses) {
  Scene result;
  result.instances = unplaced(parts);
  result.solids = std::move(parts.solids);
  if (scene.paper) result.paper = *scene.paper;
  result.ground = scene.ground;
  for (std::size_t i = 0; i < result.instances.size(); ++i) result.instances[i].pose = poses[i];
  result.view.vertical_field = scene.vertical_field;
  result.view = scene.view ? *scene.view : fitted_view(result, scene.view_direction);
  return result;
}

Composition compose(const SceneDescription& scene, const Diffuser* diffuser, const ComposeOptions& options) {
  // Reads the layout first, so that its mistakes are reported before hours of growing and cutting.
  const std::optional<Layout> layout = layout_of(scene);
  SceneParts parts = make_parts(scene, diffuser, options);
  Composition composition{{}, std::move(parts.report)};
  StageClock clock;
  const std::vector<Pose> poses = clock.time("settle", [&] {
    return layout ? poses_for(*layout, parts.solids, unplaced(parts))
                  : settled_poses(scene, parts, options, composition.report);
  });
  composition.report.stages.push_back(clock.stages().front());
  composition.scene = placed(scene, std::move(parts), poses);
  return composition;
}

}  // namespace pomona
