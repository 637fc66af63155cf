#include "cli/options/scene_order.h"

#include "cli/options/find_template.h"
#include "cli/options/program_folders.h"
#include "generator/base/beside.h"
#include "generator/order/ordered_fruit.h"

namespace pomona {

Order completed(Order order, const SceneDescription& scene) {
  if (!order.fruit.seed) order.fruit.seed = scene.seed;
  if (!order.color.style.empty()) {
    const std::string& typed = order.color.style;
    if (is_style_path(typed)) order.color.style_word = word_from(start_of_commands(scene.file), typed);
  } else if (!scene.style.empty()) {
    order.color.style = style_beside(scene.file, scene.style);
    order.color.style_word = scene.style;
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
