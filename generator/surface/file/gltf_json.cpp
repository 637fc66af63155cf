#include "generator/surface/file/gltf_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "generator/base/error.h"

namespace pomona {

namespace {

using GltfJson = nlohmann::json;

[[noreturn]] void refuse(const std::string& file, const std::string& element, const std::string& message,
                         const std::string& hint = {}) {
  throw Error(ExitStatus::bad_data, {{{file, 0, 0, element}, message, hint}});
}

// ---- Types ----

enum class GltfType : std::uint8_t {
  whole,    ///< a whole number, 0 to 2^31 - 1
  wholes,   ///< a list of them
  map,      ///< an object of them
  maps,     ///< a list of such objects
  numbers,  ///< a list of numbers
  flag,
  text,
  texts,
  thing,   ///< an object with keys of its own
  things,  ///< a list of such objects
};

/// Keys that are read (glTF 2.0, section 5); others may hold anything.
struct Key {
  std::string_view name;
  GltfType type = GltfType::whole;
  bool is_needed = false;
  std::size_t length = 0;          ///< of a list of numbers; 0: any
  std::span<const Key> keys = {};  ///< of things
};

constexpr bool needed = true;

constexpr std::array asset_keys{Key{"version", GltfType::text, needed}, Key{"minVersion", GltfType::text}};
constexpr std::array scene_keys{Key{"nodes", GltfType::wholes}};
constexpr std::array instancing_keys{Key{"attributes", GltfType::map, needed}};
constexpr std::array visibility_keys{Key{"visible", GltfType::flag}};
constexpr std::array node_extensions_keys{Key{gltf_instancing, GltfType::thing, false, 0, instancing_keys},
                                          Key{gltf_visibility, GltfType::thing, false, 0, visibility_keys}};
constexpr std::array node_keys{Key{"children", GltfType::wholes},
                               Key{"mesh"},
                               Key{"skin"},
                               Key{"matrix", GltfType::numbers, false, 16},
                               Key{"translation", GltfType::numbers, false, 3},
                               Key{"rotation", GltfType::numbers, false, 4},
                               Key{"scale", GltfType::numbers, false, 3},
                               Key{"weights", GltfType::numbers},
                               Key{"extensions", GltfType::thing, false, 0, node_extensions_keys}};
constexpr std::array primitive_keys{Key{"attributes", GltfType::map, needed}, Key{"indices"}, Key{"mode"},
                                    Key{"targets", GltfType::maps}};
constexpr std::array mesh_keys{Key{"primitives", GltfType::things, needed, 0, primitive_keys},
                               Key{"weights", GltfType::numbers}};
constexpr std::array sparse_indices_keys{Key{"bufferView", GltfType::whole, needed}, Key{"byteOffset"},
                                         Key{"componentType", GltfType::whole, needed}};
constexpr std::array sparse_values_keys{Key{"bufferView", GltfType::whole, needed}, Key{"byteOffset"}};
constexpr std::array sparse_keys{Key{"count", GltfType::whole, needed},
                                 Key{"indices", GltfType::thing, needed, 0, sparse_indices_keys},
                                 Key{"values", GltfType::thing, needed, 0, sparse_values_keys}};
constexpr std::array accessor_keys{Key{"bufferView"},
                                   Key{"byteOffset"},
                                   Key{"componentType", GltfType::whole, needed},
                                   Key{"count", GltfType::whole, needed},
                                   Key{"type", GltfType::text, needed},
                                   Key{"normalized", GltfType::flag},
                                   Key{"sparse", GltfType::thing, false, 0, sparse_keys}};
constexpr std::array view_keys{Key{"buffer", GltfType::whole, needed}, Key{"byteOffset"},
                               Key{"byteLength", GltfType::whole, needed}, Key{"byteStride"}};
constexpr std::array buffer_keys{Key{"byteLength", GltfType::whole, needed}, Key{"uri", GltfType::text}};
constexpr std::array skin_keys{Key{"joints", GltfType::wholes, needed}, Key{"inverseBindMatrices"}};
constexpr std::array root_keys{Key{"asset", GltfType::thing, needed, 0, asset_keys},
                               Key{"extensionsUsed", GltfType::texts},
                               Key{"extensionsRequired", GltfType::texts},
                               Key{"scene"},
                               Key{"scenes", GltfType::things, false, 0, scene_keys},
                               Key{"nodes", GltfType::things, false, 0, node_keys},
                               Key{"meshes", GltfType::things, false, 0, mesh_keys},
                               Key{"accessors", GltfType::things, false, 0, accessor_keys},
                               Key{"bufferViews", GltfType::things, false, 0, view_keys},
                               Key{"buffers", GltfType::things, false, 0, buffer_keys},
                               Key{"skins", GltfType::things, false, 0, skin_keys}};

bool is_whole(const GltfJson& value) { return value.is_number_unsigned() && value.get<std::uint64_t>() <= INT32_MAX; }

bool is_number(const GltfJson& value) { return value.is_number() && std::isfinite(value.get<double>()); }

bool is_list_of(const GltfJson& value, bool (*is_one)(const GltfJson&)) {
  return value.is_array() && std::all_of(value.begin(), value.end(), is_one);
}

bool is_map(const GltfJson& value) { return value.is_object() && std::all_of(value.begin(), value.end(), is_whole); }

/// What a value should be but is not; nothing where it is right.
std::optional<std::string> wanted_of(const GltfJson& value, const Key& key) {
  const auto unless = [](bool is_right, const std::string& wanted) {
    return is_right ? std::nullopt : std::optional(wanted);
  };
  switch (key.type) {
    case GltfType::whole:
      return unless(is_whole(value), "a whole number from 0 to 2147483647");
    case GltfType::wholes:
      return unless(is_list_of(value, is_whole), "a list of whole numbers from 0 on");
    case GltfType::map:
      return unless(is_map(value), "an object of whole numbers");
    case GltfType::maps:
      return unless(is_list_of(value, is_map), "a list of objects of whole numbers");
    case GltfType::numbers:
      return unless(is_list_of(value, is_number) && (key.length == 0 || value.size() == key.length),
                    key.length == 0 ? "a list of numbers" : std::to_string(key.length) + " numbers");
    case GltfType::flag:
      return unless(value.is_boolean(), "true or false");
    case GltfType::text:
      return unless(value.is_string(), "a text");
    case GltfType::texts:
      return unless(is_list_of(value, [](const GltfJson& one) { return one.is_string(); }), "a list of texts");
    case GltfType::thing:
      return unless(value.is_object(), "an object");
    case GltfType::things:
      return unless(is_list_of(value, [](const GltfJson& one) { return one.is_object(); }), "a list of objects");
  }
  return {};
}

/// Checks the keys of an object, and those within.
void check_keys(const GltfJson& object, std::span<const Key> keys, const std::string& where, const std::string& file) {
  for (const Key& key : keys) {
    const std::string name = where + (where.empty() ? "" : ".") + std::string(key.name);
    const auto found = object.find(key.name);
    if (found == object.end()) {
      if (key.is_needed) refuse(file, name, "it is missing");
      continue;
    }
    if (const auto wanted = wanted_of(*found, key)) refuse(file, name, "it must be " + *wanted);
    if (key.type == GltfType::thing) check_keys(*found, key.keys, name, file);
    for (std::size_t i = 0; key.type == GltfType::things && i < found->size(); ++i)
      check_keys((*found)[i], key.keys, name + "[" + std::to_string(i) + "]", file);
  }
}

// ---- Extensions and versions ----

/// True for an extension that a file may require: one that is read here, or that affects only ignored data.
bool is_understood(std::string_view extension) {
  if (extension == gltf_instancing || extension == gltf_quantization || extension == gltf_visibility) return true;
  constexpr std::array<std::string_view, 10> looks{
      "KHR_materials_", "KHR_texture_", "EXT_texture_",   "MSFT_texture_",   "KHR_lights_",
      "EXT_lights_",    "KHR_xmp",      "KHR_animation_", "ADOBE_materials", "EXT_mesh_features"};
  return std::any_of(looks.begin(), looks.end(), [&](std::string_view look) { return extension.starts_with(look); });
}

std::string hint_about(std::string_view extension) {
  if (extension.find("draco") != std::string_view::npos || extension.find("meshopt") != std::string_view::npos)
    return "export it without compression";
  return "export it without this extension, or as .obj";
}

/// The items of a list in an object; none without such a list.
const std::vector<GltfJson>& list_at(const GltfJson& object, const char* key) {
  static const std::vector<GltfJson> none;
  const auto found = object.find(key);
  return found == object.end() ? none : found->get_ref<const GltfJson::array_t&>();
}

bool has_extension(const GltfJson& object, const std::string& name) {
  return object.contains("extensions") && object["extensions"].is_object() && object["extensions"].contains(name);
}

/// A version that 2.0 can be read by: "2.x"; of `minVersion` 2.0 at most.
void check_versions(const GltfJson& asset, const std::string& file) {
  if (!asset["version"].get_ref<const std::string&>().starts_with("2."))
    refuse(file, "asset.version", "only version 2 of glTF is known");
  if (asset.contains("minVersion") && asset["minVersion"].get_ref<const std::string&>() != "2.0")
    refuse(file, "asset.minVersion", "only version 2.0 of glTF is known", "export it as glTF 2.0");
}

/// A node is placed in one way.
void check_nodes(const GltfJson& json, const std::string& file) {
  const auto& nodes = list_at(json, "nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].contains("matrix")) continue;
    for (const char* other : {"translation", "rotation", "scale"})
      if (nodes[i].contains(other))
        refuse(file, "node " + std::to_string(i), std::string("has both a matrix and a ") + other);
  }
}

void check_extensions(const GltfJson& json, const std::string& file) {
  for (const GltfJson& required : list_at(json, "extensionsRequired")) {
    const std::string& whole = required.get_ref<const std::string&>();
    if (is_understood(whole)) continue;
    const std::string name = whole.substr(0, 64);
    refuse(file, "extensionsRequired", "it requires \"" + name + "\", which is not read", hint_about(name));
  }

  // Only the first buffer may be in the file, without a URI.
  const auto &buffers = list_at(json, "buffers"), &accessors = list_at(json, "accessors");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    if (buffers[i].contains("uri")) {
      if (buffers[i]["uri"].get_ref<const std::string&>().empty())
        refuse(file, "buffer " + std::to_string(i), "its URI is empty");
      continue;
    }
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
      if (has_extension(buffers[i], name))
        refuse(file, "buffer " + std::to_string(i),
               std::string("it is compressed by \"") + name + "\", which is not read", hint_about(name));
    if (i > 0)
      refuse(file, "buffer " + std::to_string(i), "it has no bytes", "export it anew as binary glTF 2.0 (.glb)");
  }

  // A compressed mesh may also have uncompressed values.
  const std::string draco = "KHR_draco_mesh_compression";
  for (const GltfJson& one : list_at(json, "meshes")) {
    for (const GltfJson& part : list_at(one, "primitives")) {
      if (!has_extension(part, draco)) continue;
      const std::size_t index = part.contains("indices") ? part["indices"].get<std::size_t>() : accessors.size();
      if (index < accessors.size() && !accessors[index].contains("bufferView"))
        refuse(file, "meshes", "it is compressed by \"" + draco + "\", which is not read", hint_about(draco));
    }
  }
}

// ---- Keys that stand twice ----

/// The JSON as a value; refuses the first key that stands twice in an object.
GltfJson parsed(std::string_view text, const std::string& file) {
  std::vector<std::set<std::string>> keys;
  std::optional<std::string> twice;
  const auto watch = [&](int, GltfJson::parse_event_t event, GltfJson& value) {
    if (event == GltfJson::parse_event_t::object_start) keys.emplace_back();
    if (event == GltfJson::parse_event_t::object_end) keys.pop_back();
    if (event == GltfJson::parse_event_t::key) {
      const std::string& key = value.get_ref<const std::string&>();
      if (!keys.back().insert(key).second && !twice) twice = key.substr(0, 64);
    }
    return true;
  };
  GltfJson json = GltfJson::parse(text.begin(), text.end(), watch, false);
  if (twice && !json.is_discarded()) refuse(file, "byte 20", "the key \"" + *twice + "\" stands twice in an object");
  return json;
}

}  // namespace

void check_gltf_json(std::string_view text, const std::string& file) {
  const GltfJson json = parsed(text, file);
  if (!json.is_object()) return;
  check_keys(json, root_keys, "", file);
  check_versions(json["asset"], file);
  check_nodes(json, file);
  check_extensions(json, file);
}

}  // namespace pomona
