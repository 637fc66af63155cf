// Casts rays from points along lines, by compute shaders.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/diffusion/gl_fruits.h"
#include "render/gl/program.h"

namespace pomona {

/// Up to 64 neighbouring points in one fruit: the origins of the rays of one work-group.
struct PointGroup {
  static constexpr std::size_t size = 64;

  FruitPlace fruit;
  std::uint32_t parts = 0;         ///< number of parts that the fruit uses
  std::span<const glm::vec3> eye;  ///< the points, normalised
};

/// The surfaces visible from a point: sums over all lines, in both directions.
struct Sight {
  glm::vec3 mean{0};           ///< linear colour
  float weight = 0;            ///< sum of 1 / d, normalised; 0 if no ray hits anything
  std::uint32_t heaviest = 0;  ///< the used part with the largest share of the weight
  float scatter = 0;           ///< difference between blocks of lines: standard error of the colour's worst channel
  bool near_surface = false;   ///< within 1e-5 of the surfaces' size, or a little farther
};

/// Lines of rays, on the card.
struct GlLines {
  std::size_t count = 0;
  GlBuffer axes;
};

/// Rays that the card has been told to cast.
struct CastRays {
  std::vector<std::size_t> points;  ///< of each group
  std::vector<std::size_t> groups;  ///< of each pass
  std::vector<GlBuffer> seen;       ///< by each pass
};

/// The compute shaders, and the size limit of storage buffers. Destroy this object while its context is current.
class GlRayCaster {
 public:
  /// \param max_bytes  largest size of a buffer, even if the card allows more
  /// \throws Error (helper_missing) if this OpenGL is older than 4.5.
  GlRayCaster(const CurrentGl& gl, const GlContext& context, std::size_t max_bytes = std::size_t{256} << 20);

  std::size_t max_bytes() const { return max_bytes_; }

  static GlLines lines(const CurrentGl& gl, int count);

  /// Starts rays from the points of all groups on the card, and does not wait. The result of a point depends only on
  /// the point, its fruit and the lines.
  /// \throws Error (helper_missing) if memory does not suffice.
  CastRays cast(const CurrentGl& gl, const GlFruits& fruits, std::span<const PointGroup> groups,
                const GlLines& lines) const;

  /// Waits for one sight for each point, group by group.
  static std::vector<Sight> read(const CurrentGl& gl, const CastRays& rays);

 private:
  class Pass;

  Program rays_;
  Program sums_;
  Program near_;
  std::size_t max_bytes_;
};

}  // namespace pomona
