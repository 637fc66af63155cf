#include "generator/scene/item_maker.h"

#include <algorithm>
#include <string>
#include <utility>

#include "generator/base/error.h"

namespace pomona {

std::vector<int> totals_of(const SceneDescription& scene) {
  double all = 0;
  for (const PiecesDescription& pieces : scene.pieces) all += pieces.share;
  std::vector<int> totals;
  std::vector<std::pair<double, std::size_t>> rests;
  int left = scene.total;
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
    const PiecesDescription& pieces = scene.pieces[i];
    totals.push_back(pieces.total);
    if (pieces.share <= 0) continue;
    const double wanted = scene.total * pieces.share / all;
    totals.back() = static_cast<int>(wanted);
    left -= totals.back();
    rests.emplace_back(static_cast<double>(totals.back()) - wanted, i);
  }
  std::sort(rests.begin(), rests.end());
  for (std::size_t k = 0; k < rests.size() && left > 0; ++k, --left) ++totals[rests[k].second];
  return totals;
}

ItemMaker::ItemMaker(const SceneDescription& scene, std::size_t entry, int total, SceneParts& parts)
    : pieces_(scene.pieces[entry]), parts_(parts), total_(static_cast<std::size_t>(total)) {
  for (std::size_t k = 0; k < scene.dishes.size(); ++k)
    if (scene.dishes[k].name == pieces_.dish) dish_ = static_cast<int>(k) + (scene.bowl ? 1 : 0);
  if (pieces_.dish.empty() && scene.bowl) dish_ = 0;
  if (pieces_.where) {
    arrangement_ = static_cast<int>(parts_.arrangements.size());
    parts_.arrangements.push_back(*pieces_.where);
  }
}

void ItemMaker::add(Solid solid, int fruit) {
  const bool has_total = pieces_.total > 0 || pieces_.share > 0;
  const std::size_t times =
      has_total ? total_ / solids_ + (next_ < total_ % solids_ ? 1 : 0) : static_cast<std::size_t>(pieces_.copies);
  ++next_;
  if (times == 0) return;
  if (parts_.items.size() + times > max_scene_pieces) {
    throw Error(ExitStatus::bad_data, {{pieces_.place,
                                        "pieces \"" + pieces_.name + "\": with these the scene has more than " +
                                            std::to_string(max_scene_pieces) + " pieces",
                                        "lower \"copies\", \"take\" or \"count\", or say how many by \"total\""}});
  }
  SettleItem item{.solid = static_cast<int>(parts_.solids.size()),
                  .name = solid.name,
                  .order = pieces_.order,
                  .face_up = pieces_.face_up,
                  .beside = pieces_.beside,
                  .upright = pieces_.upright,
                  .arrangement = arrangement_,
                  .place = pieces_.place};
  for (std::size_t copy = 0; copy < times; ++copy) {
    // Each copy of a fruit counts as a fruit.
    item.fruit = fruit + static_cast<int>(copy) * max_fruits;
    if (copy > 0) item.name = solid.name + ".copy-" + std::to_string(copy + 1);
    parts_.items.push_back(item);
    parts_.dish_of.push_back(dish_);
  }
  parts_.solids.push_back(std::move(solid));
}

}  // namespace pomona
