#include "render/deliver/seed_row.h"

#include <string>
#include <utility>

#include "generator/scene/in_a_row.h"

namespace pomona {

std::vector<Order> each_seed(const Order& order) {
  std::vector<Order> all;
  for (const std::uint64_t seed : order.fruit.seeds) {
    all.push_back(order);
    all.back().fruit.seed = seed;
    all.back().fruit.seeds.clear();
  }
  return all;
}

std::vector<Solid> named_by_seed(std::vector<Solid> solids, std::uint64_t seed) {
  for (Solid& solid : solids) solid.name += "-seed-" + std::to_string(seed);
  return solids;
}

Scene row_of(std::vector<Solid> solids, const Style& style) {
  Scene row = in_a_row(std::move(solids));
  row.paper = style.paper;
  return row;
}

}  // namespace pomona
