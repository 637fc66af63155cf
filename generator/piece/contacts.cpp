#include "generator/piece/contacts.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace pomona {

namespace {

/// A corner of a triangle, and its part.
struct PartCorner {
  std::array<float, 3> place{};
  std::int32_t part = 0;
};

using SortedCorners = std::array<PartCorner, 3>;
using TrianglePlaces = std::array<std::array<float, 3>, 3>;

/// The corners of a triangle by their places, whichever way it is turned.
SortedCorners corners_of(const SolidMesh& mesh, std::size_t t) {
  SortedCorners corners{};
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t v = mesh.triangle[t][k];
    const glm::vec3 p = mesh.position[v] + 0.0f;
    corners[static_cast<std::size_t>(k)] = {{p.x, p.y, p.z}, mesh.part[v]};
  }
  std::sort(corners.begin(), corners.end(), [](const PartCorner& a, const PartCorner& b) { return a.place < b.place; });
  return corners;
}

TrianglePlaces places_of(const SortedCorners& corners) {
  return {corners[0].place, corners[1].place, corners[2].place};
}

struct PieceTriangle {
  int piece = 0;
  std::size_t triangle = 0;
};

void add(PieceContact& contact, const SolidMesh& first_mesh, std::size_t first_triangle, const SolidMesh& mesh,
         std::size_t t) {
  const double area = 0.5 * glm::length(mesh.area_vector(t));
  contact.area += area;
  contact.center += area * mesh.place(t, glm::dvec3(1.0 / 3));
  const SortedCorners first = corners_of(first_mesh, first_triangle), second = corners_of(mesh, t);
  for (std::size_t k = 0; k < 3; ++k) contact.parts[{first[k].part, second[k].part}] += area / 3;
}

}  // namespace

std::vector<PieceContact> contacts_of(std::span<const Solid> pieces) {
  std::map<TrianglePlaces, PieceTriangle> waiting;
  std::map<std::tuple<int, int, std::int32_t>, PieceContact> contacts;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SolidMesh& mesh = pieces[i].mesh;
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
      const auto [other, is_new] =
          waiting.try_emplace(places_of(corners_of(mesh, t)), PieceTriangle{static_cast<int>(i), t});
      const auto& [first, triangle] = other->second;
      const int second = static_cast<int>(i);
      if (is_new || first == second) continue;
      const SolidMesh& first_mesh = pieces[static_cast<std::size_t>(first)].mesh;
      if (first_mesh.cut_face[triangle] != mesh.cut_face[t]) continue;
      PieceContact& contact = contacts[{first, second, mesh.cut_face[t]}];
      contact.first = first, contact.second = second, contact.cut = mesh.cut_face[t];
      add(contact, first_mesh, triangle, mesh, t);
    }
  }
  std::vector<PieceContact> list;
  for (auto& [key, contact] : contacts) {
    contact.center /= contact.area > 0 ? contact.area : 1.0;
    list.push_back(std::move(contact));
  }
  return list;
}

}  // namespace pomona
