// The colours of a fruit's cut faces, kept for those who ask between the section's vertices: baked textures.
#pragma once

#include <memory>
#include <vector>

#include "generator/diffusion/diffuser.h"
#include "generator/piece/solid.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"

namespace pomona {

/// What made the colours of a section, so that any other point of the cut faces gets its colour in the same way:
/// diffused from the same surfaces, then browned. Shared by all pieces of one fruit.
class SectionColors {
 public:
  /// \param surfaces those that were cut. \param fruit the variant they were grown from.
  /// \param diffuser must outlive this and its fields.
  SectionColors(DiffusionSurfaces surfaces, Template fruit, const Diffuser& diffuser);

  /// Set up anew each time; the field must not outlive this.
  /// \throws Error (bad_data) as Diffuser::field().
  std::unique_ptr<ColorField> field() const;

 private:
  DiffusionSurfaces surfaces_;
  Template fruit_;
  const Diffuser& diffuser_;
};

/// The solids of one fruit, each knowing what coloured its cut faces.
std::vector<Solid> with_section_colors(std::vector<Solid> solids, std::shared_ptr<const SectionColors> colors);

}  // namespace pomona
