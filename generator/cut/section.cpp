#include "generator/cut/section.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr std::uint32_t unset = 0xffffffffu;

/// What the sides next to a vertex say about it.
struct SideColors {
  Color sum{0};
  int count = 0;
  std::int32_t part = 0;  // of the first
};

class SectionBuilder {
 public:
  /// `same_as` tells of points which share their place with another; empty where none does.
  SectionBuilder(Section& section, std::span<const std::uint32_t> same_as, const SplitMesh& mesh,
                 const DiffusionSurfaces& surfaces, SharedVertices shared)
      : section_(section), same_as_(same_as), mesh_(mesh), surfaces_(surfaces), interior_at_(std::move(shared)) {}

  void add_face(const FaceMesh& face, const Regions& regions) {
    face_ = &face;
    regions_ = &regions;
    find_fans();
    make_vertices();
    std::vector<std::vector<std::size_t>> of_facet(face.facets());
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (regions_->is_section(t)) of_facet[face.facet_of(t)].push_back(t);
    }
    const std::size_t before = section_.mesh.triangle.size();
    for (std::size_t i = 0; i < of_facet.size(); ++i) add_facet(i, of_facet[i]);
    if (section_.mesh.triangle.size() != before) add_segments();
  }

 private:
  const TriangulatedPlane& plane() const { return face_->mesh; }
  std::size_t triangle_count() const { return plane().triangle.size(); }
  bool is_section(std::int32_t triangle) const {
    return triangle >= 0 && regions_->is_section(static_cast<std::size_t>(triangle));
  }
  std::uint32_t corner(std::size_t triangle, std::size_t i) const {
    return plane().triangle[triangle][static_cast<int>(i % 3)];
  }
  std::span<const EdgeUse> uses(std::size_t triangle, std::size_t edge) const {
    if (!plane().constrained[triangle][edge]) return {};
    return face_->uses(corner(triangle, edge), corner(triangle, edge + 1));
  }

  std::uint32_t place(std::uint32_t vertex) const {
    const std::uint32_t point = face_->point[vertex];
    return same_as_.empty() ? point : same_as_[point];
  }

  void add_facet(std::size_t facet, const std::vector<std::size_t>& triangles) {
    if (triangles.empty()) return;
    add_triangles(triangles);
    section_.mesh.faces.push_back(face_->frame(facet));
  }

  /// Joins the corners that meet at a vertex without a surface between them.
  void find_fans() {
    fan_.assign(3 * triangle_count(), 0);
    std::iota(fan_.begin(), fan_.end(), 0u);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_->is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t other = plane().neighbor[t][i];
        if (other < static_cast<std::int32_t>(t) || !is_section(other) || !uses(t, i).empty()) continue;
        const auto o = static_cast<std::size_t>(other);
        std::size_t j = 0;
        while (corner(o, j) != corner(t, i + 1)) ++j;
        join(3 * t + (i + 1) % 3, 3 * o + j);
        join(3 * t + i, 3 * o + (j + 1) % 3);
      }
    }
  }

  std::uint32_t fan_of(std::size_t corner_index) {
    auto c = static_cast<std::uint32_t>(corner_index);
    while (fan_[c] != c) c = fan_[c] = fan_[fan_[c]];
    return c;
  }

  void join(std::size_t a, std::size_t b) {
    const std::uint32_t first = fan_of(a), second = fan_of(b);
    fan_[std::max(first, second)] = std::min(first, second);
  }

  /// One vertex for every fan: with the sides' colours where it lies at a surface, else still to be diffused.
  void make_vertices() {
    std::vector<SideColors> sides(fan_.size());
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_->is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        for (const EdgeUse& use : uses(t, i)) {
          const bool front = use.forward == (corner(t, i) < corner(t, i + 1));
          see_side(sides[fan_of(3 * t + i)], use.segment, corner(t, i), front);
          see_side(sides[fan_of(3 * t + (i + 1) % 3)], use.segment, corner(t, i + 1), front);
        }
      }
    }
    vertex_of_fan_.assign(fan_.size(), unset);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_->is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t fan = fan_of(3 * t + i);
        if (vertex_of_fan_[fan] == unset) vertex_of_fan_[fan] = make_vertex(corner(t, i), sides[fan]);
      }
    }
  }

  void see_side(SideColors& sides, std::uint32_t segment_number, std::uint32_t vertex, bool front) const {
    const Segment& s = face_->segment[segment_number];
    const std::uint32_t point = face_->point[vertex];
    float share = point == s.to ? 1.0f : 0.0f;
    if (point != s.from && point != s.to) {
      const glm::dvec3 &a = mesh_.point[s.from], &b = mesh_.point[s.to];
      share = static_cast<float>(std::min(1.0, glm::distance(a, mesh_.point[point]) / glm::distance(a, b)));
    }
    const std::vector<Color>& color = front ? mesh_.front_color : mesh_.back_color;
    sides.sum += glm::mix(color[s.from_vertex], color[s.to_vertex], share);
    if (sides.count++ == 0) sides.part = (front ? surfaces_.front_part : surfaces_.back_part)[s.source];
  }

  std::uint32_t make_vertex(std::uint32_t vertex, const SideColors& sides) {
    const std::uint32_t point = place(vertex);
    const bool interior = sides.count == 0;
    const auto number = static_cast<std::uint32_t>(section_.mesh.position.size());
    if (interior && (interior_at_.contains(point) || mesh_.sets.planes_in(mesh_.planes_of[point]).size() > 1)) {
      // Where cut faces meet, they share the vertex, which is then coloured once.
      const auto [entry, is_new] = interior_at_.try_emplace(point, number);
      if (!is_new) return entry->second;
    }
    section_.mesh.position.emplace_back(mesh_.point[point]);
    section_.mesh.color.push_back(interior ? Color(0) : sides.sum / static_cast<float>(sides.count));
    section_.mesh.interior.push_back(interior ? 1 : 0);
    section_.mesh.part.push_back(sides.part);
    return number;
  }

  std::uint32_t vertex_of(std::size_t triangle, std::size_t i) { return vertex_of_fan_[fan_of(3 * triangle + i % 3)]; }

  void add_triangles(const std::vector<std::size_t>& triangles) {
    for (const std::size_t t : triangles) {
      section_.mesh.triangle.emplace_back(vertex_of(t, 0), vertex_of(t, 1), vertex_of(t, 2));
      section_.mesh.cut.push_back(static_cast<std::int32_t>(section_.mesh.faces.size()));
      add_normals(t);
      Cap cap;
      for (std::size_t i = 0; i < 3; ++i) cap.point[i] = place(corner(t, i));
      const Regions::Patch& patch = regions_->patch[regions_->patch_of[t]];
      cap.cell = patch.cell;
      cap.inside = patch.inside;
      section_.cap.push_back(cap);
      for (const Regions::Patch::Closing& closing : patch.also) {
        section_.mesh.triangle.push_back(glm::uvec3(section_.mesh.triangle.back()));
        section_.mesh.cut.push_back(section_.mesh.cut.back());
        add_normals(t);
        section_.cap.push_back({cap.point, closing.cell, closing.inside});
      }
    }
  }

  /// As soon as one face is curved, of all triangles.
  void add_normals(std::size_t triangle) {
    std::vector<std::array<glm::vec3, 3>>& normal = section_.mesh.normal;
    const CutFace& frame = face_->frame(face_->facet_of(triangle));
    if (normal.empty() && !frame.curved) return;
    const auto flat = [](const CutFace& face) {
      const glm::vec3 n(face.normal);
      return std::array{n, n, n};
    };
    for (std::size_t t = normal.size(); t + 1 < section_.mesh.triangle.size(); ++t) {
      normal.push_back(flat(section_.mesh.faces[static_cast<std::size_t>(section_.mesh.cut[t])]));
    }
    normal.push_back(frame.curved ? face_->normals(triangle) : flat(frame));
  }

  /// Every edge that follows a surface once per surface, with the vertices on one side of it.
  void add_segments() {
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_->is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const bool rim = !is_section(plane().neighbor[t][i]);
        if (!rim && corner(t, i) > corner(t, i + 1)) continue;
        std::int32_t last = -1;
        for (const EdgeUse& use : uses(t, i)) {
          const std::int32_t surface = surfaces_.surface[face_->segment[use.segment].source];
          if (surface != last) section_.mesh.segments.push_back({{vertex_of(t, i), vertex_of(t, i + 1)}, surface, rim});
          last = surface;
        }
      }
    }
  }

  Section& section_;
  std::span<const std::uint32_t> same_as_;
  const SplitMesh& mesh_;
  const DiffusionSurfaces& surfaces_;
  SharedVertices interior_at_;

  // The face at work.
  const FaceMesh* face_ = nullptr;
  const Regions* regions_ = nullptr;
  std::vector<std::uint32_t> fan_;            // per corner; union-find
  std::vector<std::uint32_t> vertex_of_fan_;  // per corner that stands for its fan
};

}  // namespace

Section assemble_all(const FaceMeshes& faces, const std::vector<Regions>& regions, const SplitMesh& mesh,
                     const DiffusionSurfaces& surfaces) {
  Section section;
  section.mesh.part_names = surfaces.part_names;
  section.mesh.surface_names = surfaces.surface_names;
  SectionBuilder builder(section, faces.same_as, mesh, surfaces, {});
  for (std::size_t f = 0; f < faces.faces.size(); ++f) builder.add_face(faces.faces[f], regions[f]);
  return section;
}

void leave_out_collapsed(Section& section) {
  CrossSection& mesh = section.mesh;
  const auto collapses = [&](const glm::uvec3& t) {
    const std::vector<glm::vec3>& p = mesh.position;
    return p[t.x] == p[t.y] || p[t.y] == p[t.z] || p[t.z] == p[t.x];
  };
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    if (collapses(mesh.triangle[t])) continue;
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
}

Section assemble(const FaceMeshes& faces, const std::vector<Regions>& regions, const SplitMesh& mesh,
                 const DiffusionSurfaces& surfaces, const CutPlanes&) {
  Section section = assemble_all(faces, regions, mesh, surfaces);
  leave_out_collapsed(section);
  return section;
}

void add_face(Section& section, const FaceMesh& face, const Regions& regions, const SplitMesh& mesh,
              const DiffusionSurfaces& surfaces, const SharedVertices& shared) {
  SectionBuilder(section, {}, mesh, surfaces, shared).add_face(face, regions);
}

}  // namespace pomona
