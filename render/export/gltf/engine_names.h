// Names for the importers of engines (docs/reference/formats.md).
#pragma once

#include <cstddef>
#include <string>

#include "render/export/styled_mesh.h"

namespace pomona::gltf {

/// The name of a node or mesh. Godot and Unreal remove dots from names; so they become underscores for all engines, and
/// names derived from this one still match.
std::string engine_name(Engine engine, const std::string& name);

/// The name of a level of detail, 0 the finest, of `count` in all. Unreal and Unity number the finest, too.
std::string level_name(Engine engine, const std::string& name, std::size_t level, std::size_t count);

/// The full name of a convex part of a node or mesh, one of `count`; empty for engines that need none.
std::string hull_name(Engine engine, const std::string& name, std::size_t part, std::size_t count);

/// The full name of a node whose triangles are collided with as they are; empty for engines that know none.
std::string triangles_name(Engine engine, const std::string& name);

}  // namespace pomona::gltf
