// A scene's solids at the poses of their instances, for all passes that draw solids.
#pragma once

#include "render/gl/program.h"
#include "render/gl/scene_upload.h"

namespace pomona {

/// A choice of solids: transparent ones have an opacity below 1.
enum class Drawn { opaque, see_through };

class PlacedSolids {
 public:
  /// Both must outlive this.
  /// \throws Error as uploaded() does.
  PlacedSolids(const CurrentGl& gl, const Scene& scene, const Style& style);

  bool any(Drawn which) const;
  /// Draws with the current program, the nearest solids first, so that hidden fragments are not shaded. Sets
  /// "placement", "instance_id", "first_triangle" and "opacity". Of closed solids, only triangles that face the eye are
  /// drawn (half of them); after CullFace(GL_FRONT) only the others.
  void draw(const Program& program, Drawn which) const;
  /// Per solid (shaders/detail.glsl); empty if no solid has guides.
  const GlTexture* detail_styles() const { return uploaded_.guides ? &uploaded_.guides->styles.texture() : nullptr; }

  bool any_example() const { return uploaded_.guides && uploaded_.guides->any_example; }

  /// Their lattices (shaders/guide_lattice.glsl); likewise.
  const GlTexture* guide_lattices() const { return uploaded_.guides ? &uploaded_.guides->lattices.texture() : nullptr; }

  /// Draws the hairs of all solids. Sets "placement".
  void draw_hairs(const Program& program) const;
  bool any_hairs() const;
  bool any_translucent() const { return uploaded_.translucent; }

  const GlTexture& triangle_tags() const { return uploaded_.triangle_tags.texture(); }
  const GlTexture& noise_styles() const { return uploaded_.noise_styles.texture(); }
  const GlTexture& materials() const { return uploaded_.materials.texture(); }
  const GlTexture& pits() const { return uploaded_.pits.texture(); }

 private:
  const CurrentGl& gl_;
  const Scene& scene_;
  UploadedSolids uploaded_;
  std::vector<std::size_t> nearest_first_;  // instances
};

}  // namespace pomona
