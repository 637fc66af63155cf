// Solids that Python looks at: the pieces of a fruit, or of a scene.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "generator/diffusion/diffuser.h"
#include "generator/scene/scene.h"
#include "python/binding/deliverable.h"
#include "render/export/styled_mesh.h"
#include "render/texture/bake.h"

namespace pomona {

class SolidSet : public Deliverable {
 public:
  /// \param diffuser that coloured the cut faces; textures are diffused by it, too.
  SolidSet(Order order, OrderTaker taker, Scene scene, std::shared_ptr<const Diffuser> diffuser)
      : Deliverable(std::move(order), taker), scene_(std::move(scene)), diffuser_(std::move(diffuser)) {}

  const Scene& scene() const { return scene_; }
  const Diffuser& diffuser() const { return *diffuser_; }
  bool can_have_textures() const override { return wants_textures(order().mesh); }

  /// What a .glb holds of each solid: its mesh, and its textures where they were ordered. Made when first asked for.
  struct Shown {
    std::vector<StyledMesh> meshes;
    std::vector<BakedSolid> baked;  ///< empty without textures
  };
  const Shown& shown() const;

 private:
  Scene scene_;
  std::shared_ptr<const Diffuser> diffuser_;
  mutable std::mutex mutex_;
  mutable std::optional<Shown> shown_;
};

}  // namespace pomona
