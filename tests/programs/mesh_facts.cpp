// What the readers of meshes make of a file, as one line of JSON: its triangles, area and box, in the file's units, and
// what is told.
//   mesh_facts FILE
#include <cstdio>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "generator/base/error.h"
#include "generator/mesh/box.h"
#include "generator/surface/file/plain_mesh_file.h"

namespace {

using Json = nlohmann::ordered_json;

Json facts_of(const pomona::PlainMesh& mesh) {
  double area = 0;
  pomona::Box<double> box;
  for (const glm::uvec3& t : mesh.triangle) {
    const glm::dvec3 &a = mesh.position[t.x], &b = mesh.position[t.y], &c = mesh.position[t.z];
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
    for (const glm::dvec3& p : {a, b, c}) box.add(p);
  }
  return {{"triangles", mesh.triangle.size()},
          {"area", area},
          {"low", {box.low.x, box.low.y, box.low.z}},
          {"high", {box.high.x, box.high.y, box.high.z}},
          {"notes", mesh.notes}};
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 64;
  try {
    std::printf("%s\n", facts_of(pomona::read_plain_mesh(words[1])).dump().c_str());
  } catch (const pomona::Error& error) {
    const pomona::Diagnostic& what = error.diagnostics().front();
    std::printf("%s\n", Json{{"error", what.message}, {"hint", what.hint}}.dump().c_str());
  }
  return 0;
}
