// A glTF file while it is built: its JSON and its buffer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "render/export/transaction/spooled_bytes.h"

namespace pomona::gltf {

using Json = nlohmann::ordered_json;

/// glTF's numbers for types of array components and for targets of buffer views.
enum class Component : int { i8 = 5120, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };
enum class Target : int { none = 0, vertices = 34962, indices = 34963 };

/// Every add_... returns the index of what it added.
class GltfDocument {
 public:
  /// \param spool receives the buffer while it grows; null = the buffer stays in memory. Must outlive the document.
  explicit GltfDocument(SpooledBytes* spool = nullptr);

  /// Appends a value to one of the file's lists: "meshes", "nodes", ...
  int add(const char* list, Json value);
  /// An added value. The reference is valid until the next add() to this list.
  Json& at(const char* list, int index) { return json_[list][static_cast<std::size_t>(index)]; }

  /// Appends bytes to the buffer, from a multiple of four on. \param stride of vertices with several attributes, else 0
  int add_view(const void* data, std::size_t size, Target target, std::size_t stride = 0);

  /// The same of arrays that meshoptimizer has coded (meshopt.h). \param mode "ATTRIBUTES" or "TRIANGLES".
  int add_coded_view(const std::string& coded, const char* mode, std::size_t count, std::size_t stride, Target target);

  /// `count` elements of a view. \param type "SCALAR", "VEC3", ...
  int add_accessor(int view, std::size_t offset, std::size_t count, Component component, const char* type);

  /// Notes that the file uses an extension; a viewer need not support it.
  void use_extension(const std::string& name);

  /// Notes that no viewer can show the file without this extension.
  void require_extension(const std::string& name);

  /// An extension of the whole file.
  void extend(const std::string& name, Json value);

  Json& scene() { return json_["scenes"][0]; }

  /// The .glb: header, JSON, buffer. The document is empty afterwards: copied blocks are freed, so that a file of
  /// hundreds of megabytes is in memory only once. With a spool, these are the first bytes of the file; the spool has
  /// the rest. \throws Error (bad_data) for more than 4 GB, the limit of the format.
  std::string bytes() &&;

 private:
  void append(const void* data, std::size_t size);

  SpooledBytes* spool_;
  Json json_;
  std::vector<std::string> buffer_;  ///< in blocks: a single growing string would be copied again and again
  std::size_t buffer_size_ = 0;
  std::size_t decoded_size_ = 0;  ///< bytes of all coded views once they are decoded
};

}  // namespace pomona::gltf
