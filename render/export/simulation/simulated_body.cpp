#include "render/export/simulation/simulated_body.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/base/utf8.h"
#include "generator/mesh/moments.h"
#include "generator/piece/piece_facts.h"
#include "render/export/collision/collision_shape.h"
#include "render/export/collision/hulls_apart.h"
#include "render/export/piece_words.h"
#include "render/export/up_axis.h"
#include "render/export/weld.h"

namespace pomona {

namespace {

/// The vertices that some triangles use, about a pivot.
VisualMesh visual_of(const StyledMesh& mesh, const MaterialGroup& group, const glm::vec3& pivot) {
  VisualMesh visual;
  std::vector<std::uint32_t> number(mesh.position.size(), 0xffffffffu);
  glm::dvec3 color(0);
  double area = 0;
  for (const glm::uvec3& t : group.triangle) {
    glm::uvec3 own(0);
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& at = number[t[k]];
      if (at == 0xffffffffu) {
        at = static_cast<std::uint32_t>(visual.position.size());
        visual.position.push_back(mesh.position[t[k]] - pivot);
        visual.normal.push_back(mesh.normal[t[k]]);
      }
      own[k] = at;
    }
    visual.triangle.push_back(own);
    const glm::dvec3 a(mesh.position[t.x]), b(mesh.position[t.y]), c(mesh.position[t.z]);
    const double share = glm::length(glm::cross(b - a, c - a));
    color += share / 3 * glm::dvec3(mesh.color[t.x] + mesh.color[t.y] + mesh.color[t.z]);
    area += share;
  }
  visual.color = to_srgb8(area > 0 ? Color(color / area) : Color(0.5f));
  return visual;
}

/// The inertia of the hulls with the piece's mass, for pieces whose inside is not known.
void add_inertia_of_hulls(SimulatedKind& kind) {
  Moments all;
  for (const HullMesh& part : kind.hulls) all.add(moments_of(part.hull.position, part.hull.triangle, glm::dvec3(0)));
  if (!(all.mass > 0)) return;
  const RigidMass rigid = rigid_mass(all, glm::dvec3(0));
  if (!(kind.mass > 0)) kind.mass = 1000 * all.mass;
  kind.center = rigid.center;
  kind.inertia = kind.mass / all.mass * rigid.inertia;
}

SimulatedKind kind_of(const Solid& solid, const StyledMesh& mesh, const ExportOptions& options) {
  SimulatedKind kind;
  kind.moves = is_fruit(solid);
  if (mesh.triangle.empty()) return kind;
  const glm::vec3 pivot = pivot_of(solid);
  const std::string name = plain_name(solid.name);
  for (const MaterialGroup& group : groups_by_material(solid, mesh)) {
    kind.visuals.push_back(visual_of(mesh, group, pivot));
    kind.visuals.back().name = name + "_" + (group.name.empty() ? "all" : plain_name(group.name));
    kind.visuals.back().opacity = solid.opacity;
  }
  for (ConvexHull& hull : collision_parts(solid, options.hulls)) {
    for (glm::vec3& p : hull.position) p -= pivot;
    kind.hulls.push_back({name + "_hull_" + std::to_string(kind.hulls.size() + 1), std::move(hull)});
  }
  const PieceFacts facts = facts_of(solid);
  kind.mass = facts.mass;
  kind.center = facts.center - glm::dvec3(pivot);
  kind.inertia = facts.inertia;
  if (kind.moves && kind.inertia == glm::dmat3(0)) add_inertia_of_hulls(kind);
  return kind;
}

/// The lowest place of anything.
double lowest_of(const SimulatedScene& scene) {
  double lowest = 0;
  for (const SimulatedBody& body : scene.bodies)
    for (const VisualMesh& visual : scene.kinds[static_cast<std::size_t>(body.kind)].visuals)
      for (const glm::vec3& p : visual.position)
        lowest = std::min(lowest, (body.rotation * glm::dvec3(p)).z + body.place.z);
  return lowest;
}

std::vector<StandingHulls> standing_hulls(const SimulatedScene& made) {
  std::vector<StandingHulls> standing;
  for (const SimulatedBody& body : made.bodies) {
    const SimulatedKind& kind = made.kinds[static_cast<std::size_t>(body.kind)];
    StandingHulls hulls{.parts = {}, .place = body.place, .rotation = body.rotation, .gives_way = kind.moves};
    for (const HullMesh& part : kind.hulls) hulls.parts.push_back(&part.hull);
    standing.push_back(std::move(hulls));
  }
  return standing;
}

/// The scene with hulls that leave room for each other.
SimulatedScene with_hulls_apart(SimulatedScene made, Threads threads) {
  std::vector<TrimmedHulls> trimmed = hulls_apart(standing_hulls(made), threads);
  for (std::size_t i = 0; i < trimmed.size(); ++i) {
    SimulatedBody& body = made.bodies[i];
    for (ConvexHull& hull : trimmed[i].parts) {
      const std::string number = std::to_string(body.own_hulls.size() + 1);
      body.own_hulls.push_back({body.name + "_trimmed_" + number, std::move(hull)});
    }
  }
  return made;
}

/// The scene with its welds. Each solid of a cut is there once.
SimulatedScene welded(SimulatedScene made, const Scene& scene) {
  std::map<int, int> body_of;
  for (std::size_t i = 0; i < made.bodies.size(); ++i) body_of[made.bodies[i].kind] = static_cast<int>(i);
  for (const Weld& weld : welds_of(scene.solids)) {
    const PieceContact& contact = weld.contact;
    const auto first = body_of.find(contact.first), second = body_of.find(contact.second);
    if (first == body_of.end() || second == body_of.end()) continue;
    made.welds.push_back({weld_name(contact), first->second, second->second, contact.area, weld.strength});
  }
  return made;
}

}  // namespace

std::string plain_name(const std::string& name) {
  std::string plain = name;
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  std::replace_if(
      plain.begin(), plain.end(), [&](char c) { return !is_plain(c); }, '_');
  return plain;
}

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : as_utf8(text)) {
    const std::size_t at = std::string("&<>\"").find(c);
    if (at == std::string::npos)
      escaped += static_cast<unsigned char>(c) < 32 ? ' ' : c;
    else
      escaped += std::vector<std::string>{"&amp;", "&lt;", "&gt;", "&quot;"}[at];
  }
  return escaped;
}

const std::vector<HullMesh>& hulls_of(const SimulatedScene& scene, const SimulatedBody& body) {
  return body.own_hulls.empty() ? scene.kinds[static_cast<std::size_t>(body.kind)].hulls : body.own_hulls;
}

std::vector<std::array<std::size_t, 2>> bodies_that_overlap(const SimulatedScene& scene, Threads threads) {
  return bodies_that_overlap(standing_hulls(scene), threads);
}

SimulatedScene simulated_scene(const Scene& scene, const ExportOptions& options) {
  SimulatedScene made;
  const std::vector<StyledMesh> meshes = styled_meshes(scene, options);
  made.kinds.resize(scene.solids.size());
  parallel_for(scene.solids.size(), options.threads,
               [&](std::size_t i) { made.kinds[i] = kind_of(scene.solids[i], meshes[i], options); });
  for (const Instance& instance : scene.instances) {
    const Solid& solid = scene.solids[static_cast<std::size_t>(instance.solid)];
    if (made.kinds[static_cast<std::size_t>(instance.solid)].visuals.empty()) continue;
    const glm::dquat rotation = glm::normalize(instance.pose.rotation);
    const glm::dvec3 place = rotation * glm::dvec3(pivot_of(solid)) + instance.pose.translation;
    made.bodies.push_back({plain_name(instance.name), instance.solid, place_with_up(UpAxis::z, place),
                           rotation_with_up(UpAxis::z, rotation)});
  }
  made.ground = lowest_of(made);
  return options.welded ? welded(std::move(made), scene) : with_hulls_apart(std::move(made), options.threads);
}

}  // namespace pomona
