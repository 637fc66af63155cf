#include "generator/cut/section/face_part.h"

#include <algorithm>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

/// Builds the part. A fan is the corners that meet at a vertex without a surface between them; it becomes one vertex of
/// the section.
class FacePartBuilder {
 public:
  FacePartBuilder(const Face& face, const Regions& regions, const SplitMesh& mesh, const DiffusionSurfaces& surfaces)
      : face_(face), regions_(regions), mesh_(mesh), surfaces_(surfaces) {}

  FacePart build() {
    find_fans();
    make_vertices();
    std::vector<std::vector<std::size_t>> of_facet(face_.frame.size());
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (regions_.is_section(t)) of_facet[face_.facet[t]].push_back(t);
    }
    for (std::size_t i = 0; i < of_facet.size(); ++i) {
      if (of_facet[i].empty()) continue;
      part_.frame.push_back(face_.frame[i]);
      for (const std::size_t t : of_facet[i]) add_triangle(t);
    }
    add_segments();
    return std::move(part_);
  }

 private:
  std::size_t triangle_count() const { return face_.triangle.size(); }
  bool is_section(std::int32_t triangle) const {
    return triangle >= 0 && regions_.is_section(static_cast<std::size_t>(triangle));
  }
  std::uint32_t corner(std::size_t triangle, std::size_t i) const { return face_.corner(triangle, i); }
  std::span<const EdgeUse> uses(std::size_t triangle, std::size_t edge) const {
    if (!face_.constrained[triangle][edge]) return {};
    return face_.uses(corner(triangle, edge), corner(triangle, edge + 1));
  }

  std::uint32_t place(std::uint32_t vertex) const { return mesh_.same_as[face_.point[vertex]]; }

  /// Joins the corners that meet at a vertex without a surface between them.
  void find_fans() {
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_.is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t other = face_.neighbor[t][i];
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
    // Collect what surfaces along edges say about the fans at both ends.
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

    // Make a vertex for each fan, in the order of the triangles: with the mean of its sides' colours, or without one.
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
    const CutSegment& s = face_.segment[segment_number];
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

  /// Adds a triangle as often as it closes something.
  void add_triangle(std::size_t t) {
    const std::array<std::uint32_t, 3> points{place(corner(t, 0)), place(corner(t, 1)), place(corner(t, 2))};
    for (const Regions::Closing& closing : regions_.closed_by(t)) add_triangle(t, {points, closing});
  }

  void add_triangle(std::size_t t, Cap cap) {
    const CutFace& frame = part_.frame.back();
    const glm::vec3 flat(frame.normal);
    part_.triangle.emplace_back(vertex_of(t, 0), vertex_of(t, 1), vertex_of(t, 2));
    part_.frame_of.push_back(static_cast<std::uint32_t>(part_.frame.size() - 1));
    part_.normal.push_back(frame.curved ? face_.normal[t] : std::array{flat, flat, flat});
    part_.cap.push_back(std::move(cap));
  }

  /// Adds every edge that follows a surface, once per surface, with the vertices on one side of it.
  void add_segments() {
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      if (!regions_.is_section(t)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const bool rim = !is_section(face_.neighbor[t][i]);
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

  const Face& face_;
  const Regions& regions_;
  const SplitMesh& mesh_;
  const DiffusionSurfaces& surfaces_;
  FacePart part_;
  DisjointSets fans_{3 * triangle_count()};   // of corners
  std::vector<std::uint32_t> vertex_of_fan_;  // per corner that stands for its fan
};

}  // namespace

FacePart part_of(const Face& face, const Regions& regions, const SplitMesh& mesh, const DiffusionSurfaces& surfaces) {
  return FacePartBuilder(face, regions, mesh, surfaces).build();
}

}  // namespace pomona
