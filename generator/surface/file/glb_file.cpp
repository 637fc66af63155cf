#include "generator/surface/file/glb_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <optional>
#include <utility>

#include <tiny_gltf.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "generator/base/error.h"
#include "generator/base/little_endian.h"

namespace pomona {

namespace {

constexpr double farthest = 1e9;                             // in units of the file
constexpr std::uint32_t most_json = std::uint32_t{4} << 20;  // bytes; what is large lies outside it
constexpr std::ptrdiff_t most_values = 500'000;              // each takes tinygltf a fifth of a kilobyte
constexpr int deepest_json = 64;
constexpr std::size_t most_nodes = 65536;

[[noreturn]] void refuse(const std::string& file, const std::string& element, const std::string& message,
                         const std::string& hint = {}) {
  throw Error(ExitStatus::bad_data, {{{file, 0, 0, element}, message, hint}});
}

/// tinygltf follows nested values by recursion: none that is deep may reach it.
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

/// Header and JSON within the limits, before any library sees them.
void check_container(std::string_view bytes, const std::string& file) {
  constexpr std::size_t head = 20;
  if (bytes.size() < head || bytes.substr(0, 4) != "glTF") refuse(file, "byte 0", "this is no binary glTF");
  if (word_at(bytes, 4) != 2) refuse(file, "byte 4", "only version 2 of glTF is known");
  if (word_at(bytes, 8) != bytes.size()) refuse(file, "byte 8", "the file's length is not the one it states");
  const std::uint32_t json = word_at(bytes, 12);
  if (word_at(bytes, 16) != 0x4E4F534Au) refuse(file, "byte 16", "the first chunk is not JSON");
  if (json > bytes.size() - head) refuse(file, "byte 12", "the file ends early");
  if (json > most_json) refuse(file, "byte 12", "more than 4 MiB of JSON", "export the one object, not the scene");
  const std::string_view text = bytes.substr(head, json);
  if (depth_of(text) > deepest_json) refuse(file, "byte 20", "values nested more than 64 deep");
  if (std::count(text.begin(), text.end(), ',') > most_values)
    refuse(file, "byte 20", "more than 500 000 values of JSON", "export the one object, not the scene");
}

bool leave_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

tinygltf::Model parse_model(std::string_view bytes, const std::string& file) {
  // Nothing but these bytes is read: images are left alone, and no other file can be found.
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(leave_image, nullptr);
  reader.SetFsCallbacks(
      {[](const std::string&, void*) { return false; }, [](const std::string& path, void*) { return path; },
       [](std::vector<unsigned char>*, std::string*, const std::string&, void*) { return false; },
       [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }, nullptr});

  // What the reader throws is an error like those it returns.
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

  // The reader's message may quote the file: only the first line is shown, and only what can be printed.
  std::string why = error.substr(0, std::min<std::size_t>(error.find('\n'), 200));
  for (char& c : why) c = c < ' ' || c > '~' ? '?' : c;
  refuse(file, "byte 20", "its JSON is no glTF that can be read" + (why.empty() ? "" : ": " + why),
         "export it anew as binary glTF 2.0 (.glb)");
}

/// The values of one accessor, checked against the bytes that are there.
struct Values {
  const unsigned char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int type = 0, component = 0;
  bool normalized = false;
};

class GlbReader {
 public:
  GlbReader(tinygltf::Model model, std::string file, std::string object)
      : model_(std::move(model)), file_(std::move(file)), object_(std::move(object)) {}

  PlainMesh read() {
    for (const int root : roots()) visit(root, glm::dmat4(1), 0);
    if (!object_.empty() && !found_)
      refuse(file_, "scene", "has no object \"" + object_ + "\"", "it has: " + listed_names(names_));
    if (mesh_.triangle.empty()) refuse(file_, "scene", "holds no triangles", "export the mesh as polygons");
    if (!colored_) mesh_.color.clear();
    return without_unused(mesh_);
  }

 private:
  /// The scene's nodes, or those that are nobody's child.
  std::vector<int> roots() const {
    const int scene = model_.defaultScene >= 0 ? model_.defaultScene : 0;
    if (static_cast<std::size_t>(scene) < model_.scenes.size())
      return model_.scenes[static_cast<std::size_t>(scene)].nodes;
    std::vector<int> roots;
    std::vector<bool> is_child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes) {
      for (const int child : node.children) {
        if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
          is_child[static_cast<std::size_t>(child)] = true;
      }
    }
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
  }

  void visit(int index, const glm::dmat4& parent, int depth) {
    const std::string what = "node " + std::to_string(index);
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
      refuse(file_, what, "there is no such node");
    if (depth > deepest_json || ++visits_ > most_nodes)
      refuse(file_, what, "nodes nested too deep, or within themselves");
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    const glm::dmat4 to_scene = parent * transform_of(node);
    if (node.mesh >= 0) {
      if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size()) refuse(file_, what, "there is no such mesh");
      const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
      if (names_.size() < 64) names_.push_back(node.name.empty() ? mesh.name : node.name);
      const bool wanted = object_.empty() || node.name == object_ || mesh.name == object_;
      found_ = found_ || wanted;
      for (std::size_t i = 0; wanted && i < mesh.primitives.size(); ++i) {
        element_ = "mesh \"" + mesh.name.substr(0, 64) + "\", primitive " + std::to_string(i);
        append(mesh.primitives[i], to_scene);
      }
    }
    for (const int child : node.children) visit(child, to_scene, depth + 1);
  }

  static glm::dmat4 transform_of(const tinygltf::Node& node) {
    glm::dmat4 result(1);
    if (node.matrix.size() == 16) {
      for (int k = 0; k < 16; ++k) result[k / 4][k % 4] = node.matrix[static_cast<std::size_t>(k)];
      return result;
    }
    if (node.rotation.size() == 4) {
      result = glm::mat4_cast(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
    }
    for (int k = 0; k < 3 && node.scale.size() == 3; ++k) result[k] *= node.scale[static_cast<std::size_t>(k)];
    for (int k = 0; k < 3 && node.translation.size() == 3; ++k)
      result[3][k] = node.translation[static_cast<std::size_t>(k)];
    return result;
  }

  Values values_of(int index, const char* name) const {
    const auto fail = [&](const char* why) { refuse(file_, element_ + ", " + name, why); };
    if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size()) fail("there is no such accessor");
    const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    if (accessor.sparse.isSparse) fail("sparse values are not understood");
    if (accessor.bufferView < 0 || static_cast<std::size_t>(accessor.bufferView) >= model_.bufferViews.size()) {
      fail("there are no bytes for it");
    }
    const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size())
      fail("there is no such buffer");
    const std::vector<unsigned char>& bytes = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    const int component = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    if (component <= 0 || components <= 0) fail("its type is not known");
    const auto size = static_cast<std::size_t>(component) * static_cast<std::size_t>(components);
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : size;

    // All in the form "what is left is less": nothing can wrap.
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) fail("the file ends early");
    if (stride < size || stride > 252 || accessor.byteOffset > view.byteLength) fail("it lies outside its bytes");
    const std::size_t left = view.byteLength - accessor.byteOffset;
    if (accessor.count == 0 || left < size || accessor.count - 1 > (left - size) / stride) {
      fail("it is longer than its bytes");
    }
    return {bytes.data() + view.byteOffset + accessor.byteOffset,
            accessor.count,
            stride,
            accessor.type,
            accessor.componentType,
            accessor.normalized};
  }

  template <typename T>
  static double raw(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof(T));
    return static_cast<double>(value);
  }

  static std::optional<double> component_of(const Values& values, std::size_t item, std::size_t k) {
    const unsigned char* start = values.data + item * values.stride;
    switch (values.component) {
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return raw<float>(start + 4 * k);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return raw<std::uint8_t>(start + k) / (values.normalized ? 255.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return raw<std::uint16_t>(start + 2 * k) / (values.normalized ? 65535.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return raw<std::uint32_t>(start + 4 * k);
      default:
        return {};
    }
  }

  void append(const tinygltf::Primitive& primitive, const glm::dmat4& to_scene) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES) {
      refuse(file_, element_, "holds no plain triangles", "export it as triangles, without points, lines and strips");
    }
    const auto found = primitive.attributes.find("POSITION");
    if (found == primitive.attributes.end()) {
      refuse(file_, element_, "has no positions", "export it without compression");
    }
    const std::size_t first = mesh_.position.size();
    append_positions(values_of(found->second, "POSITION"), to_scene);
    append_colors(primitive);
    append_triangles(primitive, first, glm::determinant(to_scene) < 0);
  }

  void append_positions(const Values& values, const glm::dmat4& to_scene) {
    if (values.type != TINYGLTF_TYPE_VEC3 || values.component != TINYGLTF_COMPONENT_TYPE_FLOAT) {
      refuse(file_, element_ + ", POSITION", "positions must be three floats", "export it without quantization");
    }
    constexpr std::size_t most_vertices = 5'000'000;
    if (values.count > most_vertices - mesh_.position.size()) {
      refuse(file_, element_, "more than 5 000 000 vertices", "simplify the mesh");
    }
    for (std::size_t i = 0; i < values.count; ++i) {
      glm::dvec3 p(0);
      for (std::size_t k = 0; k < 3; ++k) p[static_cast<int>(k)] = *component_of(values, i, k);
      p = glm::dvec3(to_scene * glm::dvec4(p, 1));
      for (int k = 0; k < 3; ++k) {
        if (!(std::fabs(p[k]) <= farthest)) {
          refuse(file_, element_ + ", vertex " + std::to_string(i), "its position is not finite or too far away");
        }
      }
      mesh_.position.push_back(p);
    }
  }

  /// COLOR_0 is linear; alpha is left alone.
  void append_colors(const tinygltf::Primitive& primitive) {
    const std::size_t first = mesh_.color.size();
    mesh_.color.resize(mesh_.position.size(), Color(0.5f));
    const auto found = primitive.attributes.find("COLOR_0");
    if (found == primitive.attributes.end()) return;
    const Values values = values_of(found->second, "COLOR_0");
    const bool is_vector = values.type == TINYGLTF_TYPE_VEC3 || values.type == TINYGLTF_TYPE_VEC4;
    if (!is_vector || values.count != mesh_.position.size() - first) {
      refuse(file_, element_ + ", COLOR_0", "it needs one colour for each vertex");
    }
    colored_ = true;
    for (std::size_t i = 0; i < values.count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double channel = component_of(values, i, k).value_or(0.5);
        mesh_.color[first + i][static_cast<int>(k)] = channel >= 0 ? static_cast<float>(std::min(channel, 1.0)) : 0.0f;
      }
    }
  }

  void append_triangles(const tinygltf::Primitive& primitive, std::size_t first, bool mirrored) {
    // Without indices, each three vertices in turn are a triangle.
    const std::size_t vertices = mesh_.position.size() - first;
    std::optional<Values> indices;
    if (primitive.indices >= 0) indices = values_of(primitive.indices, "indices");
    if (indices && (indices->type != TINYGLTF_TYPE_SCALAR || indices->component == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                    !component_of(*indices, 0, 0))) {
      refuse(file_, element_ + ", indices", "they must be whole numbers");
    }

    // Too many triangles are refused before any is read.
    const std::size_t count = (indices ? indices->count : vertices) / 3;
    if (count > most_mesh_triangles - mesh_.triangle.size()) {
      refuse(file_, element_, "more than 2 000 000 triangles", "simplify the mesh");
    }

    // A mirrored triangle would turn its back: two of its corners change places.
    for (std::size_t i = 0; i < count; ++i) {
      glm::uvec3 corners(0);
      for (std::size_t k = 0; k < 3; ++k) {
        const double vertex = indices ? *component_of(*indices, 3 * i + k, 0) : static_cast<double>(3 * i + k);
        if (!(vertex < static_cast<double>(vertices))) {
          refuse(file_, element_ + ", triangle " + std::to_string(i), "there is no such vertex");
        }
        corners[static_cast<int>(k)] = static_cast<std::uint32_t>(first + static_cast<std::size_t>(vertex));
      }
      if (mirrored) std::swap(corners.y, corners.z);
      mesh_.triangle.push_back(corners);
    }
  }

  tinygltf::Model model_;
  std::string file_, object_;
  std::string element_;  ///< what is read, for messages
  std::vector<std::string> names_;
  std::size_t visits_ = 0;
  bool found_ = false, colored_ = false;
  PlainMesh mesh_;
};

}  // namespace

PlainMesh parse_glb(std::string_view bytes, const std::string& file, const std::string& object) {
  check_container(bytes, file);
  return GlbReader(parse_model(bytes, file), file, object).read();
}

}  // namespace pomona
