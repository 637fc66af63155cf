// Names as importers of engines expect them (docs/reference/formats.md).
#pragma once

#include <string>

#include "render/export/styled_mesh.h"

namespace pomona::gltf {

/// A node's or mesh's own name. Godot and Unreal take the dots out of names; so they are underscores for any of the
/// engines, and what we name after it still fits.
std::string engine_name(Engine engine, const std::string& name);

/// Of a level of detail, 0 the finest, one of `count` in all. Unreal and Unity number the finest, too.
std::string level_name(Engine engine, const std::string& name, std::size_t level, std::size_t count);

/// Of the convex hull that belongs to a node or mesh of this name, complete; empty for engines that want none.
std::string hull_name(Engine engine, const std::string& name);

}  // namespace pomona::gltf
