// A binary glTF as tinygltf reads it, within limits.
#pragma once

#include <string>
#include <string_view>

#include <tiny_gltf.h>

namespace pomona {

/// The file's tree: nodes, meshes, accessors and the bytes of its one buffer. Header, chunks and JSON are checked
/// first, so that no library reads what would cost it more than the file's size. Images are left, and no other file is
/// opened. \throws Error (bad_data) with the byte at which the file is wrong.
tinygltf::Model glb_model(std::string_view bytes, const std::string& file);

}  // namespace pomona
