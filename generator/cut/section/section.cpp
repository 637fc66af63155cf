#include "generator/cut/section/section.h"

#include <algorithm>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/mesh/disjoint_sets.h"

namespace pomona {

namespace {

constexpr std::uint32_t unset = 0xffffffffu;

/// What the sides next to a vertex say about it.
struct SideColors {
  Color sum{0};
  int count = 0;
  std::int32_t part = 0;  // of the first
};

/// One face's share of a section, its vertices numbered from 0.
struct FacePart {
  struct Vertex {
    std::uint32_t point = 0;  // of the split mesh, first of those at one place
    Color color{0};
    std::int32_t part = 0;
    bool interior = false;  // still to be diffused
  };
  std::vector<Vertex> vertex;
  std::vector<CutFace> frame;  // one for each facet that has triangles
  std::vector<glm::uvec3> triangle;
  std::vector<std::uint32_t> frame_of;           // per triangle
  std::vector<std::array<glm::vec3, 3>> normal;  // per triangle
  std::vector<Cap> cap;                          // per triangle
  std::vector<CutSegment> segments;
};

/// Makes one face's part; those of several faces may be made at the same time.
class FacePartBuilder {
 public:
  /// `same_as` tells of points which share their place with another; empty where none does.
  FacePartBuilder(const FaceMesh& face, const Regions& regions, std::span<const std::uint32_t> same_as,
                  const SplitMesh& mesh, const DiffusionSurfaces& surfaces)
      : face_(face), regions_(regions), same_as_(same_as), mesh_(mesh), surfaces_(surfaces) {}

  FacePart build() {
    find_fans();
    make_vertices();
    std::vector<std::vector<std::size_t>> of_facet(face_.facets());
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (regions_.is_section(t)) of_facet[face_.facet_of(t)].push_back(t);
    }
    for (std::size_t i = 0; i < of_facet.size(); ++i) {
      if (of_facet[i].empty()) continue;
      part_.frame.push_back(face_.frame(i));
      for (const std::size_t t : of_facet[i]) add_triangle(t);
    }
    add_segments();
    return std::move(part_);
  }

 private:
  const TriangulatedPlane& plane() const { return face_.mesh; }
  std::size_t triangle_count() const { return plane().triangle.size(); }
  bool is_section(std::int32_t triangle) const {
    return triangle >= 0 && regions_.is_section(static_cast<std::size_t>(triangle));
  }
  std::uint32_t corner(std::size_t triangle, std::size_t i) const {
    return plane().triangle[triangle][static_cast<int>(i % 3)];
  }
  std::span<const EdgeUse> uses(std::size_t triangle, std::size_t edge) const {
    if (!plane().constrained[triangle][edge]) return {};
    return face_.uses(corner(triangle, edge), corner(triangle, edge + 1));
  }

  std::uint32_t place(std::uint32_t vertex) const {
    const std::uint32_t point = face_.point[vertex];
    return same_as_.empty() ? point : same_as_[point];
  }

  /// Joins the corners that meet at a vertex without a surface between them.
  void find_fans() {
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_.is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t other = plane().neighbor[t][i];
        if (other < static_cast<std::int32_t>(t) || !is_section(other) || !uses(t, i).empty()) continue;
        const auto o = static_cast<std::size_t>(other);
        std::size_t j = 0;
        while (corner(o, j) != corner(t, i + 1)) ++j;
        fans_.join(corner_number(t, i + 1), corner_number(o, j));
        fans_.join(corner_number(t, i), corner_number(o, j + 1));
      }
    }
  }

  static std::uint32_t corner_number(std::size_t triangle, std::size_t i) {
    return static_cast<std::uint32_t>(3 * triangle + i % 3);
  }
  std::uint32_t fan_of(std::size_t triangle, std::size_t i) { return fans_.root(corner_number(triangle, i)); }

  /// One vertex for every fan: with the sides' colours where it lies at a surface, else still to be diffused.
  void make_vertices() {
    std::vector<SideColors> sides(fans_.count());
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_.is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        for (const EdgeUse& use : uses(t, i)) {
          const bool front = use.forward == (corner(t, i) < corner(t, i + 1));
          see_side(sides[fan_of(t, i)], use.segment, corner(t, i), front);
          see_side(sides[fan_of(t, i + 1)], use.segment, corner(t, i + 1), front);
        }
      }
    }
    vertex_of_fan_.assign(fans_.count(), unset);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_.is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t fan = fan_of(t, i);
        if (vertex_of_fan_[fan] != unset) continue;
        vertex_of_fan_[fan] = static_cast<std::uint32_t>(part_.vertex.size());
        const SideColors& seen = sides[fan];
        const bool interior = seen.count == 0;
        const Color color = interior ? Color(0) : seen.sum / static_cast<float>(seen.count);
        part_.vertex.push_back({place(corner(t, i)), color, seen.part, interior});
      }
    }
  }

  void see_side(SideColors& sides, std::uint32_t segment_number, std::uint32_t vertex, bool front) const {
    const Segment& s = face_.segment[segment_number];
    const std::uint32_t point = face_.point[vertex];
    float share = point == s.to ? 1.0f : 0.0f;
    if (point != s.from && point != s.to) {
      const glm::dvec3 &a = mesh_.point[s.from], &b = mesh_.point[s.to];
      share = static_cast<float>(std::min(1.0, glm::distance(a, mesh_.point[point]) / glm::distance(a, b)));
    }
    const std::vector<Color>& color = front ? mesh_.front_color : mesh_.back_color;
    sides.sum += glm::mix(color[s.from_vertex], color[s.to_vertex], share);
    if (sides.count++ == 0) sides.part = (front ? surfaces_.front_part : surfaces_.back_part)[s.source];
  }

  std::uint32_t vertex_of(std::size_t triangle, std::size_t i) { return vertex_of_fan_[fan_of(triangle, i)]; }

  /// As often as it closes something.
  void add_triangle(std::size_t t) {
    const Regions::Patch& patch = regions_.patch[regions_.patch_of[t]];
    const std::array<std::uint32_t, 3> points{place(corner(t, 0)), place(corner(t, 1)), place(corner(t, 2))};
    add_triangle(t, {points, patch.cell, patch.inside});
    for (const Regions::Patch::Closing& closing : patch.also) add_triangle(t, {points, closing.cell, closing.inside});
  }

  void add_triangle(std::size_t t, Cap cap) {
    const CutFace& frame = part_.frame.back();
    const glm::vec3 flat(frame.normal);
    part_.triangle.emplace_back(vertex_of(t, 0), vertex_of(t, 1), vertex_of(t, 2));
    part_.frame_of.push_back(static_cast<std::uint32_t>(part_.frame.size() - 1));
    part_.normal.push_back(frame.curved ? face_.normals(t) : std::array{flat, flat, flat});
    part_.cap.push_back(std::move(cap));
  }

  /// Every edge that follows a surface once per surface, with the vertices on one side of it.
  void add_segments() {
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_.is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const bool rim = !is_section(plane().neighbor[t][i]);
        if (!rim && corner(t, i) > corner(t, i + 1)) continue;
        std::int32_t last = -1;
        for (const EdgeUse& use : uses(t, i)) {
          const std::int32_t surface = surfaces_.surface[face_.segment[use.segment].source];
          if (surface != last) part_.segments.push_back({{vertex_of(t, i), vertex_of(t, i + 1)}, surface, rim});
          last = surface;
        }
      }
    }
  }

  const FaceMesh& face_;
  const Regions& regions_;
  std::span<const std::uint32_t> same_as_;
  const SplitMesh& mesh_;
  const DiffusionSurfaces& surfaces_;
  FacePart part_;
  DisjointSets fans_{3 * triangle_count()};   // of corners
  std::vector<std::uint32_t> vertex_of_fan_;  // per corner that stands for its fan
};

/// Adds the parts of faces, one after another.
class PartJoiner {
 public:
  PartJoiner(Section& section, const SplitMesh& mesh, SharedVertices shared)
      : section_(section), mesh_(mesh), interior_at_(std::move(shared)) {}

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
    for (const CutSegment& s : part.segments) {
      all.segments.push_back({{number[s.vertex[0]], number[s.vertex[1]]}, s.surface, s.boundary});
    }
  }

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

  /// As soon as one face is curved, of all triangles.
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

  Section& section_;
  const SplitMesh& mesh_;
  SharedVertices interior_at_;
};

}  // namespace

Section assemble_all(const FaceMeshes& faces, const std::vector<Regions>& regions, const SplitMesh& mesh,
                     const DiffusionSurfaces& surfaces, Threads threads) {
  std::vector<FacePart> parts(faces.faces.size());
  parallel_for(parts.size(), threads, [&](std::size_t f) {
    parts[f] = FacePartBuilder(faces.faces[f], regions[f], faces.same_as, mesh, surfaces).build();
  });
  Section section;
  section.mesh.part_names = surfaces.part_names;
  section.mesh.surface_names = surfaces.surface_names;
  PartJoiner joiner(section, mesh, {});
  for (FacePart& part : parts) joiner.add(std::move(part));
  return section;
}

void leave_out_collapsed(Section& section) {
  const CrossSection& mesh = section.mesh;
  const auto collapses = [&](const glm::uvec3& t) {
    const std::vector<glm::vec3>& p = mesh.position;
    return p[t.x] == p[t.y] || p[t.y] == p[t.z] || p[t.z] == p[t.x];
  };
  std::vector<std::uint8_t> gone;
  for (const glm::uvec3& t : mesh.triangle) gone.push_back(collapses(t) ? 1 : 0);
  leave_out(section, gone);
}

void leave_out(Section& section, std::span<const std::uint8_t> gone) {
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
}

Section assemble(const FaceMeshes& faces, const std::vector<Regions>& regions, const SplitMesh& mesh,
                 const DiffusionSurfaces& surfaces, Threads threads) {
  Section section = assemble_all(faces, regions, mesh, surfaces, threads);
  leave_out_collapsed(section);
  return section;
}

void add_face(Section& section, const FaceMesh& face, const Regions& regions, const SplitMesh& mesh,
              const DiffusionSurfaces& surfaces, const SharedVertices& shared) {
  PartJoiner(section, mesh, shared).add(FacePartBuilder(face, regions, {}, mesh, surfaces).build());
}

}  // namespace pomona
