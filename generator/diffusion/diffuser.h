// Diffusion: colours in the volume from the colours on surfaces (paper, sections 3.2 and 3.3).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/section/cross_section.h"
#include "generator/diffusion/quality.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// One entry per point.
struct DiffusedColors {
  std::vector<Color> color;        ///< linear, never outside the hull of the surfaces' colours
  std::vector<std::int32_t> part;  ///< the part whose sides hold the largest share of the point's weight
};

/// The colours in the volume of one fruit: set up once from its surfaces, then asked for any number of cuts, texels
/// or probes.
class ColorField {
 public:
  virtual ~ColorField() = default;

  /// Colours at `points` (metres). A point on a surface takes the colour of its nearest side; where nothing is
  /// seen at all, that of the nearest surface.
  /// \throws Error (bad_data) if a coordinate is not finite.
  virtual DiffusedColors at(std::span<const glm::vec3> points) const = 0;
};

/// One fruit of a batch. All that it refers to must outlive the call.
struct DiffusionTask {
  const DiffusionSurfaces* surfaces = nullptr;
  std::span<const glm::vec3> points;
};

/// The interface of all diffusers. They differ in the method of diffusion.
class Diffuser {
 public:
  virtual ~Diffuser() = default;

  /// The field of `surfaces` as sheets() leaves them, which must outlive it.
  /// \throws Error (bad_data) if there are no surfaces, or none with an area.
  virtual std::unique_ptr<ColorField> field(const DiffusionSurfaces& surfaces) const = 0;

  /// Many fruits at once; the colours do not depend on what else is in the batch.
  virtual std::vector<DiffusedColors> diffuse_all(std::span<const DiffusionTask> tasks) const;

  /// The name in --diffuser and in --stats.
  virtual const char* name() const = 0;

  /// The device, for --stats: "cpu", or the name of OpenGL's renderer.
  virtual std::string device() const { return "cpu"; }

  /// The colours of one fruit at some points.
  DiffusedColors diffuse(const DiffusionSurfaces& surfaces, std::span<const glm::vec3> points) const;
};

/// Gives every interior vertex of the section its colour and part.
CrossSection colored(CrossSection section, const DiffusionSurfaces& surfaces, const Diffuser& diffuser);

/// The same for many sections at once, each with its own surfaces: the diffuser gets them as one batch.
std::vector<CrossSection> colored(std::vector<CrossSection> sections,
                                  std::span<const DiffusionSurfaces* const> surfaces, const Diffuser& diffuser);

}  // namespace pomona
