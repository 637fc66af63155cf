#include "generator/surface/sweep/mesh_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"
#include "generator/surface/file/far_from_origin.h"
#include "generator/surface/file/glb_file.h"
#include "generator/surface/file/obj_file.h"
#include "generator/surface/file/plain_mesh.h"
#include "generator/surface/file/surface_file.h"
#include "generator/surface/sweep/grid_painter.h"
#include "generator/template/read/entry_place.h"

namespace pomona {

namespace {

[[noreturn]] void refuse_mesh(const MeshSketch& mesh, const std::string& message, const std::string& hint) {
  throw Error(ExitStatus::bad_data, {{{mesh.file->path, 0, 0, {}}, "mesh \"" + mesh.name + "\": " + message, hint}});
}

Placing placing_of(const MeshSketch& mesh) { return {.unit = mesh.unit, .z_up = mesh.z_up, .at = mesh.at}; }

// ---- Surface files ----

/// Only the triangles of one surface; vertices stay.
DiffusionSurfaces picked_surface(DiffusionSurfaces all, const MeshSketch& mesh) {
  if (std::find(all.surface_names.begin(), all.surface_names.end(), mesh.object) == all.surface_names.end()) {
    refuse_mesh(mesh, "there is no surface \"" + mesh.object + "\" in the file",
                "it has: " + listed_names(all.surface_names));
  }
  DiffusionSurfaces picked = all;
  picked.triangle.clear();
  picked.surface.clear();
  picked.front_part.clear();
  picked.back_part.clear();
  for (std::size_t i = 0; i < all.triangle_count(); ++i) {
    if (all.surface_names[static_cast<std::size_t>(all.surface[i])] != mesh.object) continue;
    picked.triangle.push_back(all.triangle[i]);
    picked.surface.push_back(0);
    picked.front_part.push_back(all.front_part[i]);
    picked.back_part.push_back(all.back_part[i]);
  }
  picked.surface_names = {mesh.object};
  return picked;
}

/// The template's number for each part that the file's triangles have.
void renumber_parts(DiffusionSurfaces& surfaces, const Template& fruit, const MeshSketch& mesh) {
  const auto renumbered = [&](std::int32_t part) {
    const std::string& name = surfaces.part_names[static_cast<std::size_t>(part)];
    const auto found = std::find(fruit.parts.begin(), fruit.parts.end(), name);
    if (found == fruit.parts.end()) {
      refuse_mesh(mesh, "its part \"" + name.substr(0, 64) + "\" is not one of the template's parts",
                  "add it to \"parts\", or name the file's parts by comments like \"part 0 flesh\"");
    }
    return static_cast<std::int32_t>(found - fruit.parts.begin());
  };
  for (std::int32_t& part : surfaces.front_part) part = renumbered(part);
  for (std::int32_t& part : surfaces.back_part) part = renumbered(part);
  surfaces.part_names = fruit.parts;
}

DiffusionSurfaces from_surface_file(const Template& fruit, const MeshSketch& mesh) {
  // A file that is not moved keeps every bit, so template and file are cut alike.
  DiffusionSurfaces surfaces = parse_surfaces(mesh.file->bytes, mesh.file->path, placing_of(mesh));
  if (!mesh.object.empty()) surfaces = picked_surface(std::move(surfaces), mesh);
  renumber_parts(surfaces, fruit, mesh);
  for (float& blur : surfaces.blur) blur = static_cast<float>(static_cast<double>(blur) * mesh.unit);
  for (glm::uvec3& t : surfaces.triangle) {
    if (mesh.flip.value_or(false)) std::swap(t.y, t.z);
  }
  return surfaces;
}

// ---- Plain meshes ----

PlainMesh read_plain(const MeshSketch& mesh) {
  if (mesh.file->format == MeshFormat::obj) return parse_obj(mesh.file->bytes, mesh.file->path, mesh.object);
  if (mesh.file->format == MeshFormat::glb) return parse_glb(mesh.file->bytes, mesh.file->path, mesh.object);
  return parse_plain_surfaces(mesh.file->bytes, mesh.file->path, mesh.object);
}

double turn_about(double x, double z) { return x == 0 && z == 0 ? 0.0 : turn_of(reproducible::atan2(-z, x)); }

/// The place of each vertex in the ramps: by height or distance, and by angle.
SweptGrid ramp_grid(const PlainMesh& plain, const MeshSketch& mesh) {
  // Ramps along follow the height, or the distance from a given point.
  SweptGrid grid;
  for (const glm::dvec3& p : plain.position) grid.position.push_back(placing_of(mesh)(p));
  const Box<double> box = box_around(grid.position);
  if (is_too_far(box)) refuse_mesh(mesh, why_too_far(box), "move it to the origin by " + at_key(box.moved(-mesh.at)));
  for (const glm::dvec3& p : grid.position) {
    grid.along.push_back(mesh.paint->ramps_from ? glm::distance(p, *mesh.paint->ramps_from) : p.y);
  }

  // Along runs from 0 to 1; around is the angle about the mesh's own middle, the turn that about the axis.
  const auto [min, max] = std::minmax_element(grid.along.begin(), grid.along.end());
  const double from = *min, range = *max - *min;
  const glm::dvec3 middle = box.center();
  for (std::size_t i = 0; i < grid.position.size(); ++i) {
    const glm::dvec3 p = grid.position[i] - middle;
    grid.along[i] = range > 0 ? (grid.along[i] - from) / range : 0.0;
    grid.around.push_back(turn_about(p.x, p.z));
    grid.turn.emplace_back(turn_about(grid.position[i].x, grid.position[i].z));
  }

  // A mesh has no poles and no folds.
  grid.is_pole.assign(grid.position.size(), 0);
  grid.fold.assign(grid.position.size(), 0);
  grid.depth.assign(grid.position.size(), 1);
  grid.triangle = plain.triangle;
  for (glm::uvec3& t : grid.triangle) {
    if (mesh.flip.value_or(false)) std::swap(t.y, t.z);
  }
  return grid;
}

DiffusionSurfaces painted_mesh(const Template& fruit, const MeshSketch& mesh) {
  const PlainMesh plain = read_plain(mesh);
  const MeshPaint& paint = *mesh.paint;
  if (plain.color.empty() && (paint.front_color_from_file || paint.back_color_from_file)) {
    refuse_mesh(mesh, "the file has no colours at its vertices", "write \"color\" in the template's sides");
  }
  DiffusionSurfaces surfaces;
  surfaces.part_names = fruit.parts;
  surfaces.notes = plain.notes;
  GridPainter(surfaces, mesh.name, paint.front, paint.back, paint.blur).append(ramp_grid(plain, mesh));
  if (paint.front_color_from_file) surfaces.front_color = plain.color;
  if (paint.back_color_from_file) surfaces.back_color = plain.color;
  return surfaces;
}

DiffusionSurfaces read_surfaces_of(const Template& fruit, const MeshSketch& mesh) {
  DiffusionSurfaces surfaces = mesh.paint ? painted_mesh(fruit, mesh) : from_surface_file(fruit, mesh);
  for (std::string& note : surfaces.notes) note = mesh.file->path + ": mesh \"" + mesh.name + "\": " + note;
  // A mesh in a wrong unit is nearly nothing, or larger than a house.
  constexpr double smallest = 1e-6, largest = 100;
  const double size = glm::length(bounds_of(surfaces).size());
  if (!(size >= smallest && size <= largest)) {
    refuse_mesh(mesh, size < smallest ? "it has no size" : "it is larger than 100 m",
                "state the length of one unit of the file, as in unit = \"1mm\"");
  }
  return surfaces;
}

/// Reports a fault of a file as a whole where the template names it.
Error told_in_template(const Error& error, const Template& fruit, const MeshSketch& mesh) {
  std::vector<Diagnostic> diagnostics = error.diagnostics();
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.place.line > 0 || !diagnostic.place.element.empty() || fruit.file.empty()) continue;
    const std::string file = std::move(diagnostic.place.file);
    diagnostic.place = entry_place(fruit.file, "mesh", mesh.name);
    diagnostic.message = file + ": " + diagnostic.message;
  }
  return {error.status(), std::move(diagnostics)};
}

}  // namespace

DiffusionSurfaces mesh_surfaces(const Template& fruit, const MeshSketch& mesh) {
  try {
    return read_surfaces_of(fruit, mesh);
  } catch (const Error& error) {
    throw told_in_template(error, fruit, mesh);
  }
}

bool may_turn(const MeshSketch& mesh) {
  return mesh.paint && !mesh.flip && mesh.paint->front.hidden != mesh.paint->back.hidden;
}

void check_meshes_together(const Template& fruit, const MeshSketch& mesh, std::size_t triangles) {
  if (triangles <= max_mesh_triangles) return;
  refuse_entry(fruit, "mesh", mesh.name, "with it the meshes have more than 2 000 000 triangles together",
               "simplify them");
}

}  // namespace pomona
