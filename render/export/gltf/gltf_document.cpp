#include "render/export/gltf/gltf_document.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "generator/base/error.h"
#include "generator/base/json_text.h"
#include "generator/base/little_endian.h"

namespace pomona::gltf {

namespace {

/// Chunks of a .glb are filled up to multiples of four: text with spaces, bytes with zeros.
std::size_t filled(std::size_t size) { return (size + 3) / 4 * 4; }

constexpr std::size_t block_size = 8 << 20;  // size of the buffer's blocks; larger views have a block of their own

void check_size(std::size_t size) {
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw Error(ExitStatus::bad_data, "the scene is too large for a .glb, which ends at 4 GB");
}

void append_chunk_head(std::string& file, const char* kind, std::size_t size) {
  file += word_bytes(filled(size));
  file.append(kind, 4);
}

}  // namespace

GltfDocument::GltfDocument(SpooledBytes* spool) : spool_(spool) {
  json_["asset"] = {{"version", "2.0"}, {"generator", "Pomona"}};
  json_["scene"] = 0;
  json_["scenes"] = Json::array({{{"name", "scene"}, {"nodes", Json::array()}}});
}

int GltfDocument::add(const char* list, Json value) {
  Json& values = json_[list];
  values.push_back(std::move(value));
  return static_cast<int>(values.size()) - 1;
}

void GltfDocument::append(const void* data, std::size_t size) {
  check_size(buffer_size_ + size);
  if (buffer_.empty() || buffer_.back().size() + size > block_size) {
    if (spool_ != nullptr && !buffer_.empty()) {
      spool_->append(buffer_.back());
      buffer_.clear();
    }
    buffer_.emplace_back();
    buffer_.back().reserve(std::max(block_size, size));
  }
  buffer_.back().append(static_cast<const char*>(data), size);
  buffer_size_ += size;
}

int GltfDocument::add_view(const void* data, std::size_t size, Target target, std::size_t stride) {
  append("\0\0\0", filled(buffer_size_) - buffer_size_);
  Json view = {{"buffer", 0}, {"byteOffset", buffer_size_}, {"byteLength", size}};
  if (stride > 0) view["byteStride"] = stride;
  if (target != Target::none) view["target"] = static_cast<int>(target);
  append(data, size);
  return add("bufferViews", std::move(view));
}

int GltfDocument::add_accessor(int view, std::size_t offset, std::size_t count, Component component, const char* type) {
  Json accessor = {{"bufferView", view}};
  if (offset > 0) accessor["byteOffset"] = offset;
  accessor["componentType"] = static_cast<int>(component);
  accessor["count"] = count;
  accessor["type"] = type;
  return add("accessors", std::move(accessor));
}

void GltfDocument::use_extension(const std::string& name) {
  Json& used = json_["extensionsUsed"];
  if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
}

void GltfDocument::require_extension(const std::string& name) {
  use_extension(name);
  Json& required = json_["extensionsRequired"];
  if (std::find(required.begin(), required.end(), name) == required.end()) required.push_back(name);
}

int GltfDocument::add_coded_view(const std::string& coded, const char* mode, std::size_t count, std::size_t stride,
                                 Target target) {
  const std::string extension = "EXT_meshopt_compression";
  require_extension(extension);
  append("\0\0\0", filled(buffer_size_) - buffer_size_);
  // Buffer 1 is not in the file: it is where the decoded bytes would lie.
  Json view = {{"buffer", 1}, {"byteOffset", decoded_size_}, {"byteLength", count * stride}};
  if (target == Target::vertices) view["byteStride"] = stride;
  view["target"] = static_cast<int>(target);
  view["extensions"][extension] = {{"buffer", 0},
                                   {"byteOffset", buffer_size_},
                                   {"byteLength", coded.size()},
                                   {"byteStride", stride},
                                   {"mode", mode},
                                   {"count", count}};
  append(coded.data(), coded.size());
  decoded_size_ += filled(count * stride);
  return add("bufferViews", std::move(view));
}

void GltfDocument::extend(const std::string& name, Json value) {
  use_extension(name);
  json_["extensions"][name] = std::move(value);
}

std::string GltfDocument::bytes() && {
  if (buffer_size_ > 0) json_["buffers"] = Json::array({{{"byteLength", buffer_size_}}});
  if (decoded_size_ > 0) {
    json_["buffers"].push_back(
        {{"byteLength", decoded_size_}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  }
  // Names may come from files of any encoding; glTF is UTF-8.
  const std::string text = json_text(json_);
  json_ = Json();

  std::size_t size = 12 + 8 + filled(text.size());
  if (buffer_size_ > 0) size += 8 + filled(buffer_size_);
  check_size(size);
  std::string file;
  file.reserve(spool_ != nullptr ? size - buffer_size_ : size);
  file += "glTF";
  file += word_bytes(2);
  file += word_bytes(size);
  append_chunk_head(file, "JSON", text.size());
  file += text;
  file.append(filled(text.size()) - text.size(), ' ');
  if (buffer_size_ == 0) return file;
  append_chunk_head(file, std::string("BIN\0", 4).data(), buffer_size_);
  buffer_.emplace_back(filled(buffer_size_) - buffer_size_, '\0');
  for (std::string& block : buffer_) {
    if (spool_ != nullptr)
      spool_->append(block);
    else
      file += block;
    block = std::string();
  }
  return file;
}

}  // namespace pomona::gltf
