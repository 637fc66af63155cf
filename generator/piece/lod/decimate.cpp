#include "generator/piece/lod/decimate.h"

#include <limits>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>

#include "generator/base/error.h"

namespace pomona {
namespace {

namespace decimater = OpenMesh::Decimater;

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using CollapseInfo = decimater::CollapseInfoT<HalfEdgeMesh>;

HalfEdgeMesh half_edge_mesh(const VertexFans& fans, const Solid& solid) {
  HalfEdgeMesh mesh;
  for (std::size_t f = 0; f < fans.vertex.size(); ++f) {
    const glm::vec3& p = solid.mesh.position[fans.vertex[f]];
    const auto vertex = mesh.add_vertex({p.x, p.y, p.z});
    mesh.status(vertex).set_locked(fans.is_locked[f] != 0);
  }
  for (const glm::uvec3& t : fans.triangle) {
    const auto corner = [&](int i) { return HalfEdgeMesh::VertexHandle(static_cast<int>(t[i])); };
    if (!mesh.add_face(corner(0), corner(1), corner(2)).is_valid())
      throw Error(ExitStatus::bug, solid.name + ": fans do not fit a half-edge mesh");
  }
  return mesh;
}

std::uint32_t number(HalfEdgeMesh::VertexHandle vertex) { return static_cast<std::uint32_t>(vertex.idx()); }

CollapseRing ring_of(const CollapseInfo& collapse) {
  const HalfEdgeMesh& mesh = collapse.mesh;
  CollapseRing ring{.removed = number(collapse.v0), .spoke = {}, .face = {}};
  HalfEdgeMesh::HalfedgeHandle spoke = collapse.v0v1;
  do {
    ring.spoke.push_back(number(mesh.to_vertex_handle(spoke)));
    ring.face.push_back(mesh.face_handle(spoke).idx());
    spoke = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(spoke));
  } while (spoke != collapse.v0v1);
  return ring;
}

/// Quadrics for the shape, and the rules for all else.
class RuledQuadric : public decimater::ModQuadricT<HalfEdgeMesh> {
 public:
  using Quadric = decimater::ModQuadricT<HalfEdgeMesh>;
  using Quadric::Quadric;

  void follow(CollapseRules& rules) { rules_ = &rules; }

  float collapse_priority(const CollapseInfo& collapse) override {
    // The decimater takes the cheapest collapse of each vertex, so collapses above the best so far may be forbidden.
    const float shape = Quadric::collapse_priority(collapse);
    if (collapse.v0 != asked_) asked_ = collapse.v0, min_ = std::numeric_limits<float>::max();
    const std::optional<double> rest = rules_->cost(ring_of(collapse), double{min_} - shape);
    if (!rest) return ILLEGAL_COLLAPSE;
    return min_ = std::min(min_, shape + static_cast<float>(*rest));
  }

  void preprocess_collapse(const CollapseInfo& collapse) override { rules_->collapse(ring_of(collapse)); }

  void postprocess_collapse(const CollapseInfo& collapse) override {
    Quadric::postprocess_collapse(collapse);
    asked_.invalidate();
  }

 private:
  CollapseRules* rules_ = nullptr;
  HalfEdgeMesh::VertexHandle asked_;
  float min_ = std::numeric_limits<float>::max();
};

/// Observes the decimater, and stops it when a level is reached.
class LevelReached : public decimater::Observer {
 public:
  explicit LevelReached(const CollapseRules& rules) : Observer(1), rules_(rules) {}

  void aim_at(std::size_t faces) { faces_ = faces; }
  void notify(std::size_t) override {}
  bool abort() const override { return rules_.face_count() <= faces_; }

 private:
  const CollapseRules& rules_;
  std::size_t faces_ = 0;
};

}  // namespace

std::vector<std::vector<CollapseRules::Face>> decimated(const VertexFans& fans, const Solid& solid,
                                                        std::span<const LevelTarget> levels) {
  CollapseRules rules(solid, fans);
  LevelReached reached(rules);
  HalfEdgeMesh mesh = half_edge_mesh(fans, solid);
  decimater::DecimaterT<HalfEdgeMesh> decimater(mesh);
  decimater::ModHandleT<RuledQuadric> quadric;
  decimater.add(quadric);
  decimater.module(quadric).follow(rules);
  decimater.set_observer(&reached);
  decimater.initialize();

  // With looser bounds every vertex is tested again.
  std::vector<std::vector<CollapseRules::Face>> faces;
  for (const LevelTarget& level : levels) {
    rules.set_bounds(level.bounds);
    reached.aim_at(level.faces);
    if (!reached.abort()) decimater.decimate();
    faces.push_back(rules.faces());
  }
  return faces;
}

}  // namespace pomona
