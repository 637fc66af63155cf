// Fruits made ready for rays, kept for the next cut and the next knife.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "generator/diffusion/resolved_colors.h"
#include "render/diffusion/ray_surfaces.h"

namespace pomona {

/// What is kept of a fruit beside its data on the card.
struct PreparedFruit {
  std::uint64_t number = 0;  ///< no other fruit has it
  SurfaceTree tree;
  ColorHull hull;
  RayFrame frame;
};

struct KeptFruit {
  std::shared_ptr<const PreparedFruit> fruit;
  bool is_new = false;
};

/// The fruits of the last calls, up to a number of bytes. Surfaces are compared bit by bit, so changed surfaces are a
/// new fruit. May be used by many threads.
class KeptFruits {
 public:
  explicit KeptFruits(std::size_t max_bytes = std::size_t{256} << 20) : max_bytes_(max_bytes) {}

  /// The fruit of these surfaces: one that is kept, or else a new one, kept from now on.
  /// \throws Error (bad_data) as make_surface_tree() and ray_frame() do.
  KeptFruit of(const DiffusionSurfaces& surfaces);

 private:
  struct Kept;

  std::shared_ptr<const PreparedFruit> found(const DiffusionSurfaces& surfaces);
  void keep(std::shared_ptr<const Kept> fruit);

  const std::size_t max_bytes_;
  std::mutex mutex_;
  std::list<std::shared_ptr<const Kept>> kept_;  ///< the latest first
  std::size_t bytes_ = 0;
  std::uint64_t next_number_ = 0;
};

}  // namespace pomona
