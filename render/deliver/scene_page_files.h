// A scene as a page: -o FILE.html of scene.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "generator/scene/scene_file.h"
#include "render/deliver/deliver_options.h"

namespace pomona {

/// The pages of the order: the scene with the fruits of its pieces, each grown again from its pieces' origin. A warning
/// names fruit with an open boundary, which can be looked at but not cut.
/// \param find_template the file behind a template's name, if none lies beside the scene's file.
/// \throws Error (usage) for more than a page takes.
Delivered scene_page_files(const SceneDescription& description, const Scene& scene, const Order& order,
                           const DeliverOptions& how,
                           const std::function<std::filesystem::path(const std::string& name)>& find_template);

}  // namespace pomona
