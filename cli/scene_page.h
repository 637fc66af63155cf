// A scene as a page: -o FILE.html of scene.
#pragma once

#include "cli/deliver.h"
#include "cli/shared_options.h"
#include "generator/scene/scene.h"
#include "generator/scene/scene_file.h"
#include "render/page/page_scene.h"

namespace pomona {

/// The scene with the fruits that its pieces are cut from, each grown once more as its pieces tell. What cannot be cut
/// again, as its boundary is open, is warned of: it can be looked at.
/// \throws Error (usage) for more than a page takes.
PageScene scene_for_page(const SceneDescription& description, const Scene& scene, const SharedOptions& options,
                         Delivery& delivery);

}  // namespace pomona
