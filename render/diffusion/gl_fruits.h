// Fruits in storage buffers, kept there from call to call.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>

#include "render/diffusion/ray_surfaces.h"
#include "render/gl/objects.h"

namespace pomona {

/// The start of a fruit in the buffers.
struct FruitPlace {
  std::uint32_t node = 0, triangle = 0, vertex = 0;
};

/// Fruits one behind the other, until no more fit. Destroy this object while its context is current.
class GlFruits {
 public:
  /// \param max_bytes  of each buffer
  explicit GlFruits(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  /// The place of the fruit with this number; nothing if it is not here.
  std::optional<FruitPlace> place(std::uint64_t number) const;

  /// Adds a fruit behind the others; nothing if there is no room for it.
  /// \throws Error (helper_missing) if it needs more than there can be.
  std::optional<FruitPlace> add(const CurrentGl& gl, std::uint64_t number, const RaySurfaces& fruit);

  /// Forgets all fruits. Rays that were started still see theirs.
  void clear();

  /// Nodes, triangles, sides, colours, in this order.
  std::array<const GlBuffer*, 4> buffers() const;

 private:
  /// A buffer that holds `used` bytes of `size`.
  struct Growing {
    std::optional<GlBuffer> buffer;
    std::size_t size = 0, used = 0;

    void append(const CurrentGl& gl, std::span<const std::byte> bytes, std::size_t max_bytes);
  };

  std::size_t max_bytes_;
  std::array<Growing, 4> buffer_;
  FruitPlace next_;
  std::map<std::uint64_t, FruitPlace> place_;
};

}  // namespace pomona
