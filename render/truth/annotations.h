// Annotations of a picture: its contents as JSON with COCO's keys.
#pragma once

#include <string>
#include <vector>

#include "render/truth/layers.h"
#include "render/truth/mask.h"

namespace pomona {

struct AnnotatedPicture {
  std::string file_name;                 ///< of the picture, as `images` names it
  std::string made_by;                   ///< version of the program, for `info`
  std::uint64_t seed = 0;                ///< of the fruit or the scene
  std::vector<std::string> layer_files;  ///< beside the annotations
};

/// docs/formats.md, "Ground truth". \param amodal per instance.
std::string annotations(const Scene& scene, const TruthNaming& names, const TruthLayers& layers,
                        const std::vector<Mask>& amodal, const AnnotatedPicture& picture);

}  // namespace pomona
