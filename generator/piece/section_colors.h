// The colours of a fruit's cut faces at any point, not only at the section's vertices: for baked textures.
#pragma once

#include <memory>
#include <vector>

#include "generator/diffusion/diffuser.h"
#include "generator/piece/solid.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/template.h"

namespace pomona {

/// Everything that determines the colours of a section. So any other point of the cut faces can get its colour in the
/// same way: diffused from the same surfaces, then browned. All pieces of one fruit share it.
class SectionColors {
 public:
  /// \param surfaces the surfaces that were cut.
  /// \param fruit their variant.
  /// \param diffuser must outlive this and its fields.
  SectionColors(DiffusionSurfaces surfaces, Template fruit, const Diffuser& diffuser);

  /// A new field at each call. It must not outlive this object.
  /// \throws Error (bad_data) as Diffuser::field().
  std::unique_ptr<ColorField> field() const;

 private:
  DiffusionSurfaces surfaces_;
  Template fruit_;
  const Diffuser& diffuser_;
};

/// The solids of one fruit, each with a pointer to `colors`.
std::vector<Solid> with_section_colors(std::vector<Solid> solids, std::shared_ptr<const SectionColors> colors);

}  // namespace pomona
