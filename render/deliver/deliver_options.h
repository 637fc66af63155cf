// Options and input of a delivery.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "generator/order/order.h"
#include "generator/order/ordered_fruit.h"
#include "generator/scene/scene.h"
#include "render/deliver/delivered.h"
#include "render/deliver/provenance.h"
#include "render/deliver/ripeness_variants.h"
#include "render/deliver/streamed_glb.h"
#include "render/export/styled_mesh.h"
#include "render/image/image.h"
#include "render/plate/plate.h"
#include "render/style/style.h"
#include "render/truth/layers.h"

namespace pomona {

/// What each pixel of a picture shows.
struct SeenTruth {
  TruthNaming names;
  TruthLayers layers;
  std::vector<std::string> instances;  ///< their names, from number 1 on
};

/// How files are made, besides the order.
struct DeliverOptions {
  Style style = {};          ///< that drawn_style() names, as found
  Style texture_style = {};  ///< that baked_style() names, as found
  Provenance provenance = {};
  PictureSize usual_size = {960, 720};  ///< size of pictures without one in the order, and of lines in .pov
  DeliveryProgress progress = {};

  // For those who want no file: they take what a .png would hold, and no bytes of it are made.
  std::function<void(Image picture)> take_picture = {};
  std::function<void(SeenTruth truth)> take_truth = {};  ///< in place of the picture; a section has none
};

/// One scene for all formats. All that it refers to must outlive the call it is passed to.
struct SceneViews {
  const Scene& placed;                             ///< for meshes: the pieces where they grew, or lie
  const Scene* shown = nullptr;                    ///< for pictures, if these show the pieces elsewhere
  const Scene* modelled = nullptr;                 ///< for simulators, if these begin with the pieces elsewhere
  std::span<const RipenessVariant> variants = {};  ///< other ripenesses of `placed`, for textures
  std::optional<PlateText> plate_text = {};        ///< texts of a plate; none: no plate is drawn around pictures
  const OrderedFruit* fruit = nullptr;             ///< the fruit whose asset a cuttable .glb carries
  std::span<const StyledMesh> meshes = {};         ///< meshes of `placed`, if they exist already
  std::span<const std::unique_ptr<StreamedGlb>> streams = {};  ///< streams of .glb files that have taken all solids
                                                               ///< already
};

}  // namespace pomona
