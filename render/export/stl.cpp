#include "render/export/stl.h"

#include <cstdint>
#include <cstring>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "generator/base/error.h"

namespace pomona {

namespace {

// A header of 80 bytes and the number of triangles; then 50 bytes for each.
constexpr std::size_t header_bytes = 80, triangle_bytes = 50;
constexpr std::string_view header = "Pomona, in millimetres";  // it must not begin with "solid", as ASCII STL does

constexpr double millimetres = 1e3;

void append_bits(std::string& bytes, const glm::vec3& vector) {
  char raw[sizeof vector];
  std::memcpy(raw, &vector, sizeof vector);
  bytes.append(raw, sizeof vector);
}

/// Positions in millimetres, rounded as in the file: normals are those of the rounded triangles.
std::vector<glm::vec3> placed(const Solid& solid, const Pose& pose) {
  std::vector<glm::vec3> places;
  places.reserve(solid.mesh.position.size());
  for (const glm::vec3& p : solid.mesh.position)
    places.emplace_back((pose.rotation * glm::dvec3(p) + pose.translation) * millimetres);
  return places;
}

void append_instance(std::string& bytes, const Solid& solid, const Pose& pose, std::uint32_t& count) {
  const std::vector<glm::vec3> places = placed(solid, pose);
  for (const glm::uvec3& t : solid.mesh.triangle) {
    const glm::vec3 &a = places[t.x], &b = places[t.y], &c = places[t.z];
    const glm::dvec3 normal = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    append_bits(bytes, glm::vec3(normal / length));
    for (const glm::vec3& place : {a, b, c}) append_bits(bytes, place);
    bytes.append(2, '\0');  // an attribute without a standard meaning
    ++count;
  }
}

}  // namespace

std::string write_stl(const Scene& scene) {
  std::uint64_t max = 0;
  for (const Instance& instance : scene.instances)
    max += scene.solids[static_cast<std::size_t>(instance.solid)].mesh.triangle.size();
  if (max > UINT32_MAX)
    throw Error(ExitStatus::bad_data,
                "an STL holds 4294967295 triangles at most, and the scene has " + std::to_string(max));

  std::string bytes(header);
  bytes.resize(header_bytes + sizeof(std::uint32_t), '\0');
  bytes.reserve(bytes.size() + max * triangle_bytes);
  std::uint32_t count = 0;
  for (const Instance& instance : scene.instances)
    append_instance(bytes, scene.solids[static_cast<std::size_t>(instance.solid)], instance.pose, count);
  std::memcpy(bytes.data() + header_bytes, &count, sizeof count);
  return bytes;
}

}  // namespace pomona
