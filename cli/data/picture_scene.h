// The scene of one picture of a data set: composed, seen, and lit as it was drawn.
#pragma once

#include "generator/data/drawn_picture.h"
#include "generator/diffusion/diffuser.h"
#include "generator/scene/compose_options.h"
#include "generator/scene/scene.h"

namespace pomona {

struct PictureScene {
  Scene scene;  ///< with its view
  std::vector<std::string> warnings;
};

/// Grows, cuts and arranges what was drawn, and puts distractors around it.
/// \throws Error if things cannot be cut, or do not come to rest.
PictureScene picture_scene(const DataDescription& data, const DrawnPicture& drawn, const Diffuser* diffuser,
                           const ComposeOptions& options);

}  // namespace pomona
