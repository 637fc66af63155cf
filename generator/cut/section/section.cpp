#include "generator/cut/section/section.h"

#include <algorithm>
#include <utility>

namespace pomona {

namespace {

/// Adds the parts of faces, one after another.
class PartJoiner {
 public:
  PartJoiner(Section section, const SplitMesh& mesh, SharedVertices shared)
      : section_(std::move(section)), mesh_(mesh), interior_at_(std::move(shared)) {}

  void add(FacePart part) {
    std::vector<std::uint32_t> number;
    for (const FacePart::Vertex& v : part.vertex) number.push_back(number_of(v));

    CrossSection& all = section_.mesh;
    add_normals(part);
    const std::size_t first_frame = all.faces.size();
    all.faces.insert(all.faces.end(), part.frame.begin(), part.frame.end());
    for (const glm::uvec3& t : part.triangle) all.triangle.emplace_back(number[t.x], number[t.y], number[t.z]);
    for (const std::uint32_t f : part.frame_of) all.cut.push_back(static_cast<std::int32_t>(first_frame + f));
    for (Cap& cap : part.cap) section_.cap.push_back(std::move(cap));
    for (const SectionSegment& s : part.segments) {
      all.segments.push_back({{number[s.vertex[0]], number[s.vertex[1]]}, s.surface, s.boundary});
    }
  }

  Section done() { return std::move(section_); }

 private:
  /// Where cut faces meet, they share the vertex, which is then coloured once.
  std::uint32_t number_of(const FacePart::Vertex& v) {
    const auto next = static_cast<std::uint32_t>(section_.mesh.position.size());
    if (v.interior && (interior_at_.contains(v.point) || lies_on_several_planes(v.point))) {
      const auto [entry, is_new] = interior_at_.try_emplace(v.point, next);
      if (!is_new) return entry->second;
    }
    section_.mesh.position.emplace_back(mesh_.point[v.point]);
    section_.mesh.color.push_back(v.color);
    section_.mesh.interior.push_back(v.interior ? 1 : 0);
    section_.mesh.part.push_back(v.part);
    return next;
  }

  bool lies_on_several_planes(std::uint32_t point) const {
    return mesh_.sets.planes_in(mesh_.planes_of[point]).size() > 1;
  }

  /// Adds normals, for all triangles as soon as one face is curved.
  void add_normals(const FacePart& part) {
    std::vector<std::array<glm::vec3, 3>>& normal = section_.mesh.normal;
    const auto is_curved = [](const CutFace& face) { return face.curved; };
    if (normal.empty() && std::none_of(part.frame.begin(), part.frame.end(), is_curved)) return;
    for (std::size_t t = normal.size(); t < section_.mesh.triangle.size(); ++t) {
      const glm::vec3 flat(section_.mesh.faces[static_cast<std::size_t>(section_.mesh.cut[t])].normal);
      normal.push_back({flat, flat, flat});
    }
    normal.insert(normal.end(), part.normal.begin(), part.normal.end());
  }

  Section section_;
  const SplitMesh& mesh_;
  SharedVertices interior_at_;
};

}  // namespace

Section empty_section(const DiffusionSurfaces& surfaces) {
  Section section;
  section.mesh.part_names = surfaces.part_names;
  section.mesh.surface_names = surfaces.surface_names;
  return section;
}

Section with_parts(Section section, std::vector<FacePart> parts, const SplitMesh& mesh, SharedVertices shared) {
  PartJoiner joiner(std::move(section), mesh, std::move(shared));
  for (FacePart& part : parts) joiner.add(std::move(part));
  return joiner.done();
}

Section without(Section section, std::span<const std::uint8_t> gone) {
  CrossSection& mesh = section.mesh;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    if (t < gone.size() && gone[t]) continue;
    mesh.triangle[kept] = mesh.triangle[t];
    mesh.cut[kept] = mesh.cut[t];
    if (!mesh.normal.empty()) mesh.normal[kept] = mesh.normal[t];
    if (kept != t) section.cap[kept] = std::move(section.cap[t]);
    ++kept;
  }
  mesh.triangle.resize(kept);
  mesh.cut.resize(kept);
  if (!mesh.normal.empty()) mesh.normal.resize(kept);
  section.cap.resize(kept);
  return section;
}

Section without_collapsed(Section section) {
  const std::vector<glm::vec3>& p = section.mesh.position;
  std::vector<std::uint8_t> gone;
  for (const glm::uvec3& t : section.mesh.triangle) {
    gone.push_back(p[t.x] == p[t.y] || p[t.y] == p[t.z] || p[t.z] == p[t.x] ? 1 : 0);
  }
  return without(std::move(section), gone);
}

}  // namespace pomona
