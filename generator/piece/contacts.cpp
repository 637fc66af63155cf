#include "generator/piece/contacts.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace pomona {

namespace {

using Place = std::array<float, 3>;
using TrianglePlaces = std::array<Place, 3>;

/// The places of a triangle, whichever way it is turned.
TrianglePlaces corners_of(const SolidMesh& mesh, std::size_t t) {
  TrianglePlaces corners{};
  for (int k = 0; k < 3; ++k) {
    const glm::vec3 p = mesh.position[mesh.triangle[t][k]] + 0.0f;
    corners[static_cast<std::size_t>(k)] = {p.x, p.y, p.z};
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

struct CutTriangle {
  int piece = 0;
  std::size_t triangle = 0;
};

void add(PieceContact& contact, const SolidMesh& mesh, std::size_t t) {
  const double area = 0.5 * glm::length(mesh.area_vector(t));
  contact.area += area;
  contact.center += area * mesh.place(t, glm::dvec3(1.0 / 3));
  for (int k = 0; k < 3; ++k) contact.parts[mesh.part[mesh.triangle[t][k]]] += area / 3;
}

}  // namespace

std::vector<PieceContact> contacts_of(std::span<const Solid> pieces) {
  std::map<TrianglePlaces, CutTriangle> waiting;
  std::map<std::tuple<int, int, std::int32_t>, PieceContact> contacts;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SolidMesh& mesh = pieces[i].mesh;
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
      if (mesh.cut_face[t] < 0) continue;
      const auto [other, is_first] = waiting.try_emplace(corners_of(mesh, t), CutTriangle{static_cast<int>(i), t});
      if (is_first || other->second.piece == static_cast<int>(i)) continue;
      const int first = other->second.piece, second = static_cast<int>(i);
      PieceContact& contact = contacts[{first, second, mesh.cut_face[t]}];
      contact.first = first, contact.second = second, contact.cut = mesh.cut_face[t];
      add(contact, mesh, t);
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
