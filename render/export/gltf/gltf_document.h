// A glTF file under way: its JSON, and the bytes that the JSON speaks of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "render/export/transaction/spooled_bytes.h"

namespace pomona::gltf {

using Json = nlohmann::ordered_json;

/// glTF's numbers for what arrays consist of, and are for.
enum class Component : int { u16 = 5123, u32 = 5125, f32 = 5126 };
enum class Target : int { none = 0, vertices = 34962, indices = 34963 };

/// Every add_... returns the index of what it added.
class GltfDocument {
 public:
  /// \param spool where the buffer goes as it grows; none: memory holds it. Must live as long as the document.
  explicit GltfDocument(SpooledBytes* spool = nullptr);

  /// Appends a value to one of the file's lists: "meshes", "nodes", ...
  int add(const char* list, Json value);
  /// What has been added; valid until the next add() to this list.
  Json& at(const char* list, int index) { return json_[list][static_cast<std::size_t>(index)]; }

  /// Appends bytes to the buffer, from a multiple of four on. \param stride of vertices with several attributes, else 0
  int add_view(const void* data, std::size_t size, Target target, std::size_t stride = 0);

  /// `count` elements of a view. \param type "SCALAR", "VEC3", ...
  int add_accessor(int view, std::size_t offset, std::size_t count, Component component, const char* type);

  /// No viewer needs to know it.
  void use_extension(const std::string& name);

  /// An extension of the whole file.
  void extend(const std::string& name, Json value);

  Json& scene() { return json_["scenes"][0]; }

  /// As .glb: header, JSON, buffer. The document is empty then: what has been copied is let go, so that a file of
  /// hundreds of megabytes is held once. With a spool these are the file's first bytes, and the spool has the rest.
  /// \throws Error (bad_data) beyond the 4 GB that the format can tell.
  std::string bytes() &&;

 private:
  void append(const void* data, std::size_t size);

  SpooledBytes* spool_;
  Json json_;
  std::vector<std::string> buffer_;  ///< in blocks: one that grew would be copied over and over
  std::size_t buffer_size_ = 0;
};

}  // namespace pomona::gltf
