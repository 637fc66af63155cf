#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/mesh/polygon_triangles.h"
#include "generator/surface/file/far_from_origin.h"
#include "generator/surface/file/outer_skin.h"
#include "generator/surface/file/ply.h"
#include "generator/surface/file/ply_colors.h"
#include "generator/surface/file/ply_names.h"
#include "generator/surface/file/surface_file.h"

namespace pomona {

namespace {

// Limits of the reader; a fruit has some ten thousand triangles.
constexpr std::uint64_t max_bytes = std::uint64_t{512} << 20;
constexpr std::uint64_t max_vertices = 5'000'000;
constexpr std::uint64_t max_triangles = 10'000'000;
constexpr double farthest = 1e6;       ///< metres
constexpr double farthest_read = 1e8;  ///< metres, before it is moved: the Earth is 4e7 m around
constexpr double smallest = 1e-6;      ///< metres

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
  SurfaceReader(std::string_view bytes, const std::string& file, const Placing& placing)
      : ply_(bytes, file), placing_(placing) {}

  DiffusionSurfaces read() {
    read_elements();
    round_positions();
    check_whole();
    name_surfaces_and_parts();
    note_unread_colors();
    refuse_inside_out();
    return with_outer_skin(std::move(surfaces_));
  }

  /// The shape and the front's colours, not rounded.
  PlainMesh read_plain(const std::string& object) {
    read_elements();
    name_surfaces_and_parts();
    std::vector<std::uint8_t> is_wanted(surfaces_.surface_names.size(), object.empty() ? 1 : 0);
    for (std::size_t s = 0; s < is_wanted.size(); ++s)
      if (surfaces_.surface_names[s] == object) is_wanted[s] = 1;
    if (!object.empty() && std::find(is_wanted.begin(), is_wanted.end(), 1) == is_wanted.end())
      ply_.fail_whole("there is no surface \"" + object + "\" in the file",
                      "it has: " + listed_names(surfaces_.surface_names));
    PlainMesh mesh;
    mesh.position = std::move(exact_);
    if (has_color_) mesh.color = std::move(surfaces_.front_color);
    for (std::size_t i = 0; i < surfaces_.triangle_count(); ++i)
      if (is_wanted[static_cast<std::size_t>(surfaces_.surface[i])] != 0)
        mesh.triangle.push_back(surfaces_.triangle[i]);
    PlainMesh used = without_unused(mesh);
    used.notes = surfaces_.notes;
    return used;
  }

 private:
  /// The file itself says which side faces air, and has no key to turn it.
  void refuse_inside_out() const {
    const std::optional<std::size_t> triangle = shell_inside_out(surfaces_);
    if (!triangle) return;
    const std::size_t surface = static_cast<std::size_t>(surfaces_.surface[*triangle]);
    ply_.fail_at(faces_ ? faces_->byte : strips_->byte,
                 "surface \"" + surfaces_.surface_names[surface] + "\" is inside out: the side of its shell at " +
                     place_text(*triangle) + " (m) that is hidden faces inwards, so nothing of it is solid",
                 "turn its faces, or hide the other side: front_hidden and back_hidden say which one faces air");
  }

  std::string place_text(std::size_t triangle) const {
    glm::dvec3 middle(0);
    for (int k = 0; k < 3; ++k) middle += glm::dvec3(surfaces_.position[surfaces_.triangle[triangle][k]]) / 3.0;
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%.4g, %.4g, %.4g", middle.x, middle.y, middle.z);
    return text.data();
  }

  void read_elements() {
    check_elements();
    for (const PlyElement& element : ply_.header().elements) {
      if (&element == vertices_) {
        read_vertices();
      } else if (&element == faces_) {
        read_faces();
      } else if (&element == strips_) {
        read_strips();
      } else {
        skip(element);
      }
    }
    append_awaiting();
    paint_faces();
    if (const std::size_t left = ply_.bytes_left(); left > 0)
      surfaces_.notes.push_back("the " + std::to_string(left) + " bytes behind its last element are not read");
  }

  void check_elements() {
    vertices_ = find_element(ply_.header(), "vertex");
    faces_ = find_element(ply_.header(), "face");
    strips_ = find_element(ply_.header(), "tristrips");
    if (faces_ && faces_->count == 0 && strips_) faces_ = nullptr;
    if (!vertices_) ply_.fail_at(0, "the file has no vertices", "it needs an element \"vertex\"");
    if (!faces_ && !strips_) {
      if (find_element(ply_.header(), "range_grid"))
        ply_.fail_at(0, "the file has a range_grid instead of faces", "make a mesh of it in the program it came from");
      ply_.fail_at(0, "the file has no faces", "point clouds are not surfaces");
    }
    if (!has(*vertices_, {"x", "y", "z"})) ply_.fail_at(vertices_->byte, "vertices need the properties x, y and z");
    for (const PlyElement* element : {faces_, strips_}) {
      if (element && std::count_if(element->properties.begin(), element->properties.end(), is_corners) > 1)
        ply_.fail_at(element->byte, "there are two lists of corners, vertex_index and vertex_indices");
      if (element && std::none_of(element->properties.begin(), element->properties.end(), is_corners))
        ply_.fail_at(element->byte,
                     (element == faces_ ? "faces" : "strips") + std::string(" need the list vertex_indices"));
    }
    if (vertices_->count > max_vertices) ply_.fail_at(vertices_->byte, "more than 5 000 000 vertices");
    if (faces_ && faces_->count > max_triangles) ply_.fail_at(faces_->byte, "more than 10 000 000 faces");
    if (faces_ && faces_->count == 0) ply_.fail_at(faces_->byte, "the file has no faces");
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

  /// The values of one vertex.
  struct Vertex {
    glm::dvec3 position{0};
    glm::dvec3 srgb{0};
    Color front{0}, back{0};
    float blur = 0;
    bool front_hidden = false, back_hidden = false;
  };
  using Setter = std::function<void(Vertex&, double)>;

  Setter setter_of(const PlyProperty& property, const PlyColors& srgb) const {
    // Ignore list properties of a vertex.
    if (property.count_type) return {};

    // Positions and colours are vectors of three properties each.
    if (const std::optional<int> k = exact_channel_of(property, {"x", "y", "z"}))
      return [this, k = *k](Vertex& v, double value) { v.position[k] = number(value, farthest_read); };
    struct Channels {
      VectorNames names;
      glm::vec3 Vertex::*values;
    };
    static constexpr std::array<Channels, 2> vectors{
        {{{"front_r", "front_g", "front_b"}, &Vertex::front}, {{"back_r", "back_g", "back_b"}, &Vertex::back}}};
    for (const Channels& vector : vectors) {
      if (const std::optional<int> k = exact_channel_of(property, vector.names)) {
        return [this, k = *k, values = vector.values](Vertex& v, double value) {
          (v.*values)[k] = static_cast<float>(number(value, farthest));
        };
      }
    }

    // Colours for viewers have a full scale of their own; the rest are single values.
    if (const std::optional<int> k = srgb.channel(property))
      return [this, k = *k, type = property.type](Vertex& v, double value) { v.srgb[k] = channel(value, type); };
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

  static std::optional<int> exact_channel_of(const PlyProperty& property, const VectorNames& names) {
    const auto found = std::find(names.begin(), names.end(), property.name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<int>(found - names.begin()));
  }

  double number(double value, double max) const {
    if (!std::isfinite(value)) ply_.fail("this number is not finite");
    if (std::fabs(value) > max)
      ply_.fail("this number is too large",
                "at most " + std::to_string(static_cast<std::int64_t>(max)) + ", lengths in metres");
    return value;
  }

  /// A channel of a colour for viewers. Text may hold what its type cannot.
  double channel(double value, PlyType type) const {
    number(value, 1e6);
    const double largest = type == PlyType::uint8 ? 255 : type == PlyType::uint16 ? 65535 : 1e6;
    if (!is_float(type) && !(value >= 0 && value <= largest && value == std::floor(value)))
      ply_.fail("a colour cannot be that", "its type holds whole numbers from 0 to 255, or to 65535");
    return value;
  }

  void read_vertices() {
    // Find which value each property sets, and which colours the file has.
    std::vector<Setter> setters;
    PlyColors srgb(*vertices_);
    for (const PlyProperty& property : vertices_->properties) setters.push_back(setter_of(property, srgb));
    const bool has_front = has(*vertices_, {"front_r", "front_g", "front_b"});
    const bool has_back = has(*vertices_, {"back_r", "back_g", "back_b"});
    constexpr Color grey(0.5f);

    reserve_vertices(vertices_->count);
    for (std::uint64_t i = 0; i < vertices_->count; ++i) {
      ply_.start_item(*vertices_, i);
      Vertex vertex;

      // Skip the values of other properties.
      for (std::size_t k = 0; k < setters.size(); ++k) {
        const PlyProperty& property = vertices_->properties[k];
        if (setters[k]) {
          setters[k](vertex, ply_.value(property.type));
        } else {
          ply_.skip(property);
        }
      }

      if (!has_front) vertex.front = grey;
      if (!has_back) vertex.back = vertex.front;
      append(vertex);
      if (srgb.is_there()) srgb.add(vertex.srgb);
    }

    // A front without its own colour gets the viewers' colour, or grey; a back without one gets its front's.
    has_color_ = has_front || srgb.is_there();
    paints_backs_ = !has_back;
    if (has_front || !srgb.is_there()) return;
    for (std::size_t v = 0; v < surfaces_.vertex_count(); ++v) {
      surfaces_.front_color[v] = srgb.linear(v);
      if (!has_back) surfaces_.back_color[v] = surfaces_.front_color[v];
    }
  }

  void reserve_vertices(std::uint64_t count) {
    exact_.reserve(count);
    surfaces_.position.reserve(count);
    surfaces_.front_color.reserve(count);
    surfaces_.back_color.reserve(count);
    surfaces_.blur.reserve(count);
    surfaces_.front_hidden.reserve(count);
    surfaces_.back_hidden.reserve(count);
  }

  void append(const Vertex& vertex) {
    exact_.push_back(vertex.position);
    surfaces_.position.push_back(glm::vec3(vertex.position));
    surfaces_.front_color.push_back(vertex.front);
    surfaces_.back_color.push_back(vertex.back);
    surfaces_.blur.push_back(vertex.blur);
    surfaces_.front_hidden.push_back(vertex.front_hidden ? 1 : 0);
    surfaces_.back_hidden.push_back(vertex.back_hidden ? 1 : 0);
  }

  // Faces

  struct Face {
    std::vector<std::uint32_t> corners;
    std::int32_t surface = 0, front_part = 0, back_part = 0, instance = 0;
    std::uint32_t index = 0;  ///< index within the element
  };
  static constexpr std::uint32_t no_face = UINT32_MAX;

  void read_faces() {
    PlyColors& srgb = face_color_.emplace(*faces_);
    for (std::uint64_t i = 0; i < faces_->count; ++i) {
      ply_.start_item(*faces_, i);
      Face face;
      glm::dvec3 color(0);
      for (const PlyProperty& property : faces_->properties) {
        if (is_corners(property)) {
          read_corners(property, face);
        } else if (std::int32_t* index = index_of(property, face)) {
          *index = read_index(property.type);
        } else if (const std::optional<int> k = srgb.channel(property)) {
          color[*k] = channel(ply_.value(property.type), property.type);
        } else {
          ply_.skip(property);
        }
      }
      if (srgb.is_there()) srgb.add(color);
      face.index = static_cast<std::uint32_t>(i);
      if (face.corners.size() < 3)
        ++faces_left_out_;
      else
        append(std::move(face));
    }
  }

  /// Every three successive corners are a triangle, every second one with reversed order; -1 begins a new strip.
  void read_strips() {
    for (std::uint64_t i = 0; i < strips_->count; ++i) {
      ply_.start_item(*strips_, i);
      for (const PlyProperty& property : strips_->properties) {
        if (is_corners(property)) {
          read_strip(property);
        } else {
          ply_.skip(property);
        }
      }
    }
  }

  void read_strip(const PlyProperty& property) {
    const std::uint64_t count = ply_.list_length(property);
    std::uint64_t length = 0;
    glm::uvec3 last(0);
    for (std::uint64_t k = 0; k < count; ++k) {
      const double value = ply_.value(property.type);
      if (value == -1) {
        length = 0;
        continue;
      }
      last = {last.y, last.z, corner_of(value)};
      if (++length < 3 || last.x == last.y || last.y == last.z || last.z == last.x) continue;
      if (surfaces_.triangle_count() >= max_triangles) ply_.fail("more than 10 000 000 triangles");
      const bool turned = length % 2 == 0;
      append(Face{.corners = {last.x, turned ? last.z : last.y, turned ? last.y : last.z}, .index = no_face});
    }
  }

  static std::int32_t* index_of(const PlyProperty& property, Face& face) {
    if (property.count_type) return nullptr;
    if (property.name == "surface") return &face.surface;
    if (property.name == "front_part") return &face.front_part;
    if (property.name == "back_part") return &face.back_part;
    if (property.name == "instance") return &face.instance;
    return nullptr;
  }

  std::int32_t read_index(PlyType type) {
    const double value = ply_.value(type);
    if (!(value >= 0 && value < max_ply_names) || value != std::floor(value)) {
      ply_.fail("surfaces, parts and instances are numbered from 0 to 65535");
    }
    return static_cast<std::int32_t>(value);
  }

  void read_corners(const PlyProperty& property, Face& face) {
    const std::uint64_t count = ply_.list_length(property);
    if (surfaces_.triangle_count() + count > max_triangles + 2) ply_.fail("more than 10 000 000 triangles");
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint32_t corner = corner_of(ply_.value(property.type));
      if (face.corners.empty() || face.corners.back() != corner) face.corners.push_back(corner);
    }
    while (face.corners.size() > 1 && face.corners.back() == face.corners.front()) face.corners.pop_back();
  }

  std::uint32_t corner_of(double value) const {
    if (!(value >= 0 && value < static_cast<double>(vertices_->count)) || value != std::floor(value))
      ply_.fail("there is no such vertex", "vertices are numbered from 0");
    return static_cast<std::uint32_t>(value);
  }

  /// Triangulates a polygon. This needs its corners' positions: if the vertices come later, the polygon waits.
  void append(Face face) {
    if (face.corners.size() > 3 && surfaces_.vertex_count() < vertices_->count) {
      awaiting_.push_back(std::move(face));
      return;
    }
    std::vector<glm::dvec3> places;
    for (const std::uint32_t corner : face.corners)
      places.push_back(corner < exact_.size() ? exact_[corner] : glm::dvec3(0));
    const auto triangles = polygon_triangles(places);
    if (!triangles) ply_.fail("this face crosses or touches itself", "triangulate the mesh before it is exported");
    for (const glm::uvec3& t : *triangles) {
      surfaces_.triangle.emplace_back(face.corners[t.x], face.corners[t.y], face.corners[t.z]);
      surfaces_.surface.push_back(face.surface);
      surfaces_.front_part.push_back(face.front_part);
      surfaces_.back_part.push_back(face.back_part);
      surfaces_.instance.push_back(face.instance);
      face_of_.push_back(face.index);
      if (hides_both_sides(surfaces_.triangle_count() - 1)) ply_.fail(both_hidden, show_one);
    }
  }

  /// Appends the waiting polygons after all other triangles.
  void append_awaiting() {
    for (Face& face : std::exchange(awaiting_, {})) append(std::move(face));
  }

  /// If only faces have colours, gives them to the corners; each colour needs its own vertex.
  void paint_faces() {
    if (has_color_ || !face_color_ || !face_color_->is_there()) return;
    has_color_ = true;
    std::map<std::tuple<std::uint32_t, double, double, double>, std::uint32_t> known;
    std::vector<std::uint8_t> is_painted(surfaces_.vertex_count(), 0);
    for (std::size_t i = 0; i < surfaces_.triangle_count(); ++i) {
      if (face_of_[i] == no_face) continue;
      const glm::dvec3& srgb = (*face_color_)[face_of_[i]];
      for (int k = 0; k < 3; ++k) {
        std::uint32_t& corner = surfaces_.triangle[i][k];
        const auto [found, is_new] = known.try_emplace({corner, srgb.r, srgb.g, srgb.b}, corner);
        if (is_new) {
          if (is_painted[corner] != 0) found->second = doubled_vertex(corner);
          is_painted[corner] = 1;
          surfaces_.front_color[found->second] = face_color_->linear(face_of_[i]);
          if (paints_backs_) surfaces_.back_color[found->second] = surfaces_.front_color[found->second];
        }
        corner = found->second;
      }
    }
  }

  std::uint32_t doubled_vertex(std::uint32_t vertex) {
    exact_.push_back(glm::dvec3(exact_[vertex]));
    return pomona::doubled_vertex(surfaces_, vertex);
  }

  /// False before the vertices are read.
  bool hides_both_sides(std::size_t triangle) const {
    return surfaces_.vertex_count() == vertices_->count && surfaces_.is_hidden(triangle, SideOf::front) &&
           surfaces_.is_hidden(triangle, SideOf::back);
  }

  /// Places the points, then rounds them to floats: rounding first would distort shapes far from the origin.
  void round_positions() {
    if (surfaces_.triangle.empty())
      ply_.fail_at(faces_ ? faces_->byte : strips_->byte, "the file has no faces of three corners or more");
    for (std::size_t v = 0; v < exact_.size(); ++v) {
      if (placing_.moves()) exact_[v] = placing_(exact_[v]);
      surfaces_.position[v] = glm::vec3(exact_[v]);
    }
    Box<double> box;
    for (const glm::uvec3& t : surfaces_.triangle)
      for (int k = 0; k < 3; ++k) box.add(exact_[t[k]]);
    if (glm::length(box.size()) >= smallest && is_too_far(box))
      ply_.fail_at(vertices_->byte, why_too_far(box),
                   "move it to the origin; in a template, by " + at_key(box.moved(-placing_.at)));
    if (distance_of(box) > farthest)
      ply_.fail_at(vertices_->byte, "the mesh is larger than 1000 km", "positions are in metres");
  }

  void check_whole() const {
    const std::size_t byte = faces_ ? faces_->byte : strips_->byte;
    for (std::size_t i = 0; i < surfaces_.triangle_count(); ++i) {
      if (hides_both_sides(i)) ply_.fail_at(byte, both_hidden, show_one);
    }
    if (glm::length(bounds_of(surfaces_).size()) < smallest) {
      ply_.fail_at(vertices_->byte, "the surfaces have no size", "positions are in metres");
    }
  }

  // Names

  /// Notes that colours in a picture are not read.
  void note_texture() {
    for (const std::string& comment : ply_.header().comments) {
      if (!comment.starts_with("TextureFile") || has_color_) continue;
      surfaces_.notes.push_back("its colours are in a picture (" + comment.substr(0, 80) + "), which is not read");
      return;
    }
  }

  /// Notes that colours are there by names that are not read.
  void note_unread_colors() {
    for (const PlyElement& element : ply_.header().elements) {
      const std::optional<std::string_view> name = has_color_ ? std::nullopt : unread_color(element);
      if (!name) continue;
      surfaces_.notes.push_back("it has colours by a name that is not read, \"" + std::string(*name) +
                                "\"; red, green and blue would be");
      return;
    }
  }

  void name_surfaces_and_parts() {
    note_texture();
    if (faces_left_out_ > 0) surfaces_.notes.push_back(few_corners_note(faces_left_out_));
    const std::vector<std::string>& comments = ply_.header().comments;
    surfaces_.surface_names = ply_names(comments, "surface ", {&surfaces_.surface});
    surfaces_.part_names = ply_names(comments, "part ", {&surfaces_.front_part, &surfaces_.back_part});
    const auto& instance = surfaces_.instance;
    if (std::all_of(instance.begin(), instance.end(), [](std::int32_t i) { return i == 0; }))
      surfaces_.instance.clear();
  }

  PlyReader ply_;
  const PlyElement* vertices_ = nullptr;
  const PlyElement* faces_ = nullptr;
  const PlyElement* strips_ = nullptr;
  Placing placing_;
  std::vector<glm::dvec3> exact_;        ///< positions as in the file
  std::optional<PlyColors> face_color_;  ///< one for each face
  std::vector<std::uint32_t> face_of_;   ///< for each triangle
  std::vector<Face> awaiting_;           ///< polygons before their vertices
  bool has_color_ = false, paints_backs_ = false;
  std::size_t faces_left_out_ = 0;  ///< of less than three corners
  DiffusionSurfaces surfaces_;
};

[[noreturn]] void refuse_size(const std::string& file) {
  SourcePlace place;
  place.file = file;
  throw Error(ExitStatus::bad_data, {{place, "the file is larger than 512 MiB", "simplify the mesh"}});
}

}  // namespace

DiffusionSurfaces parse_surfaces(std::string_view bytes, const std::string& file, const Placing& placing) {
  if (bytes.size() > max_bytes) refuse_size(file);
  return SurfaceReader(bytes, file, placing).read();
}

PlainMesh parse_plain_surfaces(std::string_view bytes, const std::string& file, const std::string& object) {
  if (bytes.size() > max_bytes) refuse_size(file);
  return SurfaceReader(bytes, file, {}).read_plain(object);
}

DiffusionSurfaces read_surfaces(const std::filesystem::path& file) {
  return parse_surfaces(file_bytes(file, max_bytes, "simplify the mesh"), file.string());
}

}  // namespace pomona
