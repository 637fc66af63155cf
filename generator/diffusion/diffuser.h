// Diffusion: colours in the volume from the colours on surfaces (paper, sections 3.2 and 3.3).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/cross_section.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// One entry per point.
struct DiffusedColors {
  std::vector<Color> color;        ///< linear, never outside the hull of the surfaces' colours
  std::vector<std::int32_t> part;  ///< the part whose sides hold the largest share of the point's weight
};

/// The one interface with more than one implementation: what differs is how a colour diffuses.
class Diffuser {
 public:
  virtual ~Diffuser() = default;

  /// Colours at `points` (metres) from `surfaces` as sheets() leaves them. A point on a surface takes the
  /// colour of its nearest side; where nothing is seen at all, that of the nearest surface.
  /// \throws Error (bad_data) if there are no surfaces, or a coordinate is not finite.
  virtual DiffusedColors diffuse(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points) const = 0;

  /// As in --diffuser and in --stats.
  virtual const char* name() const = 0;
};

/// The error of the diffusion, nothing else (docs/diffusion.md states them, measured).
enum class Quality { draft, final, reference };

/// Gives every interior vertex of the section its colour and part.
CrossSection colored(CrossSection section, const DiffusionSurfaces& surfaces, const Diffuser& diffuser);

}  // namespace pomona
