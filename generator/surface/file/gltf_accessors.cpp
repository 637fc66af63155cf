#include "generator/surface/file/gltf_accessors.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "generator/base/error.h"

namespace pomona {

namespace {

constexpr std::size_t max_without_bytes = 5'000'000;  // rows that sparse values alone fill

/// Where values lie, and of which type they are.
struct ValueLayout {
  int view = 0;
  std::size_t offset = 0, count = 0;
  int type = 0, component = 0;
  bool normalized = false;
};

/// The `count` values of a type in a view, from an offset on.
AccessorBytes bytes_at(const tinygltf::Model& model, const ValueLayout& layout, const GltfPlace& place) {
  if (layout.view < 0 || static_cast<std::size_t>(layout.view) >= model.bufferViews.size())
    place.refuse("there are no bytes for it");
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(layout.view)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
    place.refuse("there is no such buffer");
  const std::vector<unsigned char>& bytes = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  const int component = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(layout.component));
  const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(layout.type));
  if (component <= 0 || components <= 0) place.refuse("its type is not known");
  const auto size = static_cast<std::size_t>(component) * static_cast<std::size_t>(components);
  const std::size_t stride = view.byteStride != 0 ? view.byteStride : size;

  // Compare with what is left, so that no sum can overflow.
  if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
    place.refuse("the file ends early");
  if (stride < size || stride > 252 || layout.offset > view.byteLength) place.refuse("it lies outside its bytes");
  const std::size_t left = view.byteLength - layout.offset;
  if (layout.count == 0 || left < size || layout.count - 1 > (left - size) / stride)
    place.refuse("it is longer than its bytes");
  return {.data = bytes.data() + view.byteOffset + layout.offset,
          .count = layout.count,
          .stride = stride,
          .type = layout.type,
          .component = layout.component,
          .normalized = layout.normalized};
}

ValueLayout layout_of(const tinygltf::Accessor& accessor) {
  return {.view = accessor.bufferView,
          .offset = accessor.byteOffset,
          .count = accessor.count,
          .type = accessor.type,
          .component = accessor.componentType,
          .normalized = accessor.normalized};
}

template <typename T>
double raw(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));
  return static_cast<double>(value);
}

std::vector<double> numbers_of(const AccessorBytes& bytes, std::size_t width, const GltfPlace& place) {
  std::vector<double> numbers;
  numbers.reserve(bytes.count * width);
  for (std::size_t i = 0; i < bytes.count; ++i) {
    for (std::size_t k = 0; k < width; ++k) {
      const std::optional<double> value = component_of(bytes, i, k);
      if (!value) place.refuse("its numbers are of no known type");
      numbers.push_back(*value);
    }
  }
  return numbers;
}

/// Sparse values replace others by index.
void replace_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor, AccessorTable& table,
                    const GltfPlace& place) {
  const auto& sparse = accessor.sparse;
  ValueLayout layout = layout_of(accessor);
  layout.count = static_cast<std::size_t>(std::max(0, sparse.count));
  layout.view = sparse.values.bufferView;
  layout.offset = static_cast<std::size_t>(sparse.values.byteOffset);
  const ValueLayout indices{.view = sparse.indices.bufferView,
                            .offset = static_cast<std::size_t>(sparse.indices.byteOffset),
                            .count = layout.count,
                            .type = TINYGLTF_TYPE_SCALAR,
                            .component = sparse.indices.componentType};
  const AccessorBytes at = bytes_at(model, indices, place);
  const std::vector<double> other = numbers_of(bytes_at(model, layout, place), table.width, place);
  double last = -1;
  for (std::size_t i = 0; i < layout.count; ++i) {
    const double row = component_of(at, i, 0).value_or(-1);
    if (!(row >= 0 && row < static_cast<double>(table.count))) place.refuse("a sparse value has no place");
    if (row <= last) place.refuse("the places of its sparse values do not rise");
    last = row;
    for (std::size_t k = 0; k < table.width; ++k)
      table.value[static_cast<std::size_t>(row) * table.width + k] = other[i * table.width + k];
  }
}

}  // namespace

void GltfPlace::refuse(const std::string& message, const std::string& hint) const {
  throw Error(ExitStatus::bad_data, {{{file, 0, 0, element}, message, hint}});
}

const tinygltf::Accessor& accessor_at(const tinygltf::Model& model, int index, const GltfPlace& place) {
  if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) place.refuse("there is no such accessor");
  return model.accessors[static_cast<std::size_t>(index)];
}

AccessorBytes accessor_bytes(const tinygltf::Model& model, int index, const GltfPlace& place) {
  const tinygltf::Accessor& accessor = accessor_at(model, index, place);
  if (accessor.sparse.isSparse) place.refuse("sparse values are not understood");
  return bytes_at(model, layout_of(accessor), place);
}

AccessorTable accessor_table(const tinygltf::Model& model, int index, const GltfPlace& place) {
  const tinygltf::Accessor& accessor = accessor_at(model, index, place);
  const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  if (components <= 0) place.refuse("its type is not known");
  AccessorTable table{.value = {}, .count = accessor.count, .width = static_cast<std::size_t>(components)};
  if (accessor.bufferView >= 0 || !accessor.sparse.isSparse) {
    table.value = numbers_of(bytes_at(model, layout_of(accessor), place), table.width, place);
  } else {
    if (accessor.count > max_without_bytes) place.refuse("more than 5 000 000 values");
    table.value.assign(table.count * table.width, 0);
  }
  if (accessor.sparse.isSparse) replace_sparse(model, accessor, table, place);
  return table;
}

std::optional<double> component_of(const AccessorBytes& bytes, std::size_t item, std::size_t k) {
  const unsigned char* start = bytes.data + item * bytes.stride;
  switch (bytes.component) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return raw<float>(start + 4 * k);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return bytes.normalized ? std::max(raw<std::int8_t>(start + k) / 127.0, -1.0) : raw<std::int8_t>(start + k);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return bytes.normalized ? std::max(raw<std::int16_t>(start + 2 * k) / 32767.0, -1.0)
                              : raw<std::int16_t>(start + 2 * k);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return raw<std::uint8_t>(start + k) / (bytes.normalized ? 255.0 : 1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return raw<std::uint16_t>(start + 2 * k) / (bytes.normalized ? 65535.0 : 1.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return raw<std::uint32_t>(start + 4 * k);
    default:
      return {};
  }
}

}  // namespace pomona
