// True diffusion at single points, by random walks [Muller 1956; Sawhney and Crane 2020].
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "generator/diffusion/walk/walk_options.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct WalkGround;

/// One entry per point.
struct WalkResult {
  std::vector<Color> color;           ///< mean over all walks that met a surface, linear
  std::vector<std::int32_t> part;     ///< the part whose sides walks met most often
  std::vector<float> standard_error;  ///< standard error of the colour: RMS over channels, in 1/255
  std::vector<std::uint32_t> walks;   ///< number of walks; 0 where a point lies on a surface
  std::vector<std::uint32_t> misses;  ///< number of walks that escaped from open surfaces
};

/// Surfaces, prepared for walks. A walk jumps to a random place on the largest sphere around it that no surface reaches
/// into, again and again, until it is within 1e-4 of the surfaces' size of one, and takes the colour of that side. If
/// no walk meets a surface, the nearest side counts. Random numbers depend on the seed and the point's coordinates
/// only.
class WalkOnSpheres {
 public:
  /// `surfaces` must outlive it.
  /// \throws Error (bad_data) if a coordinate or a colour is not finite, or no triangle has any area.
  WalkOnSpheres(const DiffusionSurfaces& surfaces, const WalkOptions& options);
  ~WalkOnSpheres();

  /// \param points metres
  /// \throws Error (bad_data) if a coordinate is not finite.
  WalkResult at(std::span<const glm::vec3> points) const;

 private:
  std::unique_ptr<const WalkGround> ground_;
  WalkOptions options_;
};

}  // namespace pomona
