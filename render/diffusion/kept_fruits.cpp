#include "render/diffusion/kept_fruits.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace pomona {

namespace {

template <typename Value>
std::size_t bytes_of(const std::vector<Value>& values) {
  return values.size() * sizeof(Value);
}

template <typename Value>
bool same_bits(const std::vector<Value>& one, const std::vector<Value>& other) {
  return one.size() == other.size() && (one.empty() || std::memcmp(one.data(), other.data(), bytes_of(one)) == 0);
}

}  // namespace

/// A fruit, with a copy of all that it depends on.
struct KeptFruits::Kept {
  std::vector<glm::vec3> position;
  std::vector<Color> front_color, back_color;
  std::vector<glm::uvec3> triangle;
  std::vector<std::int32_t> front_part, back_part;
  PreparedFruit fruit;

  explicit Kept(const DiffusionSurfaces& s)
      : position(s.position),
        front_color(s.front_color),
        back_color(s.back_color),
        triangle(s.triangle),
        front_part(s.front_part),
        back_part(s.back_part) {}

  bool is_of(const DiffusionSurfaces& s) const {
    return same_bits(position, s.position) && same_bits(triangle, s.triangle) &&
           same_bits(front_color, s.front_color) && same_bits(back_color, s.back_color) &&
           same_bits(front_part, s.front_part) && same_bits(back_part, s.back_part);
  }

  std::size_t bytes() const {
    std::size_t sum = bytes_of(position) + bytes_of(front_color) + bytes_of(back_color) + bytes_of(triangle) +
                      bytes_of(front_part) + bytes_of(back_part) + bytes_of(fruit.tree.order);
    for (const auto& level : fruit.tree.levels) sum += bytes_of(level);
    return sum;
  }
};

KeptFruit KeptFruits::of(const DiffusionSurfaces& surfaces) {
  if (std::shared_ptr<const PreparedFruit> same = found(surfaces)) return {same, false};
  SurfaceTree tree = make_surface_tree(surfaces);
  const auto made = std::make_shared<Kept>(surfaces);
  made->fruit.hull = hull_of(surfaces, tree);
  made->fruit.frame = ray_frame(surfaces, tree);
  made->fruit.tree = std::move(tree);
  {
    const std::lock_guard lock(mutex_);
    made->fruit.number = next_number_++;
  }
  keep(made);
  return {{made, &made->fruit}, true};
}

std::shared_ptr<const PreparedFruit> KeptFruits::found(const DiffusionSurfaces& surfaces) {
  // Compare outside the lock: others look at the same time.
  std::vector<std::shared_ptr<const Kept>> kept;
  {
    const std::lock_guard lock(mutex_);
    kept.assign(kept_.begin(), kept_.end());
  }
  const auto same = std::find_if(kept.begin(), kept.end(), [&](const auto& one) { return one->is_of(surfaces); });
  if (same == kept.end()) return nullptr;

  const std::lock_guard lock(mutex_);
  const auto place = std::find(kept_.begin(), kept_.end(), *same);
  if (place != kept_.end()) kept_.splice(kept_.begin(), kept_, place);
  return {*same, &(*same)->fruit};
}

void KeptFruits::keep(std::shared_ptr<const Kept> fruit) {
  const std::lock_guard lock(mutex_);
  bytes_ += fruit->bytes();
  kept_.push_front(std::move(fruit));
  while (bytes_ > max_bytes_) {
    bytes_ -= kept_.back()->bytes();
    kept_.pop_back();
  }
}

}  // namespace pomona
