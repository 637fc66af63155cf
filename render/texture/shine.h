// The roughness and wetness of a solid's surface at its vertices; smooth where parts change smoothly into each other.
#pragma once

#include <vector>

#include "generator/piece/solid.h"

namespace pomona {

/// The shine at a point in a triangle. Where parts of the same colour meet on a cut face, both have the mean of their
/// roughnesses and the film of the drier part; the film of the wetter part becomes thinner towards that place.
/// Everywhere else it is as the part's material says.
struct PlaceShine {
  double roughness = 0.6;  ///< roughness for physically based shading, 0..1
  double film = 1;         ///< share of the film of juice that the part's cut faces have, 0..1; 1 of what has none
};

/// The shine of a solid, computed once. The solid must outlive it.
class Shine {
 public:
  explicit Shine(const Solid& solid);

  /// \param weight barycentric, of a place in the triangle.
  PlaceShine at(std::uint32_t triangle, const glm::dvec3& weight) const;

 private:
  /// Sums over the triangles around a vertex, or around all vertices of the same colour at its position.
  struct AtVertex {
    double roughness = 0;            ///< the sum of theirs
    double driest = 1, wettest = 0;  ///< their films
    double share = 1;                ///< share of the wettest part's film where it thins out
    int count = 0;
  };
  struct OfPart {
    double skin_roughness = 0, cut_roughness = 0, film = 0;
  };

  const AtVertex& around(std::uint32_t vertex) const { return vertex_[joint_[vertex]]; }
  void thin_out();
  const OfPart& of_part(std::uint32_t triangle) const;
  double roughness_of(std::uint32_t triangle) const;

  const SolidMesh& mesh_;
  std::vector<OfPart> part_;
  std::vector<std::uint32_t> joint_;  ///< per vertex: the first vertex of its group
  std::vector<AtVertex> vertex_;      ///< data of these vertices, on cut faces
};

}  // namespace pomona
