// The values of glTF's accessors, checked against the bytes of their buffers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tiny_gltf.h>

namespace pomona {

/// What of a file is read, for messages: `mesh "lid", primitive 0, POSITION`.
struct GltfPlace {
  std::string file;
  std::string element;

  GltfPlace within(const std::string& part) const { return {file, element + ", " + part}; }
  /// \throws Error (bad_data) at this place.
  [[noreturn]] void refuse(const std::string& message, const std::string& hint = {}) const;
};

/// The values of one accessor where they lie.
struct AccessorBytes {
  const unsigned char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int type = 0, component = 0;
  bool normalized = false;
};

/// The values of one accessor as numbers: `count` rows of `width` components.
struct AccessorTable {
  std::vector<double> value;
  std::size_t count = 0, width = 0;
  double at(std::size_t item, std::size_t k) const { return value[item * width + k]; }
};

/// \throws Error (bad_data) at the place if there is none.
const tinygltf::Accessor& accessor_at(const tinygltf::Model& model, int index, const GltfPlace& place);

/// \throws Error (bad_data) at the place: no bytes, bytes outside the file, or sparse values.
AccessorBytes accessor_bytes(const tinygltf::Model& model, int index, const GltfPlace& place);

/// Includes sparse values.
/// \throws Error (bad_data) at the place.
AccessorTable accessor_table(const tinygltf::Model& model, int index, const GltfPlace& place);

/// Component k of one item; normalized ones lie in 0..1 or -1..1. Nothing for components of no known type.
std::optional<double> component_of(const AccessorBytes& bytes, std::size_t item, std::size_t k);

}  // namespace pomona
