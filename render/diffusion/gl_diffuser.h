// Positive mean value diffusion by OpenGL compute shaders [Lipman et al. 2007; paper, section 3.2].
#pragma once

#include <memory>
#include <optional>

#include "generator/diffusion/diffuser.h"
#include "render/gl/context.h"

namespace pomona {

struct GlDiffuserOptions {
  Quality quality = Quality::final;
  Threads threads = {};               ///< threads of the processor's work: trees before, points on surfaces after
  std::optional<GlRoute> route = {};  ///< nothing: as GlContext chooses
};

/// The same values as make_pmvc_diffuser() in single precision, within the same errors. diffuse_all() gives all
/// fruits to the card at once. May be called on any thread; calls wait for each other.
/// \throws Error (helper_missing) if there is no OpenGL 4.5.
std::unique_ptr<Diffuser> make_gl_diffuser(const GlDiffuserOptions& options = {});

/// The same if there is a graphics card with OpenGL 4.5; null if not, within milliseconds where there is none.
std::unique_ptr<Diffuser> make_diffuser_on_graphics_card(const GlDiffuserOptions& options = {});

}  // namespace pomona
