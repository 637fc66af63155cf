// The bodies of a scene, as simulators take them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "generator/scene/scene.h"
#include "render/export/convex_hull.h"
#include "render/export/pbr_material.h"
#include "render/export/styled_mesh.h"

namespace pomona {

/// What one sees of a body in one colour: all triangles of a look.
struct VisualMesh {
  std::string name;      ///< "tomato_piece_1_skin": unique in the scene, letters, digits and underscores
  glm::u8vec3 color{0};  ///< sRGB, the mean over its area
  float opacity = 1;
  std::vector<glm::vec3> position, normal;
  std::vector<glm::uvec3> triangle;
};

struct HullMesh {
  std::string name;  ///< "tomato_piece_1_hull_1"
  ConvexHull hull;
};

/// What the bodies of one solid share. Positions are about the body's origin: the centre of mass of a piece, the
/// frame's origin of a dish.
struct SimulatedKind {
  bool moves = false;     ///< pieces move, dishes stand still
  double mass = 0;        ///< kilograms
  glm::dvec3 center{0};   ///< centre of mass, from the origin: what single precision left of it
  glm::dmat3 inertia{0};  ///< about the centre of mass, kg m^2
  std::vector<VisualMesh> visuals;
  std::vector<HullMesh> hulls;
};

struct SimulatedBody {
  std::string name;  ///< of the instance, in letters, digits and underscores
  int kind = 0;      ///< index into SimulatedScene::kinds
  glm::dvec3 place{0};
  glm::dquat rotation{1, 0, 0, 0};

  /// Its own in place of the kind's, where its neighbours leave no room for those.
  std::vector<HullMesh> own_hulls = {};
};

/// Two bodies joined.
struct SimulatedWeld {
  std::string name;           ///< "weld_1_2_cut_0": numbers of pieces, of the cut face
  int first = 0, second = 0;  ///< indices into SimulatedScene::bodies
  double area = 0;            ///< square metres
  double strength = 0;        ///< newtons
};

/// Bodies in a frame with +Z up.
struct SimulatedScene {
  std::vector<SimulatedKind> kinds;  ///< one a solid of the scene, without anything for solids without triangles
  std::vector<SimulatedBody> bodies;
  std::vector<SimulatedWeld> welds;  ///< where the options want them
  double ground = 0;                 ///< height of the ground, which nothing begins below
};

/// What the body collides with.
const std::vector<HullMesh>& hulls_of(const SimulatedScene& scene, const SimulatedBody& body);

/// Each two bodies, by their indices, whose hulls overlap. Welded ones must not collide.
std::vector<std::array<std::size_t, 2>> bodies_that_overlap(const SimulatedScene& scene, Threads threads);

/// Pieces begin outside each other and their dishes, but for those that welds join: where hulls would overlap, a body
/// has its own, cut off [render/export/collision/hulls_apart.h]. An open piece, whose inside is not known, has the
/// inertia of its hull.
SimulatedScene simulated_scene(const Scene& scene, const ExportOptions& options);

/// Letters, digits and underscores in place of what names of models do not take.
std::string plain_name(const std::string& name);

/// The text with characters of XML's own escaped.
std::string xml_text(const std::string& text);

}  // namespace pomona
