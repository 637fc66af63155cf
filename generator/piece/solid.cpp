#include "generator/piece/solid.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "generator/piece/guided.h"

namespace pomona {

namespace {

/// Builds one solid: the skin first, then the cut faces.
class SolidBuilder {
 public:
  SolidBuilder(const CutPiece& piece, const CrossSection& section, const Template& fruit)
      : piece_(piece), section_(section), fruit_(fruit) {
    solid_.density = fruit.density;
    const auto on_skin = [](const DetailSketch& detail) { return detail.face == DetailFace::skin; };
    guides_ = !section.guide.empty() || std::any_of(fruit.details.begin(), fruit.details.end(), on_skin);
    solid_.volume = piece.volume;
    solid_.closed = piece.closed;
    solid_.crumb = piece.crumb;
    solid_.instances = piece.instances;
  }

  Solid build(std::string name) {
    solid_.name = std::move(name);
    take_skin();
    solid_.mesh.guide_lattice = section_.guide_lattice;
    for (const CutPiece::CapTriangle& cap : piece_.caps) add_cap(cap);
    drop_spare_room();
    return std::move(solid_);
  }

 private:
  static constexpr std::uint32_t unset = 0xffffffffu;

  void take_skin() {
    solid_.mesh.position = piece_.position;
    solid_.mesh.normal = piece_.normal;
    solid_.mesh.color = piece_.color;
    solid_.mesh.part = piece_.part;
    if (guides_) {
      for (const std::int32_t part : piece_.part)
        solid_.mesh.guide.push_back({.share = detail_shares(fruit_, DetailFace::skin, part, 0)});
    }
    solid_.mesh.triangle = piece_.triangle;
    solid_.mesh.surface = piece_.surface;
    solid_.mesh.instance = piece_.instance;
    solid_.mesh.cut_face.assign(piece_.triangle.size(), -1);
  }

  /// Grown vectors hold up to twice their content, and a scene has hundreds of solids.
  void drop_spare_room() {
    const auto fit = [](auto&... vectors) { (vectors.shrink_to_fit(), ...); };
    fit(solid_.mesh.position, solid_.mesh.normal, solid_.mesh.color, solid_.mesh.part, solid_.mesh.guide,
        solid_.mesh.triangle, solid_.mesh.cut_face, solid_.mesh.surface);
  }

  void add_cap(const CutPiece::CapTriangle& cap) {
    const glm::uvec3& t = section_.triangle[cap.triangle];
    const std::int32_t face = section_.cut[cap.triangle];
    std::array<glm::vec3, 3> normal{};
    normal.fill(glm::vec3(section_.faces[static_cast<std::size_t>(face)].normal));
    if (!section_.normal.empty()) normal = section_.normal[cap.triangle];
    glm::uvec3 corner(0);
    for (int i = 0; i < 3; ++i) {
      const glm::vec3& n = normal[static_cast<std::size_t>(i)];
      corner[i] = vertex(t[i], face, cap.reversed ? -n : n);
    }
    solid_.mesh.triangle.emplace_back(corner.x, cap.reversed ? corner.z : corner.y, cap.reversed ? corner.y : corner.z);
    solid_.mesh.cut_face.push_back(face);
    solid_.mesh.surface.push_back(-1);
    if (!piece_.instance.empty()) solid_.mesh.instance.push_back(0);  // organs.h says of which organ
  }

  /// A vertex of the section as seen on one face: where faces meet, each has its own normal, and so has either side of
  /// a crease within a curved face.
  std::uint32_t vertex(std::uint32_t of_section, std::int32_t face, const glm::vec3& normal) {
    if (static_cast<std::size_t>(face) >= vertex_on_face_.size())
      vertex_on_face_.resize(static_cast<std::size_t>(face) + 1);
    std::vector<std::uint32_t>& known = vertex_on_face_[static_cast<std::size_t>(face)];
    if (known.empty()) known.assign(section_.position.size(), unset);
    if (known[of_section] == unset) return known[of_section] = new_vertex(of_section, normal);
    if (solid_.mesh.normal[known[of_section]] == normal) return known[of_section];
    for (const std::uint32_t v : beyond_crease_[{face, of_section}]) {
      if (solid_.mesh.normal[v] == normal) return v;
    }
    return beyond_crease_[{face, of_section}].emplace_back(new_vertex(of_section, normal));
  }

  std::uint32_t new_vertex(std::uint32_t of_section, const glm::vec3& normal) {
    solid_.mesh.position.push_back(section_.position[of_section]);
    solid_.mesh.normal.push_back(normal);
    solid_.mesh.color.push_back(section_.color[of_section]);
    solid_.mesh.part.push_back(section_.part[of_section]);
    if (guides_) solid_.mesh.guide.push_back(section_.guide.empty() ? DetailGuide{} : section_.guide[of_section]);
    return static_cast<std::uint32_t>(solid_.mesh.position.size() - 1);
  }

  const CutPiece& piece_;
  const CrossSection& section_;
  const Template& fruit_;
  bool guides_ = false;
  Solid solid_;
  std::vector<std::vector<std::uint32_t>> vertex_on_face_;  // per face, per vertex of the section

  /// Further vertices, by face and vertex of the section.
  std::map<std::pair<std::int32_t, std::uint32_t>, std::vector<std::uint32_t>> beyond_crease_;
};

}  // namespace

FruitLook look_of(const Template& fruit, const std::vector<std::string>& part_names) {
  FruitLook look{.part_names = part_names, .noise = fruit.noise, .ink = fruit.ink};
  if (fruit.materials.empty()) return look;
  for (const std::string& name : part_names) {
    const auto at =
        static_cast<std::size_t>(std::find(fruit.parts.begin(), fruit.parts.end(), name) - fruit.parts.begin());
    look.materials.push_back(at < fruit.materials.size() ? fruit.materials[at] : MaterialSketch{});
  }
  return look;
}

std::vector<Solid> solids(std::span<const CutPiece> pieces, const CrossSection& colored_section, const Template& fruit,
                          const std::string& name) {
  FruitLook look = look_of(fruit, colored_section.part_names);
  look.details = fruit.details;
  const auto shared = std::make_shared<const FruitLook>(std::move(look));
  std::vector<Solid> all;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::string own = pieces.size() == 1 ? name : name + ".piece-" + std::to_string(i + 1);
    all.push_back(SolidBuilder(pieces[i], colored_section, fruit).build(own));
    all.back().look = shared;
  }
  return all;
}

}  // namespace pomona
