#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/surface/file/outer_skin.h"
#include "generator/surface/file/ply.h"
#include "generator/surface/file/surface_file.h"

namespace pomona {

namespace {

// Limits on what is read; a fruit has some ten thousand triangles.
constexpr std::uint64_t most_bytes = std::uint64_t{512} << 20;
constexpr std::uint64_t most_vertices = 5'000'000;
constexpr std::uint64_t most_triangles = 10'000'000;
constexpr double most_names = 65'536;
constexpr double farthest = 1e6;   ///< metres
constexpr double smallest = 1e-6;  ///< metres

constexpr const char* both_hidden = "this face hides both its sides";
constexpr const char* show_one = "hide only the side that faces air";

const PlyElement* find_element(const PlyHeader& header, std::string_view name) {
  for (const PlyElement& element : header.elements) {
    if (element.name == name) return &element;
  }
  return nullptr;
}

bool has(const PlyElement& element, std::initializer_list<std::string_view> names) {
  return std::all_of(names.begin(), names.end(), [&](std::string_view name) {
    return std::any_of(element.properties.begin(), element.properties.end(),
                       [&](const PlyProperty& p) { return p.name == name && !p.count_type; });
  });
}

class SurfaceReader {
 public:
  SurfaceReader(std::string_view bytes, const std::string& file) : ply_(bytes, file) {}

  DiffusionSurfaces read() {
    check_elements();
    for (const PlyElement& element : ply_.header().elements) {
      if (&element == vertices_) {
        read_vertices();
      } else if (&element == faces_) {
        read_faces();
      } else {
        skip(element);
      }
    }
    check_whole();
    name_surfaces_and_parts();
    return with_outer_skin(std::move(surfaces_));
  }

 private:
  void check_elements() {
    vertices_ = find_element(ply_.header(), "vertex");
    faces_ = find_element(ply_.header(), "face");
    if (!vertices_) ply_.fail_at(0, "the file has no vertices", "it needs an element \"vertex\"");
    if (!faces_) ply_.fail_at(0, "the file has no faces", "point clouds are not surfaces");
    if (!has(*vertices_, {"x", "y", "z"})) ply_.fail_at(vertices_->byte, "vertices need the properties x, y and z");
    if (std::none_of(faces_->properties.begin(), faces_->properties.end(), is_corners)) {
      ply_.fail_at(faces_->byte, "faces need the list vertex_indices");
    }
    if (vertices_->count > most_vertices) ply_.fail_at(vertices_->byte, "more than 5 000 000 vertices");
    if (faces_->count > most_triangles) ply_.fail_at(faces_->byte, "more than 10 000 000 faces");
    if (faces_->count == 0) ply_.fail_at(faces_->byte, "the file has no faces");
  }

  static bool is_corners(const PlyProperty& p) {
    return p.count_type && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  void skip(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      ply_.start_item(element, i);
      for (const PlyProperty& property : element.properties) ply_.skip(property);
    }
  }

  // Vertices

  /// One vertex as its values come.
  struct Vertex {
    glm::vec3 position{0};
    glm::dvec3 srgb{0};
    Color front{0}, back{0};
    float blur = 0;
    bool front_hidden = false, back_hidden = false;
  };
  using Setter = std::function<void(Vertex&, double)>;

  Setter setter_of(const PlyProperty& property) const {
    // Properties that are lists say nothing of a vertex.
    if (property.count_type) return {};

    // Positions and colours are vectors, each of three properties.
    struct Channels {
      std::array<std::string_view, 3> names;
      glm::vec3 Vertex::*values;
    };
    static constexpr std::array<Channels, 3> vectors{{{{"x", "y", "z"}, &Vertex::position},
                                                      {{"front_r", "front_g", "front_b"}, &Vertex::front},
                                                      {{"back_r", "back_g", "back_b"}, &Vertex::back}}};
    for (const Channels& vector : vectors) {
      if (const std::optional<int> k = channel_of(property, vector.names)) {
        return [this, k = *k, values = vector.values](Vertex& v, double value) {
          (v.*values)[k] = static_cast<float>(number(value, farthest));
        };
      }
    }

    // Colours for viewers have a full scale that depends on their type; the rest are single values.
    if (const std::optional<int> k = channel_of(property, {"red", "green", "blue"})) {
      const double white = full_scale(property.type);
      return [this, k = *k, white](Vertex& v, double value) { v.srgb[k] = number(value, 1e6) / white; };
    }
    if (property.name == "blur") {
      return [this](Vertex& v, double value) {
        if (value < 0) ply_.fail("blur is below 0", "blur is a length in metres");
        v.blur = static_cast<float>(number(value, farthest));
      };
    }
    if (property.name == "front_hidden") return [](Vertex& v, double value) { v.front_hidden = value != 0; };
    if (property.name == "back_hidden") return [](Vertex& v, double value) { v.back_hidden = value != 0; };
    return {};
  }

  static std::optional<int> channel_of(const PlyProperty& property, const std::array<std::string_view, 3>& names) {
    const auto found = std::find(names.begin(), names.end(), property.name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<int>(found - names.begin()));
  }

  /// What stands for a full channel: 255 for bytes, 1 for floats.
  static double full_scale(PlyType type) {
    if (type == PlyType::float32 || type == PlyType::float64) return 1;
    return type == PlyType::int16 || type == PlyType::uint16 ? 65535 : 255;
  }

  double number(double value, double most) const {
    if (!std::isfinite(value)) ply_.fail("this number is not finite");
    if (std::fabs(value) > most) ply_.fail("this number is too large", "at most 1000000, lengths in metres");
    return value;
  }

  void read_vertices() {
    // Find what each property sets, and which colours the file has.
    std::vector<Setter> setters;
    for (const PlyProperty& property : vertices_->properties) setters.push_back(setter_of(property));
    const bool has_srgb = has(*vertices_, {"red", "green", "blue"});
    const bool has_front = has(*vertices_, {"front_r", "front_g", "front_b"});
    const bool has_back = has(*vertices_, {"back_r", "back_g", "back_b"});
    constexpr Color grey(0.5f);

    reserve_vertices(vertices_->count);
    for (std::uint64_t i = 0; i < vertices_->count; ++i) {
      ply_.start_item(*vertices_, i);
      Vertex vertex;

      // Properties that set nothing are passed over.
      for (std::size_t k = 0; k < setters.size(); ++k) {
        const PlyProperty& property = vertices_->properties[k];
        if (setters[k]) {
          setters[k](vertex, ply_.value(property.type));
        } else {
          ply_.skip(property);
        }
      }

      // A front without a colour takes what viewers show, or is grey; a back without one is like its front.
      if (!has_front) vertex.front = has_srgb ? linear(vertex.srgb) : grey;
      if (!has_back) vertex.back = vertex.front;
      append(vertex);
    }
  }

  static Color linear(const glm::dvec3& srgb) {
    Color color;
    for (int k = 0; k < 3; ++k) {
      color[k] = static_cast<float>(linear_from_srgb(std::clamp(srgb[k], 0.0, 1.0)));
    }
    return color;
  }

  void reserve_vertices(std::uint64_t count) {
    surfaces_.position.reserve(count);
    surfaces_.front_color.reserve(count);
    surfaces_.back_color.reserve(count);
    surfaces_.blur.reserve(count);
    surfaces_.front_hidden.reserve(count);
    surfaces_.back_hidden.reserve(count);
  }

  void append(const Vertex& vertex) {
    surfaces_.position.push_back(vertex.position);
    surfaces_.front_color.push_back(vertex.front);
    surfaces_.back_color.push_back(vertex.back);
    surfaces_.blur.push_back(vertex.blur);
    surfaces_.front_hidden.push_back(vertex.front_hidden ? 1 : 0);
    surfaces_.back_hidden.push_back(vertex.back_hidden ? 1 : 0);
  }

  // Faces

  struct Face {
    std::vector<std::uint32_t> corners;
    std::int32_t surface = 0, front_part = 0, back_part = 0;
  };

  void read_faces() {
    for (std::uint64_t i = 0; i < faces_->count; ++i) {
      ply_.start_item(*faces_, i);
      Face face;
      for (const PlyProperty& property : faces_->properties) {
        if (is_corners(property)) {
          read_corners(property, face);
        } else if (std::int32_t* index = index_of(property, face)) {
          *index = read_index(property.type);
        } else {
          ply_.skip(property);
        }
      }
      append(face);
    }
  }

  static std::int32_t* index_of(const PlyProperty& property, Face& face) {
    if (property.count_type) return nullptr;
    if (property.name == "surface") return &face.surface;
    if (property.name == "front_part") return &face.front_part;
    if (property.name == "back_part") return &face.back_part;
    return nullptr;
  }

  std::int32_t read_index(PlyType type) {
    const double value = ply_.value(type);
    if (!(value >= 0 && value < most_names) || value != std::floor(value)) {
      ply_.fail("surfaces and parts are numbered from 0 to 65535");
    }
    return static_cast<std::int32_t>(value);
  }

  void read_corners(const PlyProperty& property, Face& face) {
    const std::uint64_t count = ply_.list_length(property);
    if (count < 3) ply_.fail("a face needs at least 3 vertices");
    if (surfaces_.triangle_count() + count - 2 > most_triangles) ply_.fail("more than 10 000 000 triangles");
    for (std::uint64_t k = 0; k < count; ++k) {
      const double corner = ply_.value(property.type);
      if (!(corner >= 0 && corner < static_cast<double>(vertices_->count)) || corner != std::floor(corner)) {
        ply_.fail("there is no such vertex", "vertices are numbered from 0");
      }
      face.corners.push_back(static_cast<std::uint32_t>(corner));
    }
  }

  /// A polygon as a fan around its first vertex.
  void append(const Face& face) {
    for (std::size_t k = 2; k < face.corners.size(); ++k) {
      surfaces_.triangle.emplace_back(face.corners[0], face.corners[k - 1], face.corners[k]);
      surfaces_.surface.push_back(face.surface);
      surfaces_.front_part.push_back(face.front_part);
      surfaces_.back_part.push_back(face.back_part);
      if (hides_both_sides(surfaces_.triangle_count() - 1)) ply_.fail(both_hidden, show_one);
    }
  }

  /// False while the vertices are still to come.
  bool hides_both_sides(std::size_t triangle) const {
    return surfaces_.vertex_count() == vertices_->count && surfaces_.is_hidden(triangle, SideOf::front) &&
           surfaces_.is_hidden(triangle, SideOf::back);
  }

  void check_whole() const {
    for (std::size_t i = 0; i < surfaces_.triangle_count(); ++i) {
      if (hides_both_sides(i)) ply_.fail_at(faces_->byte, both_hidden, show_one);
    }
    if (glm::length(bounds_of(surfaces_).size()) < smallest) {
      ply_.fail_at(vertices_->byte, "the surfaces have no size", "positions are in metres");
    }
  }

  // Names

  void name_surfaces_and_parts() {
    for (const std::string& comment : ply_.header().comments) {
      read_name(comment, "surface ", surfaces_.surface_names);
      read_name(comment, "part ", surfaces_.part_names);
    }
    complete(surfaces_.surface_names, surfaces_.surface, "surface ");
    complete(surfaces_.part_names, surfaces_.front_part, "part ");
    complete(surfaces_.part_names, surfaces_.back_part, "part ");
  }

  /// "surface 3 skin" names surface 3; any other comment says nothing to us.
  static void read_name(std::string_view comment, std::string_view what, std::vector<std::string>& names) {
    if (!comment.starts_with(what)) return;
    comment.remove_prefix(what.size());
    std::size_t index = 0;
    const auto [end, status] = std::from_chars(comment.data(), comment.data() + comment.size(), index);
    if (status != std::errc() || static_cast<double>(index) >= most_names) return;
    comment.remove_prefix(static_cast<std::size_t>(end - comment.data()));
    if (!comment.empty() && comment.front() != ' ') return;
    if (!comment.empty()) comment.remove_prefix(1);
    if (names.size() <= index) names.resize(index + 1);
    names[index] = comment;
  }

  /// Gives every index in use a name.
  static void complete(std::vector<std::string>& names, const std::vector<std::int32_t>& used, std::string_view what) {
    for (const std::int32_t index : used) {
      const auto at = static_cast<std::size_t>(index);
      if (names.size() <= at) names.resize(at + 1);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].empty()) names[i] = std::string(what) + std::to_string(i);
    }
  }

  PlyReader ply_;
  const PlyElement* vertices_ = nullptr;
  const PlyElement* faces_ = nullptr;
  DiffusionSurfaces surfaces_;
};

[[noreturn]] void refuse_size(const std::string& file) {
  SourcePlace place;
  place.file = file;
  throw Error(ExitStatus::bad_data, {{place, "the file is larger than 512 MiB", "simplify the mesh"}});
}

}  // namespace

DiffusionSurfaces parse_surfaces(std::string_view bytes, const std::string& file) {
  if (bytes.size() > most_bytes) refuse_size(file);
  return SurfaceReader(bytes, file).read();
}

DiffusionSurfaces read_surfaces(const std::filesystem::path& file) {
  return parse_surfaces(file_bytes(file, most_bytes, "simplify the mesh"), file.string());
}

}  // namespace pomona
