// Arrays in the coding of meshoptimizer, for EXT_meshopt_compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pomona::gltf {

/// `count` elements of so many bytes each, a multiple of four. \throws Error (bug) if meshoptimizer refuses.
std::string coded_elements(const void* data, std::size_t count, std::size_t stride);

/// Triangles in an order that codes well, each maybe begun at another corner. \param corners three a triangle.
std::string coded_triangles(const std::vector<std::uint32_t>& corners, std::size_t vertices);

}  // namespace pomona::gltf
