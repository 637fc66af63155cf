// Layouts: the poses of all instances as JSON. A layout is written once and read instead of settling again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/base/error.h"
#include "generator/scene/scene.h"
#include "generator/scene/scene_file.h"

namespace pomona {

struct Layout {
  struct Placement {
    std::string name;   ///< name of the instance
    std::string solid;  ///< name of the piece that it places
    Pose pose;
    SourcePlace place;  ///< place of the name
  };
  SourcePlace list;  ///< start of its placements, for messages
  std::vector<Placement> placements;
};

/// The bytes of a layout: one line per instance, shortest numbers that read back as the same.
std::string write_layout(const Scene& scene);

/// \throws Error (bad_data) with line and column.
Layout parse_layout(std::string_view json, const std::string& file);

/// \throws Error (input_missing) if the file cannot be read.
Layout read_layout(const std::filesystem::path& file);

/// The layout that a scene names, if it names one.
/// \throws Error (input_missing) at the place where it is named.
std::optional<Layout> layout_of(const SceneDescription& scene);

/// The poses for these instances, in their order (their own poses are ignored).
/// \throws Error (bad_data) if the layout belongs to another scene: names that differ, or are missing.
std::vector<Pose> poses_for(const Layout& layout, const std::vector<Solid>& solids,
                            const std::vector<Instance>& instances);

}  // namespace pomona
