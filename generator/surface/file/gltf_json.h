// The JSON of a glTF file, checked before any library reads it.
#pragma once

#include <string>
#include <string_view>

namespace pomona {

/// Checks the JSON of a .glb: every value that is read has its type and length, no key stands twice, and the file
/// requires no extension or version that is not supported. The library that reads it takes defaults instead of values
/// of another type, and the last of two equal keys. Text that is no JSON passes: the library tells where.
/// \throws Error (bad_data) that names the value, as in "nodes[3].scale".
void check_gltf_json(std::string_view json, const std::string& file);

/// The extensions that change shapes and are read.
constexpr const char* gltf_instancing = "EXT_mesh_gpu_instancing";
constexpr const char* gltf_quantization = "KHR_mesh_quantization";
constexpr const char* gltf_visibility = "KHR_node_visibility";

}  // namespace pomona
