#include "render/export/gltf/meshopt.h"

#include <meshoptimizer.h>

#include "generator/base/error.h"

namespace pomona::gltf {

namespace {

/// The versions of the coding that the extension asks for.
void choose_versions() {
  static const bool chosen = [] {
    meshopt_encodeVertexVersion(0);
    meshopt_encodeIndexVersion(1);
    return true;
  }();
  static_cast<void>(chosen);
}

std::string shortened(std::string bytes, std::size_t size) {
  if (size == 0) throw Error(ExitStatus::bug, "meshoptimizer does not code what it should");
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string coded_elements(const void* data, std::size_t count, std::size_t stride) {
  choose_versions();
  std::string bytes(meshopt_encodeVertexBufferBound(count, stride), '\0');
  auto* to = reinterpret_cast<unsigned char*>(bytes.data());
  const std::size_t size = meshopt_encodeVertexBuffer(to, bytes.size(), data, count, stride);
  return shortened(std::move(bytes), size);
}

std::string coded_triangles(const std::vector<std::uint32_t>& corners, std::size_t vertices) {
  choose_versions();
  std::vector<std::uint32_t> ordered(corners.size());
  meshopt_optimizeVertexCache(ordered.data(), corners.data(), corners.size(), vertices);
  std::string bytes(meshopt_encodeIndexBufferBound(ordered.size(), vertices), '\0');
  auto* to = reinterpret_cast<unsigned char*>(bytes.data());
  const std::size_t size = meshopt_encodeIndexBuffer(to, bytes.size(), ordered.data(), ordered.size());
  return shortened(std::move(bytes), size);
}

}  // namespace pomona::gltf
