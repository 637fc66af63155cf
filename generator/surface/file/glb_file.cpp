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
#include "generator/surface/file/gltf_json.h"

namespace pomona {

namespace {

constexpr double farthest = 1e9;                            // in units of the file
constexpr std::uint32_t max_json = std::uint32_t{4} << 20;  // bytes; large data lie outside the JSON
constexpr std::ptrdiff_t max_values = 500'000;              // tinygltf needs some 200 bytes for each
constexpr int deepest_json = 64;
constexpr std::size_t max_nodes = 65536;
constexpr std::size_t max_instances = 65536;  // of one node
constexpr std::size_t max_vertices = 5'000'000;

[[noreturn]] void refuse(const std::string& file, const std::string& element, const std::string& message,
                         const std::string& hint = {}) {
  throw Error(ExitStatus::bad_data, {{{file, 0, 0, element}, message, hint}});
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
  if (bytes.size() < head || bytes.substr(0, 4) != "glTF") refuse(file, "byte 0", "this is no binary glTF");
  if (word_at(bytes, 4) != 2) refuse(file, "byte 4", "only version 2 of glTF is known");
  if (word_at(bytes, 8) != bytes.size()) refuse(file, "byte 8", "the file's length is not the one it states");
  const std::uint32_t json = word_at(bytes, 12);
  if (word_at(bytes, 16) != 0x4E4F534Au) refuse(file, "byte 16", "the first chunk is not JSON");
  if (json > bytes.size() - head) refuse(file, "byte 12", "the file ends early");
  for (std::size_t at = 12; at < bytes.size();) {
    if (bytes.size() - at < 8 || word_at(bytes, at) > bytes.size() - at - 8)
      refuse(file, "byte " + std::to_string(at), "the file ends within a chunk");
    at += 8 + std::size_t{word_at(bytes, at)};
  }
  if (json > max_json) refuse(file, "byte 12", "more than 4 MiB of JSON", "export the one object, not the scene");
  const std::string_view text = bytes.substr(head, json);
  if (depth_of(text) > deepest_json) refuse(file, "byte 20", "values nested more than 64 deep");
  if (std::count(text.begin(), text.end(), ',') > max_values)
    refuse(file, "byte 20", "more than 500 000 values of JSON", "export the one object, not the scene");
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
  refuse(file, "byte 20", "its JSON is no glTF that can be read" + (why.empty() ? "" : ": " + why),
         "export it anew as binary glTF 2.0 (.glb)");
}

/// The values of one accessor, checked against the bytes of its buffer.
struct Values {
  const unsigned char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int type = 0, component = 0;
  bool normalized = false;
};

/// The same as numbers.
struct Table {
  std::vector<double> value;
  std::size_t count = 0, width = 0;
  int component = 0;
  double at(std::size_t item, std::size_t k) const { return value[item * width + k]; }
};

/// A node that shows a mesh.
struct Shown {
  int node = 0;
  glm::dmat4 to_scene{1};
  bool is_wanted_by_node = false, is_wanted_by_mesh = false;
};

class GlbReader {
 public:
  GlbReader(tinygltf::Model model, std::string file, std::string object)
      : model_(std::move(model)), file_(std::move(file)), object_(std::move(object)) {}

  PlainMesh read() {
    to_scene_.resize(model_.nodes.size());
    for (const int root : roots()) visit(root, glm::dmat4(1), 0, false);
    for (const Shown& shown : wanted()) append(shown);
    if (mesh_.triangle.empty()) refuse(file_, "scene", "holds no triangles", "export the mesh as polygons");
    if (!colored_) mesh_.color.clear();
    PlainMesh mesh = without_unused(mesh_);
    mesh.notes = std::move(mesh_.notes);
    return mesh;
  }

 private:
  /// The nodes with the wanted name; if there is none, the nodes whose mesh data have it.
  std::vector<Shown> wanted() {
    if (object_.empty()) return shown_;
    const bool by_node = std::any_of(shown_.begin(), shown_.end(), [](const Shown& s) { return s.is_wanted_by_node; });
    std::vector<Shown> wanted;
    for (const Shown& s : shown_)
      if (by_node ? s.is_wanted_by_node : s.is_wanted_by_mesh) wanted.push_back(s);
    if (wanted.empty()) refuse(file_, "scene", "has no object \"" + object_ + "\"", "it has: " + listed_names(names_));
    const std::size_t several = by_node ? called_so_ : wanted.size();
    if (several > 1)
      mesh_.notes.push_back(std::to_string(several) + " nodes " +
                            (by_node ? "are called \"" : "show the mesh data \"") + object_.substr(0, 64) +
                            "\": all of them are read");
    return wanted;
  }

  /// The scene's nodes, or all nodes without a parent.
  std::vector<int> roots() const {
    const int scene = std::max(model_.defaultScene, 0);
    if (model_.defaultScene >= 0 && static_cast<std::size_t>(scene) >= model_.scenes.size())
      refuse(file_, "scene", "there is no such scene");
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

  void visit(int index, const glm::dmat4& parent, int depth, bool is_wanted) {
    const std::string what = "node " + std::to_string(index);
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
      refuse(file_, what, "there is no such node");
    std::optional<glm::dmat4>& place = to_scene_[static_cast<std::size_t>(index)];
    if (place)
      refuse(file_, what, "is held twice: by two nodes, or within itself", "export it anew, with copies of the node");
    if (depth > deepest_json || ++visits_ > max_nodes) refuse(file_, what, "nodes nested too deep");
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    check_transform(node, what);
    const glm::dmat4 to_scene = parent * transform_of(node);
    place = to_scene;
    if (is_invisible(node)) return;
    const bool called_so = !object_.empty() && node.name == object_;
    called_so_ += called_so ? 1 : 0;
    if (node.mesh >= 0) {
      if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size()) refuse(file_, what, "there is no such mesh");
      const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
      if (names_.size() < 64) names_.push_back(node.name.empty() ? mesh.name : node.name);
      shown_.push_back({index, to_scene, called_so || is_wanted, mesh.name == object_});
    }
    // A wanted node without a mesh means all nodes below it.
    const bool all_below = is_wanted || (called_so && node.mesh < 0);
    for (const int child : node.children) visit(child, to_scene, depth + 1, all_below);
  }

  void check_transform(const tinygltf::Node& node, const std::string& what) const {
    if (node.rotation.size() == 4 && !is_turn(node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]))
      refuse(file_, what, "its rotation is no unit quaternion");
  }

  /// True for a quaternion of length 1, as far as rounding to bytes allows.
  static bool is_turn(double x, double y, double z, double w) {
    constexpr double rounding = 0.02;
    return std::fabs(std::sqrt(x * x + y * y + z * z + w * w) - 1) <= rounding;
  }

  static bool is_invisible(const tinygltf::Node& node) {
    const auto found = node.extensions.find(gltf_visibility);
    if (found == node.extensions.end() || !found->second.Has("visible")) return false;
    const tinygltf::Value& visible = found->second.Get("visible");
    return visible.IsBool() && !visible.Get<bool>();
  }

  /// Appends the mesh at each instance of its node; a skinned mesh as its joints place it.
  void append(const Shown& shown) {
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(shown.node)];
    const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
    const std::string name = "mesh \"" + mesh.name.substr(0, 64) + "\"";
    element_ = name;
    const std::vector<glm::dmat4> joints = node.skin >= 0 ? joints_of(node.skin) : std::vector<glm::dmat4>{};
    for (const glm::dmat4& place : places_of(node, shown.to_scene)) {
      for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        element_ = name + ", primitive " + std::to_string(i);
        append(mesh.primitives[i], place, joints, node.weights.empty() ? mesh.weights : node.weights);
      }
    }
  }

  std::vector<glm::dmat4> places_of(const tinygltf::Node& node, const glm::dmat4& to_scene) {
    const auto extension = node.extensions.find(gltf_instancing);
    if (extension == node.extensions.end() || node.skin >= 0) return {to_scene};
    const tinygltf::Value& attributes = extension->second.Get("attributes");
    const auto table = [&](const char* name, std::size_t width) -> std::optional<Table> {
      if (!attributes.IsObject() || !attributes.Has(name)) return {};
      Table values = table_of(attributes.Get(name).GetNumberAsInt(), name);
      if (values.width != width) refuse(file_, element_ + ", " + name, "it has another number of components");
      return values;
    };
    const auto translation = table("TRANSLATION", 3), rotation = table("ROTATION", 4), scale = table("SCALE", 3);
    const std::optional<Table>& first = translation ? translation : rotation ? rotation : scale;
    if (!first) refuse(file_, element_, "its instances have no places");
    if (first->count > max_instances) refuse(file_, element_, "more than 65 536 instances", "export fewer");
    for (const std::optional<Table>& other : {translation, rotation, scale})
      if (other && other->count != first->count) refuse(file_, element_, "its instances have lists of unequal length");
    std::vector<glm::dmat4> places;
    for (std::size_t i = 0; i < first->count; ++i) {
      glm::dmat4 place(1);
      if (rotation && !is_turn(rotation->at(i, 0), rotation->at(i, 1), rotation->at(i, 2), rotation->at(i, 3)))
        refuse(file_, element_ + ", ROTATION, instance " + std::to_string(i), "it is no unit quaternion");
      if (rotation)
        place = glm::mat4_cast(
            glm::normalize(glm::dquat(rotation->at(i, 3), rotation->at(i, 0), rotation->at(i, 1), rotation->at(i, 2))));
      for (int k = 0; k < 3; ++k) {
        if (scale) place[k] *= scale->at(i, static_cast<std::size_t>(k));
        if (translation) place[3][k] = translation->at(i, static_cast<std::size_t>(k));
      }
      places.push_back(to_scene * place);
    }
    return places;
  }

  /// The transform of each joint of a skin, for points of the mesh.
  std::vector<glm::dmat4> joints_of(int index) const {
    if (static_cast<std::size_t>(index) >= model_.skins.size()) refuse(file_, element_, "there is no such skin");
    const tinygltf::Skin& skin = model_.skins[static_cast<std::size_t>(index)];
    if (skin.joints.empty()) refuse(file_, element_, "its skin has no joints");
    std::optional<Table> inverse;
    if (skin.inverseBindMatrices >= 0) inverse = table_of(skin.inverseBindMatrices, "inverseBindMatrices");
    if (inverse && (inverse->width != 16 || inverse->count < skin.joints.size()))
      refuse(file_, element_ + ", inverseBindMatrices", "it needs a matrix for each joint");
    std::vector<glm::dmat4> joints;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const auto node = static_cast<std::size_t>(skin.joints[i]);
      if (node >= to_scene_.size() || !to_scene_[node])
        refuse(file_, element_, "a joint of its skin is not in the scene");
      glm::dmat4 from_mesh(1);
      for (int k = 0; k < 16 && inverse; ++k) from_mesh[k / 4][k % 4] = inverse->at(i, static_cast<std::size_t>(k));
      joints.push_back(*to_scene_[node] * from_mesh);
    }
    return joints;
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

  /// The `count` values of a type in a view, from an offset on.
  Values bytes_at(int view_index, std::size_t offset, std::size_t count, int type, int component_type,
                  const char* name) const {
    const auto fail = [&](const char* why) { refuse(file_, element_ + ", " + name, why); };
    if (view_index < 0 || static_cast<std::size_t>(view_index) >= model_.bufferViews.size())
      fail("there are no bytes for it");
    const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size())
      fail("there is no such buffer");
    const std::vector<unsigned char>& bytes = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    const int component = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type));
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type));
    if (component <= 0 || components <= 0) fail("its type is not known");
    const auto size = static_cast<std::size_t>(component) * static_cast<std::size_t>(components);
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : size;

    // Compare with what is left, so that no sum can overflow.
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) fail("the file ends early");
    if (stride < size || stride > 252 || offset > view.byteLength) fail("it lies outside its bytes");
    const std::size_t left = view.byteLength - offset;
    if (count == 0 || left < size || count - 1 > (left - size) / stride) fail("it is longer than its bytes");
    return {bytes.data() + view.byteOffset + offset, count, stride, type, component_type, false};
  }

  const tinygltf::Accessor& accessor_of(int index, const char* name) const {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size())
      refuse(file_, element_ + ", " + name, "there is no such accessor");
    return model_.accessors[static_cast<std::size_t>(index)];
  }

  Values values_of(int index, const char* name) const {
    const tinygltf::Accessor& accessor = accessor_of(index, name);
    if (accessor.sparse.isSparse) refuse(file_, element_ + ", " + name, "sparse values are not understood");
    Values values =
        bytes_at(accessor.bufferView, accessor.byteOffset, accessor.count, accessor.type, accessor.componentType, name);
    values.normalized = accessor.normalized;
    return values;
  }

  /// The values of an accessor as numbers, including sparse ones.
  Table table_of(int index, const char* name) const {
    const tinygltf::Accessor& accessor = accessor_of(index, name);
    const auto fail = [&](const char* why) { refuse(file_, element_ + ", " + name, why); };
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    if (components <= 0) fail("its type is not known");
    Table table{.value = {},
                .count = accessor.count,
                .width = static_cast<std::size_t>(components),
                .component = accessor.componentType};
    const bool is_sparse = accessor.sparse.isSparse;
    if (accessor.bufferView >= 0 || !is_sparse) {
      const Values plain = bytes_at(accessor.bufferView, accessor.byteOffset, accessor.count, accessor.type,
                                    accessor.componentType, name);
      fill(table, plain, accessor.normalized, name);
    } else {
      if (accessor.count > max_vertices) fail("more than 5 000 000 values");
      table.value.assign(table.count * table.width, 0);
    }
    if (!is_sparse) return table;

    // Sparse values replace others by index.
    const auto& sparse = accessor.sparse;
    const auto number = static_cast<std::size_t>(std::max(0, sparse.count));
    const Values at = bytes_at(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), number,
                               TINYGLTF_TYPE_SCALAR, sparse.indices.componentType, name);
    Table other{.value = {}, .count = number, .width = table.width, .component = table.component};
    fill(other,
         bytes_at(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), number, accessor.type,
                  accessor.componentType, name),
         accessor.normalized, name);
    double last = -1;
    for (std::size_t i = 0; i < number; ++i) {
      const double place = component_of(at, i, 0).value_or(-1);
      if (!(place >= 0 && place < static_cast<double>(table.count))) fail("a sparse value has no place");
      if (place <= last) fail("the places of its sparse values do not rise");
      last = place;
      for (std::size_t k = 0; k < table.width; ++k)
        table.value[static_cast<std::size_t>(place) * table.width + k] = other.at(i, k);
    }
    return table;
  }

  void fill(Table& table, Values values, bool normalized, const char* name) const {
    values.normalized = normalized;
    table.value.reserve(table.count * table.width);
    for (std::size_t i = 0; i < table.count; ++i) {
      for (std::size_t k = 0; k < table.width; ++k) {
        const std::optional<double> value = component_of(values, i, k);
        if (!value) refuse(file_, element_ + ", " + name, "its numbers are of no known type");
        table.value.push_back(*value);
      }
    }
  }

  template <typename T>
  static double raw(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof(T));
    return static_cast<double>(value);
  }

  static bool is_unsigned(int component) {
    return component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  }

  static std::optional<double> component_of(const Values& values, std::size_t item, std::size_t k) {
    const unsigned char* start = values.data + item * values.stride;
    switch (values.component) {
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return raw<float>(start + 4 * k);
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return values.normalized ? std::max(raw<std::int8_t>(start + k) / 127.0, -1.0) : raw<std::int8_t>(start + k);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return values.normalized ? std::max(raw<std::int16_t>(start + 2 * k) / 32767.0, -1.0)
                                 : raw<std::int16_t>(start + 2 * k);
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

  void append(const tinygltf::Primitive& primitive, const glm::dmat4& to_scene, const std::vector<glm::dmat4>& joints,
              const std::vector<double>& weights) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP &&
        primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN) {
      refuse(file_, element_, "holds no triangles, but points or lines", "export it without them");
    }
    const auto found = primitive.attributes.find("POSITION");
    if (found == primitive.attributes.end()) {
      refuse(file_, element_, "has no positions", "export it without compression");
    }
    const std::size_t first = mesh_.position.size();
    std::vector<glm::dvec3> position = positions_of(found->second);
    morph(position, primitive, weights);
    const bool on_skin = !joints.empty() && primitive.attributes.contains("JOINTS_0");
    append_positions(on_skin ? posed(position, primitive, joints) : position, on_skin ? glm::dmat4(1) : to_scene);
    append_colors(primitive);
    append_triangles(primitive, first, glm::determinant(on_skin ? joints.front() : to_scene) < 0);
  }

  std::vector<glm::dvec3> positions_of(int accessor) const {
    const tinygltf::Accessor& values = accessor_of(accessor, "POSITION");
    const bool is_quantized = has_quantization() && values.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (values.type != TINYGLTF_TYPE_VEC3 || (values.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT && !is_quantized)) {
      refuse(file_, element_ + ", POSITION", "positions must be three floats", "export it without quantization");
    }
    if (values.count > max_vertices - mesh_.position.size()) {
      // If the accessor is longer than its buffer, report that instead.
      if (!values.sparse.isSparse) values_of(accessor, "POSITION");
      refuse(file_, element_, "more than 5 000 000 vertices", "simplify the mesh");
    }
    const Table table = table_of(accessor, "POSITION");
    std::vector<glm::dvec3> position;
    position.reserve(table.count);
    for (std::size_t i = 0; i < table.count; ++i) position.emplace_back(table.at(i, 0), table.at(i, 1), table.at(i, 2));
    return position;
  }

  bool has_quantization() const {
    const auto lists = [](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), gltf_quantization) != names.end();
    };
    return lists(model_.extensionsUsed) || lists(model_.extensionsRequired);
  }

  /// Adds the morph targets by their weights.
  void morph(std::vector<glm::dvec3>& position, const tinygltf::Primitive& primitive,
             const std::vector<double>& weights) const {
    if (!weights.empty() && weights.size() != primitive.targets.size())
      refuse(file_, element_ + ", morph targets", "it needs one weight for each target");
    for (std::size_t t = 0; t < std::min(weights.size(), primitive.targets.size()); ++t) {
      const auto found = primitive.targets[t].find("POSITION");
      if (weights[t] == 0 || found == primitive.targets[t].end()) continue;
      const Table moved = table_of(found->second, "morph target");
      if (moved.width != 3 || moved.count != position.size())
        refuse(file_, element_ + ", morph target", "it needs one place for each vertex");
      for (std::size_t i = 0; i < position.size(); ++i)
        position[i] += weights[t] * glm::dvec3(moved.at(i, 0), moved.at(i, 1), moved.at(i, 2));
    }
  }

  /// The points as the joints place them, by their weights.
  std::vector<glm::dvec3> posed(const std::vector<glm::dvec3>& position, const tinygltf::Primitive& primitive,
                                const std::vector<glm::dmat4>& joints) const {
    std::vector<glm::dvec3> sum(position.size(), glm::dvec3(0));
    std::vector<double> total(position.size(), 0);
    for (int set = 0; primitive.attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
      const auto weights_at = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
      if (weights_at == primitive.attributes.end()) refuse(file_, element_, "its joints have no weights");
      const Table joint = table_of(primitive.attributes.at("JOINTS_" + std::to_string(set)), "JOINTS");
      const Table weight = table_of(weights_at->second, "WEIGHTS");
      if (joint.width != 4 || weight.width != 4 || joint.count != position.size() || weight.count != position.size())
        refuse(file_, element_, "it needs four joints and weights for each vertex");
      for (std::size_t i = 0; i < position.size(); ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
          const double w = weight.at(i, k);
          if (w == 0) continue;
          if (!(joint.at(i, k) >= 0 && joint.at(i, k) < static_cast<double>(joints.size())))
            refuse(file_, element_ + ", vertex " + std::to_string(i), "there is no such joint");
          sum[i] += w * glm::dvec3(joints[static_cast<std::size_t>(joint.at(i, k))] * glm::dvec4(position[i], 1));
          total[i] += w;
        }
      }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (!(total[i] > 0)) refuse(file_, element_ + ", vertex " + std::to_string(i), "no joint holds it");
      sum[i] /= total[i];
    }
    return sum;
  }

  void append_positions(const std::vector<glm::dvec3>& position, const glm::dmat4& to_scene) {
    for (std::size_t i = 0; i < position.size(); ++i) {
      const auto p = glm::dvec3(to_scene * glm::dvec4(position[i], 1));
      for (int k = 0; k < 3; ++k) {
        if (!(std::fabs(p[k]) <= farthest)) {
          refuse(file_, element_ + ", vertex " + std::to_string(i), "its position is not finite or too far away");
        }
      }
      mesh_.position.push_back(p);
    }
  }

  /// COLOR_0 is linear; alpha is ignored.
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
    const bool is_byte_or_short = values.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                  values.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    if (values.component != TINYGLTF_COMPONENT_TYPE_FLOAT && !(values.normalized && is_byte_or_short))
      refuse(file_, element_ + ", COLOR_0", "colours must be floats or normalized", "export it without colours");
    colored_ = true;
    for (std::size_t i = 0; i < values.count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double channel = component_of(values, i, k).value_or(0.5);
        if (!std::isfinite(channel)) refuse(file_, element_ + ", COLOR_0", "a colour is not finite");
        mesh_.color[first + i][static_cast<int>(k)] = channel >= 0 ? static_cast<float>(std::min(channel, 1.0)) : 0.0f;
      }
    }
  }

  void append_triangles(const tinygltf::Primitive& primitive, std::size_t first, bool mirrored) {
    // Without indices, every three vertices are a triangle.
    const std::size_t vertices = mesh_.position.size() - first;
    std::optional<Values> indices;
    if (primitive.indices >= 0) indices = values_of(primitive.indices, "indices");
    if (indices && (indices->type != TINYGLTF_TYPE_SCALAR || indices->normalized || !is_unsigned(indices->component)))
      refuse(file_, element_ + ", indices", "they must be whole numbers without a sign");

    // Refuse too many triangles before any is read.
    const std::size_t corners = indices ? indices->count : vertices;
    const bool apart = primitive.mode == TINYGLTF_MODE_TRIANGLES;
    if (apart && corners % 3 != 0)
      refuse(file_, element_, std::to_string(corners) + " corners are no whole number of triangles");
    const bool is_fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    const std::size_t count = apart ? corners / 3 : corners < 3 ? 0 : corners - 2;
    if (count > max_mesh_triangles - mesh_.triangle.size()) {
      refuse(file_, element_, "more than 2 000 000 triangles", "simplify the mesh");
    }

    // Swap two corners of mirrored triangles, and of every second triangle of a strip, so that their fronts stay in
    // front.
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t start = apart ? 3 * i : i;
      glm::uvec3 triangle(0);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t at = is_fan && k == 0 ? 0 : start + k;
        const double vertex = indices ? *component_of(*indices, at, 0) : static_cast<double>(at);
        if (!(vertex >= 0 && vertex < static_cast<double>(vertices))) {
          refuse(file_, element_ + ", triangle " + std::to_string(i), "there is no such vertex");
        }
        triangle[static_cast<int>(k)] = static_cast<std::uint32_t>(first + static_cast<std::size_t>(vertex));
      }
      const bool is_flat = triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x;
      if (is_flat && !apart) continue;
      const bool is_turned = !apart && !is_fan && i % 2 == 1;
      if (mirrored != is_turned) std::swap(triangle.y, triangle.z);
      mesh_.triangle.push_back(triangle);
    }
  }

  tinygltf::Model model_;
  std::string file_, object_;
  std::string element_;  ///< for messages: the element that is read
  std::vector<std::string> names_;
  std::vector<std::optional<glm::dmat4>> to_scene_;  ///< for each node of the scene
  std::vector<Shown> shown_;
  std::size_t visits_ = 0;
  std::size_t called_so_ = 0;  ///< number of nodes with the wanted name
  bool colored_ = false;
  PlainMesh mesh_;
};

}  // namespace

PlainMesh parse_glb(std::string_view bytes, const std::string& file, const std::string& object) {
  check_container(bytes, file);
  check_gltf_json(bytes.substr(20, word_at(bytes, 12)), file);
  return GlbReader(parse_model(without_empty_chunk(bytes), file), file, object).read();
}

}  // namespace pomona
