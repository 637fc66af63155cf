#include "render/deliver/ordered_diffuser.h"

#include "generator/base/error.h"
#include "generator/diffusion/harmonic/harmonic_diffuser.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/diffusion/walk/walk_diffuser.h"
#include "render/diffusion/gl_diffuser.h"

namespace pomona {

namespace {

std::unique_ptr<Diffuser> by_walks(const Order& order, const DeliveryProgress& progress) {
  WalkOptions walk;
  walk.standard_error = standard_error_of(order.color.quality);
  walk.threads = order.threads;
  if (progress) walk.progress = [progress](std::size_t done, std::size_t total) { progress("diffuse", done, total); };
  return make_walk_diffuser(walk);
}

}  // namespace

std::unique_ptr<Diffuser> ordered_diffuser(const Order& order, const DeliveryProgress& progress) {
  const Quality quality = order.color.quality;
  const GlDiffuserOptions by_opengl{.quality = quality, .threads = order.threads};
  switch (order.color.diffuser.value_or(DiffuserKind::cpu)) {
    case DiffuserKind::cpu:
      break;
    case DiffuserKind::gl:
      return make_gl_diffuser(by_opengl);
    case DiffuserKind::harmonic:
      return make_harmonic_diffuser({.quality = quality, .threads = order.threads});
    case DiffuserKind::walk:
      return by_walks(order, progress);
    case DiffuserKind::automatic:
      // Software OpenGL would be slower.
      if (std::unique_ptr<Diffuser> on_card = make_diffuser_on_graphics_card(by_opengl)) return on_card;
      break;
  }
  return make_pmvc_diffuser({.quality = quality, .threads = order.threads});
}

}  // namespace pomona
