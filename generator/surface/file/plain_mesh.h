// A mesh as most modelling tools write it: triangles, and at most one colour per vertex.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"

namespace pomona {

/// A mesh in units of its file. Corners are counter-clockwise seen from the front.
struct PlainMesh {
  std::vector<glm::dvec3> position;
  std::vector<Color> color;  ///< linear; one per vertex, or none
  std::vector<glm::uvec3> triangle;
  std::vector<std::string> notes;  ///< ambiguities of the file, and how they were read
};

constexpr std::size_t max_mesh_triangles = 2'000'000;

/// "capsule, pyramids, fat", for messages about a missing object.
std::string listed_names(const std::vector<std::string>& names);

/// "2 faces of less than three corners are left out", for notes.
std::string few_corners_note(std::size_t faces);

/// The same without vertices that no triangle uses.
PlainMesh without_unused(const PlainMesh& mesh);

}  // namespace pomona
