#include "generator/surface/file/glb_model.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <utility>

#include "generator/base/error.h"
#include "generator/base/little_endian.h"
#include "generator/surface/file/gltf_json.h"

namespace pomona {

namespace {

constexpr std::uint32_t max_json = std::uint32_t{4} << 20;  // bytes; large data lie outside the JSON
constexpr std::ptrdiff_t max_values = 500'000;              // tinygltf needs some 200 bytes for each
constexpr int deepest_json = 64;

[[noreturn]] void refuse(const std::string& file, std::size_t byte, const std::string& message,
                         const std::string& hint = {}) {
  throw Error(ExitStatus::bad_data, {{{file, 0, 0, "byte " + std::to_string(byte)}, message, hint}});
}

/// The depth of nested values. tinygltf reads them recursively, so deep ones must not reach it.
int depth_of(std::string_view json) {
  int depth = 0, deepest = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text) {
      if (c == '\\') ++i;
      if (c == '"') in_text = false;
    } else if (c == '"') {
      in_text = true;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return deepest;
}

/// Checks header and JSON against the limits, before any library reads them.
void check_container(std::string_view bytes, const std::string& file) {
  constexpr std::size_t head = 20;
  if (bytes.size() < head || bytes.substr(0, 4) != "glTF") refuse(file, 0, "this is no binary glTF");
  if (word_at(bytes, 4) != 2) refuse(file, 4, "only version 2 of glTF is known");
  if (word_at(bytes, 8) != bytes.size()) refuse(file, 8, "the file's length is not the one it states");
  const std::uint32_t json = word_at(bytes, 12);
  if (word_at(bytes, 16) != 0x4E4F534Au) refuse(file, 16, "the first chunk is not JSON");
  if (json > bytes.size() - head) refuse(file, 12, "the file ends early");
  for (std::size_t at = 12; at < bytes.size();) {
    if (bytes.size() - at < 8 || word_at(bytes, at) > bytes.size() - at - 8)
      refuse(file, at, "the file ends within a chunk");
    at += 8 + std::size_t{word_at(bytes, at)};
  }
  if (json > max_json) refuse(file, 12, "more than 4 MiB of JSON", "export the one object, not the scene");
  const std::string_view text = bytes.substr(head, json);
  if (depth_of(text) > deepest_json) refuse(file, 20, "values nested more than 64 deep");
  if (std::count(text.begin(), text.end(), ',') > max_values)
    refuse(file, 20, "more than 500 000 values of JSON", "export the one object, not the scene");
}

/// The file without an empty chunk, which the reader refuses.
std::string without_empty_chunk(std::string_view bytes) {
  std::string whole(bytes);
  const std::size_t end = 20 + std::size_t{word_at(bytes, 12)};
  if (bytes.size() != end + 8 || word_at(bytes, end) != 0) return whole;
  whole.resize(end);
  for (std::size_t k = 0; k < 4; ++k) whole[8 + k] = static_cast<char>((end >> (8 * k)) & 0xFF);
  return whole;
}

bool leave_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

tinygltf::Model parse_model(std::string_view bytes, const std::string& file) {
  // Read only these bytes: images are ignored, and no other file can be found.
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(leave_image, nullptr);
  reader.SetFsCallbacks(
      {[](const std::string&, void*) { return false; }, [](const std::string& path, void*) { return path; },
       [](std::vector<unsigned char>*, std::string*, const std::string&, void*) { return false; },
       [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }, nullptr});

  // Treat the reader's exceptions like the errors that it returns.
  tinygltf::Model model;
  std::string error, warning;
  bool is_good = false;
  try {
    is_good =
        reader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                    static_cast<unsigned int>(bytes.size()), "");
  } catch (const std::exception& thrown) {
    error = thrown.what();
  }
  if (is_good) return model;

  // The reader's message may quote the file: show only the first line, and only printable characters.
  std::string why = error.substr(0, std::min<std::size_t>(error.find('\n'), 200));
  for (char& c : why) c = c < ' ' || c > '~' ? '?' : c;
  refuse(file, 20, "its JSON is no glTF that can be read" + (why.empty() ? "" : ": " + why),
         "export it anew as binary glTF 2.0 (.glb)");
}

}  // namespace

tinygltf::Model glb_model(std::string_view bytes, const std::string& file) {
  check_container(bytes, file);
  check_gltf_json(bytes.substr(20, word_at(bytes, 12)), file);
  return parse_model(without_empty_chunk(bytes), file);
}

}  // namespace pomona
