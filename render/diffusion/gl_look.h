// Points that look along lines, by compute shader.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/diffusion/gl_fruits.h"
#include "render/gl/program.h"

namespace pomona {

/// Up to 64 neighbouring points in one fruit: what a work-group looks from.
struct PointGroup {
  static constexpr std::size_t size = 64;

  std::size_t fruit = 0;       ///< of those uploaded
  std::uint32_t parts = 0;     ///< that the fruit uses
  std::vector<glm::vec3> eye;  ///< normalised
};

/// What a point sees: sums over all lines, both ways.
struct Sight {
  glm::vec3 mean{0};           ///< linear colour
  float weight = 0;            ///< sum of 1 / d, normalised; 0 where nothing is seen
  std::uint32_t heaviest = 0;  ///< the part with the largest share of the weight, of those in use
  float scatter = 0;  ///< how far blocks of lines disagree, as the standard error of the colour's worst channel
};

/// The compute shaders, and how much a storage buffer of this OpenGL holds. Destroy them while their context is
/// current.
class GlLook {
 public:
  /// \param most_bytes  buffers hold no more than this, however much a card allows
  /// \throws Error (helper_missing) if this OpenGL is older than 4.5.
  GlLook(const CurrentGl& gl, const GlContext& context, std::size_t most_bytes = std::size_t{256} << 20);

  std::size_t most_bytes() const { return most_bytes_; }

  /// One sight for each eye, group by group, along `lines` lines. What a point sees depends on nothing but itself,
  /// its fruit and the number of lines. All is done when this returns.
  /// \throws Error (helper_missing) if memory does not suffice.
  std::vector<Sight> along(const CurrentGl& gl, const GlFruits& fruits, std::span<const PointGroup> groups,
                           int lines) const;

 private:
  class Pass;

  Program rays_;
  Program sums_;
  std::size_t most_bytes_;
};

}  // namespace pomona
