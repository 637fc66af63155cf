#include "cli/options/scene_order.h"

#include <filesystem>

#include "cli/options/find_template.h"
#include "generator/order/ordered_fruit.h"

namespace pomona {

Order completed(Order order, const SceneDescription& scene) {
  if (!order.fruit.seed) order.fruit.seed = scene.seed;
  if (order.color.style.empty() && !scene.style.empty()) {
    const std::filesystem::path folder = std::filesystem::path(scene.file).parent_path();
    order.color.style = scene.style.ends_with(".toml") ? (folder / scene.style).string() : scene.style;
  }
  return order;
}

ComposeOptions compose_options(const Order& order, const DeliveryProgress& progress) {
  ComposeOptions options;
  options.find_template = find_template;
  options.variation = order.fruit.growing.variation;
  options.curves_only = order.fruit.growing.curves_only;
  options.detail = order.fruit.growing.detail;
  options.threads = order.threads;
  options.keep_section_colors = wants_textures(order.mesh);
  options.organs = wants_organs(order);
  options.progress = progress;
  return options;
}

}  // namespace pomona
